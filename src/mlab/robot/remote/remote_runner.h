#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "mlab/agent.pb.h"
#include "mlab/robot/program/members.h"
#include "mlab/robot/program/program_runner.h"
#include "mlab/robot/program/robot_values.h"
#include "mlab/robot/remote/agent.h"

namespace mlab::robot_remote {

/// Programs that agents carry, on this machine or others. A robot's values are at its agent; what is known of
/// them here is fetched when somebody looks, and comes with the actions as long as somebody does.
///
/// A robot whose program names a host goes to the agent of that name, any other to the one with the fewest.
/// One whose program is an executable goes to agents that offer this executable, and only those go there. One
/// whose agent fails has failed; started again, it goes to another agent.
class RemoteRunner : public robot::ProgramRunner {
 public:
  struct Newcomers {
    std::vector<std::unique_ptr<Agent>> agents;  ///< opened; each is told once
    std::string why_none;                        ///< why there may be none, a sentence for a person
  };
  /// Says which agents have joined since it was asked last.
  /// @param program  of the robot that wants one
  /// @param lost  names of those that were given out and have failed since it was asked last: if they are
  /// there,
  ///              they may be given out again
  using Recruit =
      std::function<Newcomers(const robot::RobotProgram& program, const std::vector<std::string>& lost)>;
  explicit RemoteRunner(Recruit recruit) : recruit_(std::move(recruit)) {}

  Member add(base::RobotId robot, const robot::RobotProgram& program) override;
  void remove(Member member) override;
  std::optional<std::string> start(Member member) override;
  std::optional<std::string> set(Member member, std::string_view port, const std::string& value) override;
  std::optional<std::string> force(Member member, std::string_view sequence, std::string_view state) override;
  std::optional<std::string> hold(Member member, std::string_view port, std::string_view value) override;
  std::optional<std::string> release(Member member, std::string_view port) override;
  bool take_over(Member member, const robot::RobotProgram& after, bool is_running) override;
  void open() override;
  void needs(std::span<const Member> members, std::span<percept::Needs> out) const override;
  void act(std::span<const Turn> turns) override;
  void ask() override;
  void wait(const robot::Meanwhile& meanwhile) override;
  std::string machine(Member member) const override;
  bool has_lost(Member member) const override;
  std::expected<robot::Said, std::string> said(Member member) override;
  std::vector<robot::SilentMachine> silent_machines() const override;
  robot::Workings workings(Member member) const override;
  robot::RobotValues* values(Member member) override;
  std::vector<flow::Restart> go_on_from(Member member, const robot::RobotValues& before) override;
  std::expected<robot::RobotMemory, std::string> memory(Member /*member*/) const override {
    return std::unexpected("another machine carries it, and goes on with its program");
  }
  flow::Frame save(Member member) const override;
  bool restore(Member member, const flow::Frame& frame) override;

 protected:
  /// Of silent agents: cycles wait for them.
  virtual bool waits_for_silent() const { return true; }
  static constexpr std::uint64_t kLongAgo = ~std::uint64_t{0} / 2;
  struct Carrier {
    std::unique_ptr<Agent> agent;
    std::uint32_t robots = 0;
    wire::ToAgent cycle;
    std::vector<Member> joined;
    bool is_given_up = false;  // it has failed, which was told
  };
  struct Robot {
    robot::RobotValues values;   // as they were known last
    Carrier* carrier = nullptr;  // null: it was not started
    std::uint32_t number = 0;    // by which its agent knows it
    percept::Needs needs;
    int place = 0;  // in the cycle
    Turn turn;
    std::uint64_t known = 0;         // after which cycle its values were as they are here
    std::uint64_t asked = kLongAgo;  // after which cycle somebody looked last
  };
  /// What is known of its values is what they are now, as far as that can be.
  virtual bool is_known_well(const Robot& robot) const { return robot.known == cycle_; }
  std::optional<std::string> take_action(const wire::AgentAction& acted, Robot& robot) const;

  std::deque<Carrier> carriers_;
  mutable robot::Members<Robot> members_;  // who looks makes their values newer
  std::uint64_t cycle_ = 0;                // that have been
  bool is_in_cycle_ = false;  // agents are asked for one, and for nothing else until they have answered

 private:
  std::string welcome(const robot::RobotProgram& program);
  std::expected<Carrier*, std::string> carrier_for(const robot::RobotProgram& program);
  void leave(Robot& robot);
  std::optional<std::string> enlist(Robot& robot);
  std::optional<std::string> put(Robot& robot, bool begins) const;
  std::optional<std::string> change(Robot& robot, wire::Change::Kind kind, std::string_view path,
                                    std::string_view value);
  /// Its agent can be asked; if not, what people do counts at its next start.
  static bool is_carried(const Robot& robot);
  const Robot& looked_at(Member member) const;
  void take_answer(Carrier& carrier, const wire::AgentActed& acted);

  Recruit recruit_;
  std::uint32_t next_number_ = 1;
};

}  // namespace mlab::robot_remote
