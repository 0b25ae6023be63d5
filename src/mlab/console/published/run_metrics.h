#pragma once

#include "mlab/console/run/live_run.h"
#include "mlab/metrics/exposition.h"

namespace mlab::console {

/// What a run tells a monitoring system of itself: time, steps, questions, the recording. What is counted
/// begins anew with each run.
void tell_run(const LiveRun& live, metrics::Exposition& out);
/// Its robots: how many are how, and of the first metrics::kMostSeries that are in the world what each has
/// met and how old is what it acts on; machines that carry them.
void tell_robots(const LiveRun& live, metrics::Exposition& out);

}  // namespace mlab::console
