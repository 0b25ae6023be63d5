#include "mlab/designer/designer.h"
#include "mlab/designer/drawing/titles.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "mlab/designer.pb.h"
#include "mlab/designer/testing/browser.h"

namespace mlab::designer {
namespace {

using testing::Browser;

constexpr const char* kText = "assemblage A() {\n  cooperate {\n    1: Noise();\n  }\n}\n";

TEST(Designer, GreetsWithWhatThereIsToOpen) {
  Browser browser;
  browser.write("a.cdl", kText);
  browser.greet(2);
  ASSERT_EQ(browser.hello().files_size(), 1);
  EXPECT_EQ(browser.hello().files(0).path(), "a.cdl");
  EXPECT_GE(browser.hello().examples_size(), 1);
}

TEST(Designer, ShowsPagesAndWhatIsDrawnOnThem) {
  Browser browser;
  browser.write("a.cdl", kText);
  ASSERT_EQ(browser.open("a.cdl"), "a.cdl");
  browser.ask([](ToDesigner& m) {
    Page& page = *m.mutable_look()->add_pages();
    page.set_document("a.cdl");
    page.set_path("A");
  });
  EXPECT_EQ(browser.drawing("A").nodes_size(), 2);
  const Answer answer = browser.ask([](ToDesigner& m) {
    m.mutable_edit()->set_document("a.cdl");
    Place& place = *m.mutable_edit()->add_changes()->mutable_place();
    place.set_page("A");
    place.set_component("Stand");
    place.set_to_node("cooperate");
    place.set_to_port("members");
  });
  ASSERT_TRUE(answer.ok()) << answer.error();
  EXPECT_EQ(browser.drawing("A").nodes_size(), 3);
  EXPECT_NE(browser.document("a.cdl").text().find("    Stand();\n"), std::string::npos)
      << browser.document("a.cdl").text();
  EXPECT_EQ(browser.document("a.cdl").undo(), "place Stand");
  browser.ask([](ToDesigner& m) { m.mutable_undo()->set_document("a.cdl"); });
  EXPECT_EQ(browser.document("a.cdl").text(), kText);
  EXPECT_EQ(browser.drawing("A").nodes_size(), 2);
}

TEST(Designer, SharesADocumentAmongWindows) {
  Browser browser;
  browser.write("a.cdl", kText);
  browser.open("a.cdl");
  browser.greet(2);
  browser.open("a.cdl", 2);
  browser.type("a.cdl", "// other\n");
  EXPECT_EQ(browser.document("a.cdl", 2).text(), "// other\n");
}

TEST(Designer, KeepsDrawingWhileTheTextHasASlip) {
  Browser browser;
  browser.write("a.cdl", kText);
  browser.open("a.cdl");
  browser.type("a.cdl", "assemblage A( {\n");
  const Document document = browser.document("a.cdl");
  EXPECT_TRUE(document.is_outdated());
  EXPECT_GE(document.problems_size(), 1);
  const Answer answer = browser.ask([](ToDesigner& m) {
    m.mutable_edit()->set_document("a.cdl");
    m.mutable_edit()->add_changes()->mutable_remove()->add_nodes("A");
  });
  EXPECT_FALSE(answer.ok());
  EXPECT_EQ(browser.document("a.cdl").text(), "assemblage A( {\n");
}

TEST(Designer, TellsWhatTheCheckerSays) {
  Browser browser;
  browser.write("a.cdl", "assemblage A() {\n  cooperate {\n    1: Noise(persistence = 2 m);\n  }\n}\n");
  browser.open("a.cdl");
  ASSERT_TRUE(browser.waits_for([&] { return browser.seen("a.cdl").problems_size() > 0; }));
  EXPECT_EQ(browser.document("a.cdl").problems(0).node(), "Noise");
}

TEST(Designer, SavesAndRefusesToOverwriteWhatOthersChanged) {
  Browser browser;
  browser.write("a.cdl", kText);
  browser.open("a.cdl");
  browser.type("a.cdl", "// mine\n");
  browser.write("a.cdl", "// theirs\n");
  const auto save = [&](bool overwrite) {
    return browser.ask([&](ToDesigner& m) {
      m.mutable_save()->set_document("a.cdl");
      m.mutable_save()->set_overwrite(overwrite);
    });
  };
  EXPECT_FALSE(save(false).ok());
  EXPECT_EQ(browser.read("a.cdl"), "// theirs\n");
  EXPECT_TRUE(save(true).ok());
  EXPECT_EQ(browser.read("a.cdl"), "// mine\n");
  EXPECT_FALSE(browser.document("a.cdl").is_dirty());
}

TEST(Designer, KeepsTheLineEndsOfAFile) {
  Browser browser;
  browser.write("a.cdl", "// one\r\n// two\r\n");
  browser.open("a.cdl");
  EXPECT_EQ(browser.document("a.cdl").text(), "// one\n// two\n");
  EXPECT_FALSE(browser.document("a.cdl").is_dirty());
  browser.type("a.cdl", "// one\n// and a half\n// two\n");
  const auto save = [&](const std::string& as) {
    return browser.ask([&](ToDesigner& m) {
      m.mutable_save()->set_document("a.cdl");
      m.mutable_save()->set_as(as);
    });
  };
  EXPECT_TRUE(save("").ok());
  EXPECT_EQ(browser.read("a.cdl"), "// one\r\n// and a half\r\n// two\r\n");
  EXPECT_TRUE(save("b.cdl").ok());
  EXPECT_EQ(browser.read("b.cdl"), browser.read("a.cdl"));
}

TEST(Designer, TakesOverAFileThatOthersChanged) {
  Browser browser;
  browser.write("a.cdl", kText);
  browser.open("a.cdl");
  browser.write("a.cdl", "// theirs\n");
  ASSERT_TRUE(browser.waits_for([&] { return browser.seen("a.cdl").text() == "// theirs\n"; }));
  EXPECT_FALSE(browser.changed(1).empty());
}

TEST(Designer, MergesWhatBothChanged) {
  Browser browser;
  browser.write("a.cdl", "// one\n// two\n// three\n");
  browser.open("a.cdl");
  browser.type("a.cdl", "// ONE\n// two\n// three\n");
  browser.write("a.cdl", "// one\n// two\n// three\n// four\n");
  const Answer answer = browser.ask([](ToDesigner& m) {
    m.mutable_reload()->set_document("a.cdl");
    m.mutable_reload()->set_merge(true);
  });
  EXPECT_TRUE(answer.ok()) << answer.error();
  EXPECT_EQ(browser.document("a.cdl").text(), "// ONE\n// two\n// three\n// four\n");
}

TEST(Designer, BringsBackUnsavedWork) {
  Browser browser;
  browser.write("a.cdl", kText);
  browser.open("a.cdl");
  browser.type("a.cdl", "// not saved\n");
  const std::string fresh = browser.open("");
  browser.type(fresh, "// new\n");
  browser.start();
  EXPECT_EQ(browser.open("a.cdl"), "a.cdl");
  EXPECT_EQ(browser.document("a.cdl").text(), "// not saved\n");
  EXPECT_TRUE(browser.document("a.cdl").is_dirty());
  EXPECT_EQ(browser.open(fresh), fresh);
  EXPECT_EQ(browser.document(fresh).text(), "// new\n");
  browser.ask([](ToDesigner& m) { m.mutable_undo()->set_document("a.cdl"); });
  EXPECT_EQ(browser.document("a.cdl").text(), kText);
}

TEST(Designer, TellsWhoComesLaterThatPeopleHaveToDecide) {
  Browser browser;
  browser.write("a.cdl", kText);
  browser.open("a.cdl");
  browser.type("a.cdl", "// mine\n");
  browser.write("a.cdl", "// theirs\n");
  ASSERT_TRUE(browser.waits_for([&] { return !browser.seen_changes(1).empty(); }));
  EXPECT_TRUE(browser.changed(1).back().is_dirty_here());
  browser.greet(2);
  browser.open("a.cdl", 2);
  ASSERT_EQ(browser.changed(2).size(), 1U);
  EXPECT_TRUE(browser.changed(2)[0].is_dirty_here());
  browser.write("a.cdl", kText);
  ASSERT_TRUE(browser.waits_for([&] { return browser.seen_changes(2).size() == 2; }));
  EXPECT_TRUE(browser.changed(2)[1].is_same_again()) << "nothing is to be decided any more";
  EXPECT_TRUE(browser.changed(1).back().is_same_again());
}

TEST(Designer, TellsWhoMayNotSaveThatPeopleHaveToDecide) {
  Browser browser;
  browser.write("a.cdl", kText);
  browser.open("a.cdl");
  browser.type("a.cdl", "// mine\n");
  browser.write("a.cdl", "// theirs\n");
  ASSERT_TRUE(browser.waits_for([&] { return !browser.seen_changes(1).empty(); }));
  const std::size_t before = browser.changed(1).size();
  EXPECT_FALSE(browser.ask([](ToDesigner& m) { m.mutable_save()->set_document("a.cdl"); }).ok());
  ASSERT_EQ(browser.changed(1).size(), before + 1) << "who has put it out of sight is told again";
  EXPECT_TRUE(browser.changed(1).back().is_dirty_here());
}

TEST(Designer, TellsEverythingAnewToWhomOpensADocumentAgain) {
  Browser browser;
  browser.write("a.cdl", kText);
  browser.open("a.cdl");
  const std::size_t before = browser.times_told("a.cdl");
  browser.send([](ToDesigner& m) { m.mutable_close()->set_document("a.cdl"); });
  browser.open("a.cdl");
  EXPECT_GT(browser.times_told("a.cdl"), before);
}

TEST(Designer, OpensWhatIsKeptOfAFileThatIsGone) {
  Browser browser;
  browser.write("a.cdl", kText);
  browser.open("a.cdl");
  browser.type("a.cdl", "// not saved\n");
  browser.start();
  std::filesystem::remove(browser.folder() + "/a.cdl");
  browser.start();
  ASSERT_EQ(browser.hello().recent_size(), 1);
  EXPECT_EQ(browser.hello().recent(0).path(), "a.cdl");
  EXPECT_EQ(browser.open("a.cdl"), "a.cdl");
  EXPECT_EQ(browser.document("a.cdl").text(), "// not saved\n");
  ASSERT_FALSE(browser.changed(1).empty());
  EXPECT_TRUE(browser.changed(1).back().is_gone());
  EXPECT_TRUE(browser.ask([](ToDesigner& m) { m.mutable_save()->set_document("a.cdl"); }).ok());
  EXPECT_EQ(browser.read("a.cdl"), "// not saved\n");
}

TEST(Designer, ThrowsAwayWhatIsKeptOfAFileThatIsGone) {
  Browser browser;
  browser.write("a.cdl", kText);
  browser.open("a.cdl");
  browser.type("a.cdl", "// not saved\n");
  browser.start();
  EXPECT_EQ(browser.hello().only_kept_size(), 0) << "it has its file";
  const auto discard = [&] {
    return browser.ask([](ToDesigner& m) { m.mutable_discard()->set_document("a.cdl"); }).error();
  };
  EXPECT_EQ(discard(), "only what has no file can be thrown away");
  std::filesystem::remove(browser.folder() + "/a.cdl");
  browser.start();
  ASSERT_EQ(browser.hello().only_kept_size(), 1);
  EXPECT_EQ(browser.hello().only_kept(0), "a.cdl");
  EXPECT_EQ(discard(), "");
  EXPECT_NE(discard(), "") << "there is nothing any more";
  browser.start();
  EXPECT_EQ(browser.hello().only_kept_size(), 0);
  EXPECT_EQ(browser.hello().recent_size(), 0);
}

TEST(Designer, CallsWhatHasNoFileByWhatItHolds) {
  EXPECT_EQ(unsaved_title(""), "New configuration");
  EXPECT_EQ(
      unsaved_title("// From `old/demo.cdl`, a configuration of the historic tools.\nassemblage A() {}"),
      "demo.cdl");
  EXPECT_EQ(unsaved_title("assemblage Drift(a: gain) {\n}\n\nrobot One is MRV2 {\n}"), "Drift, One");
  EXPECT_EQ(unsaved_title("assemblage A() {\n}\nassemblage B() {}\nsociety C: A;\nrobot D{}\n"), "A, B, C …");
  EXPECT_EQ(unsaved_title("// From `"), "New configuration");
}

TEST(Designer, ListsUnsavedWorkByItsTitleUntilItIsThrownAway) {
  Browser browser;
  const std::string fresh = browser.open("");
  browser.type(fresh, kText);
  EXPECT_EQ(browser.document(fresh).title(), "A");
  browser.start();
  const auto entries = [&] {
    std::string out;
    for (const auto& one : browser.hello().recent()) out += one.path() + " is " + one.title() + ";";
    return out;
  };
  EXPECT_EQ(entries(), fresh + " is A;");
  EXPECT_EQ(browser.open(fresh), fresh);
  browser.greet(2);
  EXPECT_EQ(browser.open(fresh, 2), fresh);
  const auto discard = [&](int from, const std::string& path) {
    return browser.ask([&](ToDesigner& m) { m.mutable_discard()->set_document(path); }, from);
  };
  EXPECT_EQ(discard(1, fresh).error(), "another window has it open: close that first");
  browser.ask([&](ToDesigner& m) { m.mutable_close()->set_document(fresh); }, 2);
  EXPECT_TRUE(discard(1, fresh).ok());
  EXPECT_FALSE(browser.ask([&](ToDesigner& m) { m.mutable_open()->set_path(fresh); }).ok());
  browser.start();
  EXPECT_EQ(entries(), "");
}

TEST(Designer, SaysWhatAConfigurationIsFor) {
  EXPECT_EQ(said_of(""), "");
  EXPECT_EQ(said_of("assemblage A() {}\n// too late"), "");
  EXPECT_EQ(said_of("\n// Forage: of the report.\nassemblage A() {}"), "Forage: of the report.");
  EXPECT_EQ(said_of("// One robot\n//  that wanders. It does\n// no more.\n"), "One robot that wanders.");
  EXPECT_EQ(said_of("//\n/// Drives.\r\nrobot A {}"), "Drives.");
  EXPECT_EQ(said_of("// First\n//\n// second"), "First");
  EXPECT_LT(said_of("// " + std::string(9000, 'x')).size(), 200U);
  EXPECT_TRUE(said_of("// " + std::string(90, 'x') + ' ' + std::string(90, 'y')).ends_with("x …"));
}

TEST(Designer, TellsAllWindowsWhatThereIsToOpen) {
  Browser browser;
  browser.write("b.cdl", "// Says what it is.\n" + std::string(kText));
  browser.start();
  ASSERT_EQ(browser.hello().files_size(), 1);
  EXPECT_EQ(browser.hello().files(0).title(), "b");
  EXPECT_EQ(browser.hello().files(0).about(), "Says what it is.");
  const std::string fresh = browser.open("");
  browser.type(fresh, kText);
  browser.greet(2);
  browser.ask([&](ToDesigner& m) {
    m.mutable_save()->set_document(fresh);
    m.mutable_save()->set_as("a.cdl");
  });
  const std::optional<Lists> lists = browser.lists(2);
  ASSERT_TRUE(lists);
  ASSERT_GT(lists->recent_size(), 0);
  EXPECT_EQ(lists->recent(0).path(), "a.cdl");
  for (const auto& one : lists->recent()) EXPECT_NE(one.path(), fresh);
  EXPECT_EQ(lists->files_size(), 2);
}

TEST(Designer, ThrowsNoFileAway) {
  Browser browser;
  browser.write("a.cdl", kText);
  browser.open("a.cdl");
  browser.type("a.cdl", "// not saved\n");
  EXPECT_FALSE(browser.ask([](ToDesigner& m) { m.mutable_discard()->set_document("a.cdl"); }).ok());
  EXPECT_EQ(browser.document("a.cdl").text(), "// not saved\n");
}

TEST(Designer, OpensTheLibraryReadOnlyAndNothingOutside) {
  Browser browser;
  EXPECT_EQ(browser.open("library:assemblages/wander.cdl"), "library:assemblages/wander.cdl");
  EXPECT_TRUE(browser.document("library:assemblages/wander.cdl").is_read_only());
  for (const char* path : {"../a.cdl", "/etc/passwd", "library:../x", "no.cdl", "examples:../../etc/passwd"})
    EXPECT_TRUE(browser.open(path).starts_with("error")) << path;
}

TEST(Designer, SavesANewDocumentUnderAName) {
  Browser browser;
  const std::string fresh = browser.open("");
  browser.type(fresh, kText);
  const auto save = [&](const std::string& as) {
    return browser.ask([&](ToDesigner& m) {
      m.mutable_save()->set_document(fresh);
      m.mutable_save()->set_as(as);
    });
  };
  EXPECT_FALSE(save("").ok());
  EXPECT_FALSE(save("../b.cdl").ok());
  const Answer answer = save("b.cdl");
  EXPECT_TRUE(answer.ok()) << answer.error();
  EXPECT_EQ(browser.read("b.cdl"), kText);
  EXPECT_EQ(browser.document("b.cdl").path(), "b.cdl");
}

TEST(Designer, AnswersNonsense) {
  Browser browser;
  EXPECT_FALSE(browser.ask([](ToDesigner& m) { m.mutable_edit()->set_document("x"); }).ok());
  EXPECT_FALSE(browser.ask([](ToDesigner& m) { m.mutable_undo(); }).ok());
  EXPECT_FALSE(browser.ask([](ToDesigner&) {}).ok());
  EXPECT_FALSE(browser.ask([](ToDesigner& m) { m.mutable_edit(); }, 7).ok());
}

}  // namespace
}  // namespace mlab::designer
