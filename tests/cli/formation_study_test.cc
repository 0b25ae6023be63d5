// A small version of missions/formation_study: that it runs, and that its README tells what comes out.

#include <map>
#include <string>
#include <tuple>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "command.h"

namespace mlab {
namespace {

using Json = nlohmann::json;
using FormationStudy = Command;

TEST_F(FormationStudy, HasAllCombinationsAndTheOrderOfItsReadme) {
  const Outcome out =
      mlab("batch " + kMissions +
           "formation_study/study.toml --runs 2 --patience 60 --table t.json --html p.html --quiet");
  EXPECT_EQ(out.status, 0) << out.err;
  const Json table = Json::parse(text_of(folder_ / "t.json"));
  EXPECT_EQ(table["summary"]["combinations"].size(), 24U);
  ASSERT_EQ(table["runs"].size(), 48U);
  std::map<std::tuple<std::string, std::string, int>, double> turn;  // error by reference, formation and seed
  for (const Json& row : table["runs"]) {
    EXPECT_EQ(row["contacts"], 0) << row.dump();
    EXPECT_GE(row["path_ratio"].get<double>(), 1.0) << row.dump();
    EXPECT_GT(row["formation_error_m"].get<double>(), 0.0) << row.dump();
    EXPECT_GT(row["out_of_formation"].get<double>(), 0.0) << row.dump();
    if (has(row["OVERLAY"], "obstacle_field")) continue;
    EXPECT_EQ(row["outcome"], "done") << row.dump();
    turn[{row["formation_reference"], row["FORMATION"], row["seed"]}] = row["formation_error_m"];
  }
  EXPECT_EQ(turn.size(), 24U);
  for (const int seed : {1, 2}) {
    const auto error = [&](const char* reference, const char* formation) {
      return turn.at({reference, formation, seed});
    };
    for (const char* other : {"Line", "Column", "Wedge"})
      EXPECT_LT(error("unit-center", "Diamond"), error("unit-center", other)) << seed;
    for (const char* other : {"Column", "Diamond"}) {
      EXPECT_LT(error("leader", "Line"), error("leader", other)) << seed;
      EXPECT_LT(error("leader", "Wedge"), error("leader", other)) << seed;
    }
    for (const char* formation : {"Line", "Column", "Wedge", "Diamond"})
      EXPECT_LT(error("unit-center", formation), error("leader", formation)) << seed;
  }
  EXPECT_TRUE(has(text_of(folder_ / "p.html"), "path ratio"));
}

}  // namespace
}  // namespace mlab
