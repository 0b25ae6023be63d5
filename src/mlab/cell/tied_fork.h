#pragma once

#include <sys/types.h>

#include <functional>

namespace mlab::cell {

/// As fork(2), for a child that must not outlive this process: the kernel kills it as soon as this process is
/// gone, however it went, and a program in a cell can't change that. The kernel means the *thread* that
/// forked, so all such children are forked by one thread, which goes on until the process ends.
///
/// @param in_child  becomes a program: safe between fork and exec, and never comes back
/// @return  as fork, -1 with errno; 0 never
pid_t tied_fork(const std::function<void()>& in_child);

}  // namespace mlab::cell
