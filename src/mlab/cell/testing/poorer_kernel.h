#pragma once

#include <seccomp.h>
#include <sys/prctl.h>

#include <cerrno>
#include <cstdint>
#include <initializer_list>

/// A kernel that has less to offer, for this process and what it starts.
namespace mlab::cell::testing {

inline void refuse(std::initializer_list<int> calls, int why) {
  prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ALLOW);
  for (const int call : calls)
    seccomp_rule_add(filter, SCMP_ACT_ERRNO(static_cast<std::uint32_t>(why)), call, 0);
  seccomp_load(filter);
  seccomp_release(filter);
}

inline void have_no_landlock() {
  refuse({444, 445, 446}, ENOSYS);
}

inline void have_no_namespaces() {
  refuse({SCMP_SYS(unshare), SCMP_SYS(setns), SCMP_SYS(mount), SCMP_SYS(pivot_root)}, EPERM);
}

}  // namespace mlab::cell::testing
