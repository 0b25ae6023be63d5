// The built command on a terminal, where it asks people and shows colours.

#include <string>

#include <gtest/gtest.h>

#include "command.h"
#include "terminal.h"

namespace mlab {
namespace {

const std::string kRun = "exec '" + std::string(MLAB_COMMAND) + "' ";

class OnATerminal : public Command {
 protected:
  // Occupies a place, and asks there; the question answers itself after so many seconds.
  void write_question(const std::string& seconds) const {
    write("map.odl", kMap);
    write("m.mdl",
          std::string(kMission) + "2. UNIT u OCCUPY There UNTIL TIMEOUT " + seconds + "\n3. UNIT u STOP\n");
  }
};

TEST_F(OnATerminal, AQuestionStaysVisibleUntilItIsAnswered) {
  write_question("60");
  Terminal terminal(folder_, kRun + "run m.mdl --headless");
  ASSERT_TRUE(terminal.await("Proceed? [y/n]")) << terminal.output();
  terminal.watch(1.0);  // ten times as long as the bar takes to draw itself again
  EXPECT_TRUE(has(terminal.last_line(), "Proceed? [y/n]")) << terminal.output();
  terminal.type("perhaps\n");
  ASSERT_TRUE(terminal.await("y lets the unit proceed")) << terminal.output();
  terminal.watch(0.5);
  EXPECT_TRUE(has(terminal.last_line(), "Proceed? [y/n]")) << terminal.output();
  const double asked = now();
  terminal.type("y\n");
  EXPECT_EQ(terminal.finish(), 0) << terminal.output();
  EXPECT_LT(now() - asked, 20.0) << "the answer is taken when it comes";
  EXPECT_TRUE(has(terminal.output(), "mission done")) << terminal.output();
}

TEST_F(OnATerminal, APersonHasRealSecondsToAnswerInWhateverTheSpeed) {
  for (const std::string speed : {"", " --speed 1000"}) {
    write_question("2");
    Terminal terminal(folder_, kRun + "run m.mdl --headless" + speed);
    ASSERT_TRUE(terminal.await("yes by itself after 2 s")) << terminal.output();
    const double asked = now();
    EXPECT_EQ(terminal.finish(), 0) << terminal.output();
    EXPECT_GT(now() - asked, 1.6) << terminal.output();
  }
}

TEST_F(OnATerminal, NobodyIsWaitedForWhereTheTerminalHasSaidThatNothingMoreComes) {
  write_question("1000");
  Terminal terminal(folder_, kRun + "run m.mdl --headless");
  ASSERT_TRUE(terminal.await("Proceed? [y/n]")) << terminal.output();
  terminal.type("\x04");
  EXPECT_EQ(terminal.finish(), 0) << terminal.output();
}

TEST_F(OnATerminal, DiagnosticsAreColoredUnlessNobodyWantsThat) {
  write("map.odl", std::string(kMap) + "PP Broken 1\n");
  const auto checked = [&](const std::string& before) {
    Terminal terminal(folder_, before + kRun + "check map.odl");
    EXPECT_EQ(terminal.finish(), 2);
    return terminal.output();
  };
  EXPECT_TRUE(has(checked("export TERM=xterm; unset NO_COLOR; "), "\x1b[1;31merror\x1b[0m"));
  for (const char* before : {"export TERM=xterm NO_COLOR=1; ", "export TERM=dumb; unset NO_COLOR; "}) {
    const std::string plain = checked(before);
    EXPECT_TRUE(has(plain, "map.odl:5:")) << plain;
    EXPECT_FALSE(has(plain, "\x1b[")) << plain;
  }
  write_question("1");
  Terminal run(folder_, "export TERM=xterm; unset NO_COLOR; " + kRun + "run m.mdl --headless --proceed");
  EXPECT_EQ(run.finish(), 0);
  EXPECT_TRUE(has(run.output(), "\x1b[1;32mdone\x1b[0m")) << run.output();
  write("map.odl", std::string(kMap) + "PP Broken 1\n");
  EXPECT_FALSE(has(mlab("check map.odl", "TERM=xterm").err, "\x1b["));
}

}  // namespace
}  // namespace mlab
