#pragma once

#include <deque>
#include <span>
#include <vector>

#include "mlab/flow/library.h"
#include "mlab/flow/network.h"
#include "mlab/robot/wire/shared_cycle.h"

namespace mlab::robot_process {

/// Says in the shared Control whose code runs while a procedure that was brought fires, and that memory ran
/// out, so that the run can tell a person which one it was that never came back, and why. There is one in a
/// process.
class TracedLibrary {
 public:
  /// Adds the behaviors to the library, traced. They replace others of the same names.
  void add(std::span<const flow::Behavior* const> behaviors, flow::Library& library);
  /// Begins to tell, for the nodes of this network.
  void trace(const flow::Network& network, const flow::Library& library, robot_wire::Control& control);

  const std::deque<flow::Behavior>& behaviors() const { return behaviors_; }

 private:
  std::deque<flow::Behavior> behaviors_;          ///< descriptors that fire through the trace
  std::vector<const flow::Behavior*> originals_;  ///< by index of these
};

}  // namespace mlab::robot_process
