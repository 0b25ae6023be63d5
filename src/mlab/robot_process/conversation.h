#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/flow/frame.h"
#include "mlab/flow/program.h"
#include "mlab/robot.pb.h"
#include "mlab/robot_process/speaker.h"
#include "mlab/robot_wire/percepts_wire.h"

namespace mlab::robot_process {

/// One side of the conversation between a run and a robot program: answers, and keeps the robots' values.
class Conversation : public Speaker {
 public:
  /// @param version  of the missionlab that the executable was made with
  /// @param body     what the configuration says of the body, in SI units
  Conversation(std::shared_ptr<const flow::Program> program, std::string version,
               std::map<std::string, double> body = {});

  /// The answer to one message, valid until the next call. Bytes that are no message, and messages that make
  /// no sense, are answered by a Problem and change nothing.
  const wire::FromRobot& answer(std::string_view bytes) override;
  SharedFiles* shared() override { return shared_ ? &*shared_ : nullptr; }
  const flow::Program& program() const override { return *program_; }

 private:
  struct Robot {
    flow::Frame frame;
    std::uint64_t seed = 0;
  };

  void answer(const wire::Hello& hello);
  void answer(const wire::Describe& describe);
  void answer(const wire::Start& start);
  void answer(const wire::Cycle& cycle);
  void answer(const wire::Set& set);
  void answer(const wire::ReadPorts& read);
  void answer(const wire::Share& share);
  void refuse(std::string why);
  Robot* find(std::uint32_t id);
  std::optional<std::string> check(const wire::Cycle& cycle);
  void act(std::uint32_t robot, const percept::Percepts& percepts, wire::RobotActed& out);

  std::shared_ptr<const flow::Program> program_;
  std::string version_;
  std::map<std::string, double> body_;
  std::map<std::uint32_t, Robot> robots_;
  std::optional<SharedFiles> shared_;
  wire::ToRobot message_;
  wire::FromRobot answer_;
  std::vector<std::unique_ptr<robot_wire::DecodedPercepts>> decoded_;  // of the cycle, by place in it
};

}  // namespace mlab::robot_process
