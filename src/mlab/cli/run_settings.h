#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mlab/cell/permission.h"
#include "mlab/cli/clock.h"
#include "mlab/cli/commands.h"
#include "mlab/cli/places.h"
#include "mlab/console/machine_watch.h"
#include "mlab/lang/mdl/mdl.h"
#include "mlab/preflight/gate.h"
#include "mlab/robot/program/robot_program.h"
#include "mlab/run/mission_run.h"

namespace mlab::cli {

/// What `mlab run` says about how to run, whatever the mission.
struct RunManner {
  double speed = 0.0;  ///< simulated seconds per second; 0: as fast as it goes
  MissionClock clock;
  run::RunSettings settings;                        ///< all but the environment, which belongs to a mission
  std::shared_ptr<preflight::Gate> gate;            ///< before vehicles; null: the run has none
  std::shared_ptr<console::MachineWatch> machines;  ///< of its fleet; null: it has none
};

/// @param default_speed  where the options name none
/// @return nothing where an option can't be understood; it is then told on standard error
std::optional<RunManner> run_manner(const RunOptions& options, double default_speed);

/// The files that a run leaves behind.
std::vector<NamedFile> outputs_of(const RunOptions& options);
/// The files that a mission is made from: itself, overlays and what these name, configurations and
/// executables.
/// @param crew  with those that its configurations name; null: they are not known yet
std::vector<NamedFile> files_read_for(const mission::Mission& mission, const run::Crew* crew);

/// What the programs of the command line's mission are found with.
robot::ProgramSources mission_sources(const RunOptions& options, const cell::Permission& permission);
/// What its text is read with.
mdl::LoadOptions load_options(const RunOptions& options, robot::ProgramSources sources);
/// What a person at the terminal is told of it: all but notes of what these options have settled.
text::Diagnostics told_of_run(const text::Diagnostics& all, const RunOptions& options);
/// What --set says; nothing where one of them can't be understood, which is told on standard error.
std::optional<std::vector<mdl::Setting>> settings_of(const RunOptions& options);

/// Tells on standard error what is wrong with the command line.
/// @return kBadInput
int usage_error(const std::string& message);

/// Writes what a run has left behind, and says where. False where that fails, which is told as well.
/// @param command  that does so: `mlab run`
bool deliver(const char* command, const char* what, const std::string& file, const std::string& text);

}  // namespace mlab::cli
