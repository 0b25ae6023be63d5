#include "mlab/study/study_file.h"

#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "mlab/study/plan.h"

namespace mlab::study {
namespace {

std::string told(const std::string& text, Definition& out) {
  text::Diagnostics sink;
  const bool is_good = read_study(std::make_shared<const text::Source>("folder/study.toml", text), out, sink);
  EXPECT_EQ(is_good, sink.items().empty());
  return text::render(sink);
}
std::string told(const std::string& text) {
  Definition unused;
  return told(text, unused);
}

TEST(StudyFile, HasNothingThatItsParserDoesNotBear) {
  EXPECT_EQ(told("\xef\xbb\xbf# caf\xc3\xa9\nmission = \"caf\xc3\xa9.mdl\" # \xd0\x98\nruns = 2\n"), "");
  EXPECT_EQ(told("mission = \"\"\"a\\\n  \xc3\xa9.mdl\"\"\"\nruns = 2\n"), "");
  EXPECT_EQ(told("# a\xe2\x80\xa8\xd0\x98\nruns = 2\n"), "");
  EXPECT_EQ(told("mission = 'caf\xc3\xa9.mdl'\nruns = 2\n"), "");
  EXPECT_EQ(told("mission = \"\"\"a\\\n  b\xc3\xa9.mdl\"\"\"\nruns = 2\n"), "");
  EXPECT_EQ(told("mission = \"\"\"caf\xc3\xa9\"\"\"\"\"\nruns = 2\n"), "")
      << "two more quotes are of the text";
  for (const char* wrong :
       {"caf\xc3\xa9 = 1\n", "mission = 26-\xd0\x98\n", "mission = \"a.mdl\"\xc3\xa9\n",
        "\xc2\xa0mission = \"a\"\n", "mission = \"a\n\xc3\xa9\n", "[[[\n", "mission = 26\"\"\"-\xd0\x98\n",
        "mission = \"a\"\"\xc3\xa9\"\n", "runs = 26..\"\"\"-\xd0\x98\n", "runs = 2 # x\n [ .a]\n",
        "mission = 'a'\n[\n", "[]\n"}) {
    const std::string said = told(wrong);
    EXPECT_NE(said.find("[no-toml]"), std::string::npos) << wrong << said;
    EXPECT_NE(said.find("study.toml:"), std::string::npos) << said;
  }
  EXPECT_NE(told("runs = 2\n\n [ .a]\nseed = 1\n").find("study.toml:3:1: error: what stands here is no TOML"),
            std::string::npos)
      << told("runs = 2\n\n [ .a]\nseed = 1\n");
}

TEST(StudyFile, HasTheOptionsAsKeys) {
  Definition d;
  EXPECT_EQ(told(R"(# a comment
mission = "demo.mdl"
runs = 1_000
seed = 5
start-time = "2026-03-01 08:30"
success = 'outcome == done and contacts == 0'
require = ["success >= 0.95 @ 0.99", "success <= 0.999"]
until = "decided"
limit = 900.5
draw = "latin"
html = "out.html"

[set]
base_velocity = [1, 2.5]
"scout:robot_radius" = "0.1:0.3:0.1"
avoid_gain = "1..5"
)",
                 d),
            "");
  EXPECT_EQ(d.mission.text, "folder/demo.mdl");
  EXPECT_EQ(d.page, "folder/out.html");
  EXPECT_EQ(d.runs, 1000U);
  EXPECT_EQ(d.start_time, "2026-03-01 08:30");
  EXPECT_EQ(d.requirements.size(), 2U);
  EXPECT_EQ(d.limit, 900.5);
  EXPECT_TRUE(d.until->is_decided);
  ASSERT_EQ(d.dimensions.size(), 3U);
  EXPECT_EQ(d.dimensions[0].name.text, "base_velocity");
  EXPECT_EQ(d.dimensions[0].values[1].text, "2.5");
  EXPECT_EQ(d.dimensions[1].name.text, "scout:robot_radius");
  EXPECT_EQ(d.dimensions[1].values.size(), 3U);
  EXPECT_TRUE(d.dimensions[2].is_drawn());
  EXPECT_FALSE(settle(d));
  EXPECT_EQ(Plan(d).combinations(), 6U);
}

TEST(StudyFile, SaysWhatIsWrongWithLineAndColumn) {
  EXPECT_NE(told("mission = \"a.mdl\"\nrun = 3\n").find("study.toml:2:1: error: a study has no `run`"),
            std::string::npos);
  EXPECT_NE(told("runs = 0\n").find("study.toml:1:8: error: expected a whole number from 1"),
            std::string::npos)
      << told("runs = 0\n");
  EXPECT_NE(told("success = \"durations < 3\"\n").find("study.toml:1:12: error"), std::string::npos)
      << told("success = \"durations < 3\"\n");
  EXPECT_NE(told("[set]\nv = \"1:5:-1\"\n").find("study.toml:2:6: error: steps of -1"), std::string::npos)
      << told("[set]\nv = \"1:5:-1\"\n");
  EXPECT_NE(told("runs = [1, 2]\n").find("expected a text or a number"), std::string::npos);
  EXPECT_NE(told("set = 3\n").find("expected a table of values"), std::string::npos);
  EXPECT_NE(told("[set]\nv = []\n").find("study.toml:2:5: error: expected values, and the list is empty"),
            std::string::npos)
      << told("[set]\nv = []\n");
  EXPECT_NE(told("[set]\nv = [1, \"\"]\n").find("study.toml:2:10: error: `v` has a value that is empty"),
            std::string::npos)
      << told("[set]\nv = [1, \"\"]\n");
  const std::string ordered = told("runs = 0\ncombine = \"all\"\nagain = 1\n");
  EXPECT_LT(ordered.find("study.toml:1:"), ordered.find("study.toml:2:")) << ordered;
  EXPECT_LT(ordered.find("study.toml:2:"), ordered.find("study.toml:3:")) << ordered;
}

TEST(StudyFile, IsTomlOrSaysWhereItIsNot) {
  EXPECT_NE(told("runs = \n").find("[no-toml]"), std::string::npos);
  EXPECT_NE(told("a = 1\na = 2\n").find("study.toml:2:"), std::string::npos) << told("a = 1\na = 2\n");
  for (const std::string& text :
       {std::string("\xff\xfe"), std::string(1000, '['), std::string("a = \"\\u0000\""),
        std::string("[set]\n\"\" = \"\"\n"), std::string("mission = \"\"")})
    EXPECT_NE(told(text), "") << text;
}

}  // namespace
}  // namespace mlab::study
