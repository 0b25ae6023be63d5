#pragma once

#include <cstdint>
#include <initializer_list>
#include <span>

#include "mlab/robot/process/wiring.h"

namespace mlab::flow {
struct Behavior;
}

namespace mlab::robot_process {

/// A file of procedures in CNL, with blanks where its C++ stood (cnl::declarations_of).
struct DeclarationsText {
  const char* file;
  const char* text;
};

using BehaviorList = std::span<const flow::Behavior* const> (*)();

/// A robot program as generated C++ describes it.
struct RobotProgramText {
  const char* name;
  const char* version;  ///< of the missionlab that generated it
  WiringFunction parameters;
  std::initializer_list<WiringFunction> groups;  ///< nodes that were compiled together
  struct Run {
    std::uint32_t group;
    std::uint32_t count;  ///< so many of its next nodes
  };
  std::initializer_list<Run> order;             ///< of all nodes
  BehaviorList components;                      ///< the component library
  std::initializer_list<BehaviorList> brought;  ///< procedures besides, later ones in place of earlier ones
  std::initializer_list<DeclarationsText> declarations;  ///< of these
  bool is_closed;                                        ///< does not reveal how it is made
  struct BodySetting {
    const char* name;
    double value;  ///< [SI units]
  };
  std::initializer_list<BodySetting> body;
  std::initializer_list<std::uint64_t> sources;  ///< hashes of all that it was made from, the same on every
                                                 ///< machine: of this text, and of the files in their order
  const char* agent;  ///< path of `mlab-agent` where it was made; empty: it is to be looked for
};

/// The `main` of a robot executable: builds the program, and serves it on standard input and output. With
/// `--fleet` it becomes an agent of that fleet, which carries robots of this program.
/// @return  the exit status: 0 when its input has ended; 1 where that was in the middle of something; 2 where
///          it was called wrongly, or the program can't be built
int robot_main(int argc, char** argv, const RobotProgramText& text);

}  // namespace mlab::robot_process
