#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "mlab/robot.pb.h"
#include "mlab/robot/host/robot_program_process.h"
#include "mlab/robot/program/members.h"
#include "mlab/robot/program/program_runner.h"

namespace mlab::robot {

/// Executables that were made by somebody else: they are told percepts and answer with actions, and keep
/// their robots' values to themselves. All robots of one executable share a few processes.
class ExecutableRunner final : public ProgramRunner {
 public:
  /// @param most  processes for each executable, >= 1
  ExecutableRunner(std::uint64_t seed, int most) : seed_(seed), most_(most) {}

  Member add(base::RobotId robot, const RobotProgram& program) override;
  void remove(Member member) override { members_.remove(member); }
  std::optional<std::string> start(Member member) override;
  std::optional<std::string> set(Member member, std::string_view port, const std::string& value) override;
  std::optional<std::string> force(Member /*member*/, std::string_view /*sequence*/,
                                   std::string_view /*state*/) override {
    return kElsewhere;
  }
  std::optional<std::string> hold(Member /*member*/, std::string_view /*port*/,
                                  std::string_view /*value*/) override {
    return kElsewhere;
  }
  std::optional<std::string> release(Member /*member*/, std::string_view /*port*/) override {
    return kElsewhere;
  }
  bool take_over(Member member, const RobotProgram& after, bool is_running) override;
  void open() override;
  void needs(std::span<const Member> members, std::span<percept::Needs> out) const override;
  void act(std::span<const Turn> turns) override;
  void ask() override;
  void wait(const Meanwhile& meanwhile) override;
  std::expected<Said, std::string> said(Member member) override;
  Workings workings(Member /*member*/) const override { return {}; }
  std::expected<RobotMemory, std::string> memory(Member /*member*/) const override {
    return std::unexpected(kElsewhere);
  }
  flow::Frame save(Member /*member*/) const override { return {}; }
  bool restore(Member /*member*/, const flow::Frame& /*frame*/) override { return false; }

 private:
  static constexpr const char* kElsewhere = "its program is an executable, which keeps its values to itself";
  static constexpr std::size_t kNoProcess = ~std::size_t{0};
  struct Process {
    std::string executable;
    std::optional<robot_host::RobotProgramProcess> running;
    wire::ToRobot cycle;
    std::vector<Member> joined;
    bool is_asked = false;
  };
  struct Robot {
    base::RobotId robot;
    const RobotProgram* program = nullptr;
    std::map<int, std::string> set;  // by a person, as written, by index of the description's ports
    std::size_t process = kNoProcess;
    int place = 0;  // in the cycle
    percept::Needs needs;
    Turn turn;
  };
  std::size_t process_for(const NativeProgram& native);
  std::optional<std::string> tell(Robot& robot, const std::string& port, const std::string& value);
  void take_answer(Process& process, const wire::Actions& actions);

  std::uint64_t seed_;
  int most_;
  std::vector<Process> processes_;
  Members<Robot> members_;
};

}  // namespace mlab::robot
