#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "mlab/base/id.h"
#include "mlab/flow/frame.h"
#include "mlab/percept/action.h"
#include "mlab/robot/program_runner.h"
#include "mlab/robot/robot_program.h"

namespace mlab::robot {

/// All values of a robot whose program was built in this process, wherever it is computed: what ProgramRunner
/// says of them.
class RobotValues {
 public:
  RobotValues() = default;
  /// @param program  outlives this
  RobotValues(base::RobotId robot, const RobotProgram& program)
      : robot_(robot), program_(&program), frame_(program.initial) {}

  base::RobotId robot() const { return robot_; }
  const RobotProgram& robot_program() const { return *program_; }
  const flow::Program& program() const { return *program_->program; }
  std::byte* frame() { return frame_.data(); }
  const flow::Frame& saved() const { return frame_; }
  Workings workings() const { return {program_->program.get(), frame_.data()}; }

  void start();
  std::optional<std::string> set(std::string_view port, const std::string& value);
  bool take_over(const RobotProgram& after);
  bool restore(const flow::Frame& frame);
  /// Where an action that is no number comes from: path of a port, or words where all ports are sound.
  std::string find_fault() const;

 private:
  base::RobotId robot_;
  const RobotProgram* program_ = nullptr;
  flow::Frame frame_;
  std::map<std::uint32_t, std::string> set_;  // by a person, as written, by index of the program's ports
  bool has_started_ = false;
};

}  // namespace mlab::robot
