#include "mlab/documents/enclosed_file.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <system_error>
#include <utility>

#include <fmt/core.h>

namespace mlab::documents {
namespace {

constexpr int kFolder = O_RDONLY | O_DIRECTORY | O_CLOEXEC;

/// Closes what it holds.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  operator int() const { return fd_; }  // NOLINT(google-explicit-constructor): it stands for the number

 private:
  int fd_;
};

std::string reason(int error) {
  if (error == ELOOP || error == ENOTDIR) return "it is a symbolic link, or no file";
  return std::generic_category().message(error);
}

// Folders of some file systems can't be synced, and need not be.
bool sync_folder(int fd) {
  return ::fsync(fd) == 0 || errno == EINVAL || errno == ENOTSUP || errno == EROFS;
}

bool write_all(int fd, std::string_view text) {
  while (!text.empty()) {
    const ssize_t n = ::write(fd, text.data(), text.size());
    if (n < 0 && errno == EINTR) continue;
    if (n == 0) errno = ENOSPC;
    if (n <= 0) return false;
    text.remove_prefix(static_cast<std::size_t>(n));
  }
  return true;
}

}  // namespace

EnclosedFolder::EnclosedFolder(const std::string& root, std::span<const std::string> parts, Missing missing) {
  fd_ = ::open(root.c_str(), kFolder);
  for (const std::string& part : parts) {
    if (fd_ < 0) break;
    if (missing == Missing::kMake && ::mkdirat(fd_, part.c_str(), 0777) == 0) sync_folder(fd_);
    const int next = ::openat(fd_, part.c_str(), kFolder | O_NOFOLLOW);
    error_ = errno;
    ::close(fd_);
    fd_ = next;
  }
  if (fd_ < 0 && error_ == 0) error_ = errno;
}

EnclosedFolder::~EnclosedFolder() {
  if (fd_ >= 0) ::close(fd_);
}

EnclosedFolder::EnclosedFolder(EnclosedFolder&& from) noexcept
    : fd_(std::exchange(from.fd_, -1)), error_(from.error_) {}

std::vector<EnclosedFolder::Item> EnclosedFolder::items(std::size_t most) const {
  std::vector<Item> out;
  const int copy = fd_ < 0 ? -1 : ::openat(fd_, ".", kFolder);
  DIR* const folder = copy < 0 ? nullptr : ::fdopendir(copy);
  if (folder == nullptr) {
    if (copy >= 0) ::close(copy);
    return out;
  }
  while (const dirent* entry = ::readdir(folder)) {  // NOLINT(concurrency-mt-unsafe): a stream of our own
    struct stat status{};
    const std::string name(static_cast<const char*>(entry->d_name));
    if (name == "." || name == ".." || ::fstatat(fd_, name.c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0)
      continue;
    if (S_ISREG(status.st_mode) || S_ISDIR(status.st_mode)) out.push_back({name, S_ISDIR(status.st_mode)});
    if (out.size() == most) break;
  }
  ::closedir(folder);
  return out;
}

bool EnclosedFolder::has_file(const std::string& name) const {
  struct stat status{};
  return fd_ >= 0 && ::fstatat(fd_, name.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0 &&
         S_ISREG(status.st_mode);
}

std::string EnclosedFolder::read(const std::string& name, std::size_t most_bytes, std::string& out) const {
  if (fd_ < 0) return reason(error_);
  const Descriptor file(
      ::openat(fd_, name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
  struct stat status{};
  if (file < 0 || ::fstat(file, &status) != 0) return reason(errno);
  if (!S_ISREG(status.st_mode)) return "it is no file";
  out.clear();
  char block[1 << 16];
  while (true) {
    const ssize_t n = ::read(file, block, sizeof block);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return reason(errno);
    if (n == 0) return "";
    out.append(block, static_cast<std::size_t>(n));
    if (out.size() > most_bytes) return fmt::format("it has more than {} bytes", most_bytes);
  }
}

std::string EnclosedFolder::write(const std::string& name, std::string_view text, Reach reach,
                                  unsigned mode) const {
  if (fd_ < 0) return reason(error_);
  struct stat before{};
  const bool exists = ::fstatat(fd_, name.c_str(), &before, AT_SYMLINK_NOFOLLOW) == 0;
  if (exists && !S_ISREG(before.st_mode)) return "what stands there is no file";
  if (exists && ::faccessat(fd_, name.c_str(), W_OK, 0) != 0) return reason(errno);
  const std::string beside = fmt::format(".{}.{}.part", name.substr(0, 200), ::getpid());
  ::unlinkat(fd_, beside.c_str(), 0);
  const mode_t wanted = mode != 0 ? mode : exists ? before.st_mode & 0777U : 0666U;
  const Descriptor file(
      ::openat(fd_, beside.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, wanted));
  if (file < 0) return reason(errno);
  if (exists) ::fchmod(file, wanted);
  const bool waits = reach == Reach::kOnDisk;
  const bool is_in_place = write_all(file, text) && (!waits || ::fsync(file) == 0) &&
                           ::renameat(fd_, beside.c_str(), fd_, name.c_str()) == 0;
  if (is_in_place && (!waits || sync_folder(fd_))) return "";
  const int error = errno;
  if (!is_in_place) ::unlinkat(fd_, beside.c_str(), 0);
  return reason(error);
}

std::string EnclosedFolder::sync(const std::string& name) const {
  if (fd_ < 0) return reason(error_);
  const Descriptor file(::openat(fd_, name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  if (file < 0 || ::fsync(file) != 0 || !sync_folder(fd_)) return reason(errno);
  return "";
}

}  // namespace mlab::documents
