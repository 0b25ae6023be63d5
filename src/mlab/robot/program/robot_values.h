#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/base/id.h"
#include "mlab/flow/carry_over.h"
#include "mlab/flow/frame.h"
#include "mlab/percept/action.h"
#include "mlab/robot/program/program_runner.h"
#include "mlab/robot/program/robot_memory.h"
#include "mlab/robot/program/robot_program.h"

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
  Workings workings() const { return {program_->program.get(), frame_.data(), interventions_.get()}; }
  /// For the coming cycle; null: there are none. `finish` says that it is over.
  flow::Interventions* interventions() { return interventions_.get(); }
  void finish();

  void start();
  std::optional<std::string> set(std::string_view port, const std::string& value);
  std::optional<std::string> force(std::string_view sequence, std::string_view state);
  std::optional<std::string> hold(std::string_view port, std::string_view value);
  std::optional<std::string> release(std::string_view port);
  bool take_over(const RobotProgram& after);
  /// Goes on as another program, with what of the values before it can go on with.
  /// @return  what begins anew
  std::vector<flow::Restart> go_on_from(const RobotValues& before);
  bool restore(const flow::Frame& frame);
  RobotMemory memory() const;
  void remember(const RobotMemory& memory);
  /// Values that somebody else has computed on, which fit the program.
  void adopt(std::span<const std::byte> frame, const flow::Interventions* interventions);
  /// Where an action that is no number comes from: path of a port, or words where all ports are sound.
  std::string find_fault() const;

 private:
  void set_again(const RobotValues& before, std::vector<flow::Restart>& restarts);

  base::RobotId robot_;
  const RobotProgram* program_ = nullptr;
  flow::Frame frame_;
  std::unique_ptr<flow::Interventions> interventions_;  // null: none, as with most robots
  std::map<std::uint32_t, std::string> set_;  // by a person, as written, by index of the program's ports
  bool has_started_ = false;
};

}  // namespace mlab::robot
