#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mlab/flow/frame.h"
#include "mlab/flow/program.h"
#include "mlab/robot.pb.h"
#include "mlab/robot/process/speaker.h"
#include "mlab/robot/wire/percepts_wire.h"

namespace mlab::robot_process {

/// One side of the conversation between a run and a robot program: answers, and keeps the robots' values.
class Conversation : public Speaker {
 public:
  /// @param version  of the missionlab that the executable was made with
  /// @param body     what the configuration says of the body, in SI units
  Conversation(const std::shared_ptr<const flow::Program>& program, std::string version,
               std::map<std::string, double> body = {});

  const flow::Program* program() const override { return program_.get(); }

 protected:
  void answer_other(const wire::ToRobot& message) override;
  /// What the configuration says of the body, in SI units.
  const std::map<std::string, double>& body() const { return body_; }

 private:
  struct Robot {
    flow::Frame frame;
    std::uint64_t seed = 0;
  };

  void describe(const wire::Describe& message);
  void start(const wire::Start& message);
  void act(const wire::Cycle& cycle);
  void set(const wire::Set& message);
  void read_ports(const wire::ReadPorts& read);
  Robot* find(std::uint32_t id);
  std::optional<std::string> check(const wire::Cycle& cycle);
  void act(std::uint32_t robot, const percept::Percepts& percepts, wire::RobotActed& out);

  std::shared_ptr<const flow::Program> program_;
  std::map<std::string, double> body_;
  std::map<std::uint32_t, Robot> robots_;
  std::vector<std::unique_ptr<robot_wire::DecodedPercepts>> decoded_;  // of the cycle, by place in it
};

}  // namespace mlab::robot_process
