#pragma once

#include <memory>

#include "mlab/flow/async_runner.h"
#include "mlab/robot/program/members.h"
#include "mlab/robot/program/program_runner.h"
#include "mlab/robot/program/robot_values.h"

namespace mlab::robot {

/// Programs of behaviors that are part of this process.
class InProcessRunner final : public ProgramRunner {
 public:
  explicit InProcessRunner(std::uint64_t seed) : seed_(seed) {}

  Member add(base::RobotId robot, const RobotProgram& program) override;
  void remove(Member member) override { members_.remove(member); }
  std::optional<std::string> start(Member member) override;
  std::optional<std::string> set(Member member, std::string_view port, const std::string& value) override {
    return members_[member].set(port, value);
  }
  std::optional<std::string> force(Member member, std::string_view sequence,
                                   std::string_view state) override {
    return members_[member].force(sequence, state);
  }
  std::optional<std::string> hold(Member member, std::string_view port, std::string_view value) override {
    return members_[member].hold(port, value);
  }
  std::optional<std::string> release(Member member, std::string_view port) override {
    return members_[member].release(port);
  }
  bool take_over(Member member, const RobotProgram& after, bool /*is_running*/) override {
    return members_[member].take_over(after);
  }
  void needs(std::span<const Member> members, std::span<percept::Needs> out) const override;
  void act(std::span<const Turn> turns) override;
  Workings workings(Member member) const override { return members_[member].workings(); }
  RobotValues* values(Member member) override { return &members_[member]; }
  flow::Frame save(Member member) const override { return members_[member].saved(); }
  bool restore(Member member, const flow::Frame& frame) override { return members_[member].restore(frame); }
  std::expected<RobotMemory, std::string> memory(Member member) const override {
    return members_[member].memory();
  }
  void remember(Member member, const RobotMemory& memory) override;

 private:
  std::uint64_t seed_;
  Members<RobotValues> members_;
  std::unique_ptr<flow::AsyncRunner> async_;
};

}  // namespace mlab::robot
