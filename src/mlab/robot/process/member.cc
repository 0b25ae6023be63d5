#include "mlab/robot/process/member.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <fmt/core.h>

namespace mlab::robot_process {
namespace {

constexpr int kNoMember = 2;
constexpr const char* kAgent = "mlab-agent";

std::string_view variable(const char* name) {
  const char* const value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe): there is one thread
  return value == nullptr ? "" : value;
}

// Where it may be, in the order in which it is looked for.
std::vector<std::string> places_of_agent(const std::filesystem::path& self, const char* made_with) {
  if (const std::string_view named = variable("MLAB_AGENT"); !named.empty()) return {std::string(named)};
  std::vector<std::string> out = {(self.parent_path() / kAgent).string()};
  std::string_view rest = variable("PATH");
  while (!rest.empty()) {
    const std::string_view folder = rest.substr(0, rest.find(':'));
    rest.remove_prefix(std::min(folder.size() + 1, rest.size()));
    if (!folder.empty()) out.push_back(fmt::format("{}/{}", folder, kAgent));
  }
  if (*made_with != '\0') out.emplace_back(made_with);
  return out;
}

}  // namespace

bool names_fleet(std::span<char* const> arguments) {
  return std::ranges::any_of(arguments, [](const char* argument) {
    const std::string_view word = argument;
    return word == "--fleet" || word.starts_with("--fleet=");
  });
}

int become_member(const RobotProgramText& text, std::span<char* const> arguments) {
  if (text.is_closed) {
    fmt::print(stderr, "{}: is closed (mlab build --closed), and a run has to see how a member is made\n",
               text.name);
    return kNoMember;
  }
  // Else one that is named by mistake in the place of mlab-agent would start itself for ever.
  if (std::ranges::any_of(arguments, [](const char* argument) {
        return std::string_view(argument).starts_with("--offer");
      })) {
    fmt::print(stderr,
               "{}: takes no --offer, it offers itself; where nobody said that, MLAB_AGENT or PATH names a "
               "robot program as mlab-agent\n",
               text.name);
    return kNoMember;
  }
  std::error_code failure;
  std::string self = std::filesystem::read_symlink("/proc/self/exe", failure).string();
  if (failure) {
    fmt::print(stderr, "{}: /proc does not say where it is: {}\n", text.name, failure.message());
    return kNoMember;
  }
  std::string name = kAgent;
  std::string offer = "--offer";
  std::vector<char*> words = {name.data(), offer.data(), self.data()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  words.push_back(nullptr);
  std::string why;
  const std::vector<std::string> places = places_of_agent(self, text.agent);
  for (const std::string& place : places) {
    ::execv(place.c_str(), words.data());
    const bool is_named = places.size() == 1;  // by MLAB_AGENT
    if (((errno != ENOENT && errno != ENOTDIR) || is_named) && why.empty())
      why = fmt::format(" ({}: {})", place, std::generic_category().message(errno));
  }
  // The whole of missionlab has an agent, too.
  if (variable("MLAB_AGENT").empty()) {
    std::string mlab = "mlab";
    std::string agent = "agent";
    words[0] = agent.data();
    words.insert(words.begin(), mlab.data());
    ::execvp(mlab.c_str(), words.data());
  }
  fmt::print(
      stderr,
      "{}: --fleet needs mlab, or mlab-agent of the package missionlab-agent, and neither is beside this "
      "file or in PATH; MLAB_AGENT names its path{}\n",
      text.name, why);
  return kNoMember;
}

}  // namespace mlab::robot_process
