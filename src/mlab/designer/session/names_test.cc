// Renaming, uses and search over the files of a project, by messages.

#include <unistd.h>

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "mlab/designer.pb.h"
#include "mlab/designer/testing/browser.h"
#include "mlab/documents/drafts.h"

namespace mlab::designer {
namespace {

using testing::Browser;

constexpr const char* kOwnSkills =
    "/// Goes about.\nassemblage Roam(urge: gain = 1) {\n  cooperate {\n    urge: Noise();\n  } as both\n}\n";
constexpr const char* kRobots =
    "use \"skills.cdl\";\nrobot Scout(urge: gain = 0.5) {\n  movement = Roam(urge = urge);\n}\n"
    "assemblage Hunt() {\n  sequence {\n    start Looking: Roam();\n      when Wait(delay = 2 s) goto "
    "Resting;\n"
    "    Resting: Roam();\n  }\n}\n";
constexpr const char* kMission =
    "NEW-ROBOT scout \"../robots.cdl\" (urge = 0.7)\r\nUNIT <a> scout\r\nCOMMAND LIST:\r\n"
    " 1. UNIT a START 1 2\r\n";

class DesignerNamesTest : public ::testing::Test {
 protected:
  DesignerNamesTest() {
    browser_.write("skills.cdl", kOwnSkills);
    browser_.write("robots.cdl", kRobots);
    browser_.write("missions/m.mdl", kMission);
    browser_.open("robots.cdl");
  }

  static NameAt drawn(const std::string& page, const std::string& node,
                      const std::string& document = "robots.cdl") {
    NameAt out;
    out.set_document(document);
    out.set_is_drawn(true);
    out.set_page(page);
    out.set_node(node);
    return out;
  }
  Answer plan(const NameAt& at, const std::string& name) {
    return browser_.ask([&](ToDesigner& m) {
      *m.mutable_plan_rename()->mutable_at() = at;
      m.mutable_plan_rename()->set_name(name);
    });
  }
  Answer carry_out(const NameAt& at, const std::string& name, const std::string& seal) {
    return browser_.ask([&](ToDesigner& m) {
      *m.mutable_rename_everywhere()->mutable_at() = at;
      m.mutable_rename_everywhere()->set_name(name);
      m.mutable_rename_everywhere()->set_seal(seal);
    });
  }
  Answer take_back() {
    return browser_.ask([](ToDesigner& m) { m.mutable_undo_rename(); });
  }
  Answer uses(const NameAt& at) {
    return browser_.ask([&](ToDesigner& m) { *m.mutable_find_uses()->mutable_at() = at; });
  }

  Browser browser_;
};

bool has_part(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST_F(DesignerNamesTest, APlanSaysWhatChangesInAllFiles) {
  const Answer answer = plan(drawn("Scout", "urge"), "need");
  ASSERT_TRUE(answer.ok()) << answer.error();
  const names::Plan& shown = answer.plan();
  EXPECT_EQ(shown.kind(), "parameter");
  ASSERT_EQ(shown.files_size(), 2);
  EXPECT_EQ(shown.files(0).path(), "robots.cdl");
  EXPECT_EQ(shown.files(0).uses_size(), 2);
  EXPECT_EQ(shown.files(1).path(), "missions/m.mdl");
  EXPECT_FALSE(shown.files(1).can_open());
  const names::Use& use = shown.files(1).uses(0);
  EXPECT_EQ(use.line(), 1U);
  EXPECT_EQ(use.before() + "|" + use.name() + "|" + use.after(),
            "NEW-ROBOT scout \"../robots.cdl\" (|urge| = 0.7)\r");
  EXPECT_EQ(use.becomes(), "need");
  EXPECT_EQ(browser_.read("robots.cdl"), kRobots) << "nothing is done yet";
}

TEST(DesignerNames, AFolderBehindTheMostFilesIsNotLookedAtAndThatIsSaid) {
  Browser browser;
  const auto left_out = [&] {
    return browser
        .ask([](ToDesigner& m) {
          m.mutable_search()->set_query("Scout");
          m.mutable_search()->set_most(9);
        })
        .hits()
        .left_out();
  };
  for (int i = 0; i < 2000; ++i) browser.write("a/" + std::to_string(i) + ".cdl", "");
  EXPECT_EQ(left_out(), "");
  browser.write("b/more.cdl", "");
  EXPECT_NE(left_out(), "");
}

TEST_F(DesignerNamesTest, WhatIsNotLookedAtIsSaid) {
  const auto search = [&] {
    return browser_.ask([](ToDesigner& m) {
      m.mutable_search()->set_query("Scout");
      m.mutable_search()->set_most(9);
    });
  };
  browser_.write("a/b/c/d/e/f/there.cdl", kOwnSkills);
  EXPECT_EQ(uses(drawn("Scout", "urge")).uses().left_out(), "");
  EXPECT_EQ(search().hits().left_out(), "");
  EXPECT_EQ(plan(drawn("Scout", "urge"), "need").plan().notes_size(), 0);
  browser_.write("a/b/c/d/e/f/g/too_deep.cdl", kOwnSkills);
  const std::string said = "files more than 6 folders deep, or beyond the first 2000, were not looked at";
  EXPECT_EQ(uses(drawn("Scout", "urge")).uses().left_out(), said);
  EXPECT_EQ(search().hits().left_out(), said);
  const Answer planned = plan(drawn("Scout", "urge"), "need");
  ASSERT_EQ(planned.plan().notes_size(), 1);
  EXPECT_EQ(planned.plan().notes(0), said);
}

TEST_F(DesignerNamesTest, WhatIsOpenIsSavedWhatIsClosedIsWritten) {
  const NameAt at = drawn("Scout", "urge");
  const Answer done = carry_out(at, "need", plan(at, "need").plan().seal());
  ASSERT_TRUE(done.ok()) << done.error();
  EXPECT_TRUE(has_part(browser_.read("robots.cdl"), "robot Scout(need: gain"));
  EXPECT_TRUE(has_part(browser_.read("missions/m.mdl"), "(need = 0.7)\r\n")) << "with its line ends";
  EXPECT_FALSE(browser_.document("robots.cdl").is_dirty());
  EXPECT_EQ(browser_.document("robots.cdl").undo(), "rename urge to need");
  ASSERT_TRUE(take_back().ok());
  EXPECT_EQ(browser_.read("robots.cdl"), kRobots);
  EXPECT_EQ(browser_.read("missions/m.mdl"), kMission);
  EXPECT_FALSE(take_back().ok()) << "once";
}

TEST_F(DesignerNamesTest, UnsavedWorkStaysUnsavedAndIsRenamedWhereItIsKept) {
  browser_.open("skills.cdl");
  browser_.type("skills.cdl", std::string(kOwnSkills) + "// more\n");
  browser_.ask([](ToDesigner& m) { m.mutable_close()->set_document("skills.cdl"); });
  NameAt component;
  component.set_document("robots.cdl");
  component.set_cursor(static_cast<std::uint32_t>(std::string(kRobots).find("Roam(urge")));
  const Answer shown = plan(component, "Drift");
  ASSERT_TRUE(shown.ok()) << shown.error();
  EXPECT_EQ(shown.plan().kind(), "assemblage");
  EXPECT_FALSE(shown.plan().notes().empty()) << "runs become others";
  ASSERT_TRUE(carry_out(component, "Drift", shown.plan().seal()).ok());
  EXPECT_EQ(browser_.read("skills.cdl"), kOwnSkills);
  browser_.open("skills.cdl");
  EXPECT_TRUE(has_part(browser_.document("skills.cdl").text(), "assemblage Drift("));
  EXPECT_TRUE(has_part(browser_.document("skills.cdl").text(), "// more"));
  EXPECT_TRUE(browser_.document("skills.cdl").is_dirty());
}

TEST_F(DesignerNamesTest, WhatWasNotShownIsNotDone) {
  const NameAt at = drawn("Scout", "urge");
  const std::string seal = plan(at, "need").plan().seal();
  browser_.write("missions/m.mdl", std::string(kMission) + " 2. UNIT a STOP\n");
  const Answer late = carry_out(at, "need", seal);
  EXPECT_FALSE(late.ok());
  EXPECT_TRUE(has_part(late.error(), "changed meanwhile")) << late.error();
  EXPECT_EQ(browser_.read("robots.cdl"), kRobots);
  ASSERT_TRUE(carry_out(at, "need", plan(at, "need").plan().seal()).ok());
  browser_.write("missions/m.mdl", kMission);
  EXPECT_FALSE(take_back().ok()) << "somebody has changed it since";
  EXPECT_TRUE(has_part(browser_.read("robots.cdl"), "need")) << "all or nothing";
}

TEST_F(DesignerNamesTest, WhatCantBeWrittenEverywhereStandsNowhere) {
  browser_.write("more.cdl", "use \"skills.cdl\";\nassemblage Wander() {\n  Roam();\n}\n");
  // In the way of the file's new text.
  browser_.write(fmt::format(".more.cdl.{}.part/any", ::getpid()), "");
  NameAt at;
  at.set_document("robots.cdl");
  at.set_cursor(static_cast<std::uint32_t>(std::string(kRobots).find("Roam(urge")));
  const Answer planned = plan(at, "Drift");
  ASSERT_EQ(planned.plan().files_size(), 3) << planned.error();
  const Answer done = carry_out(at, "Drift", planned.plan().seal());
  EXPECT_TRUE(has_part(done.error(), "cannot write `more.cdl`")) << done.error();
  EXPECT_EQ(browser_.read("skills.cdl"), kOwnSkills);
  EXPECT_EQ(browser_.read("robots.cdl"), kRobots);
}

TEST_F(DesignerNamesTest, ACollisionIsRefusedWithItsPlace) {
  const Answer answer = plan(drawn("", "Hunt"), "Roam");
  EXPECT_FALSE(answer.ok());
  EXPECT_FALSE(answer.error().empty());
  EXPECT_FALSE(plan(drawn("Scout", "urge"), "two words").ok());
  EXPECT_FALSE(plan(drawn("Scout", "nothing of this name"), "x").ok());
}

TEST_F(DesignerNamesTest, MissionsThatAreEditedInTheConsoleStayAsTheyAre) {
  documents::Drafts drafts(browser_.state_folder(), browser_.project_folder());
  const std::string mission = kMission;
  ASSERT_EQ(drafts.keep("missions/m.mdl", "anything", &mission), "");
  const Answer answer = plan(drawn("Scout", "urge"), "need");
  ASSERT_TRUE(answer.ok()) << answer.error();
  ASSERT_EQ(answer.plan().files_size(), 2);
  EXPECT_EQ(answer.plan().files(1).kept(), "has unsaved changes in the console");
  EXPECT_TRUE(std::ranges::any_of(answer.plan().notes(), [](const std::string& note) {
    return note.starts_with("`missions/m.mdl` has unsaved");
  }));
}

TEST_F(DesignerNamesTest, UsesOfWhatIsDrawnAreListedByFile) {
  const Answer state = uses(drawn("Hunt", "Resting"));
  ASSERT_TRUE(state.ok()) << state.error();
  EXPECT_EQ(state.uses().kind(), "state");
  ASSERT_EQ(state.uses().files_size(), 1);
  EXPECT_EQ(state.uses().files(0).uses_size(), 2);
  NameAt of_state = drawn("Hunt", "Resting");
  of_state.set_of_component(true);
  const Answer component = uses(of_state);
  ASSERT_TRUE(component.ok()) << component.error();
  EXPECT_EQ(component.uses().name(), "Roam");
  EXPECT_EQ(component.uses().files_size(), 2);
  EXPECT_EQ(component.uses().files(0).uses(0).within(), "Scout");
  const Answer unnamed = uses(drawn("Hunt.Looking", "Roam"));
  ASSERT_TRUE(unnamed.ok()) << unnamed.error();
  EXPECT_EQ(unnamed.uses().name(), "Roam") << "has no name of its own";
  NameAt written;
  written.set_document("robots.cdl");
  written.set_cursor(static_cast<std::uint32_t>(std::string(kRobots).find("Wait(")));
  const Answer library = uses(written);
  ASSERT_TRUE(library.ok()) << library.error();
  EXPECT_TRUE(library.uses().is_library());
  EXPECT_EQ(library.uses().files_size(), 1);
}

TEST_F(DesignerNamesTest, SearchFindsOverAllFilesAtOnce) {
  const auto found = [&](const std::string& query) {
    const Answer answer = browser_.ask([&](ToDesigner& m) {
      m.mutable_search()->set_query(query);
      m.mutable_search()->set_most(20);
    });
    std::vector<std::string> out;
    for (const names::Hit& hit : answer.hits().hits())
      out.push_back(fmt::format("{} {} {}:{}", hit.kind(), hit.name(), hit.path(), hit.line()));
    return out;
  };
  EXPECT_EQ(found("rest"), (std::vector<std::string>{"state Resting robots.cdl:9"}));
  EXPECT_EQ(found("hunt"), (std::vector<std::string>{"assemblage Hunt robots.cdl:5"}));
  EXPECT_EQ(found("roam").front(), "assemblage Roam skills.cdl:2");
  EXPECT_EQ(found("m.mdl"), (std::vector<std::string>{"file m.mdl missions/m.mdl:1"}));
  std::string large;
  for (int i = 0; i < 40; ++i)
    large += fmt::format(
        "assemblage Skill_{0}(urge: gain = 1) {{\n  let drift = Noise();\n  cooperate {{\n"
        "    urge: drift;\n    1: Wander();\n  }}\n}}\n\n",
        i);
  browser_.write("large.cdl", large);
  EXPECT_EQ(found("skill_37").size(), 1U) << "in a file that has come meanwhile";
}

}  // namespace
}  // namespace mlab::designer
