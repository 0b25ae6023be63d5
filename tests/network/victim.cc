#include "victim.h"

#include <poll.h>

#include <cstdlib>
#include <fstream>
#include <utility>

#include "pidfd.h"

namespace mlab::network {

Victim::Victim(std::string name, Descriptor pidfd)
    : name_(std::move(name)),
      pidfd_(std::make_shared<const Descriptor>(std::move(pidfd))),
      id_(process_of(*pidfd_)) {}

Victim::Victim(const Seen& process) : Victim(process.name, open_pidfd(process.id)) {}

bool Victim::is_alive() const {
  if (!pidfd_ || !pidfd_->is_open()) return false;
  pollfd ended{pidfd_->number(), POLLIN, 0};
  return ::poll(&ended, 1, 0) == 0;
}

bool Victim::signal(int number) const {
  return pidfd_ && pidfd_->is_open() && signal_by(*pidfd_, number);
}

pid_t process_of(const Descriptor& pidfd) {
  if (!pidfd.is_open()) return -1;
  std::ifstream file("/proc/self/fdinfo/" + std::to_string(pidfd.number()));
  constexpr std::string_view kLine = "Pid:";
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with(kLine)) return std::atoi(line.c_str() + kLine.size());
  }
  return -1;
}

}  // namespace mlab::network
