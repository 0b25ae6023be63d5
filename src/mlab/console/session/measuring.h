#pragma once

#include <memory>
#include <mutex>
#include <string>

#include "mlab/console/run/event_log.h"
#include "mlab/console/session/people.h"
#include "mlab/console/session/run_control.h"
#include "mlab/metrics/exposition.h"

namespace mlab::console {

/// What the session tells a monitoring system. Its thread looks around now and then; whoever asks is told
/// what it saw last, and waits for nobody.
class Measuring {
 public:
  struct Parts {
    const People& people;
    const RunControl& run;
    const EventLog& log;
    const std::string& version;  ///< of mlab
  };
  explicit Measuring(const Parts& parts) : parts_(parts) {}

  /// Called by the session's thread, as often as it likes.
  void look();
  /// From any thread: what was seen last, and how long ago. Nothing before the first look.
  void tell(metrics::Exposition& out) const;

 private:
  struct Seen {
    double wall = 0.0;  // [s]
    metrics::Exposition told;
  };

  void tell_session(metrics::Exposition& out, double wall) const;

  const Parts parts_;
  double looked_ = -1e9;  // [s]
  mutable std::mutex mutex_;
  std::shared_ptr<const Seen> seen_;
};

}  // namespace mlab::console
