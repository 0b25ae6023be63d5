#include "mlab/cli/interrupt.h"

#include <time.h>
#include <unistd.h>

#include <csignal>

#include "mlab/cli/commands.h"
#include "mlab/cli/output.h"

namespace mlab::cli {
namespace {

volatile std::sig_atomic_t interrupts = 0;
timespec first_interrupt{};

void on_signal(int /*signal*/) {
  note_interrupt();
}

}  // namespace

bool was_interrupted() {
  return interrupts != 0;
}

// One key press can come as several signals: from the terminal, and from a program that stands between.
void note_interrupt() {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  if (interrupts == 0) first_interrupt = now;
  interrupts = 1;
  output_hurries = 1;
  const double seconds = static_cast<double>(now.tv_sec - first_interrupt.tv_sec) +
                         1e-9 * static_cast<double>(now.tv_nsec - first_interrupt.tv_nsec);
  if (seconds > 0.5) ::_exit(kFailed);
}

void note_interrupts() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    if (std::signal(signal, SIG_IGN) != SIG_IGN) std::signal(signal, on_signal);  // nohup ignores one
  }
}

}  // namespace mlab::cli
