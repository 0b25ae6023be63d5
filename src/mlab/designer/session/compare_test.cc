#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "mlab/designer/testing/browser.h"

namespace mlab::designer {
namespace {

using testing::Browser;

constexpr const char* kBefore = R"(assemblage Drift() -> Vector {
  cooperate {
    1: Noise(persistence = 12 s);
    1: Stand();
  }
}

assemblage Seek() -> Vector {
  sequence {
    start Look: Drift();
      when Wait(delay = 9 s) goto Rest;
    Rest: Stand();
  }
}
)";

std::string with(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), by);
}

class Compared : public ::testing::Test {
 protected:
  void open(const std::string& page) {
    browser_.write("a.cdl", kBefore);
    ASSERT_EQ(browser_.open("a.cdl"), "a.cdl");
    look(page);
  }
  void look(const std::string& page) {
    browser_.ask([&](ToDesigner& m) {
      Page& one = *m.mutable_look()->add_pages();
      one.set_document("a.cdl");
      one.set_path(page);
    });
  }
  Answer compare(const std::function<void(CompareWith&)>& fill) {
    return browser_.ask([&](ToDesigner& m) {
      m.mutable_compare_with()->set_document("a.cdl");
      fill(*m.mutable_compare_with());
    });
  }

  Browser browser_;
};

TEST_F(Compared, WithTheSavedFileFollowsWhatIsTyped) {
  open("Drift");
  ASSERT_TRUE(compare([](CompareWith& w) { w.set_saved(true); }).ok());
  EXPECT_EQ(browser_.differences("a.cdl").title(), "the saved file");
  EXPECT_EQ(browser_.differences("a.cdl").entries_size(), 0);
  browser_.type("a.cdl", with(with(kBefore, "12 s", "6 s"), "    1: Stand();\n", ""));
  const Differences all = browser_.differences("a.cdl");
  ASSERT_EQ(all.entries_size(), 2);
  EXPECT_EQ(all.entries(0).text(), "Stand");
  EXPECT_EQ(all.entries(0).kind(), REMOVED);
  EXPECT_EQ(all.entries(0).node(), "-Stand");
  EXPECT_EQ(all.entries(1).text(), "Noise: persistence 12 s -> 6 s");
  EXPECT_EQ(all.entries(1).node(), "Noise");
  const PageDifference page = browser_.page_difference("Drift");
  ASSERT_EQ(page.nodes_size(), 1);
  EXPECT_EQ(page.nodes(0).name(), "-Stand");
  ASSERT_EQ(page.wires_size(), 1);
  EXPECT_EQ(page.wires(0).from(), "-Stand");
  EXPECT_EQ(page.wires(0).to(), "cooperate");
  ASSERT_EQ(page.marks_size(), 1);
  EXPECT_EQ(page.marks(0).name(), "Noise");
  EXPECT_EQ(page.marks(0).details(0).before(), "12 s");
  browser_.ask([](ToDesigner& m) { m.mutable_save()->set_document("a.cdl"); });
  EXPECT_EQ(browser_.differences("a.cdl").entries_size(), 0);
}

TEST_F(Compared, DrawsStatesAndTransitionsThatHaveGone) {
  open("Seek");
  ASSERT_TRUE(compare([](CompareWith& w) { w.set_saved(true); }).ok());
  browser_.type("a.cdl",
                with(with(kBefore, "      when Wait(delay = 9 s) goto Rest;\n", ""), "    Rest: Stand();\n",
                     "    Go: MoveToGoal();\n      when Wait(delay = 1 s) goto Look;\n"));
  browser_.differences("a.cdl");
  const PageDifference page = browser_.page_difference("Seek");
  ASSERT_EQ(page.states_size(), 1);
  EXPECT_EQ(page.states(0).name(), "-Rest");
  ASSERT_EQ(page.transitions_size(), 1);
  EXPECT_EQ(page.transitions(0).from(), "Look");
  EXPECT_EQ(page.transitions(0).to(), "-Rest");
  ASSERT_EQ(page.marks_size(), 2);
  EXPECT_EQ(page.marks(0).name(), "Go");
  EXPECT_EQ(page.marks(0).kind(), ADDED);
  EXPECT_EQ(page.marks(1).name(), "Go/0");
  EXPECT_EQ(page.marks(1).kind(), ADDED);
}

TEST_F(Compared, WithAnotherFileUntilItIsLeft) {
  browser_.write("b.cdl", with(kBefore, "9 s", "3 s"));
  open("Seek");
  EXPECT_FALSE(compare([](CompareWith& w) { w.set_file("none.cdl"); }).ok());
  ASSERT_TRUE(compare([](CompareWith& w) { w.set_file("b.cdl"); }).ok());
  const Differences all = browser_.differences("a.cdl");
  EXPECT_EQ(all.title(), "b.cdl");
  ASSERT_EQ(all.entries_size(), 1);
  EXPECT_EQ(all.entries(0).node(), "Look/0");
  browser_.ask([](ToDesigner& m) { m.mutable_stop_comparing()->set_document("a.cdl"); });
  browser_.type("a.cdl", with(kBefore, "12 s", "6 s"));
  EXPECT_EQ(browser_.differences("a.cdl").entries_size(), 1) << "told of something else after it was left";
}

TEST_F(Compared, WithARevisionOfGit) {
  open("Drift");
  const auto revisions = [&] {
    return browser_.ask([](ToDesigner& m) { m.mutable_list_revisions()->set_document("a.cdl"); });
  };
  EXPECT_NE(revisions().error().find("in no repository"), std::string::npos) << revisions().error();
  const std::string git = fmt::format(
      "cd '{}' && git init -q && git add a.cdl && git -c user.name=T -c user.email=t@example.org commit -q "
      "-m first",
      browser_.folder());
  ASSERT_EQ(std::system(git.c_str()), 0);  // NOLINT(cert-env33-c): the test's own words
  browser_.type("a.cdl", with(kBefore, "12 s", "6 s"));
  const Answer listed = revisions();
  ASSERT_EQ(listed.revisions().revisions_size(), 1) << listed.error();
  EXPECT_EQ(listed.revisions().revisions(0).subject(), "first");
  ASSERT_TRUE(compare([&](CompareWith& w) { w.set_revision(listed.revisions().revisions(0).id()); }).ok());
  EXPECT_EQ(browser_.differences("a.cdl").entries_size(), 1);
  EXPECT_FALSE(compare([](CompareWith& w) { w.set_revision("--all"); }).ok());
}

TEST_F(Compared, AsksGitOnlyForTheLastOfMany) {
  open("Drift");
  constexpr int kMany = 30;
  std::vector<std::uint32_t> requests;
  for (int i = 0; i < kMany; ++i)
    requests.push_back(
        browser_.send([](ToDesigner& m) { m.mutable_list_revisions()->set_document("a.cdl"); }));
  int replaced = 0;
  for (const std::uint32_t request : requests)
    replaced += browser_.answer_to(request).error() == "it was asked for again since" ? 1 : 0;
  EXPECT_GT(replaced, 0);
  EXPECT_NE(browser_.answer_to(requests.back()).error().find("in no repository"), std::string::npos);
}

TEST_F(Compared, DoesNotSayOfWhatCantBeReadThatItIsTheSame) {
  browser_.write("torn.cdl", std::string(kBefore) + "assemblage {\n");
  open("Drift");
  ASSERT_TRUE(compare([](CompareWith& w) { w.set_file("torn.cdl"); }).ok());
  const Differences all = browser_.differences("a.cdl");
  EXPECT_EQ(all.entries_size(), 0);
  ASSERT_EQ(all.remarks_size(), 1);
  EXPECT_EQ(all.remarks(0), "only what could be read was compared, and that is the same");
}

}  // namespace
}  // namespace mlab::designer
