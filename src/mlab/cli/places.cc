#include "mlab/cli/places.h"

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "mlab/cli/version.h"

namespace mlab::cli {
namespace fs = std::filesystem;

namespace {

std::string prefix_of_host;  // empty: this is a program of ours

// Of a host that has no such program beside it; empty where there is none, or this is a program of ours.
std::string runner_of_host() {
  for (const char* const place : {"bin/mlab-robots", "libexec/mlab/mlab-robots"}) {
    const std::string path = (fs::path(prefix_of_host) / place).string();
    if (!prefix_of_host.empty() && ::access(path.c_str(), X_OK) == 0) return path;
  }
  return "";
}

}  // namespace

std::string environment_variable(const char* name) {
  const char* value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe): nothing sets variables
  return value == nullptr ? "" : value;
}

void set_prefix(const std::string& folder) {
  prefix_of_host = folder;
}

std::string prefix() {
  if (!prefix_of_host.empty()) return prefix_of_host;
  std::error_code error;
  return fs::read_symlink("/proc/self/exe", error).parent_path().parent_path().string();
}

std::string include_root() {
  std::error_code error;
  for (const fs::path& root : {fs::path(prefix()) / "include", fs::path(MLAB_SOURCE_INCLUDE)}) {
    if (fs::exists(root / "mlab" / "schema" / "procedure.h", error)) return root.string();
  }
  return "";
}

robot::ProgramSources program_sources(const std::string& folder, const cell::Permission& permission) {
  robot::ProgramSources out{permission, folder, include_root(), kVersion};
  out.runner = runner_of_host();
  return out;
}

std::vector<std::string> overlay_folders() {
  return {(fs::path(prefix()) / "share" / "mlab" / "overlays").string()};
}

std::string state_folder() {
  fs::path folder = environment_variable("XDG_STATE_HOME");
  if (folder.empty() && !environment_variable("HOME").empty())
    folder = fs::path(environment_variable("HOME")) / ".local" / "state";
  if (!folder.is_absolute()) return "";
  return (folder / "mlab").string();
}

bool is_writable(const std::string& path) {
  std::error_code error;
  if (fs::exists(path, error)) return !fs::is_directory(path, error) && ::access(path.c_str(), W_OK) == 0;
  const fs::path folder = fs::path(path).parent_path();
  return ::access(folder.empty() ? "." : folder.c_str(), W_OK) == 0;
}

bool write_file(const std::string& path, const std::string& text) {
  std::error_code error;
  errno = 0;
  if (fs::exists(path, error) && !fs::is_regular_file(path, error)) {  // /dev/stdout, a pipe
    std::ofstream file(path, std::ios::binary);
    return static_cast<bool>(file.write(text.data(), static_cast<std::streamsize>(text.size())).flush());
  }
  const fs::path target = fs::is_symlink(path, error) ? fs::canonical(path, error) : fs::path(path);
  const fs::path fresh = target.string() + ".new";
  {
    std::ofstream file(fresh, std::ios::binary | std::ios::trunc);
    if (!file.write(text.data(), static_cast<std::streamsize>(text.size())).flush()) {
      const int why = errno;
      fs::remove(fresh, error);
      errno = why;
      return false;
    }
  }
  if (fs::exists(target, error)) fs::permissions(fresh, fs::status(target).permissions(), error);
  fs::rename(fresh, target, error);
  if (error) errno = error.value();
  return !error;
}

std::string why_not_written() {
  return errno == 0 ? std::string() : ": " + std::generic_category().message(errno);
}

}  // namespace mlab::cli
