#include "mlab/text/diagnostic.h"

#include <memory>

#include <gtest/gtest.h>

#include "mlab/base/testing/processor_time.h"

namespace mlab::text {
namespace {

Place place_of(const SourcePtr& source, std::string_view word) {
  const auto at = static_cast<std::uint32_t>(source->text().find(word));
  return {source, {at, at + static_cast<std::uint32_t>(word.size())}};
}

TEST(Render, LetsNoFileSpeakToTheTerminal) {
  const auto source = std::make_shared<const Source>("a\x1b[2J.mdl", "use \x1b]0;me\x07;\n");
  Diagnostics sink;
  Diagnostic& d = sink.error("cannot-read", {source, {4, 8}}, "cannot read `\x1b[31m\n`");
  d.label = "\x9b";
  d.hints = {"\x07"};
  d.notes = {{"\x1b[0m", {source, {0, 1}}}};
  for (const std::string& text : {render(sink), render(sink.items()[0])}) {
    for (const char one : text)
      EXPECT_TRUE(one == '\n' || (one >= ' ' && one < 0x7f)) << static_cast<int>(one) << " in " << text;
  }
}

TEST(Render, ShowsTheLineWithCaretsHintsAndNotes) {
  const auto mission = std::make_shared<const Source>("demo.mdl", "x\n  2. MOVETO ATK-AP9\n");
  const auto map = std::make_shared<const Source>("democ.odl", "ATK AP1 1 2\n");
  Diagnostics sink;
  Diagnostic& d = sink.error("unknown-control-measure", place_of(mission, "ATK-AP9"),
                             "unknown control measure `ATK-AP9`");
  d.label = "not in overlay `democ.odl`";
  d.hints = {"did you mean `ATK-AP1`?"};
  d.notes = {{"`AP1` declared here", place_of(map, "AP1")}};
  EXPECT_EQ(render(sink),
            "demo.mdl:2:13: error: unknown control measure `ATK-AP9` [unknown-control-measure]\n"
            "    2 |   2. MOVETO ATK-AP9\n"
            "      |             ^^^^^^^ not in overlay `democ.odl`\n"
            "      = hint: did you mean `ATK-AP1`?\n"
            "democ.odl:1:5: note: `AP1` declared here\n");
}

TEST(Render, NeverPrintsControlCharactersOfTheSource) {
  const auto source = std::make_shared<const Source>("a", "a\x1b[31mb");
  Diagnostics sink;
  sink.error("k", {source, {0, 1}}, "m");
  EXPECT_EQ(render(sink).find('\x1b'), std::string::npos);
}

TEST(Render, CutsALongLineAroundTheCarets) {
  const auto source =
      std::make_shared<const Source>("a", std::string(5000, 'x') + "Y" + std::string(5000, 'z'));
  Diagnostics sink;
  sink.error("k", {source, {5000, 5001}}, "m");
  const std::string out = render(sink);
  EXPECT_LT(out.size(), 400U);
  EXPECT_NE(out.find('Y'), std::string::npos);
}

TEST(Render, CountsCharactersNotBytesInALongLine) {
  std::string text;
  for (int i = 0; i < 200; ++i) text += "\xc3\xa4";
  const auto source = std::make_shared<const Source>("a", text + "Y" + text);
  Diagnostics sink;
  sink.error("k", {source, {400, 401}}, "m");
  const std::string out = render(sink);
  EXPECT_NE(out.find("a:1:201: "), std::string::npos) << out;
  EXPECT_NE(out.find("\n      | " + std::string(53, ' ') + "^\n"), std::string::npos) << out;
}

TEST(Render, OfALineOfMegabytesGrowsWithItsLengthOnly) {
  const auto show = [](std::size_t size) {
    const auto source = std::make_shared<const Source>("a", std::string(size, '\xff'));
    const auto step = static_cast<std::uint32_t>(size / 104);
    Diagnostics sink;
    for (std::uint32_t i = 0; i < 100; ++i) sink.error("k", {source, {i * step, i * step + step / 20}}, "m");
    EXPECT_LT(render(sink).size(), 200000U);
  };
  EXPECT_LT(base::growth(show, base::kMegabyte / 4), base::kGrowthOfLine);
}

TEST(Diagnostics, KeepsTheFirstHundredErrorsAndCountsTheRest) {
  Diagnostics sink;
  for (int i = 0; i < 250; ++i) sink.error("k", {}, "m").hints = {"h"};
  EXPECT_EQ(sink.items().size(), 100U);
  EXPECT_EQ(sink.error_count(), 250U);
  EXPECT_NE(render(sink).find("150 more"), std::string::npos);
}

TEST(ReadSource, SaysWhyAFileCannotBeRead) {
  const Result<SourcePtr> missing = read_source("/nonexistent/file");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().kind, "cannot-read");
  EXPECT_NE(missing.error().message.find("No such file"), std::string::npos);
  EXPECT_FALSE(read_source("/"));  // a folder
}

TEST(NearestName, FindsWhatSomebodyMeant) {
  const std::vector<std::string> names = {"MOVETO", "OCCUPY", "navigation_avoid_obstacle_gain"};
  EXPECT_EQ(nearest_name("MOVTO", names), "MOVETO");
  EXPECT_EQ(nearest_name("navigation_avoid_obstacel_gain", names), "navigation_avoid_obstacle_gain");
  EXPECT_EQ(nearest_name("moveto", names), "MOVETO");
  EXPECT_EQ(nearest_name("OCUPPYY", names), "OCCUPY");
  EXPECT_EQ(nearest_name("xyzzy", names), "");
  EXPECT_EQ(nearest_name("", names), "");
}

TEST(NearestName, TakesTheFirstOfSeveralThatAreAsNear) {
  const std::vector<std::string> names = {"ab", "abcd", "abcf", "abce"};
  EXPECT_EQ(nearest_name("abcg", names), "abcd");
  EXPECT_EQ(nearest_name("abce", names), "abce");
}

}  // namespace
}  // namespace mlab::text
