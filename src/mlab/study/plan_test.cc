#include "mlab/study/plan.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace mlab::study {
namespace {

Definition defined(std::vector<std::pair<std::string, std::string>> fields) {
  Definition out;
  fields.emplace_back("mission", "m.mdl");
  for (const auto& [field, value] : fields)
    EXPECT_FALSE(take(out, field, written_in_option("--" + field, value))) << field;
  return out;
}
std::string problem(std::vector<std::pair<std::string, std::string>> fields) {
  Definition d = defined(std::move(fields));
  const auto found = settle(d);
  return found ? found->message : "none";
}

TEST(Plan, HasEachValueWithEach) {
  const Definition d = defined({{"set", "a=1,2"}, {"set", "b=x,y,z"}, {"runs", "2"}});
  const Plan plan(d);
  ASSERT_EQ(plan.combinations(), 6U);
  std::string all;
  for (std::uint32_t i = 0; i < 6; ++i) all += text_of(plan.settings(i)) + "\n";
  EXPECT_EQ(all, "a=1, b=x\na=1, b=y\na=1, b=z\na=2, b=x\na=2, b=y\na=2, b=z\n");
  EXPECT_EQ(plan.all(), 12U);
}

TEST(Plan, HasValuesInPairs) {
  const Definition d = defined({{"set", "a=1,2"}, {"set", "b=x,y"}, {"combine", "paired"}});
  const Plan plan(d);
  ASSERT_EQ(plan.combinations(), 2U);
  EXPECT_EQ(text_of(plan.settings(1)), "a=2, b=y");
  EXPECT_NE(
      problem({{"set", "a=1,2"}, {"set", "b=x"}, {"combine", "paired"}}).find("`a` has 2 values, `b` 1"),
      std::string::npos);
}

TEST(Plan, HasNoCombinationTwice) {
  for (const char* const set : {"v=1,2,1", "v=1,2,1.0", "v=0,-0", "v=a,b,a"}) {
    EXPECT_NE(problem({{"set", set}}).find("is given twice: expected each once"), std::string::npos) << set;
  }
  EXPECT_EQ(problem({{"set", "v=a,b,A,1,1x"}}), "none");
  // What is paired may come again, with something else beside it.
  EXPECT_EQ(problem({{"set", "a=1,1,2"}, {"set", "b=x,y,x"}, {"combine", "paired"}}), "none");
  EXPECT_EQ(problem({{"set", "a=1,2,1.0"}, {"set", "b=x,y,x"}, {"combine", "paired"}}),
            "`a=1.0` with `b=x` is given twice: expected each once, as the same runs would be done again");
}

TEST(Plan, BeginsAllRunsOfASeedBeforeTheNext) {
  const Definition d = defined({{"set", "a=1,2"}, {"runs", "3"}, {"seed", "7"}, {"against", "n.mdl"}});
  const Plan plan(d);
  EXPECT_EQ(plan.all(), 12U);
  std::set<RunKey> seen;
  for (std::uint64_t i = 0; i < plan.all(); ++i) {
    EXPECT_EQ(plan.key(i).run, i / 4);
    seen.insert(plan.key(i));
  }
  EXPECT_EQ(seen.size(), 12U);
  EXPECT_EQ(plan.seed(2), 9U);
}

TEST(Plan, DrawsTheSameForAllCombinationsAndWhateverElseIsSet) {
  const Definition one = defined({{"set", "a=1,2"}, {"set", "v=0..1"}, {"runs", "50"}});
  const Definition other = defined({{"set", "v=0..1"}, {"set", "w=0..1"}, {"runs", "10"}});
  const Plan plan(one);
  const Plan less(other);
  for (std::uint32_t run = 0; run < 10; ++run) {
    const std::string value = plan.settings(RunKey{0, 0, run})[1].value;
    EXPECT_EQ(plan.settings(RunKey{0, 1, run})[1].value, value);
    EXPECT_EQ(less.settings(RunKey{0, 0, run})[0].value, value);
    EXPECT_NE(less.settings(RunKey{0, 0, run})[1].value, value);
  }
  EXPECT_EQ(text_of(plan.settings(0)), "a=1");
}

// What a mission does not take of them is told there.
TEST(Plan, KnowsWhereDrawnValuesAreWritten) {
  const Definition d = defined({{"set", "v=1..2"}});
  const Plan plan(d);
  for (const mdl::Setting& one : {plan.settings(RunKey{})[0], plan.extremes(0, true)[0]}) {
    EXPECT_EQ(one.name_place.source->text(one.name_place.span), "v");
    EXPECT_EQ(one.value_place.source->text(one.value_place.span), "1..2");
  }
}

TEST(Plan, FillsALatinHypercube) {
  const Definition d = defined({{"set", "v=10..20"}, {"set", "w=0..1"}, {"draw", "latin"}, {"runs", "40"}});
  const Plan plan(d);
  for (std::size_t dimension : {0U, 1U}) {
    const double low = dimension == 0 ? 10.0 : 0.0;
    const double width = dimension == 0 ? 10.0 : 1.0;
    std::set<int> strata;
    for (std::uint32_t run = 0; run < 40; ++run) {
      const double value = std::stod(plan.settings(RunKey{0, 0, run})[dimension].value);
      strata.insert(static_cast<int>(std::floor((value - low) / width * 40.0)));
    }
    EXPECT_EQ(strata.size(), 40U) << "one run in each fortieth";
    EXPECT_EQ(*strata.begin(), 0);
    EXPECT_EQ(*strata.rbegin(), 39);
  }
}

TEST(Definition, SaysWhatDoesNotGoTogether) {
  EXPECT_EQ(problem({}), "none");
  EXPECT_NE(problem({{"set", "a=1"}, {"set", "a=2"}}).find("`a` is set twice"), std::string::npos);
  EXPECT_NE(problem({{"until", "decided"}}).find("goes with a requirement"), std::string::npos);
}

TEST(Definition, TakesNothingThatIsNoValue) {
  Definition d;
  for (const auto& [field, value] : std::vector<std::pair<std::string, std::string>>{{"runs", "0"},
                                                                                     {"runs", "many"},
                                                                                     {"runs", ""},
                                                                                     {"runs", "99999999"},
                                                                                     {"seed", "-1"},
                                                                                     {"patience", "nan"},
                                                                                     {"limit", "0"},
                                                                                     {"for", "inf"},
                                                                                     {"combine", "both"},
                                                                                     {"draw", "x"},
                                                                                     {"confidence", "1"},
                                                                                     {"mission", ""}})
    EXPECT_TRUE(take(d, field, written_in_option("--" + field, value))) << field << " " << value;
}

TEST(Plan, PutsTheSeedOfTheRunInAValue) {
  Definition d = defined({{"runs", "3"}, {"seed", "7"}, {"set", "OVERLAY=maps/{seed}/a_{seed}.odl,b.odl"}});
  ASSERT_FALSE(settle(d));
  const Plan plan(d);
  EXPECT_EQ(plan.combinations(), 2U);
  EXPECT_TRUE(plan.names_seeds());
  EXPECT_EQ(text_of(plan.settings({0, 0, 2})), "OVERLAY=maps/9/a_9.odl");
  EXPECT_EQ(text_of(plan.settings({0, 1, 2})), "OVERLAY=b.odl");
  EXPECT_EQ(text_of(plan.settings(0U)), "OVERLAY=maps/{seed}/a_{seed}.odl") << "of all its runs";
  EXPECT_EQ(text_of(plan.extremes(0, true)), "OVERLAY=maps/7/a_7.odl");
}

TEST(Definition, HasTheConfidenceOfItsRequirement) {
  Definition d = defined({{"require", "success >= 0.9 @ 0.99"}});
  EXPECT_FALSE(settle(d));
  EXPECT_EQ(d.confidence, 0.99);
}

}  // namespace
}  // namespace mlab::study
