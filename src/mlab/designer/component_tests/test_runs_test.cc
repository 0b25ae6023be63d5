// Tests of components as a browser is told of them: found, run, given up, shown cycle by cycle, written.

#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "mlab/designer/component_tests/loaded_tests.h"
#include "mlab/designer/testing/browser.h"

namespace mlab::designer {
namespace {

using testing::Browser;

constexpr const char* kCareful = R"(assemblage Careful(place: Point) {
  sequence {
    start Coming: MoveToGoal(DetectGoal(place), success_radius = 50 cm);
      when AreRobotsNear(sense_robots(), range = 3 m) goto Waiting;
    Waiting: Stand();
      when not AreRobotsNear(sense_robots(), range = 3 m) goto Coming;
  }
}
)";

constexpr const char* kGood = R"(
test "comes" of Careful([20 m, 0 m]) {
  expect state Coming;
}
)";

constexpr const char* kBad = R"(
test "waits" of Careful([20 m, 0 m]) {
  expect for 3 cycles: state Coming;
  given robot(at = [4 m, 0 m]);
  expect state Waiting;
}
)";

class ListedTests : public ::testing::Test {
 protected:
  void open(const std::string& file) { ASSERT_EQ(browser_.open(file), file); }
  void watch(const std::string& file, bool is_wanted = true) {
    const Answer answer = browser_.ask([&](ToDesigner& m) {
      m.mutable_watch_tests()->set_document(file);
      m.mutable_watch_tests()->set_is_wanted(is_wanted);
    });
    EXPECT_TRUE(answer.ok()) << answer.error();
  }
  /// Waits until the list of the document is so.
  TestList listed(const std::string& file, const std::function<bool(const TestList&)>& is_so) {
    EXPECT_TRUE(browser_.waits_for([&] { return is_so(browser_.seen_tests(file)); }));
    return browser_.tests(file);
  }
  TestList known(const std::string& file, int count) {
    return listed(file, [&](const TestList& list) { return list.is_known() && list.tests_size() == count; });
  }
  void run(const std::string& file, const TestList& list) {
    browser_.ask([&](ToDesigner& m) {
      m.mutable_run_tests()->set_document(file);
      for (const TestList::Test& test : list.tests()) *m.mutable_run_tests()->add_tests() = test.test();
    });
  }
  static bool is_done(const TestList& list) {
    for (const TestList::Test& test : list.tests()) {
      const bool is_open = test.state() == TestList::NOT_RUN || test.state() == TestList::RUNNING;
      if (is_open || test.is_outdated()) return false;
    }
    return list.tests_size() > 0;
  }
  TestList ran(const std::string& file, int count) {
    run(file, known(file, count));
    return listed(file, is_done);
  }
  Answer cycle(const std::string& file, const std::string& name, std::uint32_t cycle,
               const std::string& document, const std::string& page) {
    return browser_.ask([&](ToDesigner& m) {
      ShowTestCycle& show = *m.mutable_show_test_cycle();
      show.mutable_test()->set_file(file);
      show.mutable_test()->set_name(name);
      show.set_cycle(cycle);
      show.set_document(document);
      show.set_page(page);
    });
  }

  Browser browser_;
};

TEST_F(ListedTests, AreThoseOfTheDocumentAndOfFilesThatUseIt) {
  browser_.write("careful.cdl", std::string(kCareful) + kGood);
  browser_.write("more.cdl", std::string("use \"careful.cdl\";\n") + kBad);
  browser_.write("other.cdl", "test \"stands\" of Stand() { expect length(it) == 0; }\n");
  open("careful.cdl");
  watch("careful.cdl");
  const TestList list = known("careful.cdl", 2);
  EXPECT_EQ(list.tests(0).test().name(), "comes");
  EXPECT_EQ(list.tests(0).component(), "Careful([20 m, 0 m])");
  EXPECT_EQ(list.tests(0).state(), TestList::NOT_RUN);
  EXPECT_EQ(list.tests(1).test().file(), "more.cdl");
  EXPECT_EQ(list.tests(1).page().document(), "careful.cdl");
  EXPECT_EQ(list.tests(1).page().page(), "Careful");
  EXPECT_EQ(list.tests(1).line(), 3U);
}

TEST_F(ListedTests, SayWhatWasThereInsteadOfWhatWasExpected) {
  browser_.write("careful.cdl", std::string(kCareful) + kGood + kBad);
  open("careful.cdl");
  watch("careful.cdl");
  const TestList list = ran("careful.cdl", 2);
  EXPECT_EQ(list.tests(0).state(), TestList::PASSED);
  EXPECT_EQ(list.tests(0).cycles(), 1U);
  ASSERT_EQ(list.tests(1).state(), TestList::FAILED);
  const TestList::Failure& failure = list.tests(1).failure();
  EXPECT_EQ(failure.expected(), "state Waiting");
  EXPECT_EQ(failure.reason(), "is false");
  EXPECT_EQ(failure.cycle(), 4U);
  EXPECT_EQ(failure.line(), 17U);
  EXPECT_EQ(failure.place().document(), "careful.cdl");
  ASSERT_FALSE(failure.findings().empty());
  EXPECT_EQ(failure.findings(failure.findings_size() - 1), "in state it.Coming");
}

TEST_F(ListedTests, AreOutdatedOnceTheirTextsSaySomethingElse) {
  browser_.write("careful.cdl", kCareful);
  browser_.write("more.cdl", std::string("use \"careful.cdl\";\n") + kBad);
  open("careful.cdl");
  watch("careful.cdl");
  EXPECT_EQ(ran("careful.cdl", 1).tests(0).state(), TestList::FAILED);
  std::string text = kCareful;
  text.replace(text.find("range = 3 m) goto Waiting"), 11, "range = 9 m");
  browser_.type("careful.cdl", text);
  const TestList list = listed("careful.cdl", [](const TestList& seen) {
    return seen.tests_size() == 1 && seen.tests(0).is_outdated();
  });
  EXPECT_EQ(list.tests(0).state(), TestList::FAILED);
  run("careful.cdl", list);
  EXPECT_EQ(listed("careful.cdl", is_done).tests(0).state(), TestList::PASSED);
}

TEST_F(ListedTests, SayWhyTheyCantRun) {
  browser_.write("a.cdl", std::string(kCareful) + "test \"is\" of Careful() { expect state Nowhere; }\n");
  open("a.cdl");
  watch("a.cdl");
  const TestList list = ran("a.cdl", 1);
  EXPECT_EQ(list.tests(0).state(), TestList::CANT_RUN);
  EXPECT_EQ(list.tests(0).why(), "`Careful` needs `place`");
  EXPECT_EQ(list.tests(0).trouble().document(), "a.cdl");
}

// Each of a hundred would go on for seconds.
TEST_F(ListedTests, AreGivenUpByTheNextRunAndKeepNobodyWaiting) {
  std::string text = kCareful;
  for (int i = 0; i < 100; ++i)
    text += fmt::format(
        "test \"long {}\" of Careful([20 m, 0 m]) {{ expect for 99999 cycles: state Coming; }}\n", i);
  browser_.write("long.cdl", text);
  open("long.cdl");
  watch("long.cdl");
  const TestList list = known("long.cdl", 100);
  run("long.cdl", list);
  listed("long.cdl", [](const TestList& seen) { return seen.tests(99).state() == TestList::RUNNING; });
  run("long.cdl", {});
  const TestList stopped =
      listed("long.cdl", [](const TestList& seen) { return seen.tests(99).state() == TestList::NOT_RUN; });
  EXPECT_EQ(stopped.tests(99).state(), TestList::NOT_RUN);
  browser_.write("long.cdl", "");
}

// The same number stands for another text here, so that it shows whether the file was loaded again.
TEST(LoadedTests, KeepAFileUnlessItsLoadingWasGivenUp) {
  LoadedTests loaded({});
  const auto tests_of = [&](const std::string& text, const std::stop_token& ends) {
    const auto source = std::make_shared<const text::Source>("a.cdl", text);
    return loaded.of(source, 7, text::files_on_disk(), ends).tests.tests.size();
  };
  std::stop_source given_up;
  given_up.request_stop();
  EXPECT_EQ(tests_of(kCareful, given_up.get_token()), 0U);
  EXPECT_EQ(tests_of(std::string(kCareful) + kGood, {}), 1U);
  EXPECT_EQ(tests_of(kCareful, {}), 1U) << "what is kept";
}

TEST_F(ListedTests, ShowTheValuesOfACycleWhereAPageRuns) {
  browser_.write("careful.cdl", std::string(kCareful) + kBad);
  open("careful.cdl");
  watch("careful.cdl");
  known("careful.cdl", 1);
  const Answer answer = cycle("careful.cdl", "waits", 0xffffffffU, "careful.cdl", "Careful");
  ASSERT_TRUE(answer.ok()) << answer.error();
  const TestCycle& shown = answer.test_cycle();
  EXPECT_EQ(shown.cycle(), 4U);
  EXPECT_EQ(shown.cycles(), 4U);
  ASSERT_EQ(shown.places_size(), 1);
  EXPECT_EQ(shown.places(0), "it");
  ASSERT_EQ(shown.values().states_size(), 1);
  EXPECT_EQ(shown.values().states(0), "it.Coming");
  ASSERT_EQ(shown.ports_size(), shown.values().ports_size());
  EXPECT_EQ(shown.values().active().size(), static_cast<std::size_t>(shown.ports_size()));
  EXPECT_EQ(cycle("careful.cdl", "waits", 2, "careful.cdl", "Careful").test_cycle().cycle(), 2U);
  const Answer nothing = cycle("careful.cdl", "gone", 1, "careful.cdl", "Careful");
  EXPECT_FALSE(nothing.ok());
  EXPECT_EQ(nothing.error(), "there is no test \"gone\"");
}

TEST_F(ListedTests, ShowNothingOfAPageThatIsNoPartOfThem) {
  browser_.write("careful.cdl", std::string(kCareful) + "assemblage Other() { Stand() }\n" + kGood);
  open("careful.cdl");
  watch("careful.cdl");
  known("careful.cdl", 1);
  const Answer answer = cycle("careful.cdl", "comes", 1, "careful.cdl", "Other");
  ASSERT_TRUE(answer.ok()) << answer.error();
  EXPECT_EQ(answer.test_cycle().cycle(), 1U);
  EXPECT_EQ(answer.test_cycle().places_size(), 0);
  EXPECT_EQ(answer.test_cycle().ports_size(), 0);
}

TEST_F(ListedTests, BringNothingToRunWhereCodeMayNotRun) {
  browser_.set_permission({});
  browser_.start();
  browser_.write("own.cnl", "procedure Vector STAY with\nbody\n{\n  VECTOR_ZERO(output);\n}\npend\n");
  browser_.write("own.cdl", "use \"own.cnl\";\ntest \"stays\" of STAY() { expect length(it) == 0; }\n");
  open("own.cdl");
  watch("own.cdl");
  const TestList list = ran("own.cdl", 1);
  EXPECT_TRUE(list.tests(0).brings_code());
  EXPECT_NE(list.tests(0).state(), TestList::PASSED);
}

TEST_F(ListedTests, BeginWithOneThatIsWrittenForYou) {
  browser_.write("careful.cdl", kCareful);
  open("careful.cdl");
  watch("careful.cdl");
  known("careful.cdl", 0);
  const auto add = [&](const std::string& component) {
    return browser_.ask([&](ToDesigner& m) {
      m.mutable_add_test()->set_document("careful.cdl");
      m.mutable_add_test()->set_component(component);
    });
  };
  const Answer answer = add("Careful");
  ASSERT_TRUE(answer.ok()) << answer.error();
  const std::string text = browser_.document("careful.cdl").text();
  const std::string written =
      text.substr(answer.location().begin(), answer.location().end() - answer.location().begin());
  EXPECT_EQ(written,
            "test \"Careful near an obstacle\" of Careful(place = [10 m, 0 m]) {\n"
            "  given obstacle(at = [6 m, 1 m], radius = 0.5 m);\n"
            "  expect state Coming;\n"
            "}");
  ASSERT_TRUE(add("").ok());
  const TestList list = ran("careful.cdl", 2);
  EXPECT_EQ(list.tests(1).test().name(), "Careful near an obstacle 2");
  EXPECT_EQ(list.tests(1).state(), TestList::PASSED);
  for (int i = 0; i < 2; ++i)
    browser_.ask([](ToDesigner& m) { m.mutable_undo()->set_document("careful.cdl"); });
  EXPECT_EQ(browser_.document("careful.cdl").text(), kCareful);
  const Answer refused = add("Nobody");
  EXPECT_FALSE(refused.ok());
  EXPECT_EQ(refused.error(), "there is no assemblage `Nobody` in it");
}

}  // namespace
}  // namespace mlab::designer
