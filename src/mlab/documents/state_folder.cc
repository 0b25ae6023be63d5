#include "mlab/documents/state_folder.h"

#include <signal.h>
#include <sys/types.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <filesystem>
#include <optional>
#include <system_error>

#include <fmt/core.h>

#include "mlab/base/hash.h"
#include "mlab/text/private_folder.h"

namespace mlab::documents {

namespace fs = std::filesystem;

namespace {

constexpr const char* kNowhere = "neither XDG_STATE_HOME nor HOME names a folder";

// The process that a half written file belongs to: `.NAME.PID.part`.
std::optional<pid_t> writer_of(std::string_view name) {
  constexpr std::string_view kEnd = ".part";
  if (!name.starts_with('.') || !name.ends_with(kEnd)) return std::nullopt;
  name.remove_suffix(kEnd.size());
  const std::string_view digits = name.substr(name.rfind('.') + 1);
  pid_t out = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), out);
  const bool is_number = error == std::errc{} && end == digits.data() + digits.size() && out > 0;
  return is_number ? std::optional(out) : std::nullopt;
}

bool has_ended(pid_t process) {
  return ::kill(process, 0) != 0 && errno == ESRCH;
}

}  // namespace

StateFolder::StateFolder(const std::string& folder, std::string_view project) {
  if (folder.empty()) return;
  folder_ = (fs::path(folder) / fmt::format("{:016x}", base::hash_text(project))).string();
  make();
  remove_leftovers();
}

std::string StateFolder::make() const {
  std::error_code cannot;
  if (fs::is_directory(folder_, cannot)) return "";
  const auto made = text::make_private_folder(folder_);
  return made ? "" : made.error();
}

void StateFolder::remove_leftovers() const {
  for (const EnclosedFolder::Item& item : EnclosedFolder(folder_, {}).items(1000)) {
    const std::optional<pid_t> writer = writer_of(item.name);
    if (writer && has_ended(*writer)) remove(item.name);
  }
}

std::string StateFolder::name_of(std::string_view path, std::string_view extension) {
  return fmt::format("{:016x}{}", base::hash_text(path), extension);
}

bool StateFolder::read(const std::string& name, std::size_t most_bytes, std::string& out) const {
  return !folder_.empty() && EnclosedFolder(folder_, {}).read(name, most_bytes, out).empty();
}

std::string StateFolder::write(const std::string& name, std::string_view bytes) const {
  if (folder_.empty()) return kNowhere;
  std::string why = make();  // a disk that was full may have room by now
  if (!why.empty()) return why;
  return EnclosedFolder(folder_, {}).write(name, bytes, EnclosedFolder::Reach::kInFileSystem, 0600);
}

std::string StateFolder::remove(const std::string& name) const {
  if (folder_.empty()) return "";
  std::error_code cannot;
  fs::remove(fs::path(folder_) / name, cannot);
  return cannot ? cannot.message() : "";
}

std::string StateFolder::sync(const std::string& name) const {
  return folder_.empty() ? kNowhere : EnclosedFolder(folder_, {}).sync(name);
}

std::string StateFolder::problem() const {
  const std::string name = fmt::format("probe.{}", ::getpid());
  std::string out = write(name, std::string(4096, '\n'));
  if (!folder_.empty()) remove(name);
  return out;
}

std::vector<std::string> StateFolder::names(std::string_view extension) const {
  std::vector<std::string> out;
  if (folder_.empty()) return out;
  for (EnclosedFolder::Item& item : EnclosedFolder(folder_, {}).items(1000)) {
    if (item.name.ends_with(extension)) out.push_back(std::move(item.name));
  }
  return out;
}

}  // namespace mlab::documents
