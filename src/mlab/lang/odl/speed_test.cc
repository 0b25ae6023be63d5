#include <string>
#include <vector>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "mlab/base/random.h"
#include "mlab/base/testing/processor_time.h"
#include "mlab/lang/odl/odl.h"

namespace mlab::odl {
namespace {

// All that any command does with an overlay. False: it has mistakes.
bool answer(const std::string& text) {
  text::Diagnostics sink;
  overlay::Overlay overlay;
  const Tree tree = parse(std::make_shared<const text::Source>("t.odl", text), sink);
  apply(tree, overlay, sink, Companions::kIgnore);
  static_cast<void>(print(tree));
  static_cast<void>(text::render(sink));
  static_cast<void>(looks_like_odl(text));
  return !sink.has_errors();
}

std::string features(std::size_t count) {
  std::string text = "SITE x\nCONTROL MEASURES:\n";
  for (std::size_t i = 0; i < count; ++i) {
    text += i % 2 == 0 ? fmt::format("PP point-{} {} {} 2.5\n", i, i % 1000, i / 1000)
                       : fmt::format("WALL \"wall {}\" 1 2 {} {}.5 5 6\n", i, i % 1000, i / 1000);
  }
  return text;
}

double times_longer(const std::string& text) {
  static const std::string kOrdinary = features(base::kMegabyte / 30);
  static const base::Yardstick kYardstick([] { EXPECT_TRUE(answer(kOrdinary)); });
  return kYardstick.times([&] { answer(text); }, base::kPatience);
}

std::string repeated(std::string_view piece) {
  std::string out = "SITE x\nCONTROL MEASURES:\n";
  while (out.size() < base::kMegabyte) out += piece;
  return out;
}

TEST(OdlSpeed, AnswersAMegabyteOfAnythingSoon) {
  const std::vector<std::string> pieces = {"x ",
                                           "x\n",
                                           "PP ",
                                           "PP\n",
                                           "PP x\n",
                                           "PP x 1\n",
                                           "\"",
                                           "\"\n",
                                           ",",
                                           ", ",
                                           "CONTROL ",
                                           "CONTROL\t",
                                           "CONTROL MEASURES:\n",
                                           "PP a 1 2\n",
                                           "PP a 1 2 ",
                                           "--\n",
                                           "-- c -- c ",
                                           "UTM ",
                                           "PP a UTM LAT 1 LON 2\n",
                                           "BONDARY\n",
                                           "BONDARY ",
                                           "9",
                                           "9 ",
                                           "-",
                                           "- ",
                                           "+",
                                           "+ ",
                                           ".",
                                           "\xff",
                                           "\xff ",
                                           "PP\nDoor\n",
                                           "PP \"x\n",
                                           "\n",
                                           " ",
                                           "\r",
                                           "\r\n",
                                           std::string(1, '\0'),
                                           "*",
                                           "a*",
                                           "OBSTACLE 1 2 0\n",
                                           "MISSION-AREA 1 1\n",
                                           "HALLWAY h CENTERLINE 1 2 WIDTH 1 EXTENTS 3 4\n",
                                           "SCENARIO\nSITE x\n",
                                           "OBJECT 1 2 3 FIXED\n",
                                           "1e999 ",
                                           "PP 1e999 1e999\n",
                                           "WAYPOINT-FILE x\n",
                                           "LOAD-MAP x\n",
                                           "PP a 1 2 -- c\n"};
  for (const std::string& piece : pieces) {
    EXPECT_LT(times_longer(repeated(piece)), base::kPatience) << "`" << piece << "`";
  }
}

TEST(OdlSpeed, AnswersAMegabyteOfRandomBytesSoon) {
  base::Random random(1);
  for (const std::uint64_t range : {256ULL, 128ULL, 64ULL}) {
    std::string text = "CONTROL MEASURES:\n";
    while (text.size() < base::kMegabyte) text += static_cast<char>(random.below(range));
    EXPECT_LT(times_longer(text), base::kPatience);
  }
}

TEST(OdlSpeed, LoadsManyFeaturesInTimeThatGrowsWithThem) {
  EXPECT_LT(
      base::growth([](std::size_t count) { EXPECT_TRUE(answer(features(count))); }, base::kMegabyte / 80),
      base::kGrowthOfLine);
}

}  // namespace
}  // namespace mlab::odl
