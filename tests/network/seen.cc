#include "seen.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>

namespace mlab::network {
namespace {

namespace fs = std::filesystem;

// Nothing where there is none any more.
std::optional<Seen> look_at(pid_t process) {
  const std::string folder = "/proc/" + std::to_string(process);
  std::ifstream file(folder + "/stat");
  std::string text;
  if (!std::getline(file, text, '\0')) return std::nullopt;
  const std::size_t open = text.find('(');
  const std::size_t close = text.rfind(')');
  if (open == std::string::npos || close == std::string::npos) return std::nullopt;
  Seen out;
  out.id = process;
  out.name = text.substr(open + 1, close - open - 1);
  std::istringstream(text.substr(close + 1)) >> out.state >> out.parent;
  std::ifstream words(folder + "/cmdline");
  // A stream takes what fails in between for an end; iterators throw it, and a process may end at any moment.
  std::ostringstream read;
  read << words.rdbuf();
  out.command_line = std::move(read).str();
  while (out.command_line.ends_with('\0')) out.command_line.pop_back();
  std::ranges::replace(out.command_line, '\0', ' ');
  return out;
}

std::vector<Seen> all_processes() {
  std::vector<Seen> out;
  std::error_code failure;
  for (fs::directory_iterator entry("/proc", failure), end; !failure && entry != end;
       entry.increment(failure)) {
    const pid_t one = std::atoi(entry->path().filename().c_str());
    if (auto seen = one > 0 ? look_at(one) : std::nullopt) out.push_back(std::move(*seen));
  }
  return out;
}

}  // namespace

std::string Seen::words() const {
  return fmt::format("process {} of {}: {}", id, parent, command_line.empty() ? name : command_line);
}

std::vector<Seen> descendants_of(pid_t process) {
  std::multimap<pid_t, Seen> children;
  for (Seen& one : all_processes()) {
    const pid_t parent = one.parent;
    children.emplace(parent, std::move(one));
  }
  std::vector<Seen> out;
  std::vector<pid_t> open = {process};
  for (std::size_t i = 0; i < open.size(); ++i) {
    for (auto [at, end] = children.equal_range(open[i]); at != end; ++at) {
      open.push_back(at->second.id);
      if (at->second.state != 'Z') out.push_back(at->second);
    }
  }
  return out;
}

std::vector<Seen> children_of(pid_t process) {
  std::vector<Seen> out = all_processes();
  std::erase_if(out, [&](const Seen& one) { return one.parent != process; });
  return out;
}

std::vector<Seen> processes_in(const std::string& name) {
  std::vector<Seen> out;
  for (Seen& one : all_processes()) {
    if (!name.empty() && network_namespace_of(one.id) == name) out.push_back(std::move(one));
  }
  return out;
}

std::string network_namespace_of(pid_t process) {
  std::error_code failure;
  return fs::read_symlink("/proc/" + std::to_string(process) + "/ns/net", failure).string();
}

}  // namespace mlab::network
