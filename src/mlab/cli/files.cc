#include "mlab/cli/files.h"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>

#include <fmt/format.h>

#include "mlab/cli/version.h"

namespace mlab::cli {
namespace fs = std::filesystem;

bool is_writable(const std::string& path) {
  std::error_code error;
  if (fs::exists(path, error)) return !fs::is_directory(path, error) && ::access(path.c_str(), W_OK) == 0;
  const fs::path folder = fs::path(path).parent_path();
  return ::access(folder.empty() ? "." : folder.c_str(), W_OK) == 0;
}

bool write_file(const std::string& path, const std::string& text) {
  std::error_code error;
  if (fs::exists(path, error) && !fs::is_regular_file(path, error)) {  // /dev/stdout, a pipe
    std::ofstream file(path, std::ios::binary);
    return static_cast<bool>(file.write(text.data(), static_cast<std::streamsize>(text.size())).flush());
  }
  const fs::path target = fs::is_symlink(path, error) ? fs::canonical(path, error) : fs::path(path);
  const fs::path fresh = target.string() + ".new";
  {
    std::ofstream file(fresh, std::ios::binary | std::ios::trunc);
    if (!file.write(text.data(), static_cast<std::streamsize>(text.size())).flush()) {
      fs::remove(fresh, error);
      return false;
    }
  }
  if (fs::exists(target, error)) fs::permissions(fresh, fs::status(target).permissions(), error);
  fs::rename(fresh, target, error);
  return !error;
}

namespace {

// Of the installation, or of the build folder: both have the command in bin/.
fs::path prefix() {
  std::error_code error;
  return fs::read_symlink("/proc/self/exe", error).parent_path().parent_path();
}

std::string include_root() {
  std::error_code error;
  for (const fs::path& root : {prefix() / "include", fs::path(MLAB_SOURCE_INCLUDE)}) {
    if (fs::exists(root / "mlab" / "schema" / "procedure.h", error)) return root.string();
  }
  return "";
}

}  // namespace

std::string environment_variable(const char* name) {
  const char* value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe): nothing sets variables
  return value == nullptr ? "" : value;
}

robot::ProgramSources program_sources(const std::string& folder, const cell::Permission& permission) {
  return {permission, folder, include_root(), kVersion};
}

robot_build::Toolchain toolchain() {
  robot_build::Toolchain out;
  out.include_root = include_root();
  out.version = kVersion;
  std::error_code error;
  const fs::path list = prefix() / "share" / "mlab" / "robot_link.txt";
  if (fs::exists(list, error)) out.link_file = list.string();
  return out;
}

std::vector<std::string> overlay_folders() {
  return {(prefix() / "share" / "mlab" / "overlays").string()};
}

assist::Surroundings surroundings(const cell::Permission& permission) {
  assist::Surroundings out;
  out.overlay_folders = overlay_folders();
  out.programs = program_sources("", permission);
  return out;
}

std::string web_folder() {
  return (prefix() / "share" / "mlab" / "web").string();
}

std::string why_web_is_missing() {
  // The launcher leaves it where it could not build the page of these sources; an older page is then no help.
  const fs::path told = prefix() / "share" / "mlab" / "web_missing.txt";
  std::ifstream file(told, std::ios::binary);
  if (file) return (std::ostringstream() << file.rdbuf()).str();
  std::error_code error;
  if (fs::exists(fs::path(web_folder()) / "index.html", error)) return "";
  return fmt::format("this mlab was built or installed without it: there is no {}\n", web_folder());
}

std::string example_folder() {
  std::error_code error;
  for (const fs::path& folder :
       {prefix() / "share" / "mlab" / "missions", fs::path(MLAB_SOURCE_INCLUDE).parent_path() / "missions"}) {
    if (fs::is_directory(folder, error)) return folder.string();
  }
  return "";
}

std::string library_folder() {
  std::error_code error;
  for (const fs::path& folder :
       {prefix() / "share" / "mlab" / "library", fs::path(MLAB_SOURCE_INCLUDE).parent_path() / "library"}) {
    if (fs::is_directory(folder, error)) return folder.string();
  }
  return "";
}

std::string state_folder() {
  fs::path folder = environment_variable("XDG_STATE_HOME");
  if (folder.empty() && !environment_variable("HOME").empty())
    folder = fs::path(environment_variable("HOME")) / ".local" / "state";
  if (!folder.is_absolute()) return "";
  return (folder / "mlab").string();
}

}  // namespace mlab::cli
