#pragma once

#include <memory>
#include <optional>
#include <string>

#include "mlab/agent.pb.h"
#include "mlab/flow/frame.h"
#include "mlab/flow/interventions.h"
#include "mlab/flow/program.h"

namespace mlab::robot_remote {

/// A robot's values as a message.
/// @param interventions  null: there are none
void encode(const std::byte* frame, std::size_t size, const flow::Interventions* interventions,
            wire::RobotState& out);

/// All values of a robot of some program.
struct State {
  flow::Frame frame;                                   ///< any bytes, as programs leave them
  std::unique_ptr<flow::Interventions> interventions;  ///< null: there are none
};
/// Values out of a message.
/// @errors  a sentence: they are none of this program's
std::expected<State, std::string> decode(const wire::RobotState& message, const flow::Program& program);

}  // namespace mlab::robot_remote
