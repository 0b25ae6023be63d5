#pragma once

#include <string>

#include "mlab/flow/library.h"
#include "mlab/flow/program.h"
#include "mlab/robot.pb.h"
#include "mlab/robot/process/speaker.h"
#include "mlab/robot/process/workings.h"

namespace mlab::robot_runner {

/// Runs networks whose procedures a mission or configuration brought: loads the compiled procedures into this
/// process, builds the network's program, and computes the cycles that the run shares.
class Host : public robot_process::Speaker {
 public:
  /// @param components  the component library
  /// @param version     of this missionlab
  Host(flow::Library components, std::string version);

  const flow::Program* program() const override { return workings_.program().get(); }

 private:
  void answer_other(const wire::ToRobot& message) override;
  void begin_sharing(robot_wire::Control& control) override;
  void load(const wire::Load& load);
  bool open_libraries(const wire::Load& load);

  robot_process::Workings workings_;
};

}  // namespace mlab::robot_runner
