#include "mlab/cli/places.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <system_error>

#include <fmt/core.h>

#include "mlab/cli/clock.h"
#include "mlab/cli/version.h"
#include "mlab/text/shown.h"

namespace mlab::cli {
namespace fs = std::filesystem;

namespace {

constexpr double kGrace = 1.0;  // for a reader who takes nothing, once somebody wants an end [s]

std::string prefix_of_host;  // empty: this is a program of ours

// Of a host that has no such program beside it; empty where there is none, or this is a program of ours.
std::string runner_of_host() {
  for (const char* const place : {"bin/mlab-robots", "libexec/mlab/mlab-robots"}) {
    const std::string path = (fs::path(prefix_of_host) / place).string();
    if (!prefix_of_host.empty() && ::access(path.c_str(), X_OK) == 0) return path;
  }
  return "";
}

/// Waits for who reads a pipe.
class Patience {
 public:
  explicit Patience(const std::function<bool()>& gives_up) : gives_up_(gives_up) {}
  /// A little while. False, and ETIMEDOUT: nobody waits any longer.
  bool wait() {
    ::usleep(20'000);
    if (!gives_up_()) return true;
    if (given_up_ < 0.0) given_up_ = steady_seconds();
    errno = ETIMEDOUT;
    return steady_seconds() - given_up_ < kGrace;
  }

 private:
  const std::function<bool()>& gives_up_;
  double given_up_ = -1.0;
};

// Nothing here waits within the system, where a signal would not end it.
bool write_whole(int file, const std::string& text, Patience& patience) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t n = ::write(file, text.data() + done, text.size() - done);
    if (n > 0) done += static_cast<std::size_t>(n);
    if (n > 0 || (n < 0 && errno == EINTR)) continue;
    if (n == 0 || errno != EAGAIN || !patience.wait()) return false;
  }
  return true;
}

bool write_stream(const std::string& path, const std::string& text, const std::function<bool()>& gives_up) {
  Patience patience(gives_up);
  int file = -1;
  while ((file = ::open(path.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY)) < 0) {
    // A pipe that nobody reads.
    if ((errno != ENXIO && errno != EINTR) || !fs::is_fifo(path) || !patience.wait()) return false;
  }
  const bool is_written = write_whole(file, text, patience);
  const int why = errno;
  const bool is_closed = ::close(file) == 0;
  if (!is_written) errno = why;
  return is_written && is_closed;
}

// Also of what is not there yet.
bool is_same_file(const std::string& a, const std::string& b) {
  std::error_code error;
  if (fs::equivalent(a, b, error)) return true;
  const auto whole = [&](const std::string& path) {
    return fs::weakly_canonical(fs::absolute(target_of(path), error), error);
  };
  return !whole(a).empty() && whole(a) == whole(b);
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

fs::path target_of(const std::string& path) {
  constexpr int kMostLinks = 40;  // as the system follows
  fs::path out = path;
  std::error_code error;
  for (int i = 0; i < kMostLinks && fs::is_symlink(out, error); ++i)
    out = out.parent_path() / fs::read_symlink(out, error);
  return out;
}

std::string why_not_writable(const std::string& path) {
  const auto reason = [](int error) { return std::generic_category().message(error); };
  const fs::path target = target_of(path);
  std::error_code error;
  if (fs::is_directory(target, error)) return "it is a folder";
  if (fs::exists(target, error)) return ::access(target.c_str(), W_OK) == 0 ? "" : reason(errno);
  if (error) return error.message();
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  const std::string name = text::shown(folder.string(), 200);
  if (!fs::exists(folder, error))
    return error ? error.message() : fmt::format("there is no folder `{}`", name);
  if (!fs::is_directory(folder, error)) return fmt::format("`{}` is no folder", name);
  if (!target.has_filename()) return "it names a folder";
  if (::access(folder.c_str(), W_OK | X_OK) == 0) return "";
  return fmt::format("no file can be made in the folder `{}`: {}", name, reason(errno));
}

std::string problem_with_outputs(const std::vector<NamedFile>& outputs,
                                 const std::vector<NamedFile>& inputs) {
  for (auto one = outputs.begin(); one != outputs.end(); ++one) {
    const auto is_same = [&](const NamedFile& other) {
      return !other.file.empty() && is_same_file(one->file, other.file);
    };
    if (one->file.empty()) continue;
    if (const auto read = std::ranges::find_if(inputs, is_same); read != inputs.end())
      return fmt::format("{} {}: that is the {} itself, which would be overwritten", one->name, one->file,
                         read->name);
    if (std::any_of(outputs.begin(), one, is_same))
      return fmt::format("{} {}: another file goes there as well", one->name, one->file);
    if (const std::string why = why_not_writable(one->file); !why.empty())
      return fmt::format("{} {}: the file can't be written: {}", one->name, one->file, why);
  }
  return "";
}

bool write_file(const std::string& path, const std::string& text, const std::function<bool()>& gives_up) {
  std::error_code error;
  errno = 0;
  if (fs::exists(path, error) && !fs::is_regular_file(path, error))  // /dev/stdout, a pipe
    return write_stream(path, text, gives_up);
  const fs::path target = target_of(path);
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
  if (errno == ETIMEDOUT) return ": nobody reads it";
  return errno == 0 ? std::string() : ": " + std::generic_category().message(errno);
}

}  // namespace mlab::cli
