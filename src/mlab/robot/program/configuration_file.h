#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mlab/flow/library.h"
#include "mlab/flow/program.h"
#include "mlab/lang/cdl/configuration.h"
#include "mlab/lang/cdl/lower/lower.h"
#include "mlab/robot/program/robot_program.h"
#include "mlab/text/diagnostic.h"

namespace mlab::robot {

/// What every configuration knows without `use`: the component library's. Read once.
const cdl::Environment& library_environment();
/// The component library as a configuration by itself.
const cdl::Configuration& library_configuration();

/// Whether a robot program's name means a configuration: `forager.cdl`, `forager.cdl#Forager`.
bool names_configuration(std::string_view program);

/// Says who belongs to the society that a mission names at `place` as a robot's program: the programs of its
/// robots, with how many there are of each. `forager.cdl#Foragers` is `forager.cdl#Scout` and
/// `forager.cdl#Carrier`, three times each.
/// @return  nothing where it names no society: a robot, or something that is no configuration
/// @errors  what keeps the configuration from being read; `unknown-robot`
using SocietyReader = std::function<std::optional<std::vector<std::pair<std::string, int>>>(
    const std::string& program, const text::Place& place, text::Diagnostics& sink)>;
SocietyReader society_reader(ProgramSources sources);

/// A robot of a configuration, made flat and built.
struct ConfiguredRobot {
  cdl::Configuration configuration;
  std::string robot;  ///< its name there
  cdl::LoweredRobot lowered;
  BuiltProgram built;
};

/// Reads a configuration and builds the program of one of its robots. Procedures that it brings are compiled,
/// and run in a process of their own.
///
/// @param name       as the mission writes it at `place`: a file relative to the mission's folder, perhaps
/// with
///                   `#ROBOT`
/// @param type_name  of the mission's NEW-ROBOT, which may be the robot's name
/// @return  nothing where there were errors
std::optional<ConfiguredRobot> load_configuration(const std::string& name, std::string_view type_name,
                                                  const text::Place& place, const ProgramSources& sources,
                                                  text::Diagnostics& sink);

/// The same for a text that is there already; `wanted` is what would stand behind `#`.
std::optional<ConfiguredRobot> configure(const text::SourcePtr& source, std::string_view wanted,
                                         std::string_view type_name, const text::Place& place,
                                         const ProgramSources& sources, text::Diagnostics& sink);

/// A robot of the component library, which the mission names at `place`.
/// @return  nothing where there is none of that name, or there were errors
std::optional<ConfiguredRobot> library_robot(std::string_view name, const text::Place& place,
                                             const ProgramSources& sources, text::Diagnostics& sink);

/// Checks a configuration as `mlab check` does: all of its declarations, and the C++ of its procedures.
/// Nothing of it is run.
void check_configuration(const text::SourcePtr& source, const ProgramSources& sources,
                         text::Diagnostics& sink);

}  // namespace mlab::robot
