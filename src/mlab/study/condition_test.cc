#include "mlab/study/condition.h"

#include <string>

#include <gtest/gtest.h>

namespace mlab::study {
namespace {

Row row_with(double duration, double contacts, const std::string& outcome = "done") {
  Row out;
  out.outcome = outcome;
  out[Number::kDuration] = duration;
  out[Number::kContacts] = contacts;
  return out;
}
bool holds(const std::string& text, const Row& row) {
  const auto condition = Condition::parse(written_in_option("--success", text));
  EXPECT_TRUE(condition) << text;
  return condition && condition->holds(row);
}
std::string problem_in(const std::string& text) {
  const auto condition = Condition::parse(written_in_option("--success", text));
  return condition ? "none" : text::render(condition.error());
}

TEST(Condition, ComparesNumbersOfTheRun) {
  const Row row = row_with(300.0, 2.0);
  EXPECT_TRUE(holds("duration == 300", row));
  EXPECT_TRUE(holds("duration_s <= 300", row));
  EXPECT_FALSE(holds("duration < 300", row));
  EXPECT_TRUE(holds("contacts != 0", row));
  EXPECT_TRUE(holds("contacts >= 2", row));
  EXPECT_FALSE(holds("contacts > 2", row));
  EXPECT_TRUE(holds("outcome == done", row));
  EXPECT_TRUE(holds("outcome != failed", row));
}

TEST(Condition, JoinsThemAsOthersDo) {
  const Row row = row_with(300.0, 2.0);
  EXPECT_TRUE(holds("duration > 400 and contacts > 9 or outcome == done", row));
  EXPECT_FALSE(holds("duration > 400 and (contacts > 9 or outcome == done)", row));
  EXPECT_TRUE(holds("not duration > 400 and not (contacts == 0)", row));
}

TEST(Condition, IsFalseOfNumbersThatAreNotThere) {
  const Row row = row_with(300.0, 2.0);
  EXPECT_FALSE(holds("formation_error < 5", row));
  EXPECT_FALSE(holds("formation_error >= 5", row));
}

TEST(Condition, NamesThePartThatIsNotFulfilled) {
  const auto condition =
      Condition::parse(written_in_option("--success", "outcome == done and contacts == 0 and duration<9"));
  ASSERT_TRUE(condition);
  EXPECT_EQ(condition->unfulfilled(row_with(300.0, 2.0)), "contacts == 0");
  EXPECT_EQ(condition->unfulfilled(row_with(300.0, 0.0)), "duration<9");
}

TEST(Condition, ShowsWordsBeyondAsciiAsAWhole) {
  EXPECT_NE(problem_in("dürration < 3").find("1:1: error: expected a number of the run, found `dürration`"),
            std::string::npos)
      << problem_in("dürration < 3");
  EXPECT_NE(problem_in("outcome == é").find("found `é`"), std::string::npos) << problem_in("outcome == é");
  EXPECT_TRUE(Until::parse(written_in_option("--until", "success±0.05")));
}

TEST(Condition, SaysWhatIsExpectedWhere) {
  EXPECT_NE(problem_in("durtion < 3").find("did you mean `duration`?"), std::string::npos);
  EXPECT_NE(problem_in("duration << 3").find("--success:1:11: error: expected a number, found `<`"),
            std::string::npos)
      << problem_in("duration << 3");
  EXPECT_NE(problem_in("duration <").find("and it ends here"), std::string::npos);
  EXPECT_NE(problem_in("(duration < 3").find("expected `)`"), std::string::npos);
  EXPECT_NE(problem_in("duration < 3 4").find("expected `and`, `or`, or the end"), std::string::npos);
  EXPECT_NE(problem_in("outcome < done").find("`==` or `!=`"), std::string::npos);
  EXPECT_NE(problem_in("outcome == dune")
                .find("expected an outcome: done, failed, aborted, interrupted, found `dune`"),
            std::string::npos)
      << problem_in("outcome == dune");
  EXPECT_NE(problem_in("").find("expected a number of the run"), std::string::npos);
  EXPECT_NE(problem_in(std::string(10'000, '(')).find("fewer parentheses"), std::string::npos);
}

TEST(Requirement, IsMetWhereTheWholeIntervalIsThere) {
  const auto found = Requirement::parse(written_in_option("--require", "success >= 0.95 @ 0.99"));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->share, 0.95);
  EXPECT_EQ(found->confidence, 0.99);
  EXPECT_TRUE(found->is_met({0.95, 1.0}));
  EXPECT_FALSE(found->is_met({0.94, 1.0}));
  EXPECT_FALSE(found->is_refuted({0.94, 1.0}));
  EXPECT_TRUE(found->is_refuted({0.5, 0.949}));
  const auto most = Requirement::parse(written_in_option("--require", "success <= 0.1"));
  ASSERT_TRUE(most);
  EXPECT_EQ(most->confidence, 0.95);
  EXPECT_TRUE(most->is_met({0.0, 0.1}));
  EXPECT_TRUE(most->is_refuted({0.11, 0.4}));
  for (const char* wrong :
       {"", "success", "success > 0.9", "success >= 2", "success >= 0.9 @ 2", "contacts >= 0.9"})
    EXPECT_FALSE(Requirement::parse(written_in_option("--require", wrong))) << wrong;
}

TEST(Until, IsDecidedOrAWidth) {
  EXPECT_TRUE(Until::parse(written_in_option("--until", "decided"))->is_decided);
  const auto width = Until::parse(written_in_option("--until", "success +- 0.05 @ 0.9"));
  ASSERT_TRUE(width);
  EXPECT_EQ(width->half_width, 0.05);
  EXPECT_EQ(width->confidence, 0.9);
  EXPECT_TRUE(Until::parse(written_in_option("--until", "success \u00b1 0.05")));
  for (const char* wrong : {"", "decided now", "success 0.05", "success +- 0.7", "success +- 0.05 @"})
    EXPECT_FALSE(Until::parse(written_in_option("--until", wrong))) << wrong;
}

}  // namespace
}  // namespace mlab::study
