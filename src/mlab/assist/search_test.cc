#include "mlab/assist/search.h"

#include <string>
#include <vector>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "mlab/assist/testing/folder.h"
#include "mlab/base/testing/processor_time.h"

namespace mlab::assist {
namespace {

using testing::Folder;
using Strings = std::vector<std::string>;

Strings found(const Folder& folder, const std::string& query) {
  ProjectIndex index;
  index.update(folder.all(), folder.around());
  Strings out;
  for (const ProjectIndex::Hit& hit : index.find(query, 20))
    out.push_back(hit.entry->kind + " " + hit.entry->within + "/" + hit.entry->name);
  return out;
}

TEST(Match, ABeginningCountsMoreThanAWordThanARunThanLetters) {
  const int whole = match("wander", "Wander");
  const int beginning = match("wan", "Wander");
  const int word = match("goal", "MoveToGoal");
  const int run = match("ande", "Wander");
  const int letters = match("mtg", "MoveToGoal");
  EXPECT_GT(whole, beginning);
  EXPECT_GT(beginning, word);
  EXPECT_GT(word, run);
  EXPECT_GT(run, letters);
  EXPECT_GT(letters, 0);
  EXPECT_EQ(match("gtm", "MoveToGoal"), 0);
  EXPECT_EQ(match("", "Wander"), 0);
}

TEST(Search, FindsWhatHasANameInAllLanguagesAndWhereComponentsAreUsed) {
  Folder folder;
  folder.put("a.cdl",
             "/// Goes about.\nassemblage Roam(urge: gain = 1) {\n  let drift = Noise();\n  sequence {\n"
             "    start Looking: drift;\n      when Wait(delay = 2) goto Waiting;\n"
             "    Waiting: cooperate { urge: drift; } as both;\n  }\n}\nlayout Roam { Noise 1 2; }\n");
  folder.put("map.odl", "CONTROL MEASURES:\nPP Charlie 10 10\n");
  folder.put("m.mdl",
             "OVERLAY map.odl\nUNIT <roamers> ROBOT\nCOMMAND LIST:\n 1. UNIT roamers START Charlie\n");
  EXPECT_EQ(found(folder, "roam"), (Strings{"assemblage /Roam", "team /roamers"}));
  EXPECT_EQ(found(folder, "noise"), (Strings{"call Roam/Noise"})) << "not in the layout";
  EXPECT_EQ(found(folder, "urge"), (Strings{"parameter Roam/urge"}));
  EXPECT_EQ(found(folder, "wait"), (Strings{"call Roam/Wait", "state Roam/Waiting"}));
  EXPECT_EQ(found(folder, "both"), (Strings{"node Roam/both"}));
  EXPECT_EQ(found(folder, "char"), (Strings{"place /Charlie"}));
  EXPECT_EQ(found(folder, "map"), (Strings{"file /map.odl"}));
  EXPECT_EQ(found(folder, "goes ab"), (Strings{"assemblage /Roam"})) << "by its help";
  EXPECT_EQ(found(folder, "nothing of this"), Strings());
}

TEST(Search, TakesOverWhatHasChangedAndGone) {
  Folder folder;
  folder.put("a.cdl", "assemblage Roam() {\n  Noise()\n}\n");
  ProjectIndex index;
  index.update(folder.all(), folder.around());
  folder.put("a.cdl", "assemblage Drift() {\n  Noise()\n}\n");
  index.update(folder.all(), folder.around());
  EXPECT_TRUE(index.find("Roam", 5).empty());
  EXPECT_EQ(index.find("Drift", 5).size(), 1U);
  index.update({}, folder.around());
  EXPECT_TRUE(index.find("Drift", 5).empty());
}

TEST(SearchSpeed, ALongFileIsReadInTheTimeOfACheckAndSearchedInMuchLess) {
  std::string content;
  for (int i = 0; i < 375; ++i) {
    content += fmt::format(
        "/// Skill {0}.\nassemblage Skill_{0}(curious: gain = 0.8 in 0 .. 1) {{\n"
        "  let drift = Noise(persistence = 10 s);\n  cooperate {{\n    curious: drift;\n    1: Wander();\n"
        "  }}\n}}\n",
        i);
  }
  Folder folder;
  folder.put("x.cdl", content);
  ProjectIndex index;
  const Surroundings around = folder.around();
  index.update(folder.all(), around);  // the library is read once
  const Text text{std::make_shared<const text::Source>("x.cdl", content), Language::kConfiguration};
  const base::Yardstick check([&] { EXPECT_FALSE(problems(text, around).has_errors()); });
  const auto change_and_find = [&] {
    content += "\n";
    folder.put("x.cdl", content);
    index.update(folder.all(), around);
    EXPECT_EQ(index.find("Skill_37", 20).size(), 6U);
  };
  EXPECT_LT(check.times(change_and_find, 5.0), 5.0);
  EXPECT_LT(check.times([&] { EXPECT_EQ(index.find("noise", 20).size(), 20U); }, 0.5), 0.5);
}

TEST(Folds, BracesCommentsAndStepsCanBeFolded) {
  Folder folder;
  folder.put(
      "a.cdl",
      "// one\n// two\nassemblage A() {\n  cooperate {\n    1: Noise();  // not alone\n    // {\n  }\n}\n");
  const std::vector<Fold> expected = {{1, 2, true}, {3, 7, false}, {4, 6, false}};
  EXPECT_EQ(folds(folder.text("a.cdl"), folder.around()), expected);
  folder.put("m.mdl",
             "UNIT <a> ROBOT\nCOMMAND LIST:\n 1. UNIT a START 1 2\n    UNIT a STOP\n 2. UNIT a STOP\n");
  EXPECT_EQ(folds(folder.text("m.mdl"), folder.around()), (std::vector<Fold>{{3, 4, false}}));
  folder.put("p.cnl", "procedure Vector Spin with\nheader\nbody\n  output = Vector{};\npend\n");
  EXPECT_EQ(folds(folder.text("p.cnl"), folder.around()), (std::vector<Fold>{{1, 5, false}}));
}

TEST(Hints, SayUnitsAndNamesThatAreLeftOut) {
  Folder folder;
  const auto shown = [&](const std::string& name) {
    Strings out;
    for (const Hint& one : hints(folder.text(name), folder.around()))
      out.push_back(fmt::format("{} {}", one.at, one.text));
    return out;
  };
  folder.put("a.cdl",
             "assemblage A() {\n  Noise(6)\n}\nassemblage B() {\n  Noise(persistence = 6 s)\n}\n"
             "assemblage C(t: time = 2) {\n  Noise(t)\n}\n");
  EXPECT_EQ(shown("a.cdl"), (Strings{"25 persistence:", "26 s"}));
  folder.put("p.cnl", "node a is Noise with persistence = 6; nend\n");
  EXPECT_EQ(shown("p.cnl"), (Strings{"36 s"}));
  folder.put("r.cdl", "robot R(near: length = 2 m, gain: gain = 1) {\n  movement = Noise();\n}\n");
  folder.put("m.mdl",
             "NEW-ROBOT r \"r.cdl\" (near = 3, gain = 2)\nUNIT <a> r\nCOMMAND LIST:\n 1. UNIT a STOP\n");
  EXPECT_EQ(shown("m.mdl"), (Strings{"29 m"}));
}

}  // namespace
}  // namespace mlab::assist
