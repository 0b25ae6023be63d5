#pragma once

#include <memory>
#include <optional>
#include <string>

#include "mlab/flow/network.h"
#include "mlab/flow/program.h"
#include "mlab/lang/cnl/tree.h"
#include "mlab/robot/program/robot_program.h"
#include "mlab/text/diagnostic.h"

namespace mlab::robot {

/// A CNL file whose network was built.
struct NetworkFile {
  std::shared_ptr<const cnl::Tree> tree;
  flow::Network network;
  BuiltProgram built;
};

/// Builds the program of a robot that is written in CNL. Procedures that the file brings itself are compiled,
/// and run in a process of their own.
///
/// @param path   as the mission writes it at `place`; relative to the mission's folder
/// @return  nothing where there were errors
std::optional<NetworkFile> read_network(const std::string& path, const text::Place& place,
                                        const ProgramSources& sources, text::Diagnostics& sink);

/// Checks a CNL file as `mlab check` does: declarations, the C++ of its procedures, and its network where it
/// has one.
void check_network(const text::SourcePtr& source, const ProgramSources& sources, text::Diagnostics& sink);

}  // namespace mlab::robot
