#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "mlab/lang/odl/odl.h"
#include "mlab/lang/odl/testing/check_print.h"

namespace mlab::odl {
namespace {

std::string formatted(const std::string& text) {
  text::Diagnostics sink;
  return print(parse(std::make_shared<const text::Source>("t.odl", text), sink));
}

TEST(OdlPrint, PutsOneStatementOnALineWithKeywordsInCapitals) {
  EXPECT_EQ(
      formatted(
          "scenario  \"x\"   mission-area 10   20 control  measures: pp a*   1 2 Object 1 2 3 fixed red"),
      "SCENARIO \"x\"\nMISSION-AREA 10 20\n\nCONTROL MEASURES:\n\nPP a* 1 2\nOBJECT 1 2 3 FIXED red\n");
}

TEST(OdlPrint, KeepsCommentsWhereTheyStand) {
  const std::string text =
      "-- head\n\n-- of the file\nSITE x  -- beside\n-- before the header\n\nCONTROL MEASURES:  -- here they "
      "come\n\n"
      "AA a 1 2  -- first\n    -- between\n    3 4\n-- last\n\n-- end\n";
  EXPECT_EQ(formatted(text),
            "-- head\n\n-- of the file\nSITE x  -- beside\n\n-- before the header\n\nCONTROL MEASURES:  -- "
            "here they "
            "come\n\nAA a 1 2  -- first\n    -- between\n    3 4\n-- last\n\n-- end\n");
}

TEST(OdlPrint, KeepsAtMostOneBlankLineAndTheLinesOfPoints) {
  EXPECT_EQ(formatted("SITE x\n\n\n\nCONTROL MEASURES:\nAA a 1 2\n3 4\n 5\n6\n\n\n\nPP b 1 2\n"),
            "SITE x\n\nCONTROL MEASURES:\n\nAA a 1 2\n    3 4\n    5 6\n\nPP b 1 2\n");
}

TEST(OdlPrint, BreaksLongLinesBetweenPoints) {
  std::string text = "SITE x CONTROL MEASURES: BOUNDARY b";
  for (int i = 0; i < 30; ++i) text += " 1234.5 6789.1";
  const std::string out = formatted(text);
  std::size_t longest = 0;
  for (std::size_t at = 0; at < out.size(); at = out.find('\n', at) + 1) {
    longest = std::max(longest, out.find('\n', at) - at);
  }
  EXPECT_LE(longest, 100U);
  EXPECT_EQ(out.find("1234.5\n"), std::string::npos);
}

TEST(OdlPrint, BreaksLongRoutesBetweenPoints) {
  std::string text = "SITE x CONTROL MEASURES: OBSTACLE 1 2 3 ROUTE";
  for (int i = 0; i < 30; ++i) text += " 1234.5 6789.1";
  const std::string out = formatted(text + " SPEED 2");
  EXPECT_EQ(out.find("1234.5\n"), std::string::npos);
  EXPECT_NE(out.find("6789.1\n    1234.5"), std::string::npos);
  EXPECT_TRUE(out.ends_with(" SPEED 2\n"));
}

TEST(OdlPrint, KeepsBrokenStatementsAsTheyAre) {
  EXPECT_EQ(formatted("SITE x\nCONTROL MEASURES:\nPP  a   1 -- why\n  two\npp b 1 2\n"),
            "SITE x\n\nCONTROL MEASURES:\n\nPP  a   1 -- why\n  two\nPP b 1 2\n");
}

// Overlays out of pieces that are right alone, with white space and comments between them.
std::string random_overlay() {
  static const std::vector<std::string> kInformation = {"SCENARIO \"a b\"",
                                                        "site x",
                                                        "ORIGIN -5 +5.5",
                                                        "ORIGIN UTM LAT 33.7 LON -84.4",
                                                        "ORIGIN GEO \"33.7 N 84.4 W\"",
                                                        "HEADING 90",
                                                        "SET ZOOM-FACTOR 50",
                                                        "MISSION-AREA 100. .5e3",
                                                        "SCALE 25000",
                                                        "GLOBAL_REF_POINT 1 2",
                                                        "HEIGHTMAP a.hm 8 6 1 1",
                                                        "LOAD-MAP \"x\"",
                                                        "Scenario DOOR"};
  static const std::vector<std::string> kFeatures = {
      "PP a* 1 2",
      "pp \"b*\" 1 2 3",
      "AA c 1 2 3 4 5 6",
      "Gap Door 1 2 3 4 5",
      "BOUNDARY \"\" 1 2 3 4",
      "OBSTACLE 1 2 3 4",
      "obstacle 1 2 3 Route 4 5 UTM LAT 33.7 LON -84.4 6 7 speed 1.5",
      "flag 1 2 Route 4 5 UTM LAT 33.7 LON -84.4 speed 1.5 object 1 2 3 fixed red route 4 5 6 7 speed 1",
      "OBJECT 1 2 3 Fixed red",
      "ATTRACTOR 1 2",
      "HALLWAY h CENTERLINE 1 2 3 4 WIDTH 5 EXTENTS 6 7 8 9",
      "LD/LC e 1 2",
      "ROAD r 1 2 3 4 5",
      "PL u UTM LAT 33.7 LON -84.4 UTM LON -84.4 LAT 33.7",
      "PL v GEO \"33.7 N 84.4 W\" 1 2 geo \"16SGC4072331003\"",
      "obstacle geo \"33.7 -84.4\" 3 Route 4 5 GEO \"33.7 N 84.4 W\" speed 1.5",
      "SP s 1 2",
      "WAYPOINT-FILE \"w\""};
  static const std::vector<std::string> kSpaces = {
      " ",      "\n",      "\n\n",
      "\n\n\n", " -- c\n", "\n-- own line\n",
      "\t",     "\r\n",    "\n\n  -- after a blank\n-- and another  \n\n",
      " , "};
  const auto space = [] { return *rc::gen::elementOf(kSpaces); };
  // Blanks outside of quotes become any white space: a statement may spread over lines.
  const auto spread = [&](const std::string& piece) {
    std::string out;
    bool is_quoted = false;
    for (const char c : piece) {
      is_quoted = is_quoted != (c == '"');
      out += c == ' ' && !is_quoted ? space() : std::string(1, c);
    }
    return out;
  };
  std::string out = space();
  for (const auto& piece : *rc::gen::container<std::vector<std::string>>(rc::gen::elementOf(kInformation))) {
    out += spread(piece) + space();
  }
  out += "CONTROL MEASURES:" + space();
  for (const auto& piece : *rc::gen::container<std::vector<std::string>>(rc::gen::elementOf(kFeatures))) {
    out += spread(piece) + space();
  }
  return out;
}

RC_GTEST_PROP(OdlPrint, IsStableKeepsCommentsAndChangesNoMeaning, ()) {
  const std::string text = random_overlay();
  RC_LOG(text);
  bool had_errors = true;
  RC_ASSERT(what_print_changes(text, had_errors) == "");
  RC_ASSERT(!had_errors);
}

}  // namespace
}  // namespace mlab::odl
