#include "mlab/study/locked_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include <fmt/core.h>

namespace mlab::study {

std::string system_error(const char* what) {
  return fmt::format("can't be {}: {}", what, std::generic_category().message(errno));
}

namespace {

// What a device or a pipe gives may never end.
bool is_ordinary(int descriptor) {
  struct stat status{};
  return ::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
}

}  // namespace

std::expected<LockedFile, std::string> LockedFile::open(const std::string& path, const char* what) {
  const int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NONBLOCK, 0666);
  if (descriptor < 0) return std::unexpected(system_error(what));
  LockedFile out(descriptor);
  if (!is_ordinary(descriptor)) return std::unexpected("is no ordinary file");
  return out;
}

std::optional<LockedFile> LockedFile::open_existing(const std::string& path) {
  const int descriptor = ::open(path.c_str(), O_RDWR | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0) return std::nullopt;
  LockedFile out(descriptor);
  if (!is_ordinary(descriptor)) return std::nullopt;
  return out;
}

LockedFile::LockedFile(LockedFile&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}

LockedFile::~LockedFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

bool LockedFile::lock() const {
  return ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
}

void LockedFile::unlock() const {
  ::flock(descriptor_, LOCK_UN);
}

std::optional<std::string> LockedFile::read(std::size_t from) const {
  std::string out;
  char block[1 << 16];
  for (;;) {
    const ssize_t n =
        ::pread(descriptor_, block, sizeof block, static_cast<off_t>(from) + static_cast<off_t>(out.size()));
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return std::nullopt;
    if (n == 0) return out;
    out.append(block, static_cast<std::size_t>(n));
  }
}

bool LockedFile::cut(std::size_t size) const {
  return ::ftruncate(descriptor_, static_cast<off_t>(size)) == 0 &&
         ::lseek(descriptor_, static_cast<off_t>(size), SEEK_SET) >= 0;
}

bool LockedFile::append(std::string_view bytes) const {
  while (!bytes.empty()) {
    const ssize_t n = ::write(descriptor_, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
  return true;
}

void LockedFile::sync() const {
  ::fdatasync(descriptor_);
}

bool LockedFile::is_there() const {
  struct stat status{};
  return ::fstat(descriptor_, &status) == 0 && status.st_nlink > 0;
}

std::optional<std::size_t> LockedFile::size() const {
  struct stat status{};
  if (::fstat(descriptor_, &status) != 0) return std::nullopt;
  return static_cast<std::size_t>(status.st_size);
}

}  // namespace mlab::study
