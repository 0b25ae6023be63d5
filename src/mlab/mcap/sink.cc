#include "mlab/mcap/sink.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

namespace mlab::mcap {
namespace {

// Past this limit the kernel would not only refuse but send a signal, which ends the process.
bool is_past_limit(std::uint64_t at, std::size_t size) {
  rlimit limit{};
  if (::getrlimit(RLIMIT_FSIZE, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return false;
  return at > limit.rlim_cur || size > limit.rlim_cur - at;
}

}  // namespace

FileSink::Opened FileSink::open_with(const std::string& path, int flags) {
  // Without waiting: a pipe that nobody reads is refused below.
  const int fd = ::open(path.c_str(), flags | O_RDWR | O_CLOEXEC | O_NOCTTY | O_NONBLOCK, 0666);
  if (fd < 0) return {nullptr, errno};
  std::unique_ptr<FileSink> sink(new FileSink(fd));
  struct stat status{};
  if (::fstat(fd, &status) != 0) return {nullptr, errno};
  if (!S_ISREG(status.st_mode)) return {nullptr, EINVAL};
  // A file system without locks is no reason not to record.
  if (::flock(fd, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) return {nullptr, EWOULDBLOCK};
  sink->at_ = static_cast<std::uint64_t>(status.st_size);
  return {std::move(sink), 0};
}

FileSink::Opened FileSink::create(const std::string& path) {
  Opened out = open_with(path, O_CREAT);
  // Emptied only once nobody else writes it.
  if (out.sink == nullptr) return out;
  if (const int error = out.sink->cut(0); error != 0) return {nullptr, error};
  return out;
}

FileSink::Opened FileSink::open(const std::string& path) {
  return open_with(path, 0);
}

FileSink::~FileSink() {
  static_cast<void>(close());
}

int FileSink::append(std::span<const std::byte> bytes) {
  if (is_past_limit(at_, bytes.size())) return EFBIG;
  while (!bytes.empty()) {
    const ssize_t n = ::pwrite(fd_, bytes.data(), bytes.size(), static_cast<off_t>(at_));
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return errno;
    if (n == 0) return ENOSPC;
    at_ += static_cast<std::uint64_t>(n);
    bytes = bytes.subspan(static_cast<std::size_t>(n));
  }
  return 0;
}

int FileSink::cut(std::uint64_t size) {
  if (::ftruncate(fd_, static_cast<off_t>(size)) != 0) return errno;
  at_ = size;
  return 0;
}

int FileSink::sync() {
  return ::fdatasync(fd_) == 0 ? 0 : errno;
}

int FileSink::close() {
  const int fd = std::exchange(fd_, -1);
  // Not again after EINTR: Linux has closed it by then.
  return fd < 0 || ::close(fd) == 0 || errno == EINTR ? 0 : errno;
}

}  // namespace mlab::mcap
