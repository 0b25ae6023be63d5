#pragma once

#include <cstdint>
#include <string>

#include "mlab/run/mission_run.h"

namespace mlab::run {

/// What the run cost; the only part of a report that differs from run to run.
struct Performance {
  double wall_seconds = 0.0;
  double cpu_seconds = 0.0;
  std::string started_at;     ///< wall clock, ISO 8601
  std::string mission_clock;  ///< what the mission's own clock showed at time 0
  std::string program_version;
};

/// How a run came to its end.
enum class RunEnd : std::uint8_t {
  kByItself,
  kInterrupted,  ///< from outside: the outcome of a mission that was not over is `interrupted`
  kTimeIsUp      ///< it was to go on for so long: that of a mission that was not over is `done`
};

/// The report of a run as JSON, indented, ending with a newline. docs/report.md describes the schema;
/// `version` counts its changes. For the same mission and seed everything but `performance` is the same, byte
/// for byte.
std::string report_json(const MissionRun& run, const Performance& performance, RunEnd end);

/// `done`, `failed`, `aborted`, `interrupted`, ...
std::string outcome_name(const MissionRun& run, RunEnd end);

}  // namespace mlab::run
