#pragma once

#include <cstddef>
#include <cstdint>
#include <expected>
#include <optional>
#include <string>
#include <vector>

#include "mlab/robot.pb.h"
#include "mlab/robot/host/robot_program_process.h"
#include "mlab/robot/host/shared_memory.h"

namespace mlab::robot_host {

/// A robot program in a process of its own whose frames its run sees.
struct HostedProgram {
  Launch launch;
  Limits limits;
  std::optional<wire::Load> load;  ///< what it is told to load; nothing: it has its network already
  bool is_for_one_robot = false;   ///< each of its robots has a process of its own
  std::uint64_t frame_layout = 0;  ///< flow::Program::layout_hash
  std::size_t frame_size = 0;      ///< [bytes]
  std::uint64_t source = 0;  ///< as RobotProgramProcess::source: nothing else is run in its place; 0: any
  /// By index of the network's nodes: whose code runs there (`procedure `Speed` at `steer``), for sentences
  /// about it; empty: code of ours.
  std::vector<std::string> codes;
};

struct StartedProgram {
  RobotProgramProcess process;
  wire::Loaded loaded;  ///< what it said of what it loaded
};

/// Starts the program, has it load what it is to, and share cycles.
/// @param memory  null: it is only asked what it loads
/// @errors  what it did instead
std::expected<StartedProgram, std::string> start_hosted(const HostedProgram& program,
                                                        const SharedMemory* memory);

}  // namespace mlab::robot_host
