#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "mlab/console.pb.h"
#include "mlab/console/run/estimates.h"
#include "mlab/run/mission_run.h"

namespace mlab::console {

/// Where a run stands, as one word.
Status::Mode mode_of(const run::MissionRun& run);

/// Everything of Status that the run and its mission know: mode, time, steps, what is waited for. At most the
/// last kMostSteps of the steps that were started.
void encode_run(const run::MissionRun& run, const Estimates& estimates, Status& out);
inline constexpr std::size_t kMostSteps = 500;

/// How people want the display to be: options that are on, as MDL names them, and how much is in sight.
void encode_options(const mission::Options& options, Status& out);

/// Questions that are open, oldest first.
/// @param asked  when a question was asked [s], by its id
void encode_questions(const mission::State& state, const std::map<std::uint32_t, double>& asked,
                      const std::map<std::uint32_t, std::string>& texts, Questions& out);

/// The mission clock at a run time, ISO 8601 without zone.
std::string clock_time(const mission::ExecutiveOptions& options, double run_time);

}  // namespace mlab::console
