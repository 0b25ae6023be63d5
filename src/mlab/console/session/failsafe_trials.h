#pragma once

#include "mlab/console/session/request.h"
#include "mlab/console/session/run_control.h"
#include "mlab/console/session/work_share.h"

namespace mlab::console {

/// What people ask of failsafes beside what a run shows of them. The run stays as it is.
class FailsafeTrials {
 public:
  explicit FailsafeTrials(RunControl& run) : run_(run) {}

  /// What they would do under conditions that somebody sets. Refused where so much of it is asked for that
  /// the run, and the emergency stop, would wait.
  Answered try_out(const TryFailsafes& asked, Reply& reply);

 private:
  Answered answer(const TryFailsafes& asked, Reply& reply);

  RunControl& run_;
  WorkShare share_{0.2, std::chrono::milliseconds(100)};
};

}  // namespace mlab::console
