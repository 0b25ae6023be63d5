#include "mlab/console/run/breakpoints.h"

#include <cstring>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/console/testing/browser.h"

namespace mlab::console {
namespace {

using testing::TestSession;

constexpr const char* kForage = "forage/forage.mdl";

/// One who sets breakpoints in the foragers' mission.
class Debugger {
 public:
  explicit Debugger(double speed = 0.0) : session_(kForage, speed), browser_(session_, "Anna") {
    EXPECT_TRUE(browser_.wait([&] { return browser_.status().mode() == Status::READY; }));
  }

  Reply set(const Breakpoint& wanted) {
    ToServer message;
    *message.mutable_set_breakpoint()->mutable_breakpoint() = wanted;
    return browser_.ask(std::move(message));
  }
  std::string remove(std::uint32_t id) {
    ToServer message;
    message.mutable_remove_breakpoint()->set_id(id);
    return testing::Browser::error_of(browser_.ask(std::move(message)));
  }
  static Breakpoint transition(const std::string& from, const std::string& to) {
    Breakpoint out;
    out.mutable_transition()->set_sequence("movement");
    out.mutable_transition()->set_from(from);
    out.mutable_transition()->set_to(to);
    return out;
  }
  static Breakpoint condition(const std::string& port, Breakpoint::Condition::Comparison comparison,
                              const std::string& value) {
    Breakpoint out;
    out.mutable_condition()->set_port(port);
    out.mutable_condition()->set_comparison(comparison);
    out.mutable_condition()->set_value(value);
    return out;
  }
  static Breakpoint sentence(const std::string& text) {
    Breakpoint out;
    out.set_sentence(text);
    return out;
  }
  /// The cycles in which Find finds it.
  std::vector<std::uint64_t> found(const std::string& condition) {
    ToServer message;
    message.mutable_find_moments()->set_condition(condition);
    message.mutable_find_moments()->set_from(-1.0);
    const Reply reply = browser_.ask(std::move(message));
    EXPECT_TRUE(reply.ok()) << reply.error();
    std::vector<std::uint64_t> out;
    for (const Found::One& one : reply.found().moments()) out.push_back(one.cycle());
    return out;
  }
  /// Goes on until it halts. False where it does not.
  bool runs_into_one() {
    EXPECT_EQ(browser_.control(Control::RESUME), "");
    return browser_.wait(
        [&] { return browser_.status().mode() == Status::PAUSED && browser_.halted().hits_size() > 0; },
        120.0);
  }
  /// Everything about a robot, as of now.
  RobotDetail detail(std::uint32_t robot) {
    auto watch = std::make_unique<ToServer>();
    watch->mutable_watch()->add_details(robot);
    watch->mutable_watch()->set_with_ports(true);
    browser_.send(std::move(watch));
    RobotDetail out;
    browser_.wait([&] {
      for (const RobotDetail& one : browser_.frame().details()) {
        if (one.id() != robot || one.ports().empty() || browser_.frame().cycle() < browser_.halted().cycle())
          continue;
        out = one;
        return true;
      }
      return false;
    });
    return out;
  }
  testing::Browser& browser() { return browser_; }

 private:
  TestSession session_;
  testing::Browser browser_;
};

TEST(Breakpoints, PauseAtTheEndOfTheCycleInWhichATransitionWasMade) {
  Debugger anna;
  const Reply reply = anna.set(Debugger::transition("Searching", "Acquiring"));
  ASSERT_TRUE(reply.ok()) << reply.error();
  EXPECT_EQ(reply.breakpoint(), 1U);
  ASSERT_TRUE(anna.runs_into_one());
  const Halted halted = anna.browser().halted();
  const Halted::Hit& hit = halted.hits(0);
  EXPECT_EQ(hit.breakpoint(), 1U);
  EXPECT_EQ(hit.sequence(), "movement");
  EXPECT_EQ(hit.from(), "Searching");
  EXPECT_EQ(hit.to(), "Acquiring");
  EXPECT_NE(hit.text().find("goes from Searching to Acquiring"), std::string::npos) << hit.text();
  EXPECT_TRUE(anna.browser().has_log(hit.text()));
  EXPECT_EQ(anna.browser().status().cycle(), halted.cycle());
  const RobotDetail robot = anna.detail(hit.robot());
  ASSERT_FALSE(robot.states().empty());
  EXPECT_EQ(robot.states(0), "movement.Acquiring");
}

TEST(Breakpoints, HaltTheSameRunInTheSameCycle) {
  std::vector<std::uint64_t> cycles;
  for (const double speed : {0.0, 200.0}) {
    Debugger anna(speed);
    ASSERT_TRUE(anna.set(Debugger::transition("", "Acquiring")).ok());
    ASSERT_TRUE(anna.runs_into_one());
    cycles.push_back(anna.browser().halted().cycle());
  }
  EXPECT_EQ(cycles[0], cycles[1]);
}

TEST(Breakpoints, GoOnCycleByCycleAndToTheNext) {
  Debugger anna;
  ASSERT_TRUE(anna.set(Debugger::transition("", "")).ok());
  ASSERT_TRUE(anna.runs_into_one());
  const std::uint64_t first = anna.browser().halted().cycle();
  ASSERT_EQ(anna.browser().control(Control::SINGLE_CYCLE), "");
  ASSERT_TRUE(anna.browser().wait([&] { return anna.browser().status().cycle() == first + 1; }));
  EXPECT_EQ(anna.browser().status().mode(), Status::PAUSED);
  ASSERT_TRUE(anna.runs_into_one());
  ASSERT_TRUE(anna.browser().wait([&] { return anna.browser().halted().cycle() > first; }));
  EXPECT_EQ(anna.browser().breakpoints().breakpoints(0).hits() > 1, true);
}

TEST(Breakpoints, PauseWhenATriggerBecomesTrue) {
  Debugger anna;
  std::string trigger;
  for (const Port& port : anna.browser().roster().programs(0).ports()) {
    if (port.type() == "bool" && port.role() == Port::OUTPUT &&
        port.path().find("Searching") != std::string::npos &&
        port.path().find("IsValidObject") != std::string::npos)
      trigger = port.path();
  }
  ASSERT_NE(trigger, "");
  ASSERT_TRUE(anna.set(Debugger::condition(trigger, Breakpoint::Condition::EQUAL, "true")).ok());
  ASSERT_TRUE(anna.runs_into_one());
  const Halted::Hit hit = anna.browser().halted().hits(0);
  EXPECT_EQ(hit.port(), trigger);
  EXPECT_EQ(hit.value(), "true");
  // It made the transition in the same cycle, and its node is shown as one that ran.
  const RobotDetail robot = anna.detail(hit.robot());
  EXPECT_EQ(robot.states(0), "movement.Acquiring");
}

TEST(Breakpoints, PauseWhenANumberPassesAMark) {
  Debugger anna;
  ASSERT_TRUE(
      anna.set(Debugger::condition("movement.Searching.value", Breakpoint::Condition::GREATER, "0.01")).ok());
  ASSERT_TRUE(anna.runs_into_one());
  EXPECT_EQ(anna.browser().halted().hits(0).port(), "movement.Searching.value");
}

TEST(Breakpoints, AreListedSwitchedOffAndRemoved) {
  Debugger anna(1000.0);
  ASSERT_TRUE(anna.set(Debugger::transition("Searching", "Acquiring")).ok());
  Breakpoint off = Debugger::transition("Searching", "Acquiring");
  off.set_id(1);
  off.set_is_off(true);
  ASSERT_TRUE(anna.set(off).ok());
  ASSERT_TRUE(anna.browser().wait([&] {
    return anna.browser().breakpoints().breakpoints_size() == 1 &&
           anna.browser().breakpoints().breakpoints(0).is_off();
  }));
  ASSERT_EQ(anna.browser().control(Control::EXECUTE), "");
  ASSERT_TRUE(anna.browser().wait([&] { return anna.browser().status().time() > 60.0; }));
  EXPECT_EQ(anna.browser().status().mode(), Status::RUNNING);
  EXPECT_EQ(anna.remove(7), "there is no breakpoint 7");
  EXPECT_EQ(anna.remove(1), "");
  ASSERT_TRUE(anna.browser().wait([&] { return anna.browser().breakpoints().breakpoints().empty(); }));
}

TEST(Breakpoints, ThatAreChangedBeginByNotingWhatIsTrue) {
  Debugger anna;
  const auto go_on = [&] {
    for (int i = 0; i < 4; ++i) {
      const std::uint64_t next = anna.browser().status().cycle() + 1;
      ASSERT_EQ(anna.browser().control(Control::SINGLE_CYCLE), "");
      ASSERT_TRUE(anna.browser().wait([&] { return anna.browser().status().cycle() == next; }));
    }
  };
  Breakpoint wanted = Debugger::condition("movement.Searching.value", Breakpoint::Condition::GREATER, "1e9");
  ASSERT_TRUE(anna.set(wanted).ok());
  go_on();
  wanted.set_id(1);
  wanted.mutable_condition()->set_value("-1e9");
  ASSERT_TRUE(anna.set(wanted).ok());
  go_on();
  ASSERT_EQ(anna.browser().breakpoints().breakpoints_size(), 1);
  EXPECT_EQ(anna.browser().breakpoints().breakpoints(0).hits(), 0U) << "it was so already";
}

TEST(Breakpoints, SayWhyTheyCantHappen) {
  Debugger anna;
  EXPECT_FALSE(anna.set({}).ok());
  EXPECT_FALSE(anna.set(Debugger::condition("movement", Breakpoint::Condition::LESS, "fast")).ok());
  ASSERT_TRUE(anna.set(Debugger::condition("nothing.here", Breakpoint::Condition::LESS, "1")).ok());
  ASSERT_TRUE(anna.set(Debugger::transition("Searching", "Flying")).ok());
  ASSERT_TRUE(anna.set(Debugger::sentence("any robot in state Flying")).ok());
  ASSERT_TRUE(anna.browser().wait([&] { return anna.browser().breakpoints().breakpoints_size() == 3; }));
  for (const Breakpoint& one : anna.browser().breakpoints().breakpoints()) EXPECT_NE(one.error(), "");
}

TEST(Breakpoints, TakeTheSentencesThatMomentsAreFoundBy) {
  for (const char* text : {"any robot distance-driven > 3", "any robot farther than 2 m from its goal",
                           "any robot nearer than 4 m to an obstacle", "any robot in state Acquiring",
                           "any robot movement goes from Searching to Acquiring"}) {
    Debugger anna;
    const Reply reply = anna.set(Debugger::sentence(text));
    ASSERT_TRUE(reply.ok()) << reply.error();
    ASSERT_TRUE(anna.runs_into_one()) << text;
    const Halted halted = anna.browser().halted();
    EXPECT_GT(halted.hits(0).robot(), 0U);
    EXPECT_TRUE(anna.browser().has_log(halted.hits(0).text())) << halted.hits(0).text();
    EXPECT_EQ(anna.browser().status().cycle(), halted.cycle());
    EXPECT_EQ(anna.found(text), std::vector{halted.cycle()}) << text;
    ASSERT_EQ(anna.browser().breakpoints().breakpoints_size(), 1);
    EXPECT_EQ(anna.browser().breakpoints().breakpoints(0).sentence(), text);
    EXPECT_EQ(anna.browser().breakpoints().breakpoints(0).error(), "");
  }
}

TEST(Breakpoints, InWordsHaltAtWhatBecomesSoAndNotAtWhatIsSo) {
  Debugger anna;
  ASSERT_TRUE(anna.set(Debugger::sentence("robot 1 distance-driven > 2")).ok());
  ASSERT_TRUE(anna.runs_into_one());
  const std::uint64_t first = anna.browser().halted().cycle();
  ASSERT_TRUE(anna.set(Debugger::sentence("robot 1 distance-driven > 1")).ok());
  ASSERT_TRUE(anna.set(Debugger::sentence("robot 1 distance-driven > 3")).ok());
  ASSERT_TRUE(anna.runs_into_one());
  ASSERT_TRUE(anna.browser().wait([&] { return anna.browser().halted().cycle() > first; }));
  ASSERT_EQ(anna.browser().halted().hits_size(), 1);
  EXPECT_EQ(anna.browser().halted().hits(0).breakpoint(), 3U);
  ASSERT_EQ(anna.browser().breakpoints().breakpoints_size(), 3);
  EXPECT_EQ(anna.browser().breakpoints().breakpoints(1).hits(), 0U) << "it was so already";
}

TEST(Breakpoints, InWordsSayWhatIsNotUnderstoodAndWhatCantHappen) {
  Debugger anna;
  const auto refused = [&](const Breakpoint& wanted) { return testing::Browser::error_of(anna.set(wanted)); };
  EXPECT_NE(refused(Debugger::sentence("robot three in contact")).find("but saw `three`"), std::string::npos);
  EXPECT_NE(refused(Debugger::sentence("")).find("the end of the condition"), std::string::npos);
  EXPECT_NE(refused(Debugger::sentence(std::string(1001, 'x'))).find("at most 1000"), std::string::npos);
  Breakpoint both = Debugger::sentence("any robot in contact");
  both.add_robots(2);
  EXPECT_EQ(refused(both), "a sentence names its robots itself");
  const std::map<std::string, std::string> expected = {
      {"robot 99 in contact", "there is no robot 99"},
      {"any robot nearer than 2 m to PP-Nowhere", "the map has no place `PP-Nowhere`"},
      {"robot 1 movement goes to Flying", "no program of this run has such a transition of `movement`"}};
  for (const auto& [text, why] : expected) ASSERT_TRUE(anna.set(Debugger::sentence(text)).ok());
  ASSERT_TRUE(anna.browser().wait([&] { return anna.browser().breakpoints().breakpoints_size() == 3; }));
  for (const Breakpoint& one : anna.browser().breakpoints().breakpoints())
    EXPECT_EQ(one.error(), expected.at(one.sentence()));
}

TEST(Breakpoints, OfAnEarlierSessionAreThereWithTheirNumbersAndWhatTheyMean) {
  Breakpoint words = Debugger::sentence("any robot in contact");
  words.set_id(7);
  Breakpoint damaged = Debugger::sentence("any robot in");
  damaged.set_id(8);
  BreakpointTable table;
  table.recall({words, damaged});
  Breakpoints told;
  table.encode(told);
  ASSERT_EQ(told.breakpoints_size(), 1);
  EXPECT_EQ(told.breakpoints(0).sentence(), "any robot in contact");
  EXPECT_TRUE(table.are_on());
  std::string error;
  EXPECT_EQ(table.set(Debugger::transition("", ""), error), 8U);
}

TEST(RobotDetail, TellsTransitionsActivityAndVectorsOfWhatIsDrawn) {
  Debugger anna;
  anna.detail(1);  // is watched from here on
  ASSERT_TRUE(anna.set(Debugger::transition("Searching", "Acquiring")).ok());
  Breakpoint of_one = Debugger::transition("Searching", "Acquiring");
  of_one.set_id(1);
  of_one.add_robots(1);
  ASSERT_TRUE(anna.set(of_one).ok());
  ASSERT_TRUE(anna.runs_into_one());
  const RobotDetail robot = anna.detail(1);
  ASSERT_EQ(robot.transitions_size(), 1);
  EXPECT_EQ(robot.transitions(0).sequence(), "movement");
  EXPECT_EQ(robot.transitions(0).from(), "Searching");
  EXPECT_EQ(robot.transitions(0).to(), "Acquiring");
  EXPECT_EQ(robot.transitions(0).index(), 0U);
  EXPECT_EQ(robot.transitions(0).cycle(), anna.browser().halted().cycle());
  const auto& ports = anna.browser().roster().programs(0).ports();
  ASSERT_EQ(robot.active().size(), static_cast<std::size_t>(ports.size()));
  std::map<std::string, bool> ran;
  for (int i = 0; i < ports.size(); ++i)
    ran[ports[i].path()] = robot.active()[static_cast<std::size_t>(i)] == '\1';
  EXPECT_TRUE(ran.at("movement"));
  EXPECT_FALSE(ran.at("movement.Searching.value")) << "the state was left in this cycle";
  EXPECT_TRUE(ran.at("movement.Acquiring"));
  struct Arrow {
    std::uint32_t port;
    float x, y;
  };
  bool has_movement = false;
  for (std::size_t at = 0; at + sizeof(Arrow) <= robot.vectors().size(); at += sizeof(Arrow)) {
    Arrow arrow{};
    std::memcpy(&arrow, robot.vectors().data() + at, sizeof arrow);
    ASSERT_LT(arrow.port, static_cast<std::uint32_t>(ports.size()));
    EXPECT_EQ(ports[static_cast<int>(arrow.port)].type(), "Vector");
    has_movement = has_movement || ports[static_cast<int>(arrow.port)].path() == "movement";
  }
  EXPECT_TRUE(has_movement);
}

}  // namespace
}  // namespace mlab::console
