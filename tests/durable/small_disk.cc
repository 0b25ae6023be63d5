#include "small_disk.h"

#include <fcntl.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <cerrno>

#include <fmt/core.h>

namespace mlab::durable {
namespace {

bool write_line(const char* file, const std::string& line) {
  const int fd = ::open(file, O_WRONLY | O_CLOEXEC);
  const bool is_done = fd >= 0 && ::write(fd, line.data(), line.size()) == static_cast<ssize_t>(line.size());
  if (fd >= 0) ::close(fd);
  return is_done;
}

}  // namespace

bool get_small_disk(const std::string& where, std::uint64_t kilobytes) {
  const unsigned user = ::getuid();
  const unsigned group = ::getgid();
  if (::unshare(CLONE_NEWNS) != 0) {
    if (::unshare(CLONE_NEWUSER | CLONE_NEWNS) != 0) return false;
    const bool is_root = write_line("/proc/self/setgroups", "deny") &&
                         write_line("/proc/self/uid_map", fmt::format("0 {} 1", user)) &&
                         write_line("/proc/self/gid_map", fmt::format("0 {} 1", group));
    if (!is_root) return false;
  }
  return ::mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 &&
         ::mount("none", where.c_str(), "tmpfs", 0, fmt::format("size={}k", kilobytes).c_str()) == 0;
}

// Who writes to it meanwhile takes of what was free a moment ago: then the next look tells what is left.
bool CrowdedDisk::leave(std::uint64_t bytes) const {
  const int fd = ::open((where_ + "/of_others").c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
  int failure = fd >= 0 ? EAGAIN : EBADF;
  for (int attempt = 0; attempt < 100 && (failure == EAGAIN || failure == ENOSPC || failure == EINTR);
       ++attempt) {
    struct statvfs disk{};
    if (::ftruncate(fd, 0) != 0 || ::fstatvfs(fd, &disk) != 0) {
      failure = errno;
      break;
    }
    const std::uint64_t free = disk.f_bavail * disk.f_bsize;
    const std::uint64_t taken = bytes < free ? (free - bytes) / disk.f_bsize * disk.f_bsize : 0;
    failure = taken > 0 ? ::posix_fallocate(fd, 0, static_cast<off_t>(taken)) : 0;
  }
  if (fd >= 0) ::close(fd);
  return failure == 0;
}

}  // namespace mlab::durable
