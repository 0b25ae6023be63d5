// What the guides show: the commands are carried out, and what they print stands in files beside the
// examples, from which the guides are cut.

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "pages.h"

namespace mlab::examples {
namespace {

class OwnBehavior : public testing::Test {
 protected:
  void SetUp() override { here_.take("docs/examples/own_behavior", "."); }

  Answer mlab(const std::string& words) const { return here_.carry_out("./mlab " + words); }
  std::string text(const std::string& name) const { return text_of(here_.folder() / name); }

  Workplace here_;
};

TEST_F(OwnBehavior, EveryFileIsRightAndInTheCanonicalLayout) {
  const Answer checked = mlab("check field.odl wander.mdl wander.cnl mine.mdl mine.cnl");
  EXPECT_EQ(checked.status, 0) << checked.output;
  const Answer printed = mlab("fmt --check wander.cnl mine.cnl mistake.cnl");
  EXPECT_EQ(printed.status, 0) << printed.output;
}

TEST_F(OwnBehavior, TheWandererStopsWhenItIsTired) {
  const Answer run = mlab("run wander.mdl --headless --proceed");
  EXPECT_EQ(run.status, 0) << run.output;
  const std::string steps = text("wander.txt");
  ASSERT_FALSE(steps.empty());
  EXPECT_NE(run.output.find(steps), std::string::npos) << run.output;
}

TEST_F(OwnBehavior, TheRobotGoesWhereItIsToldWithoutAContact) {
  const Answer run = mlab("run mine.mdl --headless --proceed");
  EXPECT_EQ(run.status, 0) << run.output;
  const std::string steps = text("mine.txt");
  ASSERT_FALSE(steps.empty());
  EXPECT_NE(run.output.find(steps), std::string::npos) << run.output;
  EXPECT_NE(run.output.find(" 0 collisions"), std::string::npos) << run.output;
}

TEST_F(OwnBehavior, MistakesInCppAreShownAtTheirPlaces) {
  const Answer checked = mlab("check mistake.cnl");
  EXPECT_EQ(checked.status, 2);
  const std::string expected = text("mistake.txt");
  ASSERT_FALSE(expected.empty());
  EXPECT_NE(checked.output.find(expected), std::string::npos) << checked.output;
}

}  // namespace
}  // namespace mlab::examples
