#include "mlab/designer/trial/mark_store.h"

#include <cstdint>
#include <string>

#include <gtest/gtest.h>

#include "mlab/designer/testing/browser.h"
#include "mlab/documents/testing/scratch_project.h"

namespace mlab::designer {
namespace {

using testing::Browser;

std::string turns(const std::string& first, const std::string& before = "") {
  return before + "assemblage Turns() {\n  sequence {\n    start " + first +
         ": Stand();\n      when IsHalted() goto Moving;\n    Moving: Noise(persistence = 2 s);\n  }\n}\n";
}

std::uint32_t set_breakpoint(Browser& browser, const std::string& document) {
  const Answer answer = browser.ask([&](ToDesigner& m) {
    m.mutable_set_mark()->set_document(document);
    Mark& mark = *m.mutable_set_mark()->mutable_mark();
    mark.set_page("Turns");
    mark.set_place("movement");
    mark.set_from("Waiting");
    mark.set_to("Moving");
    mark.mutable_breakpoint()->set_id(7);
    mark.mutable_breakpoint()->mutable_transition()->set_from("Waiting");
  });
  EXPECT_TRUE(answer.ok()) << answer.error();
  return answer.ok() ? static_cast<std::uint32_t>(std::stoul(answer.text())) : 0;
}

TEST(MarkStore, KeepsMarksForTheNextServer) {
  Browser browser;
  browser.write("one.cdl", turns("Waiting"));
  browser.open("one.cdl");
  set_breakpoint(browser, "one.cdl");
  browser.start();
  browser.open("one.cdl");
  const MarkList marks = browser.marks("one.cdl");
  ASSERT_EQ(marks.marks_size(), 1);
  EXPECT_EQ(marks.marks(0).from(), "Waiting");
  EXPECT_EQ(marks.marks(0).breakpoint().transition().from(), "Waiting");
  EXPECT_EQ(marks.marks(0).breakpoint().id(), 0U) << "the next server's simulator knows of none";
  EXPECT_FALSE(marks.marks(0).is_lost());
}

TEST(MarkStore, FollowsWhatWasChangedMeanwhile) {
  Browser browser;
  browser.write("one.cdl", turns("Waiting"));
  browser.open("one.cdl");
  set_breakpoint(browser, "one.cdl");
  browser.write("one.cdl", turns("Waiting", "// Turns about.\n\n"));
  browser.start();
  browser.open("one.cdl");
  ASSERT_EQ(browser.marks("one.cdl").marks_size(), 1);
  EXPECT_FALSE(browser.marks("one.cdl").marks(0).is_lost());
  browser.write("one.cdl", "assemblage Other() {\n  Stand()\n}\n");
  browser.start();
  browser.open("one.cdl");
  ASSERT_EQ(browser.marks("one.cdl").marks_size(), 1);
  EXPECT_TRUE(browser.marks("one.cdl").marks(0).is_lost());
}

TEST(MarkStore, KeepsNothingOfWhatWasTakenAway) {
  Browser browser;
  browser.write("one.cdl", turns("Waiting"));
  browser.open("one.cdl");
  const std::uint32_t id = set_breakpoint(browser, "one.cdl");
  browser.ask([&](ToDesigner& m) {
    m.mutable_remove_mark()->set_document("one.cdl");
    m.mutable_remove_mark()->set_id(id);
  });
  browser.start();
  browser.open("one.cdl");
  EXPECT_EQ(browser.marks("one.cdl").marks_size(), 0);
}

TEST(MarkStore, KeepsThemUnderTheNameThatTheDocumentWasSavedWith) {
  Browser browser;
  const std::string path = browser.open("");
  browser.type(path, turns("Waiting"));
  set_breakpoint(browser, path);
  const Answer saved = browser.ask([&](ToDesigner& m) {
    m.mutable_save()->set_document(path);
    m.mutable_save()->set_as("turns.cdl");
  });
  ASSERT_TRUE(saved.ok()) << saved.error();
  browser.start();
  browser.open("turns.cdl");
  EXPECT_EQ(browser.marks("turns.cdl").marks_size(), 1);
  // The next that has no name yet is called as that was.
  const std::string next = browser.open("");
  EXPECT_EQ(browser.marks(next).marks_size(), 0);
}

TEST(MarkStore, IgnoresWhatCannotBeRead) {
  const documents::testing::ScratchProject scratch;
  const std::string folder = scratch.path("state").string();
  const documents::StateFolder state(folder, "project");
  const MarkStore store(folder, "project");
  state.write(documents::StateFolder::name_of("one.cdl", ".marks"), "no marks");
  EXPECT_FALSE(store.find("one.cdl", {}).has_value());
  EXPECT_FALSE(store.find("two.cdl", {}).has_value());
  EXPECT_FALSE(MarkStore("", "project").find("one.cdl", {}).has_value());
}

}  // namespace
}  // namespace mlab::designer
