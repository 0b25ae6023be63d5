#pragma once

#include <cstdint>
#include <expected>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/cell/permission.h"
#include "mlab/flow/frame.h"
#include "mlab/flow/library.h"
#include "mlab/flow/program.h"
#include "mlab/robot/host/limits.h"
#include "mlab/robot/program/places.h"
#include "mlab/text/diagnostic.h"
#include "mlab/text/files.h"

namespace mlab::robot_host {
struct HostedProgram;
}

namespace mlab::robot {

/// A parameter of a robot type, as the mission sets it.
struct Setting {
  std::string key;
  std::string value;
  text::Place place;  ///< of the key
  text::Place value_place;
  bool is_preset = false;  ///< of programs that have it; others are not told
};

struct NativeProgram;

/// The texts that a program was built from, so that it can be built elsewhere.
struct ProgramOrigin {
  std::string folder;                  ///< as ProgramSources::folder
  std::vector<text::SourcePtr> texts;  ///< all that were read
};

/// The executable that a program is in, one that `mlab build` made: what tells it from others on any machine.
struct ExecutableOrigin {
  std::string name;          ///< of its file, for people
  std::uint64_t source = 0;  ///< hash of all that it was made from
};

/// A parameter that is a named place of the mission, where the mission does not set it.
struct PlaceParameter {
  std::string path;   ///< of the parameter
  std::string name;   ///< of the place
  text::Place place;  ///< where the configuration names it; nowhere: an executable told of it
};

/// Of a network's parameters those that are named places.
std::vector<PlaceParameter> places_of(const flow::Network& network);

/// A network made ready to run.
struct BuiltProgram {
  std::shared_ptr<const flow::Program> program;
  /// Not null: some of its behaviors are brought along, so a process of its own steps it; `program` is what
  /// reads and sets its frames here.
  std::shared_ptr<const robot_host::HostedProgram> hosted;
  /// Some of its behaviors are brought along, and nothing may run them: it was only to be checked.
  bool is_described_only = false;
};

/// A program of which only is known what it answered in a run that was recorded, cycle by cycle: it is in an
/// executable, which is not started.
struct RecordedProgram {
  std::uint64_t build = 0;                             ///< where it is the same, so is the program
  bool is_open = false;                                ///< in that run its values could be seen
  bool reports = true;                                 ///< as RobotProgram::Tells
  std::map<std::string, double, std::less<>> numbers;  ///< of parameters, before the first cycle, in SI units
  std::map<std::string, double> body;                  ///< as RobotProgram
};

/// The program of one robot type, with the type's parameters set. Shared by all robots of the type.
struct RobotProgram {
  std::string name;  ///< as the mission writes it
  std::shared_ptr<const flow::Program> program =
      nullptr;  ///< null: nothing here answers to the name; such a robot stands parked
  /// As BuiltProgram::hosted.
  std::shared_ptr<const robot_host::HostedProgram> hosted = nullptr;
  bool is_described_only = false;  ///< as BuiltProgram
  flow::Frame initial = {};        ///< values before the first cycle
  std::string type = {};           ///< the robot type that it was built for
  std::map<std::string, double> body =
      {};  ///< what a configuration says of the body: `radius`, ... in SI units
  std::shared_ptr<const NativeProgram> native = nullptr;  ///< runs in processes of its own; then no `program`

  std::shared_ptr<const RecordedProgram> recorded = nullptr;  ///< not null: neither `program` nor `native`

  std::shared_ptr<const ProgramOrigin> origin = nullptr;  ///< null: it is in an executable
  std::optional<ExecutableOrigin> executable = {};  ///< nothing: it is in none, or in one that is closed
  std::string host = {};       ///< machine whose agent may carry such robots, as the mission says; empty: any
  bool is_of_vehicle = false;  ///< that host is a vehicle, which is its robot's body: it is computed here

  std::vector<PlaceParameter> places = {};  ///< what `place("Gate")` of a configuration became
  bool is_own = false;                      ///< of a network or configuration that the mission names

  /// What can be known of it without running it: false where nothing in it ever does so.
  struct Tells {
    bool reports = true;  ///< says how far the robot is with an order
    bool shares = true;   ///< shares with the others of its unit what is ordered to all of them
  };
  Tells tells = {};

  /// Somebody answers to the name.
  bool can_run() const { return program != nullptr || native != nullptr || recorded != nullptr; }
  /// What it computes is in nobody's text.
  bool is_in_executable() const { return native != nullptr || executable || recorded != nullptr; }
  /// It is in an executable that keeps its values to itself.
  bool is_closed() const { return native != nullptr || (recorded != nullptr && !recorded->is_open); }
  /// The vehicle that is its robot's body; empty: none is.
  std::string vehicle() const { return is_of_vehicle ? host : std::string(); }
  /// It can be built and computed on another machine.
  bool can_be_elsewhere() const {
    return !is_of_vehicle && program != nullptr && (origin != nullptr || executable);
  }
  /// What a parameter or constant holds before the first cycle, in SI units; nothing where there is none of
  /// that path, or it is no number.
  std::optional<double> number(std::string_view path) const;
};

/// What finding a program may use.
struct ProgramSources {
  cell::Permission permission;  ///< whether code that files bring may be compiled, and run
  std::string folder = {};      ///< of the mission; relative names start here
  std::string include_root =
      {};  ///< where "mlab/schema/procedure.h" is found, for procedures of the mission's own
  std::string version = {};            ///< of this program: code compiled for another one is not used again
  const text::Files* files = nullptr;  ///< how configurations and networks are read; null: from disk
  bool checks_code = true;             ///< a check gives C++ of procedures to the compiler
  bool came_from_elsewhere =
      false;  ///< texts did: files of this machine that lie beside them by name are none of theirs
  bool in_own_processes = false;   ///< each robot is computed in a process of its own
  robot_host::Limits limits = {};  ///< of programs that run in processes of their own
  std::string project = {};        ///< folder that programs, and what they use, come from; empty: any
  const Places* places = nullptr;  ///< of the mission; null: there is none, and places lie anywhere
  std::stop_token ends = {};       ///< stops a C++ compiler that is at work: nobody waits for it any more
  std::string runner = {};         ///< the program `mlab-robots`; empty: the one beside this program
  /// Programs of which only is known what they answered, by name and type of robots; null where it is none of
  /// these. Empty: there are none.
  std::function<std::shared_ptr<const RecordedProgram>(const std::string& name, std::string_view type)>
      recorded = {};
  std::function<bool(const std::string& host)> is_vehicle = {};  ///< as run::RunSettings
};

/// Finds and builds the program of a robot type and sets its parameters.
///
/// A program is told by the last part of its name: `robot`, `mlab-2.0-robot` and `tmr_robot-1998` mean the
/// standard robot; `x.cnl` and `x.cdl` are compiled, and of a configuration `x.cdl#Robot` means one robot.
/// An executable is run only where the permission allows it. Everything else is a warning and gives a parked
/// robot. A parameter that the program does not have is a warning with the nearest name; one with a value
/// that it can't take is an error.
/// A parameter of type Point may be set to the name of a place, or to two coordinates, where `sources` knows
/// places; one that is a named place itself is where that is.
/// @errors  also `unknown-place`
/// @param name   as the mission writes it, at `place`
/// @param known_keys  parameter names that somebody else takes (the vehicle)
/// @param built  the one of that name, where it has been built before; it is not built again then
/// @param type   name of the robot type: of a configuration with several robots it means the one of that name
/// @return  nothing where there were errors
std::optional<RobotProgram> load_program(const std::string& name, const text::Place& place,
                                         std::span<const Setting> settings, const ProgramSources& sources,
                                         const std::vector<std::string>& known_keys, text::Diagnostics& sink,
                                         const RobotProgram* built = nullptr, std::string_view type = {});

/// The program of an executable that its owner wants robots computed with on this machine.
/// @param sources  whose permission allows executables to be started
/// @errors  what it is instead, as a sentence about it
std::expected<RobotProgram, std::string> load_offered(const std::string& path, const ProgramSources& sources);

/// How the files of programs are read: as `sources` says, and nothing outside of the project, by whatever
/// name or link.
/// @errors  `outside-project`
text::Files files_of(const ProgramSources& sources);

/// A file that a mission or its author names, relative to the folder of `sources`.
/// @errors  as `text::read_source`, at `place`
text::SourcePtr read_program(const std::string& path, const text::Place& place, const ProgramSources& sources,
                             text::Diagnostics& sink);

/// The component library: all behaviors that come with missionlab.
const flow::Library& component_library();

}  // namespace mlab::robot
