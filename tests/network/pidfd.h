#pragma once

#include <sys/syscall.h>
#include <sys/types.h>
#include <unistd.h>

#include "descriptor.h"

namespace mlab::network {

// By system calls: the header of glibc 2.36 declares them as if they were C++.

/// Stands for this very process, even once it has ended. Not open: there is none.
inline Descriptor open_pidfd(pid_t process) {
  return Descriptor(static_cast<int>(::syscall(SYS_pidfd_open, process, 0)));
}

inline bool signal_by(const Descriptor& pidfd, int number) {
  return ::syscall(SYS_pidfd_send_signal, pidfd.number(), number, nullptr, 0) == 0;
}

}  // namespace mlab::network
