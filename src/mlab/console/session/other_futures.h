#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "mlab/console/inbox.h"
#include "mlab/console/past/other_run.h"
#include "mlab/console/session.h"
#include "mlab/console/session/look_backs.h"
#include "mlab/console/session/people.h"

namespace mlab::console {

/// How runs would have gone on with something else: one for each client that has asked, and for all the
/// recording that the one on the line is compared with. They are computed in pieces on the thread of the
/// look-backs. Belongs to the session's thread.
class OtherFutures {
 public:
  /// What it works with; all of it outlives it.
  struct Parts {
    const SessionSettings& settings;
    LookBacks& look_backs;
    const RunControl& run;
    People& people;
    Inbox& inbox;
  };
  explicit OtherFutures(const Parts& parts) : parts_(parts) {}
  ~OtherFutures() { end(); }
  OtherFutures(const OtherFutures&) = delete;
  OtherFutures& operator=(const OtherFutures&) = delete;
  /// Before the look-backs end.
  void end();

  /// The recording that was opened is compared with another one.
  void compare(const OpenRecording& with);

  // ---- what is asked; answers come later

  Answered read_changeable(const Sender& sender, const ReadChangeable& asked, const Reply& reply);
  Answered what_if(const Sender& sender, const WhatIf& asked, const Reply& reply);
  Answered save(const Sender& sender, const SaveFuture& asked, const Reply& reply);

  Answered forget_future(const Sender& sender, const ForgetFuture& asked);
  /// Somebody has come.
  void begin(ConnectionId connection);
  void forget(ConnectionId connection);
  /// Called when another run may have begun: futures of the one before go.
  void follow_run();

 private:
  /// For the look-backs' thread, but for what is atomic.
  struct One {
    std::atomic<bool> is_dropped = false;
    std::unique_ptr<OtherRun> run;
    OtherFuture told;  // of the session's thread
  };
  using OnePtr = std::shared_ptr<One>;

  void begin(ConnectionId to, const OnePtr& one, std::uint64_t run);
  void keep_on(ConnectionId to, const OnePtr& one);
  void take(ConnectionId to, const OnePtr& one, OtherFuture told);
  void tell(ConnectionId to, const OtherFuture& future) const;
  /// Those that have none of their own.
  void tell_compared() const;
  static void drop(OnePtr& one);

  const Parts parts_;
  std::map<ConnectionId, OnePtr> futures_;
  OnePtr compared_;
  std::uint64_t known_run_ = 0;
};

}  // namespace mlab::console
