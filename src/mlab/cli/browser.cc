#include "mlab/cli/browser.h"

#include <fcntl.h>
#include <spawn.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <string_view>

#include <fmt/core.h>

#include "mlab/cli/files.h"

namespace mlab::cli {
namespace {

namespace fs = std::filesystem;

bool is_in_path(const std::string& program) {
  const std::string path = environment_variable("PATH");
  for (std::size_t begin = 0; begin < path.size();) {
    const std::size_t end = std::min(path.find(':', begin), path.size());
    if (::access((path.substr(begin, end - begin) + "/" + program).c_str(), X_OK) == 0) return true;
    begin = end + 1;
  }
  return false;
}

// A file that only its owner can read. Empty where there is none.
std::string private_file(const std::string& text) {
  std::error_code error;
  const std::string runtime = environment_variable("XDG_RUNTIME_DIR");
  const fs::path folder = runtime.empty() ? fs::temp_directory_path(error) : fs::path(runtime);
  std::string name = (folder / "mlab_console_XXXXXX.html").string();
  const int file = ::mkostemps(name.data(), 5, O_CLOEXEC);
  if (file < 0) return "";
  const bool is_whole = ::write(file, text.data(), text.size()) == static_cast<ssize_t>(text.size());
  ::close(file);
  return is_whole ? name : "";
}

}  // namespace

bool Browser::open(const std::string& url) {
  if (environment_variable("DISPLAY").empty() && environment_variable("WAYLAND_DISPLAY").empty())
    return false;
  if (!is_in_path("xdg-open")) return false;
  file_ = private_file(fmt::format(
      "<!doctype html>\n<title>mlab</title>\n<meta http-equiv=\"refresh\" content=\"0; url={0}\">\n"
      "<a href=\"{0}\">operator console</a>\n",
      url));
  if (file_.empty()) return false;
  posix_spawnattr_t attributes{};
  posix_spawn_file_actions_t actions{};
  posix_spawnattr_init(&attributes);
  posix_spawn_file_actions_init(&actions);
  // Ctrl-C in this terminal is not meant for the browser, nor is what it prints meant for the terminal.
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSID);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&actions, stream, "/dev/null", O_RDWR, 0);
  std::string program = "xdg-open";
  std::array<char*, 3> arguments = {program.data(), file_.data(), nullptr};
  pid_t process = 0;
  const int failure =
      posix_spawnp(&process, program.c_str(), &actions, &attributes, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  posix_spawnattr_destroy(&attributes);
  return failure == 0;
}

Browser::~Browser() {
  if (!file_.empty()) ::unlink(file_.c_str());
}

}  // namespace mlab::cli
