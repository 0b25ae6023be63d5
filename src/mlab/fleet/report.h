#pragma once

#include <string>

#include "mlab/fleet/mission_run.h"

namespace mlab::fleet {

/// What the run cost; the only part of a report that differs from run to run.
struct Performance {
  double wall_seconds = 0.0;
  double cpu_seconds = 0.0;
  std::string started_at;     ///< wall clock, ISO 8601
  std::string mission_clock;  ///< what the mission's own clock showed at time 0
  std::string program_version;
};

/// The report of a run as JSON, indented, ending with a newline. docs/report.md describes the schema;
/// `version` counts its changes. For the same mission and seed everything but `performance` is the same, byte
/// for byte.
/// @param interrupted  the run was ended from outside; its outcome is then `interrupted`
std::string report_json(const MissionRun& run, const Performance& performance, bool interrupted);

/// `done`, `failed`, `aborted`, `interrupted`, ...
std::string outcome_name(const MissionRun& run, bool interrupted);

}  // namespace mlab::fleet
