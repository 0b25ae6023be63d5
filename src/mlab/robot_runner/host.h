#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "mlab/flow/library.h"
#include "mlab/flow/program.h"
#include "mlab/robot.pb.h"
#include "mlab/robot_process/speaker.h"
#include "mlab/robot_process/traced_library.h"

namespace mlab::robot_runner {

/// Runs networks whose procedures a mission or configuration brought: loads the compiled procedures into this
/// process, builds the network's program, and computes the cycles that the run shares.
class Host : public robot_process::Speaker {
 public:
  /// @param components  the component library
  /// @param version     of this missionlab
  Host(flow::Library components, std::string version);

  const wire::FromRobot& answer(std::string_view bytes) override;
  robot_process::SharedFiles* shared() override { return shared_ ? &*shared_ : nullptr; }
  const flow::Program& program() const override { return *program_; }

 private:
  void answer(const wire::Hello& hello);
  void answer(const wire::Load& load);
  void answer(const wire::Share& share);
  void refuse(std::string why);
  bool open_libraries(const wire::Load& load);

  flow::Library library_;
  std::string version_;
  robot_process::TracedLibrary brought_;
  flow::Network network_;
  std::shared_ptr<const flow::Program> program_;
  std::optional<robot_process::SharedFiles> shared_;
  wire::ToRobot message_;
  wire::FromRobot answer_;
};

}  // namespace mlab::robot_runner
