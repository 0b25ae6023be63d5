// Robots that run take a change of their configuration.

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "mlab/designer/testing/live_desk.h"

namespace mlab::designer {
namespace {

using console::Control;
using console::Status;
using testing::LiveDesk;

// Stands for a while, then wanders for ever.
std::string waits_then(const std::string& later = "Moving", const std::string& persistence = "2 s") {
  return "assemblage Turns() {\n"
         "  sequence {\n"
         "    start Waiting: Stand();\n"
         "      when Wait(delay = 1 s) goto " +
         later + ";\n    final " + later + ": Noise(persistence = " + persistence + ");\n  }\n}\n";
}

class TakingOver : public ::testing::Test {
 protected:
  TakingOver() : path_(desk_.write(waits_then())) {
    EXPECT_TRUE(desk_.try_out(path_, "Turns", 2).ok());
    EXPECT_TRUE(desk_.runs_until(5.0));
  }

  Answer take_over(std::uint32_t count = 2) {
    return desk_.try_out(path_, "Turns", count, [](Try& request) {
      request.set_execute(false);
      request.set_take_over(true);
    });
  }
  void type(const std::string& text) { desk_.type(path_, text); }
  LiveDesk& desk() { return desk_; }
  double time() { return desk_.browser().status().time(); }
  bool goes_on() {
    const double before = time();
    return desk_.runs_until(before + 1.0);
  }

 private:
  LiveDesk desk_;
  std::string path_;
};

TEST_F(TakingOver, RobotsGoOnWhereTheyAre) {
  const double before = time();
  type(waits_then("Moving", "3 s"));
  const Answer answer = take_over();
  ASSERT_TRUE(answer.ok()) << answer.error();
  EXPECT_EQ(answer.trial().taken_over(), "robots 1, 2 took over a change; nothing begins anew");
  EXPECT_TRUE(desk().browser().wait([&] { return desk().browser().status().time() > before + 1.0; }));
  EXPECT_TRUE(desk().browser().wait(
      [&] { return desk().browser().has_log("robots 1, 2 took over a change; nothing begins anew"); }));
  EXPECT_GE(time(), before) << "no other run";
}

TEST_F(TakingOver, ItIsSaidWhatBeginsAnewAndAnUndoIsTakenOverAlike) {
  type(waits_then("Roaming"));
  Answer answer = take_over();
  ASSERT_TRUE(answer.ok()) << answer.error();
  EXPECT_EQ(answer.trial().taken_over(),
            "robots 1, 2 took over a change; `movement` begins in Waiting: its state Moving is gone");
  ASSERT_TRUE(goes_on());
  type(waits_then());
  answer = take_over();
  ASSERT_TRUE(answer.ok()) << answer.error();
  EXPECT_NE(answer.trial().taken_over().find("took over a change"), std::string::npos);
  EXPECT_TRUE(goes_on());
}

TEST_F(TakingOver, WhatCanNotBeTakenOverIsRefusedAndTheRunGoesOn) {
  type("assemblage Turns() { Nothing(); }\n");
  EXPECT_FALSE(take_over().ok());
  EXPECT_TRUE(goes_on());
  type(waits_then("Roaming"));
  const Answer more = take_over(3);
  EXPECT_EQ(more.error(), "what runs, how many or where has changed");
  EXPECT_TRUE(goes_on());
  EXPECT_TRUE(take_over().ok());
}

TEST_F(TakingOver, ARestartAfterOneThatWasRefusedIsOfWhatRan) {
  type("assemblage Turns() { Nothing(); }\n");
  EXPECT_FALSE(take_over().ok());
  desk().browser().control(Control::RESTART);
  EXPECT_TRUE(desk().browser().wait([&] { return desk().browser().status().mode() == Status::READY; }));
}

TEST_F(TakingOver, OfAnotherMissionIsRefused) {
  const double before = time();
  desk().browser().control(Control::RESTART);
  ASSERT_TRUE(desk().browser().wait([&] { return desk().browser().status().mode() == Status::READY; }));
  EXPECT_LT(time(), before);
  EXPECT_EQ(take_over().error(), "no robot has started yet");
}

}  // namespace
}  // namespace mlab::designer
