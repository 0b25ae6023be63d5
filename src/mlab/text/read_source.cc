#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

#include <fmt/core.h>

#include "mlab/text/diagnostic.h"
#include "mlab/text/standard_input.h"

namespace mlab::text {
namespace {

constexpr int kWriterWaitMs = 2000;

// Closed when it goes out of scope.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return number_; }

 private:
  int number_;
};

std::unexpected<Diagnostic> refused(const std::string& name, std::string kind, const std::string& why) {
  return std::unexpected(Diagnostic{
      Severity::kError, std::move(kind), fmt::format("cannot read `{}`: {}", name, why), {}, {}, {}, {}});
}

// To its end, however long that takes.
Result<SourcePtr> read_all(int descriptor, const std::string& name, std::string text) {
  char block[1 << 16];
  for (;;) {
    const ssize_t n = ::read(descriptor, block, sizeof block);
    if (n == 0) return std::make_shared<const Source>(name, std::move(text));
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return refused(name, "cannot-read", std::generic_category().message(errno));
    text.append(block, static_cast<std::size_t>(n));
    if (text.size() > Source::kMaxBytes)
      return refused(name, "file-too-large", fmt::format("it has more than {} bytes", Source::kMaxBytes));
  }
}

// Whether somebody writes to a pipe that was opened without waiting, or does so within two seconds. A byte
// that is read on the way is put into `text`.
bool has_writer(int pipe, std::string& text) {
  pollfd wanted{pipe, POLLIN, 0};
  if (::poll(&wanted, 1, kWriterWaitMs) > 0) return true;
  char byte = 0;
  const ssize_t n = ::read(pipe, &byte, 1);
  if (n == 1) text += byte;
  return n != 0;
}

}  // namespace

Result<SourcePtr> read_source(const std::string& path) {
  // Without O_NONBLOCK a pipe to which nobody writes would be waited for right here, for ever.
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  struct stat status{};
  if (file.get() < 0 || ::fstat(file.get(), &status) != 0)
    return refused(path, "cannot-read", std::generic_category().message(errno));
  std::string begun;
  if (S_ISFIFO(status.st_mode) && !has_writer(file.get(), begun))
    return refused(path, "cannot-read", "it is a pipe, and nobody writes to it");
  ::fcntl(file.get(), F_SETFL, 0);
  return read_all(file.get(), path, std::move(begun));
}

Result<SourcePtr> read_standard_input() {
  return read_all(STDIN_FILENO, "<stdin>", "");
}

}  // namespace mlab::text
