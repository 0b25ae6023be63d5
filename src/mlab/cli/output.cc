#include "mlab/cli/output.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <iostream>
#include <system_error>

#include <fmt/core.h>
#include <ext/stdio_sync_filebuf.h>

#include "mlab/cli/clock.h"
#include "mlab/cli/commands.h"

namespace mlab::cli {

volatile std::sig_atomic_t output_hurries = 0;

namespace {

constexpr double kGrace = 1.0;  // for a reader who takes nothing, once somebody wants an end [s]

int output_error = 0;  // of the system; once something could not be written nothing more is
double hurries_since = -1.0;

// Waits until a piece of a pipe's size can be written without waiting. False: nobody waits any longer.
bool wait_for_room() {
  pollfd output{STDOUT_FILENO, POLLOUT, 0};
  for (;;) {
    const int ready = ::poll(&output, 1, 100);
    if (ready > 0 || (ready < 0 && errno != EINTR)) return true;
    if (output_hurries == 0) continue;
    if (hurries_since < 0.0) hurries_since = steady_seconds();
    if (steady_seconds() - hurries_since < kGrace) continue;
    errno = ETIMEDOUT;
    return false;
  }
}

// Of a stream that never fails, so that what prints need not care.
ssize_t write_output(void* /*cookie*/, const char* bytes, std::size_t size) {
  constexpr std::size_t kPiece = 4096;  // that a pipe takes whole where it has room: PIPE_BUF
  for (std::size_t done = 0; output_error == 0 && done < size;) {
    if (!wait_for_room()) {
      output_error = errno;
      break;
    }
    const ssize_t n = ::write(STDOUT_FILENO, bytes + done, std::min(kPiece, size - done));
    if (n < 0 && errno != EINTR && errno != EAGAIN) output_error = errno;
    if (n == 0) output_error = ENOSPC;
    if (n > 0) done += static_cast<std::size_t>(n);
  }
  return static_cast<ssize_t>(size);
}

void do_nothing(int /*signal*/) {}

}  // namespace

void guard_output() {
  // Not SIG_IGN, which children would inherit. A file that must not grow any more is an error, as a full disk
  // is.
  std::signal(SIGPIPE, do_nothing);
  std::signal(SIGXFSZ, do_nothing);
  if (::fcntl(STDOUT_FILENO, F_GETFD) < 0) {
    output_error = EBADF;
    ::open("/dev/null", O_WRONLY);  // takes the place, so that no file that is opened later does
  }
  const cookie_io_functions_t functions{nullptr, write_output, nullptr, nullptr};
  std::FILE* const guarded = ::fopencookie(nullptr, "w", functions);
  if (guarded == nullptr) return;
  std::setvbuf(guarded, nullptr, ::isatty(STDOUT_FILENO) != 0 ? _IOLBF : _IOFBF, BUFSIZ);
  stdout = guarded;
  // Never destroyed: what is left in it is written when everything else has gone.
  static auto* const kBuffer = new __gnu_cxx::stdio_sync_filebuf<char>(guarded);
  std::cout.rdbuf(kBuffer);
}

bool write_output_now(std::string_view bytes) {
  std::fwrite(bytes.data(), 1, bytes.size(), stdout);
  std::fflush(stdout);
  return output_error == 0;
}

int output_status(int status) {
  std::cout.flush();
  std::fflush(nullptr);
  if (output_error == 0 && !std::cout.good()) output_error = EIO;
  if (output_error == 0) return status;
  if (output_error != EPIPE)
    fmt::print(stderr, "mlab: standard output could not be written: {}\n",
               std::generic_category().message(output_error));
  return status == kDone ? kFailed : status;
}

}  // namespace mlab::cli
