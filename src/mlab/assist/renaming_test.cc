// Renaming and uses over all files of a project.

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "mlab/assist/service.h"
#include "mlab/assist/testing/folder.h"
#include "mlab/base/testing/source_folder.h"
#include "mlab/text/testing/golden.h"

namespace mlab::assist {
namespace {

namespace fs = std::filesystem;
using testing::Folder;
using TextByFile = std::map<std::string, std::string>;

constexpr const char* kProcedures =
    "/// Turns on the spot.\nprocedure Vector Spin with\n  double [rad/s] rate = 1 in 0 .. 3;\nheader\nbody\n"
    "  // the rate is \"rate\"\n  const double fast = rate * 2.0;\n  output = Vector{p.rate, fast};\npend\n";

class RenamingTest : public ::testing::Test {
 protected:
  RenamingTest() {
    folder_.put("mine.cnl", kProcedures);
    folder_.put("skills.cdl",
                "use \"mine.cnl\";\n/// Goes about.\nassemblage Roam(urge: gain = 1) {\n"
                "  cooperate { urge: Noise(); 1: Spin(rate = 2 rad/s); }\n}\n");
    folder_.put("robots.cdl",
                "use \"skills.cdl\";\nclass Cart(top: speed = 1 m/s in 0 .. 5) {\n"
                "  actuator wheels: Drive(max_velocity = top) binds movement;\n}\n"
                "robot Scout(urge: gain = 0.5 in 0 .. 1) is Cart {\n"
                "  movement = cooperate { 1: Roam(urge = urge); 1: Roam(); } as both;\n}\n"
                "robot Guard() is Cart {\n  movement = Roam();\n}\n"
                "layout Scout { both 10 20; both.Roam 3 4; both.Roam_2 3 4; }\n");
    folder_.put("map.odl", "CONTROL MEASURES:\nPP Charlie 10 10\n");
    folder_.put("m.mdl",
                "OVERLAY map.odl\nNEW-ROBOT left \"robots.cdl#Scout\" (urge = 0.7)\n"
                "NEW-ROBOT scout \"robots.cdl\" (urge = 0.2)\nUNIT <pair> left scout\nCOMMAND LIST:\n"
                " 1. UNIT pair START Charlie\n 2. UNIT pair MOVETO PP-Charlie\n");
    folder_.put("n.mdl", "OVERLAY map.odl\nUNIT <a> ROBOT\nCOMMAND LIST:\n 1. UNIT a START PP-charlie\n");
  }

  auto renamed(const std::string& file, const std::string& what, const std::string& to) {
    return rename(folder_.text(file), begin(file, what), to, around_ ? *around_ : folder_.around());
  }
  std::uint32_t begin(const std::string& file, const std::string& what) const {
    return static_cast<std::uint32_t>(folder_.text(file).source->text().find(what));
  }
  TextByFile after(const std::string& file, const std::string& what, const std::string& to) {
    const auto done = renamed(file, what, to);
    EXPECT_TRUE(done) << done.error().message;
    TextByFile out;
    if (!done) return out;
    for (const Change& one : done->changes) out[one.source->name()] = changed_text(one);
    return out;
  }
  /// Where and why it is refused: `x.cdl:3: ...`
  std::string refusal(const std::string& file, const std::string& what, const std::string& to) {
    const auto done = renamed(file, what, to);
    if (done) return "";
    const text::Place& place = done.error().place;
    if (!place.source) return done.error().message;
    return place.source->name() + ":" + std::to_string(place.source->line_column(place.span.begin).line) +
           ": " + done.error().message;
  }

  Folder folder_;
  std::optional<Surroundings> around_;
};

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST_F(RenamingTest, TheNodesOfALayoutAreCalledAsTheirAssemblage) {
  TextByFile files = after("skills.cdl", "Roam(", "Drift");
  EXPECT_EQ(files.size(), 2U);
  EXPECT_TRUE(has(files["skills.cdl"], "assemblage Drift(urge"));
  EXPECT_TRUE(has(files["robots.cdl"], "1: Drift(urge = urge); 1: Drift(); } as both"));
  EXPECT_TRUE(has(files["robots.cdl"], "both.Drift 3 4; both.Drift_2 3 4;")) << files["robots.cdl"];
}

TEST_F(RenamingTest, ALayoutNamesWhatItsPageShows) {
  folder_.put("go.cdl",
              "assemblage Keep(g: gain = 1) {\n  cooperate { g: Noise(); 1: Noise(); }\n}\n"
              "assemblage Go() {\n  sequence {\n"
              "    start Keep: cooperate { 1: Keep(g = 0.3); };\n      when IsTrue(true) goto Last;\n"
              "    Last: Keep();\n  }\n}\n"
              "layout Go { Keep 1 2; Keep.Keep 5 6; }\nlayout Go.Keep { Keep 20 40; }\n");
  TextByFile state = after("go.cdl", "Keep: cooperate", "Holding");
  EXPECT_TRUE(has(state["go.cdl"], "layout Go { Holding 1 2; Holding.Keep 5 6; }")) << state["go.cdl"];
  EXPECT_TRUE(has(state["go.cdl"], "layout Go.Holding { Keep 20 40; }")) << state["go.cdl"];
  TextByFile called = after("go.cdl", "Keep(g: gain", "Stay");
  EXPECT_TRUE(has(called["go.cdl"], "layout Go { Keep 1 2; Keep.Stay 5 6; }")) << called["go.cdl"];
  EXPECT_TRUE(has(called["go.cdl"], "layout Go.Keep { Stay 20 40; }")) << called["go.cdl"];
}

TEST_F(RenamingTest, AProcedureIsRenamedWhereverConfigurationsCallIt) {
  TextByFile files = after("skills.cdl", "Spin(", "Whirl");
  EXPECT_EQ(files.size(), 2U);
  EXPECT_TRUE(has(files["mine.cnl"], "procedure Vector Whirl with"));
  EXPECT_TRUE(has(files["skills.cdl"], "1: Whirl(rate = 2 rad/s)"));
}

TEST_F(RenamingTest, AnInputOfAProcedureIsRenamedInItsCodeToo) {
  TextByFile files = after("skills.cdl", "rate = 2", "speed");
  EXPECT_TRUE(has(files["mine.cnl"], "double [rad/s] speed = 1"));
  EXPECT_TRUE(has(files["mine.cnl"], "// the rate is \"rate\"\n  const double fast = speed * 2.0;"));
  EXPECT_TRUE(has(files["mine.cnl"], "Vector{p.rate, fast}")) << files["mine.cnl"];
  EXPECT_TRUE(has(files["skills.cdl"], "Spin(speed = 2 rad/s)"));
}

TEST_F(RenamingTest, AParameterIsRenamedInMissionsToo) {
  TextByFile files = after("robots.cdl", "urge: gain = 0.5", "need");
  EXPECT_EQ(files.size(), 2U);
  EXPECT_TRUE(has(files["robots.cdl"], "robot Scout(need: gain"));
  EXPECT_TRUE(has(files["robots.cdl"], "Roam(urge = need)")) << "another one of that name";
  EXPECT_TRUE(has(files["m.mdl"], "#Scout\" (need = 0.7)"));
  EXPECT_TRUE(has(files["m.mdl"], "\"robots.cdl#need\"") == false);
  EXPECT_EQ(after("m.mdl", "urge = 0.7", "need"), files) << "from either side";
}

TEST_F(RenamingTest, ARobotIsRenamedInMissionsAlsoWhereItsTypeSaysWhich) {
  TextByFile files = after("robots.cdl", "Scout(", "Seeker");
  EXPECT_TRUE(has(files["robots.cdl"], "layout Seeker {"));
  EXPECT_TRUE(has(files["m.mdl"], "left \"robots.cdl#Seeker\""));
  EXPECT_TRUE(has(files["m.mdl"], "NEW-ROBOT scout \"robots.cdl#Seeker\" (urge = 0.2)")) << files["m.mdl"];
}

TEST_F(RenamingTest, APlaceIsRenamedInAllMissionsOnItsMap) {
  TextByFile files = after("m.mdl", "Charlie\n", "Delta");
  EXPECT_EQ(files.size(), 3U);
  EXPECT_TRUE(has(files["map.odl"], "PP Delta 10"));
  EXPECT_TRUE(has(files["m.mdl"], "START Delta\n 2. UNIT pair MOVETO PP-Delta"));
  EXPECT_TRUE(has(files["n.mdl"], "START PP-Delta"));
}

TEST_F(RenamingTest, APlaceIsRenamedWhereRobotsNameItByAText) {
  folder_.put("way.cdl", "assemblage Way() {\n  MoveToGoal(DetectGoal(place(\"PP-Charlie\")))\n}\n");
  folder_.put("walker.cdl",
              "use \"way.cdl\";\nrobot Walker(to: Point = place(\"Charlie\")) is Scout {\n"
              "  movement = cooperate { 1: MoveToGoal(DetectGoal(to)); 1: Way(); };\n}\n");
  folder_.put("w.mdl", "OVERLAY map.odl\nNEW-ROBOT walker \"walker.cdl\"\nUNIT <a> walker\n");
  TextByFile files = after("map.odl", "Charlie", "Far-Pond");
  EXPECT_EQ(files.size(), 5U);
  EXPECT_TRUE(has(files["walker.cdl"], "place(\"Far-Pond\")")) << files["walker.cdl"];
  EXPECT_TRUE(has(files["way.cdl"], "place(\"PP-Far-Pond\")")) << "what a configuration uses";
  EXPECT_EQ(after("walker.cdl", "Charlie", "Far-Pond"), files) << "from either side";
  const auto at = definition(folder_.text("way.cdl"), begin("way.cdl", "Charlie"), folder_.around());
  ASSERT_TRUE(at);
  EXPECT_EQ(at->source->name(), "map.odl");
  EXPECT_EQ(uses(folder_.text("map.odl"), begin("map.odl", "Charlie"), folder_.around()).places.size(), 6U);

  folder_.put("other.odl", "CONTROL MEASURES:\nPP Charlie 1 1\n");
  folder_.put("v.mdl", "OVERLAY other.odl\nNEW-ROBOT walker \"walker.cdl\"\nUNIT <a> walker\n");
  const std::string why = refusal("map.odl", "Charlie", "Delta");
  EXPECT_TRUE(why.starts_with("walker.cdl:2: `Charlie` is a place of `other.odl`, too") ||
              why.starts_with("way.cdl:2: `Charlie` is a place of `other.odl`, too"))
      << why;
}

TEST_F(RenamingTest, APlaceOnNoMapOfARobotIsNoName) {
  folder_.put("walker.cdl",
              "assemblage A(to: Point = place(\"Charlie\")) {\n  MoveToGoal(DetectGoal(to))\n}\n");
  EXPECT_EQ(after("map.odl", "Charlie", "Delta").count("walker.cdl"), 0U);
  EXPECT_EQ(refusal("walker.cdl", "Charlie", "Delta"), "there is no name here");
}

TEST_F(RenamingTest, WhatWouldCollideIsRefusedWithItsPlace) {
  EXPECT_TRUE(refusal("robots.cdl", "Guard(", "Scout").starts_with("m.mdl:2:"))
      << refusal("robots.cdl", "Guard(", "Scout");
  EXPECT_TRUE(refusal("skills.cdl", "Roam(", "Noise").starts_with("skills.cdl:4:"))
      << "the call of the library's would mean it: " << refusal("skills.cdl", "Roam(", "Noise");
  EXPECT_TRUE(has(refusal("mine.cnl", "rate = 1", "fast"), "mine.cnl:"))
      << "the code has a name like that: " << refusal("mine.cnl", "rate = 1", "fast");
  folder_.put("x.cdl", "assemblage A() {\n  Noise()\n}\nassemblage B() {\n  Noise()\n}\n");
  EXPECT_TRUE(has(refusal("x.cdl", "A()", "B"), "x.cdl:")) << "though nobody names either";
  folder_.put("x.cdl", "assemblage A() {\n  Nothing_of_this_name()\n}\nassemblage B() {\n  Noise()\n}\n");
  EXPECT_TRUE(has(refusal("x.cdl", "A()", "B"), "x.cdl:4")) << "though there was an error before";
  EXPECT_TRUE(has(refusal("m.mdl", "Charlie", "two words"), "no name"));
  EXPECT_TRUE(has(refusal("m.mdl", "Charlie", std::string(1000, 'x')), "at most"));
  EXPECT_TRUE(has(refusal("skills.cdl", "Noise", "Other"), "not declared in this project"));
}

TEST_F(RenamingTest, TellsWhatStaysAsItIs) {
  around_ = folder_.around();
  around_->fixed = [](const std::string& path) { return path == "m.mdl" ? "is read only" : ""; };
  const auto done = renamed("robots.cdl", "urge: gain = 0.5", "need");
  ASSERT_TRUE(done) << done.error().message;
  EXPECT_EQ(done->changes.size(), 1U);
  ASSERT_EQ(done->kept.size(), 1U);
  EXPECT_EQ(done->kept[0].places, 2U);
  ASSERT_EQ(done->notes.size(), 1U);
  EXPECT_TRUE(has(done->notes[0], "`m.mdl` is read only")) << done->notes[0];
  around_->fixed = [](const std::string& path) { return path == "robots.cdl" ? "is read only" : ""; };
  EXPECT_TRUE(has(refusal("m.mdl", "urge = 0.7", "need"), "which is read only"));
}

TEST_F(RenamingTest, SaysWhereRunsBecomeOthers) {
  EXPECT_FALSE(renamed("skills.cdl", "Roam(", "Drift")->notes.empty());
  EXPECT_EQ(renamed("skills.cdl", "urge:", "need")->notes, std::vector<std::string>());
  EXPECT_EQ(renamed("m.mdl", "Charlie", "Delta")->notes, std::vector<std::string>());
}

TEST_F(RenamingTest, SaysThatAFileCanNotBeReadAsAWhole) {
  folder_.put("skills.cdl", "assemblage Roam() {\n  cooperate { 1: Noise( }\n}\n");
  const auto done = renamed("skills.cdl", "Roam(", "Drift");
  ASSERT_TRUE(done) << done.error().message;
  EXPECT_TRUE(std::ranges::any_of(done->notes,
                                  [](const std::string& note) { return has(note, "slips of grammar"); }));
}

TEST_F(RenamingTest, UsesAreListedByFileWithWhatTheyStandIn) {
  const Uses found = uses(folder_.text("skills.cdl"), begin("skills.cdl", "Roam("), folder_.around());
  EXPECT_EQ(found.name, "Roam");
  EXPECT_EQ(found.kind, "assemblage");
  EXPECT_FALSE(found.is_library);
  ASSERT_EQ(found.places.size(), 6U);
  EXPECT_TRUE(found.places[0].is_declaration);
  EXPECT_EQ(found.places[1].within, "Scout");
  EXPECT_EQ(found.places[3].within, "Guard");
  const Uses noise = uses(folder_.text("skills.cdl"), begin("skills.cdl", "Noise"), folder_.around());
  EXPECT_TRUE(noise.is_library);
  EXPECT_EQ(noise.places.size(), 1U);
}

/// The files of a mission that comes with missionlab.
Folder corpus(const fs::path& folder, std::vector<std::string>& names) {
  Folder out;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string ending = entry.path().extension().string();
    if (ending != ".mdl" && ending != ".odl" && ending != ".cdl" && ending != ".cnl") continue;
    names.push_back(entry.path().string());
    out.put(names.back(), text::testing::read_all(entry.path()));
  }
  std::ranges::sort(names);
  return out;
}

RC_GTEST_PROP(Renaming, OfAnythingInAProjectCanBeTakenBack, ()) {
  const char* const folder = *rc::gen::element("forage", "survey", "rover", "ugv", "mrv2", "herd", "patrol");
  std::vector<std::string> names;
  Folder files = corpus(fs::path(base::source_folder()) / "missions" / folder, names);
  const std::string file = names[*rc::gen::inRange<std::size_t>(0, names.size())];
  const Text text = files.text(file);
  const auto size = static_cast<std::uint32_t>(text.source->text().size());
  auto cursor = *rc::gen::inRange<std::uint32_t>(0, size);
  while (cursor < size && !renamable(text, cursor, files.around())) ++cursor;
  if (cursor == size) return;
  const auto done = rename(text, cursor, "Quite_Another", files.around());
  if (!done) return;
  const Folder before = files;
  const std::string declaring = done->changes.front().source->name();
  for (const Change& one : done->changes) files.put(one.source->name(), changed_text(one));
  const auto at = static_cast<std::uint32_t>(files.text(declaring).source->text().find("Quite_Another"));
  const auto back = rename(files.text(declaring), at, done->from, files.around());
  // A name in quotes, or a word of the language, is none that could be given.
  const bool is_wordy = declaring.ends_with(".mdl") || declaring.ends_with(".odl");
  if (!back && is_wordy) return;
  if (!back) RC_FAIL(back.error().message);
  for (const Change& one : back->changes) files.put(one.source->name(), changed_text(one));
  for (const std::string& name : names) {
    // Of a robot that its type named by itself the name is said now.
    std::string now(files.text(name).source->text());
    if (const std::size_t said = now.find("#" + done->from);
        said != std::string::npos &&
        before.text(name).source->text().find("#" + done->from) == std::string::npos)
      now.erase(said, done->from.size() + 1);
    RC_ASSERT(now == before.text(name).source->text());
  }
}

}  // namespace
}  // namespace mlab::assist
