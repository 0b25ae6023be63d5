#pragma once

#ifdef MLAB_SANITIZE_THREAD
#include <sanitizer/tsan_interface.h>
#endif

namespace mlab::dds {

// Cyclone's own locks see to it that a listener sees what was written before it was handed over, and that who
// has deleted a reader or writer sees what its listener did. The thread sanitizer does not see those locks,
// and is told here.

/// Before a listener is handed to Cyclone, and at the end of each of its calls.
inline void hand_over([[maybe_unused]] void* state) {
#ifdef MLAB_SANITIZE_THREAD
  __tsan_release(state);
#endif
}

/// At the begin of each call of a listener, and once it is called no more.
inline void take_over([[maybe_unused]] void* state) {
#ifdef MLAB_SANITIZE_THREAD
  __tsan_acquire(state);
#endif
}

/// A call of a listener.
class ListenerCall {
 public:
  explicit ListenerCall(void* state) : state_(state) { take_over(state_); }
  ListenerCall(const ListenerCall&) = delete;
  ListenerCall& operator=(const ListenerCall&) = delete;
  ~ListenerCall() { hand_over(state_); }

 private:
  void* state_;
};

}  // namespace mlab::dds
