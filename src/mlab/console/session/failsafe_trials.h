#pragma once

#include "mlab/console/session/request.h"
#include "mlab/console/session/run_control.h"

namespace mlab::console {

/// What people ask of failsafes beside what a run shows of them. The run stays as it is.
class FailsafeTrials {
 public:
  explicit FailsafeTrials(RunControl& run) : run_(run) {}

  /// What they would do under conditions that somebody sets.
  Answered try_out(const TryFailsafes& asked, Reply& reply);

 private:
  RunControl& run_;
};

}  // namespace mlab::console
