#include <string>

#include <gtest/gtest.h>

#include "mlab/console/testing/browser.h"

namespace mlab::console {
namespace {

using testing::Browser;
using testing::TestSession;

/// Somebody who interferes with the foragers' programs, one cycle after the other.
class Intervening : public ::testing::Test {
 protected:
  Intervening() : session_("forage/forage.mdl", 0.0), anna_(session_, "Anna") {
    EXPECT_TRUE(anna_.wait([&] { return anna_.status().mode() == Status::READY; }));
    cycles(3);
  }

  void cycles(int count) {
    for (int i = 0; i < count; ++i) {
      const std::uint64_t before = anna_.status().cycle();
      ASSERT_EQ(anna_.control(Control::SINGLE_CYCLE), "");
      ASSERT_TRUE(anna_.wait([&] { return anna_.status().cycle() == before + 1; }));
    }
  }
  static ToServer force(std::uint32_t robot, const std::string& sequence, const std::string& state) {
    ToServer out;
    out.mutable_force_state()->set_robot(robot);
    out.mutable_force_state()->set_sequence(sequence);
    out.mutable_force_state()->set_state(state);
    return out;
  }
  static ToServer hold(std::uint32_t robot, const std::string& port, const std::string& value) {
    ToServer out;
    out.mutable_hold_value()->set_robot(robot);
    out.mutable_hold_value()->set_port(port);
    out.mutable_hold_value()->set_value(value);
    return out;
  }
  static ToServer release(std::uint32_t robot, const std::string& port) {
    ToServer out;
    out.mutable_release_value()->set_robot(robot);
    out.mutable_release_value()->set_port(port);
    return out;
  }
  std::string ask(ToServer message) { return Browser::error_of(anna_.ask(std::move(message))); }
  /// As of the newest cycle.
  RobotDetail detail(std::uint32_t robot) {
    auto watch = std::make_unique<ToServer>();
    watch->mutable_watch()->add_details(robot);
    watch->mutable_watch()->set_with_ports(true);
    anna_.send(std::move(watch));
    RobotDetail out;
    EXPECT_TRUE(anna_.wait([&] {
      for (const RobotDetail& one : anna_.frame().details()) {
        if (one.id() != robot || one.ports().empty() || anna_.frame().cycle() != anna_.status().cycle())
          continue;
        out = one;
        return true;
      }
      return false;
    }));
    return out;
  }
  bool is_in(std::uint32_t robot, const std::string& state) {
    const RobotDetail now = detail(robot);
    return std::ranges::find(now.states(), state) != now.states().end();
  }
  bool tells(const std::string& text) {
    return anna_.wait([&] { return anna_.has_log(text); });
  }
  Browser& anna() { return anna_; }
  TestSession& session() { return session_; }

 private:
  TestSession session_;
  Browser anna_;
};

TEST_F(Intervening, ARobotGoesToTheStateThatItIsForcedTo) {
  detail(1);  // its transitions are noted from the next cycle on
  cycles(1);
  const std::string before = detail(1).states(0);
  EXPECT_EQ(ask(force(1, "movement", "Delivering")), "");
  EXPECT_EQ(detail(1).states(0), before) << "not before the next cycle";
  cycles(1);
  const RobotDetail now = detail(1);
  EXPECT_EQ(now.states(0), "movement.Delivering");
  ASSERT_EQ(now.transitions_size(), 1);
  EXPECT_TRUE(now.transitions(0).is_forced());
  EXPECT_EQ("movement." + now.transitions(0).from(), before);
  EXPECT_EQ(now.transitions(0).to(), "Delivering");
  EXPECT_FALSE(is_in(2, "movement.Delivering")) << "the others are left alone";
  EXPECT_TRUE(tells("Anna: robot 1 is forced: movement goes to Delivering"));
}

TEST_F(Intervening, WhatCanNotBeForcedIsRefused) {
  EXPECT_EQ(ask(force(99, "movement", "Delivering")), "there is no robot 99");
  EXPECT_EQ(ask(force(1, "movement", "Nowhere")), "`movement` has no state `Nowhere`");
  EXPECT_EQ(ask(force(1, "elsewhere", "Delivering")), "there is no sequence `elsewhere`");
  anna().control(Control::RESTART);
  ASSERT_TRUE(anna().wait([&] { return anna().status().mode() == Status::READY; }));
  EXPECT_EQ(ask(force(1, "movement", "Delivering")), "robot 1 does not run: not started");
}

TEST_F(Intervening, AHeldValueIsToldToAllAndReleasedWithTheRun) {
  Browser ben(session(), "Ben");
  EXPECT_EQ(ask(hold(2, "movement", "{0.25, 0}")), "");
  ASSERT_TRUE(ben.wait([&] { return ben.held().values_size() == 1; }));
  EXPECT_EQ(ben.held().values(0).robot(), 2U);
  EXPECT_EQ(ben.held().values(0).port(), "movement");
  EXPECT_TRUE(tells("Anna: hold movement of robot 2 at {0.25, 0}"));
  cycles(2);
  EXPECT_EQ(ask(hold(2, "movement", "fast")),
            "`fast` is no vector: `movement` takes two or three numbers, as {1, 2}");
  EXPECT_EQ(ask(release(1, "movement")), "`movement` is not held");
  EXPECT_EQ(ask(release(0, "movement")), "");
  ASSERT_TRUE(ben.wait([&] { return ben.held().values().empty(); }));
  EXPECT_EQ(ask(hold(2, "movement", "{0.25, 0}")), "");
  ASSERT_TRUE(ben.wait([&] { return ben.held().values_size() == 1; }));
  anna().control(Control::RESTART);
  ASSERT_TRUE(ben.wait([&] { return ben.held().values().empty(); }));
  EXPECT_TRUE(tells("1 held value is released: the run has ended"));
}

TEST_F(Intervening, OnlyTheOperatorMay) {
  Browser ben(session(), "Ben");
  for (ToServer message :
       {force(1, "movement", "Delivering"), hold(1, "movement", "{1, 0}"), release(0, "")}) {
    const std::string refused = Browser::error_of(ben.ask(std::move(message)));
    EXPECT_NE(refused.find("operator"), std::string::npos) << refused;
  }
  cycles(1);
  EXPECT_FALSE(is_in(1, "movement.Delivering"));
}

}  // namespace
}  // namespace mlab::console
