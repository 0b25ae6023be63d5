#pragma once

#include <cstdint>
#include <expected>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mlab/flow/network.h"
#include "mlab/robot/host/robot_program_process.h"
#include "mlab/robot/program/robot_program.h"

namespace mlab::robot {

/// A robot program in an executable, that runs in processes of its own.
struct NativeProgram {
  bool is_for_one_robot = false;  ///< each of its robots has a process of its own
  std::string executable;         ///< absolute path
  robot_host::Settings settings;  ///< of the robot type; every robot starts with them
  wire::Description description;  ///< with these settings
  robot_host::Launch launch;
  robot_host::Limits limits;

  /// Null where there is none of that path.
  const wire::Port* find(std::string_view path) const;
};

/// Whether the name means an executable file, relative to the mission's folder.
bool is_executable(const std::string& name, const ProgramSources& sources);

/// An executable that was made with the headers of this program: its program is built once more here.
struct RevealedProgram {
  BuiltProgram built;
  flow::Network network;
  std::map<std::string, double> body;  ///< as RobotProgram has it
  std::uint64_t source = 0;            ///< as ExecutableOrigin
};
/// Starts the executable of that name to ask how it is made.
/// @param wall  of its cell
/// @return  nothing where it was made otherwise; then there is `load_native_program`
/// @errors  a sentence that says what it did instead
std::expected<std::optional<RevealedProgram>, std::string> load_revealed_program(
    const std::string& name, cell::Wall wall, const ProgramSources& sources);

/// Says that an executable is no robot program, and what it did.
void refuse_executable(const std::string& name, const text::Place& place, const std::string& what,
                       text::Diagnostics& sink);

/// Starts the executable that `robot.name` means to ask what it is, and checks the type's settings.
/// @param wall  of its cell
/// @return  nothing where there were errors: `bad-robot-program` where it is no robot program, and those of
///          parameters
std::optional<RobotProgram> load_native_program(RobotProgram robot, const text::Place& place,
                                                std::span<const Setting> settings, cell::Wall wall,
                                                const ProgramSources& sources,
                                                const std::vector<std::string>& known_keys,
                                                text::Diagnostics& sink);

}  // namespace mlab::robot
