#include "mlab/console/documents/completion.h"

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "mlab/console/documents/check_text.h"
#include "mlab/lang/mdl/mdl.h"

namespace mlab::console {
namespace {

class CompletionTest : public ::testing::Test {
 protected:
  CompletionTest() {
    const std::string text =
        "NEW-ROBOT scout \"robot\"\nSP Start 1 2\nUNIT <pair> (<left> scout) (<\"right wing\"> "
        "ROBOT)\nCOMMAND "
        "LIST:\n0. QUIT\n";
    text::Diagnostics sink;
    auto mission = std::make_shared<mission::Mission>(
        *mdl::check_mission(std::make_shared<const text::Source>("m.mdl", text), "", sink));
    const auto place = [&](overlay::MeasureKind kind, const std::string& name) {
      overlay::ControlMeasure measure;
      measure.kind = kind;
      measure.name = name;
      measure.points = {{1, 2}, {3, 4}};
      mission->overlay.measures.push_back(measure);
    };
    place(overlay::MeasureKind::kPassagePoint, "Charlie");
    place(overlay::MeasureKind::kPhaseLine, "Red");
    place(overlay::MeasureKind::kAxis, "long way");
    place(overlay::MeasureKind::kObjective, "Field");
    mission->overlay.measures.back().points.push_back({5, 9});
    mission_ = mission;
  }

  // The texts that are offered at the bar.
  std::vector<std::string> at(Complete::Language language, std::string text) {
    Complete request;
    request.set_language(language);
    const std::size_t cursor = text.find('|');
    request.set_cursor(static_cast<std::uint32_t>(cursor));
    request.set_text(text.erase(cursor, 1));
    const Completions got =
        complete(request, {mission_.get(), &mission_->overlay, {"democ.odl", "my map.odl"}});
    begin_ = got.begin();
    std::vector<std::string> out;
    for (const Completions::Item& item : got.items()) out.push_back(item.text());
    return out;
  }
  std::vector<std::string> typed(const std::string& text) { return at(Complete::IMMEDIATE, text); }
  std::vector<std::string> in_mission(const std::string& text) { return at(Complete::MISSION, text); }
  std::vector<std::string> in_overlay(const std::string& text) { return at(Complete::OVERLAY, text); }
  static bool has(const std::vector<std::string>& list, const std::string& text) {
    return std::ranges::find(list, text) != list.end();
  }

  std::shared_ptr<const mission::Mission> mission_;
  std::uint32_t begin_ = 0;
};

using Strings = std::vector<std::string>;

TEST_F(CompletionTest, OffersRobotsByTheirNumbersAndWhatTheyCanDo) {
  EXPECT_EQ(typed("ro|"), (Strings{"ROBOT", "ROBOTS"}));
  EXPECT_EQ(typed("ROBOT |"), (Strings{"1", "2"}));
  EXPECT_EQ(typed("ROBOT 2 m|"), Strings{"MOVETO"});
  EXPECT_FALSE(has(typed("ROBOT 2 |"), "1")) << "ROBOT takes one number";
  EXPECT_TRUE(has(typed("robots 2 |"), "1"));
  EXPECT_FALSE(has(typed("robots 2 |"), "2")) << "it is named already";
  EXPECT_TRUE(has(typed("robots 2 |"), "STOP"));
  EXPECT_EQ(typed("ROBOTS 2 1 FOLLOW |"), (Strings{"PL-Red", "\"AXIS-long way\""}));
  EXPECT_TRUE(has(typed("ROBOTS 2 1 MOVETO 3 4 |"), "AND"));
}

TEST_F(CompletionTest, FollowsATypedCommandFromWordToWord) {
  EXPECT_EQ(typed("u|"), Strings{"UNIT"});
  EXPECT_EQ(typed("UNIT |"), (Strings{"<", "pair", "left", "\"right wing\""}));
  EXPECT_EQ(begin_, 5U);
  EXPECT_EQ(typed("UNIT \"r|"), Strings{"\"right wing\""});
  EXPECT_EQ(begin_, 5U);
  EXPECT_EQ(typed("UNIT left m|"), Strings{"MOVETO"});
  EXPECT_EQ(typed("UNIT left MOVETO |"),
            (Strings{"SP-Start", "PP-Charlie", "PL-Red", "\"AXIS-long way\"", "OBJ-Field"}));
  EXPECT_EQ(typed("UNIT left SEARCH |"), Strings{"OBJ-Field"});
  EXPECT_TRUE(has(typed("UNIT left VISIT PP-Charlie |"), "PL-Red"));
  EXPECT_TRUE(has(typed("UNIT left VISIT PP-Charlie 3 4 |"), "SPEED"));
  EXPECT_FALSE(has(typed("UNIT left VISIT PP-Charlie SPEED 3 |"), "PL-Red"));
  EXPECT_EQ(typed("UNIT left MOVETO ch|"), Strings{"PP-Charlie"});
  EXPECT_EQ(typed("UNIT left MOVETO pp-|"), Strings{"PP-Charlie"});
  EXPECT_EQ(typed("UNIT left FOLLOW |"), (Strings{"PL-Red", "\"AXIS-long way\""}));
  EXPECT_EQ(typed("UNIT left MOVETO PP-Charlie FORMATION w|"),
            (Strings{"Wedge", "Wedge-Left", "Wedge-Right"}));
  EXPECT_EQ(typed("UNIT left MOVETO 3 4 TECHNIQUE = b|"), Strings{"Bounding-Overwatch"});
  EXPECT_EQ(typed("UNIT left MOVETO 3 4 PHASE-LINE r|"), Strings{"PL-Red"});
  EXPECT_TRUE(has(typed("UNIT left MOVETO 3 4 PHASE-LINE Red |"), "ACKNOWLEDGE"));
  EXPECT_TRUE(has(typed("UNIT left MOVETO 3 4 PHASE-LINE Red ACK \"x\" |"), "WAIT"));
  EXPECT_TRUE(has(typed("UNIT left MOVETO 3 4 |"), "UNTIL"));
  EXPECT_FALSE(has(typed("UNIT left START 3 4 |"), "UNTIL"));
  EXPECT_TRUE(has(typed("UNIT left OCCUPY 3 4 |"), "UNTIL"));
  EXPECT_EQ(typed("UNIT left OCCUPY 3 4 UNTIL |"), Strings{"TIMEOUT"});
  EXPECT_EQ(typed("UNIT left STOP AND U|"), Strings{"UNIT"});
  EXPECT_EQ(typed("SET SHOW-M|"), Strings{"SHOW-MOVEMENT-VECTORS"});
  EXPECT_TRUE(has(typed("SET SHOW-TRAILS |"), "OFF"));
  EXPECT_TRUE(typed("UNIT left MOVETO 3 |").empty());
  EXPECT_TRUE(typed("UNIT left MOVETO 3 4 SPEED |").empty());
}

TEST_F(CompletionTest, FollowsAFailsafeFromWordToWord) {
  EXPECT_EQ(in_mission("OVERLAY x.odl\nFAILS|"), Strings{"FAILSAFE"});
  EXPECT_EQ(in_mission("FAILSAFE |"), (Strings{"OUTSIDE", "IN-CONTACT", "STUCK", "LINK-LOST",
                                               "PERCEPTS-STALE", "OPERATOR-ABSENT", "BATTERY", "FOR"}));
  EXPECT_EQ(in_mission("FAILSAFE BATTERY |"), Strings{"BELOW"});
  EXPECT_EQ(in_mission("FAILSAFE BATTERY BELOW |"), Strings{});
  EXPECT_EQ(in_mission("FAILSAFE FOR ROBOT BATTERY BELOW 30% |"),
            (Strings{"AFTER", "HOLD", "STOP", "RETURN", "CONTINUE"}));
  EXPECT_EQ(in_mission("FAILSAFE BATTERY BELOW 30% AFTER 3 |"),
            (Strings{"HOLD", "STOP", "RETURN", "CONTINUE"}));
  EXPECT_TRUE(has(in_mission("OVERLAY x.odl\nFAILSAFE FOR |"), "ROBOT"));
  EXPECT_EQ(in_mission("FAILSAFE FOR ROBOT OUT|"), Strings{"OUTSIDE"});
  EXPECT_TRUE(has(in_mission("FAILSAFE FOR ROBOT STUCK AFTER 3 |"), "HOLD"));
  EXPECT_TRUE(has(in_mission("OVERLAY x.odl\nFAILSAFE OUTSIDE |"), "PL-Red"));
  EXPECT_TRUE(has(in_mission("FAILSAFE OUTSIDE Field |"), "REVERSE INSIDE"));
  EXPECT_TRUE(has(in_mission("FAILSAFE STUCK |"), "AFTER"));
  EXPECT_FALSE(has(in_mission("FAILSAFE STUCK |"), "REVERSE INSIDE"));
  EXPECT_EQ(in_mission("FAILSAFE STUCK AFTER |"), Strings{});
  EXPECT_EQ(in_mission("FAILSAFE STUCK AFTER 3 |"), (Strings{"HOLD", "STOP", "RETURN", "CONTINUE"}));
  EXPECT_TRUE(has(in_mission("FAILSAFE STUCK AFTER 3 HOLD\n|"), "UNIT"));
  EXPECT_TRUE(has(in_mission("FAILSAFE OUTSIDE Field REVERSE INSIDE\n|"), "UNIT"));
}

TEST_F(CompletionTest, KnowsWhereInAMissionItIs) {
  EXPECT_TRUE(has(in_mission("|"), "OVERLAY"));
  EXPECT_EQ(in_mission("OVERLAY |"), (Strings{"\"democ.odl\"", "\"my map.odl\""}));
  EXPECT_EQ(in_mission("OVERLAY x.odl\nUNIT <u> sc|"), Strings{"scout"});
  EXPECT_EQ(in_mission("OVERLAY x.odl\nCOMMAND L|"), Strings{});
  EXPECT_EQ(in_mission("OVERLAY x.odl\nCOMM|"), Strings{"COMMAND LIST:"});
  EXPECT_EQ(in_mission("COMMAND LIST:\n 1. UNIT left MOVETO Charlie\n 2. UNIT l|\n 3. QUIT"),
            Strings{"left"});
  EXPECT_TRUE(has(in_mission("COMMAND LIST:\n 1. |"), "QUIT"));
  EXPECT_FALSE(has(in_mission("COMMAND LIST:\n 1. SET |"), "SEED"));
  EXPECT_TRUE(in_mission("-- OVER|").empty());
  EXPECT_TRUE(in_mission("MISSION NAME \"OVER|").empty());
}

TEST_F(CompletionTest, KnowsWhereInAnOverlayItIs) {
  EXPECT_EQ(in_overlay("MIS|"), Strings{"MISSION-AREA"});
  EXPECT_EQ(in_overlay("SITE x\nCON|"), Strings{"CONTROL MEASURES:"});
  EXPECT_FALSE(has(in_overlay("SITE x\n|"), "AA"));
  EXPECT_EQ(in_overlay("CONTROL MEASURES:\nAA a 1 2\nOB|"), (Strings{"OBJ", "OBJECT", "OBSTACLE"}));
  EXPECT_TRUE(in_overlay("CONTROL MEASURES:\nAA |").empty());
  EXPECT_EQ(in_overlay("CONTROL MEASURES:\nGAP door |"), (Strings{"UTM", "GEO"}));
  EXPECT_EQ(in_overlay("CONTROL MEASURES:\nPP a UTM |"), (Strings{"LAT", "LON"}));
  EXPECT_EQ(in_overlay("CONTROL MEASURES:\nPP a UTM LON 3 |"), Strings{"LAT"});
  EXPECT_EQ(in_overlay("CONTROL MEASURES:\nOBJECT 1 2 3 m|"), Strings{"MOVABLE"});
  EXPECT_TRUE(has(in_overlay("CONTROL MEASURES:\nOBJECT 1 2 3 FIXED w|"), "white"));
  EXPECT_EQ(in_overlay("CONTROL MEASURES:\nHALLWAY h CENTERLINE 1 2 3 4 W|"), Strings{"WIDTH"});
  EXPECT_EQ(in_overlay("CONTROL MEASURES:\nOBSTACLE 1 2 3 ROU|"), Strings{"ROUTE"});
  EXPECT_EQ(in_overlay("CONTROL MEASURES:\nOBSTACLE 1 2 3 4 ROUTE 5 6 S|"), Strings{"SPEED"});
  EXPECT_FALSE(has(in_overlay("CONTROL MEASURES:\nOBSTACLE 1 2 |"), "ROUTE")) << "the radius is missing";
  EXPECT_TRUE(has(in_overlay("CONTROL MEASURES:\nOBSTACLE 1 2 3 ROUTE 5 6 SPEED 1 |"), "PP"));
  EXPECT_EQ(in_overlay("CONTROL MEASURES:\nFLAG 1 2 ROU|"), Strings{"ROUTE"});
  EXPECT_EQ(in_overlay("CONTROL MEASURES:\nOBJECT 1 2 3 FIXED red ROU|"), Strings{"ROUTE"});
  EXPECT_FALSE(has(in_overlay("CONTROL MEASURES:\nFLAG 1 |"), "ROUTE"));
  EXPECT_EQ(in_overlay("SET |"), Strings{"ZOOM-FACTOR"});
}

RC_GTEST_PROP(Completion, SurvivesAnyTextAndCursor, (const std::string& text, std::uint32_t cursor)) {
  for (const auto language : {Complete::IMMEDIATE, Complete::MISSION, Complete::OVERLAY}) {
    Complete request;
    request.set_language(language);
    request.set_text(text);
    request.set_cursor(cursor);
    RC_ASSERT(complete(request, {}).begin() <= text.size());
  }
}

TEST_F(CompletionTest, EveryCommandThatIsOfferedIsUnderstood) {
  for (const std::string& action : typed("UNIT pair |")) {
    if (action == "<") continue;
    const std::string place = action == "STOP" ? "" : action == "SEARCH" ? " OBJ-Field" : " PL-Red";
    Check check;
    check.set_text("UNIT pair " + action + place);
    EXPECT_FALSE(check_text(check, mission_.get(), "", {}).has_errors()) << action;
    const auto clauses = typed("UNIT pair " + action + place + " |");
    for (const std::string& clause : clauses) {
      Check with;
      const std::string more = clause == "FORMATION"       ? " Line"
                               : clause == "TECHNIQUE"     ? " Traveling"
                               : clause == "PHASE-LINE"    ? " Red"
                               : clause == "ON-COMPLETION" ? " MESSAGE done"
                               : clause == "AND"           ? " UNIT left STOP"
                                                           : "";
      const bool wants_number =
          clause == "SPEED" || clause == "SWATH" || clause == "HEADING" || clause == "UNTIL";
      with.set_text(check.text() + " " + clause + more + (wants_number ? " 5" : ""));
      if (clause == "AND") with.set_text("UNIT left " + action + place + " AND SET SHOW-TRAILS");
      EXPECT_FALSE(check_text(with, mission_.get(), "", {}).has_errors()) << with.text();
    }
  }
}

TEST_F(CompletionTest, ChecksTextsWithoutLoadingThem) {
  Check check;
  check.set_text("UNIT pair MOVETO Nowhere");
  EXPECT_EQ(check_text(check, mission_.get(), "", {}).items()[0].kind, "unknown-control-measure");
  EXPECT_TRUE(check_text(check, nullptr, "", {}).has_errors());
  check.set_language(Complete::OVERLAY);
  check.set_text("CONTROL MEASURES:\nAA a 1\n");
  EXPECT_TRUE(check_text(check, nullptr, "", {}).has_errors());
  check.set_language(Complete::MISSION);
  check.set_text("MISSION NAME x\nCOMMAND LIST:\n0. QUIT\n");
  EXPECT_FALSE(check_text(check, nullptr, "", {}).has_errors());
}

}  // namespace
}  // namespace mlab::console
