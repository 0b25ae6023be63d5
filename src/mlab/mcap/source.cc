#include "mlab/mcap/source.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

#include <fmt/core.h>

#include "mlab/text/shown.h"

namespace mlab::mcap {
namespace {

class FileSource final : public Source {
 public:
  FileSource(int fd, std::uint64_t size, bool is_ours) : fd_(fd), size_(size), is_ours_(is_ours) {}
  ~FileSource() override {
    if (is_ours_) ::close(fd_);
  }
  FileSource(const FileSource&) = delete;
  FileSource& operator=(const FileSource&) = delete;

  std::uint64_t size() const override { return size_; }
  int read(std::uint64_t offset, std::span<std::byte> out) const override {
    if (offset > size_ || out.size() > size_ - offset) return ENODATA;
    while (!out.empty()) {
      const ssize_t n = ::pread(fd_, out.data(), out.size(), static_cast<off_t>(offset));
      if (n < 0 && errno == EINTR) continue;
      if (n < 0) return errno;
      if (n == 0) return ENODATA;
      offset += static_cast<std::uint64_t>(n);
      out = out.subspan(static_cast<std::size_t>(n));
    }
    return 0;
  }

 private:
  int fd_;
  std::uint64_t size_;
  bool is_ours_;
};

class MemorySource final : public Source {
 public:
  explicit MemorySource(std::span<const std::byte> bytes) : bytes_(bytes) {}

  std::uint64_t size() const override { return bytes_.size(); }
  int read(std::uint64_t offset, std::span<std::byte> out) const override {
    if (offset > bytes_.size() || out.size() > bytes_.size() - offset) return ENODATA;
    std::ranges::copy(bytes_.subspan(static_cast<std::size_t>(offset), out.size()), out.begin());
    return 0;
  }

 private:
  std::span<const std::byte> bytes_;
};

}  // namespace

text::Result<std::shared_ptr<const Source>> open_source(const std::string& path) {
  const auto failed = [&](const std::string& why) {
    return std::unexpected(
        text::Diagnostic{text::Severity::kError,
                         "cannot-read",
                         fmt::format("`{}` can't be read: {}", text::shown(path, 200), why),
                         {},
                         {},
                         {},
                         {}});
  };
  const int fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK);
  if (fd < 0) return failed(std::generic_category().message(errno));
  const off_t size = ::lseek(fd, 0, SEEK_END);
  auto source = std::make_shared<FileSource>(fd, size < 0 ? 0 : static_cast<std::uint64_t>(size), true);
  struct stat status{};
  if (::fstat(fd, &status) != 0) return failed(std::generic_category().message(errno));
  if (!S_ISREG(status.st_mode)) return failed("it is no ordinary file");
  return source;
}

std::shared_ptr<const Source> source_of(int descriptor, std::uint64_t size) {
  return std::make_shared<FileSource>(descriptor, size, false);
}

std::shared_ptr<const Source> source_of(std::span<const std::byte> bytes) {
  return std::make_shared<MemorySource>(bytes);
}

}  // namespace mlab::mcap
