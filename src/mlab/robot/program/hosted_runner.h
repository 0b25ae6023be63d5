#pragma once

#include <memory>
#include <vector>

#include "mlab/robot/host/hosted_cycle.h"
#include "mlab/robot/program/members.h"
#include "mlab/robot/program/program_runner.h"
#include "mlab/robot/program/robot_values.h"

namespace mlab::robot {

/// Programs some of whose behaviors are brought along: processes in cells compute them, and their robots'
/// values are here, handed in and taken back in each cycle. All robots of one program share a few processes,
/// which compute a cycle side by side.
class HostedRunner final : public ProgramRunner {
 public:
  /// @param most  processes for each program, >= 1
  HostedRunner(std::uint64_t seed, int most) : seed_(seed), most_(most) {}

  Member add(base::RobotId robot, const RobotProgram& program) override {
    return members_.add({{robot, program}, kNoProcess, 0, {}});
  }
  void remove(Member member) override;
  std::optional<std::string> start(Member member) override;
  std::optional<std::string> set(Member member, std::string_view port, const std::string& value) override {
    return members_[member].values.set(port, value);
  }
  std::optional<std::string> force(Member member, std::string_view sequence,
                                   std::string_view state) override {
    return members_[member].values.force(sequence, state);
  }
  std::optional<std::string> hold(Member member, std::string_view port, std::string_view value) override {
    return members_[member].values.hold(port, value);
  }
  std::optional<std::string> release(Member member, std::string_view port) override {
    return members_[member].values.release(port);
  }
  std::expected<Said, std::string> said(Member member) override;
  bool take_over(Member member, const RobotProgram& after, bool /*is_running*/) override {
    return members_[member].values.take_over(after);
  }
  void open() override;
  void needs(std::span<const Member> members, std::span<percept::Needs> out) const override;
  void act(std::span<const Turn> turns) override;
  void ask() override;
  void wait(const Meanwhile& meanwhile) override;
  Workings workings(Member member) const override { return members_[member].values.workings(); }
  RobotValues* values(Member member) override { return &members_[member].values; }
  flow::Frame save(Member member) const override { return members_[member].values.saved(); }
  bool restore(Member member, const flow::Frame& frame) override {
    return members_[member].values.restore(frame);
  }
  std::expected<RobotMemory, std::string> memory(Member member) const override {
    return members_[member].values.memory();
  }
  void remember(Member member, const RobotMemory& memory) override;

 private:
  static constexpr std::size_t kNoProcess = ~std::size_t{0};
  struct Process {
    std::shared_ptr<const robot_host::HostedProgram> program;
    std::unique_ptr<robot_host::HostedCycle> cycle;  ///< null: its robots have gone, and so has it
  };
  struct Robot {
    RobotValues values;
    std::size_t process = kNoProcess;
    std::size_t place = 0;  // in the cycle
    Turn turn;
  };
  std::size_t process_for(const std::shared_ptr<const robot_host::HostedProgram>& program);
  void give_process(Robot& robot);
  void leave_process(std::size_t process);
  void take(Robot& robot);

  std::uint64_t seed_;
  int most_;
  std::vector<Process> processes_;
  Members<Robot> members_;
};

}  // namespace mlab::robot
