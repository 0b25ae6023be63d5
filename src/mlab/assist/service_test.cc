#include "mlab/assist/service.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "mlab/assist/testing/ask_everything.h"
#include "mlab/assist/testing/folder.h"
#include "mlab/base/testing/processor_time.h"
#include "mlab/base/testing/source_folder.h"
#include "mlab/mission/tasks.h"
#include "mlab/text/testing/golden.h"

namespace mlab::assist {
namespace {

namespace fs = std::filesystem;
using Strings = std::vector<std::string>;

using testing::Folder;

std::string applied(const text::SourcePtr& source, const std::vector<Splice>& splices) {
  std::string out;
  std::uint32_t at = 0;
  for (const Splice& splice : splices) {
    out += source->text({at, splice.span.begin});
    out += splice.text;
    at = splice.span.end;
  }
  return out + std::string(source->text().substr(at));
}

Strings names_of(const Completions& offered) {
  Strings out;
  for (const Candidate& one : offered.candidates) out.push_back(one.text);
  return out;
}

bool contains(const Strings& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

class ServiceTest : public ::testing::Test {
 protected:
  ServiceTest() {
    folder_.put("skills.cdl",
                "/// Goes about.\nassemblage Roam(urge: gain = 1) {\n  cooperate { urge: Noise(); }\n}\n");
    folder_.put(
        "robots.cdl",
        "use \"skills.cdl\";\nuse \"mine.cnl\";\n"
        "class Cart(top: speed = 1 m/s in 0 .. 5) {\n  actuator wheels: Drive(max_velocity = top) binds "
        "movement;\n}\n"
        "robot Scout(urge: gain = 0.5 in 0 .. 1) is Cart {\n  movement = cooperate { 1: Roam(urge); 0: "
        "Spin(); } as both;\n}\n"
        "layout Scout { both 10 20; both.Roam 3 4; }\n");
    folder_.put(
        "mine.cnl",
        "/// Turns on the spot.\nprocedure Vector Spin with\n  double [rad/s] rate = 1 in 0 .. 3;  ///< how "
        "fast\nheader\nbody\n  output = Vector{};\npend\n"
        "node a is Spin with rate = 2; nend\nnode b is WeightedSum with members = a; nend\n");
    folder_.put("traffic.odl", "CONTROL MEASURES:\nOBSTACLE 1 2 3 ROUTE 4 5 SPEED 1\n");
    folder_.put("map.odl",
                "CONTROL MEASURES:\nPP Charlie 10 10\nPL \"red line\" 0 0 20 20\n"
                "BOUNDARY Field 0 0 99 0 99 99\n");
    folder_.put("m.mdl",
                "OVERLAY map.odl\nSP Home 5 5\nFAILSAFE OUTSIDE Field HOLD\nNEW-ROBOT scout "
                "\"robots.cdl#Scout\" (urge = 0.7)\n"
                "UNIT <pair> (<left> scout) (<right> ROBOT)\nCOMMAND LIST:\n"
                " 1. UNIT pair START Home\n 2. UNIT left MOVETO PP-Charlie PHASE-LINE \"red line\"\n"
                " 3. ROBOTS 2 1 STOP\n");
  }

  std::optional<text::Place> declared(const std::string& file, const std::string& what) const {
    return definition(folder_.text(file), folder_.at(file, what), folder_.around());
  }
  std::string hovered(const std::string& file, const std::string& what) const {
    const auto found = hover(folder_.text(file), folder_.at(file, what), folder_.around());
    return found ? found->markdown : "";
  }
  Strings offered(const std::string& file, const std::string& text) {
    const std::size_t at = text.find('|');
    folder_.put(file, text.substr(0, at) + text.substr(at + 1));
    return names_of(complete(folder_.text(file), static_cast<std::uint32_t>(at), folder_.around()));
  }

  Folder folder_;
};

TEST_F(ServiceTest, LeadsFromFileToFile) {
  EXPECT_EQ(declared("robots.cdl", "Roam(")->source->name(), "skills.cdl");
  EXPECT_EQ(declared("robots.cdl", "skills.cdl")->source->name(), "skills.cdl");
  EXPECT_EQ(declared("robots.cdl", "Spin()")->source->name(), "mine.cnl");
  EXPECT_EQ(declared("m.mdl", "Charlie")->source->name(), "map.odl");
  EXPECT_EQ(declared("m.mdl", "red line")->source->text(declared("m.mdl", "red line")->span), "red line");
  EXPECT_EQ(declared("m.mdl", "Field")->source->name(), "map.odl");
  EXPECT_EQ(declared("m.mdl", "map.odl")->source->name(), "map.odl");
  EXPECT_EQ(declared("m.mdl", "urge")->source->name(), "robots.cdl");
  EXPECT_EQ(declared("mine.cnl", "rate = 2")->span, declared("mine.cnl", "rate = 1")->span);
}

TEST_F(ServiceTest, TellsWhatThingsAre) {
  EXPECT_NE(hovered("robots.cdl", "Roam(").find("Goes about."), std::string::npos);
  EXPECT_NE(hovered("robots.cdl", "wheels").find("actuator wheels: Drive binds movement"), std::string::npos);
  EXPECT_NE(hovered("mine.cnl", "rate = 2").find("how fast"), std::string::npos);
  EXPECT_NE(hovered("mine.cnl", "nend").find("ends a node"), std::string::npos);
  EXPECT_EQ(hovered("m.mdl", "pair"), "unit `pair` of 2 robots");
  EXPECT_NE(hovered("m.mdl", "Charlie").find("`PP-Charlie` at 10 10"), std::string::npos);
  EXPECT_NE(hovered("m.mdl", "MOVETO").find("moves there"), std::string::npos);
  EXPECT_NE(hovered("m.mdl", "urge").find("range 0 .. 1"), std::string::npos);
  EXPECT_EQ(hovered("m.mdl", " 2 "), "robot 2, a `ROBOT` of unit `right`");
  EXPECT_NE(hovered("m.mdl", "ROBOTS").find("a unit as long as the command lasts"), std::string::npos);
  EXPECT_NE(hovered("m.mdl", "OUTSIDE").find("about to leave"), std::string::npos);
  EXPECT_NE(hovered("m.mdl", "HOLD").find("it stands until"), std::string::npos);
  EXPECT_NE(hovered("map.odl", "PP").find("passage point"), std::string::npos);
  EXPECT_NE(hovered("traffic.odl", "ROUTE").find("there and back"), std::string::npos);
  EXPECT_NE(hovered("traffic.odl", "SPEED").find("m/s"), std::string::npos);
}

TEST_F(ServiceTest, KnowsWhoASocietyIs) {
  folder_.put("team.cdl",
              "use \"robots.cdl\";\nsociety Pair: team of 2 Scout;\nsociety All: caste { Pair; Scout; };\n");
  folder_.put("s.mdl",
              "SP Home 5 5\nNEW-ROBOT band \"team.cdl#All\" blue shaft\nCOMMAND LIST:\n"
              " 1. UNIT band START Home\n 2. ROBOT 3 STOP\n");
  EXPECT_EQ(hovered("s.mdl", "band \""),
            "society `band`: program `team.cdl#All`, 2 `band#Scout`, 1 `band#Scout`");
  EXPECT_EQ(hovered("s.mdl", "UNIT band S"), "unit `band` of 3 robots");
  EXPECT_EQ(hovered("s.mdl", " 3 "), "robot 3, a `band#Scout` of unit `band`");
  const auto program = declared("s.mdl", "team.cdl#All");
  EXPECT_EQ(program->source->text(program->span), "All");
  const auto unit = declared("s.mdl", "UNIT band S");
  EXPECT_EQ(unit->source->line_column(unit->span.begin).line, 2U);
  EXPECT_EQ(offered("n.mdl", "NEW-ROBOT band \"team.cdl#All\"\nCOMMAND LIST:\n 1. UNIT |"),
            (Strings{"band"}));
  EXPECT_TRUE(contains(offered("n.mdl", "NEW-ROBOT band \"team.cdl#All\"\nUNIT <u> |"), "band"));
  const text::Diagnostics said = problems(folder_.text("s.mdl"), folder_.around());
  ASSERT_EQ(said.note_count(), 1U) << text::render(said);
  EXPECT_FALSE(said.has_errors()) << text::render(said);
}

TEST_F(ServiceTest, CompletesMissionsWithWhatOverlaysAndConfigurationsDeclare) {
  const std::string head =
      "OVERLAY map.odl\nNEW-ROBOT scout \"robots.cdl\" (urge = 1)\nUNIT <pair> scout ROBOT\nCOMMAND LIST:\n";
  EXPECT_EQ(offered("n.mdl", head + " 1. UNIT pair MOVETO |"),
            (Strings{"PP-Charlie", "\"PL-red line\"", "BOUNDARY-Field"}));
  EXPECT_EQ(offered("n.mdl", head + " 1. UNIT |"), (Strings{"pair"}));
  EXPECT_TRUE(contains(offered("n.mdl", "OVERLAY |"), "\"map.odl\""));
  EXPECT_TRUE(contains(offered("n.odl", "ORIGIN |"), "GEO"));
  EXPECT_TRUE(contains(offered("n.odl", "CONTROL MEASURES:\nPP a |"), "GEO"));
  EXPECT_FALSE(contains(offered("n.odl", "CONTROL MEASURES:\nPP a GEO |"), "UTM")) << "a place in quotes";
  const Strings keys = offered("n.mdl", "NEW-ROBOT scout \"robots.cdl\" (|");
  EXPECT_TRUE(contains(keys, "urge"));
  EXPECT_TRUE(contains(keys, "top"));
  EXPECT_TRUE(contains(keys, "robot_radius"));
  EXPECT_EQ(offered("n.mdl", "NEW-ROBOT scout \"robots.cdl\" (urge = 1, t|")[0], "top");
}

TEST_F(ServiceTest, KnowsEveryCommandOfMissionsAndItsClauses) {
  const std::string head = "UNIT <pair> ROBOT ROBOT\nCOMMAND LIST:\n 1. UNIT pair ";
  const Strings commands = offered("n.mdl", head + "|");
  for (const mission::TaskInfo& task : mission::kTasks) {
    const std::string word(task.word);
    SCOPED_TRACE(word);
    EXPECT_TRUE(contains(commands, word));
    folder_.put("commands.mdl", head + word + " 10 20\n");
    EXPECT_NE(hovered("commands.mdl", word).find(task.help), std::string::npos);
    if (task.place.empty()) continue;
    const Strings clauses = offered("n.mdl", head + word + " 10 20 |");
    for (const mission::ClauseInfo& clause : mission::kClauses)
      EXPECT_EQ(contains(clauses, std::string(clause.word)), mission::takes(task.task, clause.kind))
          << clause.word;
  }
}

TEST_F(ServiceTest, CompletesNetworks) {
  const std::string procedure =
      "procedure Vector Spin with\n  double [rad/s] rate = 1;\nheader\nbody\npend\n";
  EXPECT_TRUE(contains(offered("x.cnl", "|"), "procedure"));
  EXPECT_TRUE(contains(offered("x.cnl", procedure + "node a is |"), "Spin"));
  EXPECT_TRUE(contains(offered("x.cnl", procedure + "node a is Noi|"), "Noise"));
  EXPECT_TRUE(contains(offered("x.cnl", procedure + "node a is Spin with |"), "rate"));
  const Strings sources =
      offered("x.cnl", procedure + "node a is Spin with nend\nnode b is WeightedSum with members = |");
  EXPECT_EQ(sources[0], "a");
  EXPECT_TRUE(contains(offered("x.cnl", "procedure |"), "Vector"));
  EXPECT_TRUE(contains(
      offered("x.cnl", "procedure Vector Spin with\n  double rate = 1;\nheader\nbody\n  out|"), "output"));
  EXPECT_TRUE(contains(
      offered("x.cnl", "sequence s of Vector with start state one is a; when t goto |\nnend"), "one"));
}

TEST_F(ServiceTest, CompletesNamesOfFiles) {
  EXPECT_TRUE(contains(offered("x.cdl", "use \"sk|"), "skills.cdl"));
}

TEST_F(ServiceTest, KnowsNotesAndFramesOnTheCanvas) {
  const std::string text =
      "assemblage A() {\n  let frame = Noise();\n  frame\n}\nlayout A {\n  note 40 -20 \"looks\" "
      "\"around\";\n"
      "  frame 0 0 400 300;\n  frame 7 8;\n  |\n}\n";
  const Strings words = offered("x.cdl", text);
  EXPECT_TRUE(contains(words, "note"));
  EXPECT_TRUE(contains(words, "frame"));
  const Text read = folder_.text("x.cdl");
  const auto at = [&](const std::string& what) { return folder_.at("x.cdl", what); };
  EXPECT_NE(hover(read, at("note 40"), folder_.around())->markdown.find("canvas"), std::string::npos);
  EXPECT_FALSE(definition(read, at("note 40"), folder_.around()));
  EXPECT_FALSE(definition(read, at("frame 0"), folder_.around()));
  const auto node = definition(read, at("frame 7 8") - 3, folder_.around());
  ASSERT_TRUE(node) << "a node that is called so";
  EXPECT_EQ(node->span.begin, text.find("frame"));
  for (const Shade& shade : shades(read, folder_.around())) {
    const std::string_view word = read.source->text(shade.span);
    if (word == "note") {
      EXPECT_EQ(shade.kind, Shade::Kind::kKeyword);
    }
  }
}

TEST_F(ServiceTest, HelpsWithTheCallThatTheCursorIsIn) {
  folder_.put("x.cdl", "assemblage A() {\n  Noise(persistence = 2 s)\n}\n");
  const auto call = signature(folder_.text("x.cdl"), folder_.at("x.cdl", "= 2"), folder_.around());
  ASSERT_TRUE(call);
  EXPECT_TRUE(call->label.starts_with("Noise(persistence: double [s]")) << call->label;
  EXPECT_EQ(call->active, 0U);
}

TEST_F(ServiceTest, RenamesInAllTexts) {
  const auto changes =
      rename(folder_.text("robots.cdl"), folder_.at("robots.cdl", "Roam("), "Drift", folder_.around());
  ASSERT_TRUE(changes) << changes.error().message;
  std::map<std::string, std::string> after;
  for (const Change& change : changes->changes)
    after[change.source->name()] = applied(change.source, change.splices);
  EXPECT_NE(after["skills.cdl"].find("assemblage Drift("), std::string::npos);
  EXPECT_NE(after["robots.cdl"].find("1: Drift(urge)"), std::string::npos);
  EXPECT_NE(after["robots.cdl"].find("both.Drift 3 4"), std::string::npos) << "the layout too";
  EXPECT_EQ(after.size(), 2U);
}

TEST_F(ServiceTest, RefusesNamesThatStandForSomethingElse) {
  folder_.put("x.cdl",
              "assemblage A(a: gain = 1, b: gain = 1) {\n  cooperate { a: Noise(); b: Noise(); }\n}\n");
  const auto refused = [&](const std::string& name) {
    return !rename(folder_.text("x.cdl"), folder_.at("x.cdl", "a:"), name, folder_.around());
  };
  EXPECT_TRUE(refused("b"));
  EXPECT_TRUE(refused("two words"));
  EXPECT_FALSE(refused("c"));
  EXPECT_TRUE(refused("")) << "nothing";
  EXPECT_FALSE(rename(folder_.text("x.cdl"), folder_.at("x.cdl", "Noise"), "Other", folder_.around()))
      << "is of the library";
}

TEST_F(ServiceTest, FindsProceduresOfTheLibraryToo) {
  folder_.put("x.cdl", "assemblage A() {\n  cooperate { 1: Noise(); 2: Noise(); }\n}\n");
  EXPECT_EQ(uses(folder_.text("x.cdl"), folder_.at("x.cdl", "Noise"), folder_.around()).places.size(), 3U)
      << "in skills.cdl as well";
}

TEST_F(ServiceTest, GivesTheOutlineOfAText) {
  const auto outline = symbols(folder_.text("robots.cdl"), folder_.around());
  ASSERT_EQ(outline.size(), 2U);
  EXPECT_EQ(outline[0].kind, "class");
  EXPECT_EQ(outline[1].name, "Scout");
  EXPECT_EQ(outline[0].parts.size(), 2U);
  EXPECT_EQ(symbols(folder_.text("mine.cnl"), folder_.around()).size(), 3U);
  EXPECT_EQ(symbols(folder_.text("m.mdl"), folder_.around()).size(), 8U);
  EXPECT_EQ(symbols(folder_.text("map.odl"), folder_.around()).size(), 3U);
}

const std::vector<fs::path>& examples() {
  static const std::vector<fs::path> kExamples = [] {
    std::vector<fs::path> out;
    for (const char* folder : {"missions", "library", "src/mlab/lang"}) {
      for (const auto& entry : fs::recursive_directory_iterator(fs::path(base::source_folder()) / folder)) {
        const std::string ending = entry.path().extension().string();
        const bool is_ours = ending == ".mdl" || ending == ".odl" || ending == ".cdl" || ending == ".cnl";
        constexpr std::uintmax_t kMostBytes = 20000;
        if (is_ours && entry.is_regular_file() && entry.file_size() < kMostBytes) out.push_back(entry.path());
      }
    }
    std::ranges::sort(out);
    return out;
  }();
  return kExamples;
}

RC_GTEST_PROP(Service, AnswersEverythingAboutTextsThatAreBeingTyped, ()) {
  const fs::path& path = examples()[*rc::gen::inRange<std::size_t>(0, examples().size())];
  std::string content = text::testing::read_all(path);
  // Somebody typed up to here; something is missing there.
  const auto cut = *rc::gen::inRange<std::size_t>(0, content.size() + 1);
  if (*rc::gen::arbitrary<bool>()) content.resize(cut);
  const auto hole = *rc::gen::inRange<std::size_t>(0, content.size() + 1);
  content.erase(hole, *rc::gen::inRange<std::size_t>(0, 12));
  content.insert(hole, *rc::gen::element<std::string>("", "(", "{", "\"", "as ", ";", "goto ", "\xff", "= "));
  const auto source = std::make_shared<const text::Source>(path.string(), content);
  const Text text{source, *language_of(text::Source(path.string(), ""))};
  const auto cursor = *rc::gen::inRange<std::uint32_t>(0, static_cast<std::uint32_t>(content.size()) + 2);
  RC_ASSERT(testing::ask_everything(text, cursor, testing::nowhere()) == "");
}

RC_GTEST_PROP(Service, AnswersEverythingAboutAnyText, (const std::string& content, std::uint32_t cursor)) {
  for (const Language language : {Language::kConfiguration, Language::kNetwork, Language::kMission,
                                  Language::kOverlay, Language::kEnvironment}) {
    const Text text{std::make_shared<const text::Source>("x", content), language};
    RC_ASSERT(testing::ask_everything(text, cursor, testing::nowhere()) == "");
  }
}

RC_GTEST_PROP(Service, ARenamingCanBeTakenBack, ()) {
  const fs::path& path = examples()[*rc::gen::inRange<std::size_t>(0, examples().size())];
  const std::string content = text::testing::read_all(path);
  const Text text{std::make_shared<const text::Source>(path.string(), content),
                  *language_of(text::Source(path.string(), ""))};
  const auto from = *rc::gen::inRange<std::uint32_t>(0, static_cast<std::uint32_t>(content.size()) + 1);
  const Surroundings around = testing::nowhere();
  // The next name that is declared in this file; a reference into another one can't be followed here.
  std::optional<std::uint32_t> cursor;
  constexpr std::uint32_t kFar = 200;
  for (std::uint32_t at = from; at < std::min<std::size_t>(from + kFar, content.size()) && !cursor; ++at) {
    if (renamable(text, at, around)) cursor = at;
  }
  const auto there = cursor ? rename(text, *cursor, "Quite_Another", around) : std::unexpected(Refusal{});
  if (!there) return;
  RC_ASSERT(there->changes.size() == 1U);
  const std::string old(text.source->text(there->changes.front().splices.front().span));
  const Text changed{std::make_shared<const text::Source>(
                         path.string(), applied(text.source, there->changes.front().splices)),
                     text.language};
  const auto at = changed.source->text().find("Quite_Another");
  const auto back = rename(changed, static_cast<std::uint32_t>(at), old, around);
  // Missions and overlays have names in quotes and words of the language as names, and a network with a
  // mistake has a dotted one: renaming refuses them.
  const bool is_wordy = text.language == Language::kMission || text.language == Language::kOverlay;
  if (!back && (is_wordy || old.contains('.'))) return;
  // What was wrong may be mended by it.
  if (!back && problems(text, around).has_errors()) return;
  if (!back) RC_FAIL(path.string() + " " + old + ": " + back.error().message);
  RC_ASSERT(applied(changed.source, back->changes.front().splices) == content);
}

TEST(ServiceSpeed, AFileOfTenThousandLinesIsCompletedInAboutTheTimeOfACheck) {
  const std::size_t size = base::kMegabyte * 2 / 5;  // ten thousand lines
  std::string content;
  for (int i = 0; content.size() < size; ++i) {
    content += fmt::format(
        "/// Skill {0}.\nassemblage Skill_{0}(curious: gain = 0.8 in 0 .. 1, goal: Vector [m]) {{\n"
        "  let drift = Noise(persistence = 10 s);\n  cooperate {{\n    curious: drift;\n    1: "
        "MoveToGoal(goal, "
        "success_radius = 1 m);\n  }}\n}}\n\n",
        i);
  }
  EXPECT_GE(std::ranges::count(content, '\n'), base::kIsSlowBuild ? 10'000 / 32 : 10'000);
  const Text text{std::make_shared<const text::Source>("x.cdl", content), Language::kConfiguration};
  const Surroundings around = testing::nowhere();
  const auto ask = [&] {
    const auto cursor = static_cast<std::uint32_t>(content.rfind("MoveToGoal") + 4);
    EXPECT_TRUE(complete(text, cursor, around).candidates.front().text.starts_with("Move"));
  };
  ask();  // the library is read once
  const base::Yardstick check([&] { EXPECT_FALSE(problems(text, around).has_errors()); });
  EXPECT_LT(check.times(ask, 5.0), 5.0);
}

}  // namespace
}  // namespace mlab::assist
