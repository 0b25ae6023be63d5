#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/history/recorded_answers.h"
#include "mlab/robot/program/members.h"
#include "mlab/robot/program/program_runner.h"

namespace mlab::history {

/// Robots whose programs answered in a run that was recorded: they answer the same again, and nothing else.
/// Beyond that they are silent, and stand because of it. It holds nothing of a robot that a checkpoint would
/// have to.
class RecordedRunner final : public robot::ProgramRunner {
 public:
  /// @param history  may grow
  /// @param cycle    how many have run, the one that is being computed included
  RecordedRunner(std::shared_ptr<const History> history, std::function<std::uint64_t()> cycle)
      : answers_(std::move(history)), cycle_(std::move(cycle)) {}

  Member add(base::RobotId robot, const robot::RobotProgram& program) override {
    return members_.add({robot, &program});
  }
  void remove(Member member) override { members_.remove(member); }
  /// Where it was not brought to life RecordedFailures knows of it.
  std::optional<std::string> start(Member /*member*/) override { return std::nullopt; }
  /// What people did then has its effect in what was answered: all are taken.
  std::optional<std::string> set(Member /*member*/, std::string_view /*port*/,
                                 const std::string& /*value*/) override {
    return std::nullopt;
  }
  std::optional<std::string> force(Member member, std::string_view sequence, std::string_view state) override;
  std::optional<std::string> hold(Member member, std::string_view port, std::string_view value) override;
  std::optional<std::string> release(Member member, std::string_view port) override;
  bool take_over(Member member, const robot::RobotProgram& after, bool is_running) override;
  std::vector<flow::Restart> go_on_from(Member /*member*/, const robot::RobotValues& /*before*/) override {
    return {};
  }
  void open() override { answers_.go_to(cycle_()); }
  void needs(std::span<const Member> members, std::span<percept::Needs> out) const override;
  void act(std::span<const Turn> turns) override;
  robot::Workings workings(Member /*member*/) const override { return {}; }
  flow::Frame save(Member /*member*/) const override { return {}; }
  bool restore(Member /*member*/, const flow::Frame& /*frame*/) override { return false; }
  std::expected<robot::RobotMemory, std::string> memory(Member member) const override;
  double silence(Member member) const override;
  double percept_age(Member member) const override;

 private:
  struct Robot {
    base::RobotId robot;
    const robot::RobotProgram* program = nullptr;
  };
  const RecordedAnswer* now(Member member) const;
  std::optional<std::string> refusal(Member member) const;

  mutable RecordedAnswers answers_;  // stands at the cycle that is asked for
  std::function<std::uint64_t()> cycle_;
  robot::Members<Robot> members_;
};

}  // namespace mlab::history
