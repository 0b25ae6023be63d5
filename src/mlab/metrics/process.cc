#include "mlab/metrics/process.h"

#include <unistd.h>

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <system_error>

namespace mlab::metrics {
namespace {

double seconds_of(clockid_t clock) {
  std::timespec time{};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

void tell_memory(Exposition& out) {
  std::ifstream file("/proc/self/statm");  // in pages
  double virtual_pages = 0.0;
  double resident_pages = 0.0;
  if (!(file >> virtual_pages >> resident_pages)) return;
  const auto page = static_cast<double>(::sysconf(_SC_PAGESIZE));
  out.gauge("process_virtual_memory_bytes", "Virtual memory size in bytes.", virtual_pages * page);
  out.gauge("process_resident_memory_bytes", "Resident memory size in bytes.", resident_pages * page);
}

void tell_descriptors(Exposition& out) {
  std::error_code error;
  std::filesystem::directory_iterator entry("/proc/self/fd", error);
  double count = -1.0;  // without the folder's own
  for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) ++count;
  if (!error) out.gauge("process_open_fds", "Number of open file descriptors.", count);
}

// Field 22 of /proc/self/stat, in ticks since the machine started; what stands before the last parenthesis is
// a name.
void tell_start(Exposition& out) {
  std::ifstream file("/proc/self/stat");
  std::string line;
  std::getline(file, line);
  std::istringstream rest(line.substr(std::min(line.rfind(')') + 1, line.size())));
  constexpr int kBefore = 19;  // fields between the name and that one
  std::string skipped;
  for (int i = 0; i < kBefore; ++i) rest >> skipped;
  double ticks = 0.0;
  if (!(rest >> ticks)) return;
  const double machine_started = seconds_of(CLOCK_REALTIME) - seconds_of(CLOCK_BOOTTIME);
  out.gauge("process_start_time_seconds", "Start time of the process since unix epoch in seconds.",
            machine_started + ticks / static_cast<double>(::sysconf(_SC_CLK_TCK)));
}

}  // namespace

void tell_process(Exposition& out) {
  out.counter("process_cpu_seconds_total", "Total user and system CPU time spent in seconds.",
              seconds_of(CLOCK_PROCESS_CPUTIME_ID));
  tell_memory(out);
  tell_descriptors(out);
  tell_start(out);
}

}  // namespace mlab::metrics
