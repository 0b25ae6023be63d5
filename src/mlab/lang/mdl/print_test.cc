#include "mlab/lang/mdl/testing/check_print.h"

#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "mlab/base/random.h"
#include "mlab/lang/mdl/mdl.h"
#include "mlab/lang/mdl/tree.h"

namespace mlab::mdl {
namespace {

std::string printed(const std::string& text) {
  text::Diagnostics sink;
  const Tree tree = parse(std::make_shared<const text::Source>("test.mdl", text), sink);
  EXPECT_EQ(text::render(sink), "");
  return print(tree);
}

TEST(MdlPrint, GivesEveryMissionTheSameLayout) {
  EXPECT_EQ(printed(R"(mission   name "Demo"  -- what it is
   overlay democ.odl
new-robot small robot blue "" (a=1,b=yes)
new-robot large "x" ( -- many
 a = 1, -- first

 -- second
 b=.5, c = "d" )
unit <scouts>(<front> robot small)(<rear>large)
set show-trails set system-seed 5 -- both
command list: -- and now
0. unit scouts start AA1 0 20 -- here we go
   -- the first leg
 1a. unit front moveto PP-1 wedge speed=3 phase-line PL-1 01-02-26 10:00 ack "ready" wait and -- one
   -- the other half
 unit rear telop 310 205 on-completion msg done
10. unit scouts occupy "a b" formation = column heading 90 until timeout +1:30 and set show-robot-trails no
12. quit
-- that is all
)"),
            R"(MISSION NAME "Demo"  -- what it is
OVERLAY democ.odl
NEW-ROBOT small robot blue "" (a = 1, b = yes)
NEW-ROBOT large "x" (
    -- many
    a = 1,  -- first

    -- second
    b = .5,
    c = "d"
)
UNIT <scouts> (<front> robot small) (<rear> large)
SET SHOW-TRAILS
SET SEED 5  -- both

COMMAND LIST:  -- and now

  0. UNIT scouts START AA1 0 20  -- here we go
  -- the first leg
 1a. UNIT front MOVETO PP-1 FORMATION Wedge SPEED 3 PHASE-LINE PL-1 10:00 01-02-26 ACKNOWLEDGE "ready" WAIT AND  -- one
     -- the other half
     UNIT rear TELEOPERATE 310 205 ON-COMPLETION MESSAGE done
 10. UNIT scouts OCCUPY "a b" FORMATION Column HEADING 90 UNTIL TIMEOUT +1:30 AND
     SET SHOW-TRAILS OFF
 12. QUIT
-- that is all
)");
}

TEST(MdlPrint, FoldsManyPlaces) {
  std::string places;
  for (int i = 1; i <= 20; ++i) places += " PP-Sample" + std::to_string(i);
  EXPECT_EQ(
      printed("unit <u> robot command list:\n1. unit u visit" + places + " 10 20 speed 2 and unit u stop"),
      R"(UNIT <u> robot

COMMAND LIST:

  1. UNIT u VISIT PP-Sample1 PP-Sample2 PP-Sample3 PP-Sample4 PP-Sample5 PP-Sample6 PP-Sample7
         PP-Sample8 PP-Sample9 PP-Sample10 PP-Sample11 PP-Sample12 PP-Sample13 PP-Sample14
         PP-Sample15 PP-Sample16 PP-Sample17 PP-Sample18 PP-Sample19 PP-Sample20 10 20 SPEED 2 AND
     UNIT u STOP
)");
}

TEST(MdlPrint, PrintsTypedCommands) {
  EXPECT_EQ(printed("immediate command: unit u stop and -- soon\n unit <v> robot and obstacle 1 2 3 and "
                    "injecttrack red"),
            "IMMEDIATE COMMAND: UNIT u STOP AND  -- soon\n    UNIT <v> robot AND\n    OBSTACLE 1 2 3 AND\n   "
            " INJECTTRACK RED\n");
}

TEST(MdlPrint, KeepsCommentsThatStandInsideStatements) {
  EXPECT_EQ(printed("UNIT -- the team\n <u> -- its robots\n ROBOT\nCOMMAND LIST:\n 0. -- end\n QUIT"),
            "UNIT <u> ROBOT  -- the team\n-- its robots\n\nCOMMAND LIST:\n\n  -- end\n  0. QUIT\n");
}

// A mission put together at random, with comments and blank lines wherever a token may end.
class Author {
 public:
  explicit Author(std::uint64_t seed) : random_(seed) {}

  std::string mission() {
    preamble();
    word("COMMAND LIST:");
    for (int i = 0, n = up_to(4) + 1; i < n; ++i) {
      word(one_of({"0.", "1.", "2a.", "10b.", "17."}));
      command();
      while (chance(4)) {
        word("AND");
        command();
      }
    }
    return out_;
  }

 private:
  int up_to(int n) { return static_cast<int>(random_.below(static_cast<std::uint64_t>(n) + 1)); }
  bool chance(int one_in) { return up_to(one_in - 1) == 0; }
  const char* one_of(const std::vector<const char*>& words) {
    return words[static_cast<std::size_t>(up_to(static_cast<int>(words.size()) - 1))];
  }

  void word(const std::string& text) {
    out_ += text;
    out_ += one_of({" ", " ", " ", "\n", "  ", " -- a comment\n", "\n-- its own line\n", "\n\n", "\r\n"});
  }
  void words(const std::vector<const char*>& all) {
    for (const char* w : all) word(w);
  }

  void name() {
    word(one_of({"a", "Home", "PP-1", "\"two words\"", "\"\"", "x_2*", "veh-a", "\"-- no comment\""}));
  }
  void number() { word(one_of({"0", "1", "-2.5", ".5", "310", "1e3", "0.30000001"})); }

  void preamble() {
    for (int i = 0, n = up_to(5) + 1; i < n; ++i) statement();
  }

  void statement() {
    switch (up_to(9)) {
      case 0:
        word("MISSION NAME"), name();
        break;
      case 1:
        word("scenario"), name();
        break;
      case 2:
        word("OVERLAY"), word(one_of({"democ.odl", "\"a b.odl\"", "x", "./y/z.ovl~"}));
        break;
      case 3:
        word("mission-area"), number(), number();
        break;
      case 4:
        word("SP"), name(), number(), number();
        break;
      case 5:
        word("OBSTACLE"), number(), number(), number();
        break;
      case 6:
        new_robot();
        break;
      case 7:
        unit();
        break;
      case 8:
        set();
        break;
      default:
        word(one_of({"CREATE-OBSTACLES", "PRINT CONSOLE-DB", "print robot-info", "LOAD-MAP \"x.mapinfo\""}));
        break;
    }
  }

  void new_robot() {
    word("NEW-ROBOT"), name(), word(one_of({"robot", "\"x\"", "ROBOT"}));
    if (chance(2)) {
      word(one_of({"blue", "red", "\"dark green\""}));
      if (chance(2)) word(one_of({"\"\"", "yellow"}));
    }
    if (chance(2)) return;
    word("(");
    for (int i = up_to(3);; --i) {
      word(one_of({"gain", "TIMEOUT", "\"seed\"", "speed"})), word("=");
      word(one_of({"1", "0.30", "on", "No", "name", "\"text\""}));
      if (i == 0) break;
      word(",");
    }
    word(")");
  }

  void unit() {
    word("UNIT");
    group(0);
  }
  void group(int depth) {
    if (depth == 0 || chance(2)) {
      word("<"), name(), word(">");
      if (depth < 3 && chance(2)) {
        for (int i = up_to(2); i >= 0; --i) {
          word("(");
          group(depth + 1);
          word(")");
        }
        return;
      }
    }
    for (int i = up_to(2); i >= 0; --i) word(one_of({"ROBOT", "robot", "small", "\"ROBOT\""}));
  }

  void set() {
    word("SET");
    if (chance(2)) {
      word(one_of({"SEED", "SYSTEM-SEED", "OBSTACLE-COVERAGE", "ZOOM-FACTOR", "CYCLE-DURATION"})), number();
    } else {
      set_flag();
    }
  }
  void set_flag() {
    word(one_of({"SHOW-TRAILS", "USE-MILITARY-STYLE", "SHOW-MOVEMENT-VECTORS", "DEBUG-ROBOTS"}));
    if (chance(2)) word(one_of({"ON", "off", "Yes", "TRUE", "no"}));
  }

  void command() {
    switch (up_to(6)) {
      case 0:
        word("QUIT");
        break;
      case 1:
        word("SET"), set_flag();
        break;
      case 2:
        word("PRINT ROBOT-INFO");
        break;
      default:
        unit_command();
        break;
    }
  }

  void location() { chance(3) ? (number(), number()) : name(); }

  void unit_command() {
    word("UNIT"), name();
    switch (up_to(8)) {
      case 0:
        word("START"), location();
        if (chance(2)) number(), number();
        break;
      case 1:
        word("STOP");
        break;
      case 2:
        word("OCCUPY"), location();
        until();
        break;
      case 3:
        word("telop"), name();
        formation();
        break;
      case 4:
        word("Rally"), location();
        if (chance(2)) word("SPEED"), number();
        break;
      case 5:
        word(one_of({"VISIT", "Patrol"}));
        for (int i = up_to(40); i >= 0; --i) location();
        if (chance(3)) word("UNTIL TIMEOUT 10");
        break;
      case 6:
        word("SEARCH"), name();
        if (chance(2)) word("SWATH"), number();
        break;
      default:
        word(one_of({"MOVETO", "SWEEPTO"})), location();
        clauses();
        break;
    }
  }

  void formation() {
    if (chance(2)) word("FORMATION");
    if (out_.find("FORMATION", out_.size() > 12 ? out_.size() - 12 : 0) != std::string::npos && chance(3))
      word("=");
    word(one_of({"Column", "LINE-LEFT", "wedge", "No-Formation"}));
  }
  void until() {
    if (chance(2)) formation();
    word("UNTIL");
    word(one_of(
        {"TIMEOUT 10", "TIMEOUT +1:30", "12:30", "12:30 1-02-26", "01-02-26 12:30:15", "+5", "750", "-3"}));
  }
  void clauses() {
    for (int i = up_to(3); i > 0; --i) {
      switch (up_to(4)) {
        case 0:
          formation();
          break;
        case 1:
          word(one_of({"TECHNIQUE TRAVELING", "bounding-overwatch", "TECHNIQUE = Traveling-Overwatch"}));
          break;
        case 2:
          word(one_of({"SPEED 3", "speed = .5"}));
          break;
        case 3:
          word("ON-COMPLETION"), word(one_of({"MSG", "MESSAGE"})), name();
          break;
        default:
          word("PHASE-LINE"), name(),
              word(one_of({"", "12:00", "+5", "1-02-26 12:00", "ACK ready", "12:00 1-02-26 ACK ready WAIT"}));
          break;
      }
    }
  }

  base::Random random_;
  std::string out_;
};

RC_GTEST_PROP(MdlPrint, ChangesNothingButTheLayout, (std::uint64_t seed)) {
  for (std::uint64_t i = 0; i < 50; ++i) {  // a mission is cheap to try
    const std::string text = Author(base::combine_bits(seed, i)).mission();
    bool had_errors = true;
    const std::string changes = what_print_changes(text, had_errors);
    RC_LOG() << (had_errors || !changes.empty() ? text + "\n" + changes : "");
    RC_ASSERT(!had_errors);
    RC_ASSERT(changes.empty());
  }
}

}  // namespace
}  // namespace mlab::mdl
