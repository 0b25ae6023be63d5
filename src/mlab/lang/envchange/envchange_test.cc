#include "mlab/lang/envchange/envchange.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "mlab/base/testing/processor_time.h"
#include "mlab/base/testing/source_folder.h"
#include "mlab/text/testing/golden.h"

namespace mlab::envchange {
namespace {

namespace golden = text::testing;
const std::filesystem::path kFolder =
    std::filesystem::path(base::source_folder()) / "src/mlab/lang/envchange";

std::vector<overlay::EnvironmentEvent> events(const std::string& text, geom::Offset origin = {}) {
  text::Diagnostics sink;
  const auto changes = parse(std::make_shared<const text::Source>("t.env", text), origin, sink);
  EXPECT_TRUE(changes) << text::render(sink);
  return changes ? changes->events : std::vector<overlay::EnvironmentEvent>{};
}

TEST(EnvironmentChangeFile, HasEventsWithAStartAndPerhapsAPeriod) {
  const auto e = events(
      "STEP_COUNT 10 REMOVE OBSTACLE 1 2 // once\nstep_count 0.6 99.5 /* again\nand again */ add obstacle 3 "
      "4 5");
  ASSERT_EQ(e.size(), 2U);
  EXPECT_EQ(e[0].start, 10.0);
  EXPECT_EQ(e[0].period, 0.0);
  EXPECT_EQ(e[1].start, 1.0);
  EXPECT_EQ(e[1].period, 100.0);
  const auto& add = std::get<overlay::AddObstacle>(e[1].changes.at(0));
  EXPECT_EQ(add.center, (geom::Point{3, 4}));
  EXPECT_EQ(add.radius, 5.0);
}

TEST(EnvironmentChangeFile, MayDoSeveralThingsAtOnce) {
  const auto e = events(
      "STEP_COUNT 1 ADD OBSTACLE 1 2 3 REMOVE OBSTACLE 1 2 REGION 1 2 3 4 REMOVE OBSTACLE ADD OBSTACLE 1 1 "
      "1");
  ASSERT_EQ(e.size(), 1U);
  EXPECT_EQ(e[0].changes.size(), 4U);
}

TEST(EnvironmentChangeFile, AddsTheOriginAndTakesCornersInAnyOrder) {
  const auto e = events("STEP_COUNT 1 REGION 200 0 0 -100 REMOVE OBSTACLE REMOVE OBSTACLE 1 1", {10, 20});
  const auto& region = std::get<overlay::ClearRegion>(e[0].changes[0]).region;
  EXPECT_EQ(region.low, (geom::Point{10, -80}));
  EXPECT_EQ(region.high, (geom::Point{210, 20}));
  EXPECT_EQ(std::get<overlay::RemoveObstacle>(e[0].changes[1]).center, (geom::Point{11, 21}));
}

TEST(EnvironmentChangeFile, FillsRegionsWithOrWithoutASeed) {
  const auto e = events(
      "STEP_COUNT 1 100 REGION 0 0 200 200 ADD OBSTACLE 3 1 5 1\nREGION 0 0 9 9 ADD OBSTACLE 3 1 5 7, 2\n"
      "REGION 0 0 9 9 ADD OBSTACLE 3 1 5\nREGION 0 0 9 9 ADD OBSTACLE 3 1 5 -1");
  const auto fill = [&](std::size_t i) { return std::get<overlay::FillRegion>(e.at(0).changes.at(i)); };
  EXPECT_EQ(fill(0).field.coverage_percent, 3.0);
  EXPECT_EQ(fill(0).field.min_radius, 1.0);
  EXPECT_EQ(fill(0).field.max_radius, 5.0);
  EXPECT_EQ(fill(0).seed, 1.0);
  EXPECT_EQ(fill(0).seed_increment, 0.0);
  EXPECT_EQ(fill(1).seed, 7.0);
  EXPECT_EQ(fill(1).seed_increment, 2.0);
  EXPECT_FALSE(fill(2).seed);
  EXPECT_FALSE(fill(3).seed);
}

TEST(EnvironmentChangeFile, MayBeEmpty) {
  EXPECT_TRUE(events(" // nothing\r\n").empty());
}

TEST(EnvironmentChangeFile, ParsesAsItsPageShowsIt) {
  const std::string page =
      golden::read_all(std::filesystem::path(base::source_folder()) / "docs/languages/odl.md");
  const std::string fence = "\n```env\n";
  const std::size_t begin = page.find(fence);
  ASSERT_NE(begin, std::string::npos);
  const std::size_t end = page.find("\n```", begin + fence.size());
  const auto e = events(page.substr(begin + fence.size(), end - begin - fence.size()));
  ASSERT_EQ(e.size(), 2U);
  EXPECT_EQ(e[1].changes.size(), 2U);
}

TEST(EnvironmentChangeFile, ThatIsMissingSaysSo) {
  text::Diagnostics sink;
  EXPECT_FALSE(load("/nonexistent/a.env", {}, sink));
  EXPECT_TRUE(sink.has_errors());
}

std::string repeated(const std::string& piece) {
  std::string out;
  while (out.size() < base::kMegabyte) out += piece;
  return out;
}

// False: it has mistakes.
bool answer(const std::string& text) {
  text::Diagnostics sink;
  static_cast<void>(parse(std::make_shared<const text::Source>("t.env", text), {}, sink));
  static_cast<void>(text::render(sink));
  return !sink.has_errors();
}

TEST(EnvironmentChangeFile, OfAMegabyteOfAnythingIsAnsweredAsSoonAsOneWithAMistakeInEachLine) {
  EXPECT_TRUE(answer(repeated("STEP_COUNT 1 ADD OBSTACLE 1 2 3\n")));
  const std::string ordinary = repeated("STEP_COUNT 1 ADD OBSTACLE 1 two 3\n");
  const base::Yardstick yardstick([&] { EXPECT_FALSE(answer(ordinary)); });
  for (const std::string piece : {"STEP_COUNT\n", "STEP_COUNT 1 ", "ADD\n", "REGION ", "x ", "x\n", "1 ", "9",
                                  "-", ".", "/", "/*", "//\n", "/**/", ",", "\xff "}) {
    const std::string text = repeated(piece);
    EXPECT_LT(yardstick.times([&] { answer(text); }, base::kPatience), base::kPatience) << piece;
  }
}

TEST(LooksLikeEnvchange, IsToldByTheFirstWord) {
  EXPECT_TRUE(looks_like_envchange("/* a */ // b\n Step_Count 1"));
  EXPECT_FALSE(looks_like_envchange("SCENARIO x"));
  EXPECT_FALSE(looks_like_envchange(""));
}

TEST(EnvironmentChangeGolden, FilesGetTheDiagnosticsThatStandAtTheirEnd) {
  for (const auto& path : golden::golden_files(kFolder / "testdata", ".env")) {
    golden::check_golden(path, "//", [](const text::SourcePtr& source) {
      text::Diagnostics sink;
      const auto changes = parse(source, {}, sink);
      return (changes ? "accepted\n" : "refused\n") + text::render(sink);
    });
  }
}

TEST(EnvironmentChangeGolden, EveryKindOfDiagnosticHasOne) {
  const auto said = golden::kinds_said_in(kFolder, {"error(", "warning(", "fail_expected("});
  EXPECT_EQ(said.size(), 5U);
  EXPECT_EQ(said, golden::kinds_expected_in(golden::golden_files(kFolder / "testdata", ".env")));
}

}  // namespace
}  // namespace mlab::envchange
