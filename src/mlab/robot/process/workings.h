#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>

#include "mlab/flow/library.h"
#include "mlab/flow/network.h"
#include "mlab/flow/program.h"
#include "mlab/robot.pb.h"
#include "mlab/robot/process/traced_library.h"

namespace mlab::robot_process {

/// A network, the procedures that were brought for it, and the program that they make. There is one in a
/// process.
class Workings {
 public:
  /// @param components  the component library
  explicit Workings(flow::Library components) : components_(components), library_(std::move(components)) {}

  /// Procedures replace others of the same names.
  void add(std::span<const flow::Behavior* const> brought) { brought_.add(brought, library_); }
  /// @return  why the network can't be built; nothing: it is
  std::optional<std::string> build(flow::Network network);

  const flow::Network& network() const { return network_; }
  /// Null until it is built.
  const std::shared_ptr<const flow::Program>& program() const { return program_; }

  /// Says from now on in `control` whose code runs.
  void trace(robot_wire::Control& control) { brought_.trace(network_, library_, control); }
  /// What only compiled code knows, and the program that was built.
  void describe(wire::Loaded& out) const;

 private:
  flow::Library components_;
  flow::Library library_;
  TracedLibrary brought_;
  flow::Network network_;
  std::shared_ptr<const flow::Program> program_;
};

}  // namespace mlab::robot_process
