#pragma once

#include <cstdint>
#include <optional>
#include <random>
#include <set>
#include <span>
#include <string>
#include <string_view>

#include "mlab/robot/program/in_process_runner.h"

namespace mlab::history::testing {

/// Computes what its robots do, now and then loses one in the middle of a cycle, and can't always start one:
/// as machines that are lost, but by a seed.
class LosingRunner final : public robot::ProgramRunner {
 public:
  /// One in so many.
  struct Odds {
    std::uint32_t start = 4;    ///< starts that fail; 0: none
    std::uint32_t cycle = 300;  ///< robot-cycles in which the robot is lost
    int most = 1'000'000;       ///< that are lost, in all
  };
  explicit LosingRunner(std::uint32_t seed, Odds odds) : own_(seed), random_(seed), odds_(odds) {}

  Member add(base::RobotId robot, const robot::RobotProgram& program) override {
    return own_.add(robot, program);
  }
  void remove(Member member) override { own_.remove(member); }
  std::optional<std::string> start(Member member) override {
    if (odds_.start != 0 && random_() % odds_.start == 0) return "has no agent: nobody is there";
    lost_members_.erase(member);
    return own_.start(member);
  }
  std::optional<std::string> set(Member member, std::string_view port, const std::string& value) override {
    return own_.set(member, port, value);
  }
  std::optional<std::string> force(Member member, std::string_view sequence,
                                   std::string_view state) override {
    return own_.force(member, sequence, state);
  }
  std::optional<std::string> hold(Member member, std::string_view port, std::string_view value) override {
    return own_.hold(member, port, value);
  }
  std::optional<std::string> release(Member member, std::string_view port) override {
    return own_.release(member, port);
  }
  bool take_over(Member member, const robot::RobotProgram& after, bool is_running) override {
    return own_.take_over(member, after, is_running);
  }
  void needs(std::span<const Member> members, std::span<percept::Needs> out) const override {
    own_.needs(members, out);
  }
  void act(std::span<const Turn> turns) override {
    for (const Turn& turn : turns) {
      if (lost_ == odds_.most || random_() % odds_.cycle != 0) {
        own_.act({&turn, 1});
        continue;
      }
      ++lost_;
      lost_members_.insert(turn.member);
      *turn.action = {};
      turn.fault->clear();
      *turn.failure = "can't be reached: the agent on `south` was silent for 5 s";
    }
  }
  std::string machine(Member /*member*/) const override { return "south"; }
  bool has_lost(Member member) const override { return lost_members_.contains(member); }
  robot::Workings workings(Member member) const override { return own_.workings(member); }
  robot::RobotValues* values(Member member) override { return own_.values(member); }
  flow::Frame save(Member member) const override { return own_.save(member); }
  bool restore(Member member, const flow::Frame& frame) override { return own_.restore(member, frame); }

  int lost() const { return lost_; }

 private:
  robot::InProcessRunner own_;
  std::mt19937 random_;
  const Odds odds_;
  int lost_ = 0;
  std::set<Member> lost_members_;
};

}  // namespace mlab::history::testing
