#include "mlab/lang/odl/write.h"

#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/lang/odl/odl.h"

namespace mlab::odl {
namespace {

// Reads a text, changes its last statement, and says the text afterwards.
template <class Change>
std::string after(const std::string& text, Change change) {
  text::Diagnostics unsaid;
  const Tree tree = parse(std::make_shared<const text::Source>("t.odl", text), unsaid);
  std::vector<text::Span> words;
  for (const Token& token : tree.tokens) {
    if (token.span.end > token.span.begin) words.push_back(token.span);
  }
  Statement now = tree.statements.back();
  change(now);
  text::WordChanges changes(tree.source, words);
  changes.reword(now.span, words_of(now, tree));
  return text::spliced(text, changes.joined().value());
}

TEST(OdlWrite, LeavesWhatIsNotChangedAsItIsWritten) {
  for (const char* text :
       {"control measures:\nhallway  \"a b\"* Centerline 1.0 2 -- c\n 3 4 width 5 extents 1 2",
        "CONTROL MEASURES: Object 1 2 3.00 fixed  red", "CONTROL MEASURES: pp a utm lon -84.3 lat 33.7 +12",
        "CONTROL MEASURES: obstacle 1.0 2 3, 4 route 5 6 7 08  -- there\n speed 1.50", "mission-area 1e2 200",
        "SET Zoom-Factor 50", "SCENARIO \"x\"", "HEIGHTMAP h.pgm 1 2 3 4"}) {
    EXPECT_EQ(after(text, [](Statement&) {}), text);
  }
}

TEST(OdlWrite, WritesOnlyTheWordsThatChange) {
  EXPECT_EQ(after("CONTROL MEASURES:\nWALL w 0 0, 5.0 5; -- there\n 6 6 2",
                  [](Statement& now) {
                    now.points[1].y = {7.125, {}};
                    now.name = {"the wall", true, {}};
                  }),
            "CONTROL MEASURES:\nWALL \"the wall*\" 0 0, 5.0 7.12 ; -- there\n 6 6 2");
  EXPECT_EQ(after("CONTROL MEASURES: OBJECT 1 2 3 FIXED red",
                  [](Statement& now) { now.style = overlay::ObjectStyle::kMovable; }),
            "CONTROL MEASURES: OBJECT 1 2 3 MOVABLE red");
}

TEST(OdlWrite, PrintsANewStatement) {
  Statement now;
  now.keyword = keyword_of(overlay::MeasureKind::kPassagePoint);
  now.name = {"a", true, {}};
  now.points = {{.x = {1.5, {}}, .y = {-2.0, {}}}};
  EXPECT_EQ(print(now), "PP a* 1.5 -2");
}

TEST(OdlWrite, WritesTheRouteOfAnObject) {
  EXPECT_EQ(after("CONTROL MEASURES: flag 1 2 route 4 5 -- there\n 6 7 speed 1.50",
                  [](Statement& changed) { changed.route[1].x = {8.0, {}}; }),
            "CONTROL MEASURES: flag 1 2 route 4 5 -- there\n 8 7 speed 1.50");
  EXPECT_EQ(after("CONTROL MEASURES: object 1 2 3 fixed red route 4 5 speed 1.50",
                  [](Statement& changed) { changed.style = overlay::ObjectStyle::kMovable; }),
            "CONTROL MEASURES: object 1 2 3 MOVABLE red route 4 5 speed 1.50");
}

TEST(OdlWrite, WritesTheRouteOfAnObstacle) {
  Statement now;
  now.keyword = Keyword::kObstacle;
  now.points = {{.x = {1.5, {}}, .y = {-2.0, {}}}};
  now.numbers = {{3.0, {}}};
  now.route = {{.x = {4.0, {}}, .y = {5.0, {}}}, {.x = {6.0, {}}, .y = {7.0, {}}}};
  now.speed = NumberSyntax{1.25, {}};
  EXPECT_EQ(print(now), "OBSTACLE 1.5 -2 3 ROUTE 4 5 6 7 SPEED 1.25");
  EXPECT_EQ(after("CONTROL MEASURES: obstacle 1 2 3 route 4 5 -- there\n 6 7 speed 1.50",
                  [](Statement& changed) { changed.route[1].x = {8.0, {}}; }),
            "CONTROL MEASURES: obstacle 1 2 3 route 4 5 -- there\n 8 7 speed 1.50");
}

TEST(OdlWrite, WritesNumbersBriefly) {
  EXPECT_EQ(written(12.5), "12.5");
  EXPECT_EQ(written(12.0), "12");
  EXPECT_EQ(written(-0.001 + 0.001), "0");
  EXPECT_EQ(written(-3.14159), "-3.14");
  EXPECT_EQ(written(100), "100");
  EXPECT_EQ(written(0.0012), "0.0012");
}

}  // namespace
}  // namespace mlab::odl
