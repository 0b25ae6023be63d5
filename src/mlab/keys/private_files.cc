#include "mlab/keys/private_files.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <system_error>

#include <fmt/format.h>

#include "mlab/text/shown.h"

namespace mlab::keys {
namespace fs = std::filesystem;
namespace {

constexpr std::uintmax_t kMostBytes = 1 << 20;
constexpr std::size_t kLongestPath = 1000;

std::string shown(const fs::path& path) {
  return text::shown(path.string(), kLongestPath);
}

std::string reason(int number) {
  return std::generic_category().message(number);
}

bool write_all(int file, const std::string& text) {
  std::size_t done = 0;
  while (done < text.size()) {
    const ssize_t more = ::write(file, text.data() + done, text.size() - done);
    if (more < 0 && errno == EINTR) continue;
    if (more <= 0) return false;
    done += static_cast<std::size_t>(more);
  }
  return ::fsync(file) == 0;
}

}  // namespace

std::expected<void, std::string> write_private(const fs::path& file, const std::string& text) {
  const std::string fresh = file.string() + ".new";
  ::unlink(fresh.c_str());  // of somebody who was killed
  const int opened = ::open(fresh.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0600);
  bool is_done = opened >= 0 && write_all(opened, text);
  int problem = errno;
  if (opened >= 0) ::close(opened);
  if (is_done && ::rename(fresh.c_str(), file.c_str()) == 0) return {};
  if (is_done) problem = errno;
  ::unlink(fresh.c_str());
  return std::unexpected(fmt::format("`{}` can't be written: {}", shown(file), reason(problem)));
}

std::expected<std::string, std::string> read_file(const fs::path& file) {
  std::error_code failure;
  const fs::file_type type = fs::status(file, failure).type();
  if (type == fs::file_type::not_found) return std::unexpected(fmt::format("`{}` is missing", shown(file)));
  if (type == fs::file_type::none)  // its folder can't be entered, say
    return std::unexpected(fmt::format("`{}` can't be read: {}", shown(file), failure.message()));
  const bool is_file = type == fs::file_type::regular;
  const std::uintmax_t size = is_file ? fs::file_size(file, failure) : 0;
  if (!is_file || failure || size > kMostBytes)
    return std::unexpected(fmt::format("`{}` is no file of at most {} bytes", shown(file), kMostBytes));
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  if (size > 0) text << stream.rdbuf();
  if (!stream) return std::unexpected(fmt::format("`{}` can't be read: {}", shown(file), reason(EACCES)));
  return std::move(text).str();
}

std::expected<void, std::string> check_private(const fs::path& file) {
  struct stat status{};
  if (::stat(file.c_str(), &status) != 0)
    return std::unexpected(fmt::format("`{}` can't be looked at: {}", shown(file), reason(errno)));
  if (status.st_uid != ::geteuid() && status.st_uid != 0)
    return std::unexpected(fmt::format("`{}` belongs to somebody else", shown(file)));
  if ((status.st_mode & 077U) == 0) return {};
  return std::unexpected(
      fmt::format("`{0}` can be read or changed by others: `chmod 600 {0}` mends that", shown(file)));
}

std::expected<FolderLock, std::string> FolderLock::of(const fs::path& folder) {
  const fs::path path = folder / ".lock";
  const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  if (file < 0) return std::unexpected(fmt::format("`{}` can't be written: {}", shown(path), reason(errno)));
  while (::flock(file, LOCK_EX) != 0) {
    if (errno == EINTR) continue;
    const int problem = errno;
    ::close(file);
    return std::unexpected(fmt::format("`{}` can't be locked: {}", shown(path), reason(problem)));
  }
  return FolderLock(file);
}

FolderLock::~FolderLock() {
  if (file_ >= 0) ::close(file_);
}

}  // namespace mlab::keys
