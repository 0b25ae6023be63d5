#include <string>
#include <vector>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "mlab/base/random.h"
#include "mlab/base/testing/processor_time.h"
#include "mlab/lang/odl/odl.h"

namespace mlab::odl {
namespace {

// For all that any command does with an overlay [s].
double seconds_for(const std::string& text) {
  return base::processor_seconds([&] {
    text::Diagnostics sink;
    overlay::Overlay overlay;
    const Tree tree = parse(std::make_shared<const text::Source>("t.odl", text), sink);
    apply(tree, overlay, sink, Companions::kIgnore);
    static_cast<void>(print(tree));
    static_cast<void>(text::render(sink));
    static_cast<void>(looks_like_odl(text));
  });
}

std::string repeated(std::string_view piece) {
  std::string out = "SITE x\nCONTROL MEASURES:\n";
  while (out.size() < base::kMegabyte) out += piece;
  return out;
}

TEST(OdlSpeed, AnswersAMegabyteOfAnythingWithinASecond) {
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
    EXPECT_LT(seconds_for(repeated(piece)), base::kSlowness) << "`" << piece << "`";
  }
}

TEST(OdlSpeed, AnswersAMegabyteOfRandomBytesWithinASecond) {
  base::Random random(1);
  for (const std::uint64_t range : {256ULL, 128ULL, 64ULL}) {
    std::string text = "CONTROL MEASURES:\n";
    while (text.size() < base::kMegabyte) text += static_cast<char>(random.below(range));
    EXPECT_LT(seconds_for(text), base::kSlowness);
  }
}

TEST(OdlSpeed, LoadsAHundredThousandFeaturesWithinASecond) {
  std::string text = "SITE x\nCONTROL MEASURES:\n";
  for (int i = 0; i < 100000; ++i) {
    text += i % 2 == 0 ? fmt::format("PP point-{} {} {} 2.5\n", i, i % 1000, i / 1000)
                       : fmt::format("WALL \"wall {}\" 1 2 {} {}.5 5 6\n", i, i % 1000, i / 1000);
  }
  EXPECT_LT(seconds_for(text), base::kSlowness);
}

}  // namespace
}  // namespace mlab::odl
