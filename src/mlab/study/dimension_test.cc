#include "mlab/study/dimension.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace mlab::study {
namespace {

std::vector<std::string> values(const std::string& both) {
  const auto found = dimension_of(written_in_option("--set", both));
  EXPECT_TRUE(found) << both;
  std::vector<std::string> out;
  if (found) {
    for (const Written& value : found->values) out.push_back(value.text);
  }
  return out;
}
std::string problem_with(const std::string& both) {
  const auto found = dimension_of(written_in_option("--set", both));
  return found ? "none" : text::render(found.error());
}
using Texts = std::vector<std::string>;

TEST(Dimension, IsAList) {
  EXPECT_EQ(values("v=1,2,5"), (Texts{"1", "2", "5"}));
  EXPECT_EQ(values("OVERLAY=a.odl, b.odl"), (Texts{"a.odl", "b.odl"}));
  EXPECT_EQ(values("goal={1, 2},{3, 4}"), (Texts{"{1, 2}", "{3, 4}"}));
  EXPECT_EQ(values("a=b=c"), (Texts{"b=c"}));
}

TEST(Dimension, IsARange) {
  EXPECT_EQ(values("v=1:5:1"), (Texts{"1", "2", "3", "4", "5"}));
  EXPECT_EQ(values("v=0:0.3:0.1"), (Texts{"0", "0.1", "0.2", "0.3"}));
  EXPECT_EQ(values("v=5:1:-2"), (Texts{"5", "3", "1"}));
  EXPECT_EQ(values("at=12:30"), (Texts{"12:30"}));
  EXPECT_NE(problem_with("v=1:5:-1").find("steps of -1 don't lead from 1 to 5"), std::string::npos);
  EXPECT_NE(problem_with("v=1:5:0").find("empty-range"), std::string::npos);
  for (const char* many : {"v=0:1e9:1", "v=1:1e300:1e-300", "v=-1e308:1e308:1"})
    EXPECT_NE(problem_with(many).find("more than 10000 values"), std::string::npos) << problem_with(many);
}

TEST(Dimension, HasTheDecimalsOfItsRange) {
  EXPECT_EQ(values("v=-0.3:0.3:0.1"), (Texts{"-0.3", "-0.2", "-0.1", "0", "0.1", "0.2", "0.3"}));
  EXPECT_EQ(values("v=0.3:-0.1:-0.1"), (Texts{"0.3", "0.2", "0.1", "0", "-0.1"}));
  EXPECT_EQ(values("v=9007199254740000:9007199254740002:1"),
            (Texts{"9007199254740000", "9007199254740001", "9007199254740002"}));
  EXPECT_EQ(values("v=1.0000000000001:1.0000000000003:1e-13"),
            (Texts{"1.0000000000001", "1.0000000000002", "1.0000000000003"}));
  EXPECT_EQ(values("v=0:2.5e-9:1.25e-9"), (Texts{"0", "1.25e-09", "2.5e-09"}));
  EXPECT_EQ(values("v=-1e308:1e308:1e308"), (Texts{"-1e+308", "0", "1e+308"}));
  EXPECT_EQ(values("v=3:3:1e-300"), (Texts{"3"}));
}

TEST(Dimension, IsDrawnBetweenTwoNumbers) {
  const auto found = dimension_of(written_in_option("--set", "v=-1..2.5"));
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->is_drawn());
  EXPECT_EQ(found->low, -1.0);
  EXPECT_EQ(found->high, 2.5);
  EXPECT_EQ(values("file=a..b"), (Texts{"a..b"}));
  EXPECT_NE(problem_with("v=2..2").find("nothing can be drawn"), std::string::npos);
}

TEST(Dimension, SaysWhereAMistakeStands) {
  EXPECT_NE(problem_with("v=1,,2").find("--set:1:5: error: `v` has a value that is empty"), std::string::npos)
      << problem_with("v=1,,2");
  EXPECT_NE(problem_with("v").find("expected NAME=VALUE, found `v`"), std::string::npos);
  EXPECT_NE(problem_with("=3").find("expected NAME=VALUE"), std::string::npos);
  EXPECT_NE(problem_with("").find("expected NAME=VALUE"), std::string::npos);
}

TEST(Dimension, OfASingleRunIsOneValueWhateverStandsInIt) {
  const auto found = setting_of("goal=1,2");
  ASSERT_TRUE(found);
  EXPECT_EQ(found->name, "goal");
  EXPECT_EQ(found->value, "1,2");
  EXPECT_FALSE(setting_of("goal"));
}

}  // namespace
}  // namespace mlab::study
