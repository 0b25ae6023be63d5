#include "mlab/designer/trial/marks.h"

#include <functional>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/designer/testing/live_desk.h"

namespace mlab::designer {
namespace {

using testing::LiveDesk;

constexpr const char* kTurns = R"(assemblage Inner() {
  sequence {
    start Waiting: Stand();
      when Wait(delay = 1 s) and not IsHalted() goto Moving;
    Moving: cooperate {
      1: Noise(persistence = 2 s);
      0.5: Noise(persistence = 9 s);
    };
      when not Wait(delay = 1 s) goto Waiting;
  }
}

assemblage Outer() {
  sequence {
    start Resting: Stand();
      when Wait(delay = 1 s) goto Acting;
    Acting: Inner();
      when Wait(delay = 9 s) goto Resting;
  }
}
)";

class MarkTest : public ::testing::Test {
 protected:
  void SetUp() override {
    desk_.folder().write("project/one.cdl", kTurns);
    path_ = desk_.open("one.cdl");
    const Answer tried = desk_.try_out(path_, "Outer");
    ASSERT_TRUE(tried.ok()) << tried.error();
  }
  std::uint32_t set(const Mark& mark) {
    const Answer answer = desk_.ask([&](ToDesigner& m) {
      m.mutable_set_mark()->set_document(path_);
      *m.mutable_set_mark()->mutable_mark() = mark;
    });
    EXPECT_TRUE(answer.ok()) << answer.error();
    return answer.ok() ? static_cast<std::uint32_t>(std::stoul(answer.text())) : 0;
  }
  std::uint32_t set_transition(const std::string& from, const std::string& to) {
    Mark mark;
    mark.set_page("Inner");
    mark.set_place("movement.Acting");
    mark.set_from(from);
    mark.set_to(to);
    mark.mutable_breakpoint()->set_id(7);
    mark.mutable_breakpoint()->mutable_transition()->set_sequence("movement.Acting");
    mark.mutable_breakpoint()->mutable_transition()->set_from(from);
    mark.mutable_breakpoint()->mutable_transition()->set_to(to);
    return set(mark);
  }
  void edit(const std::function<void(Change&)>& fill) {
    const Answer answer = desk_.ask([&](ToDesigner& m) {
      m.mutable_edit()->set_document(path_);
      m.mutable_edit()->set_revision(desk_.document(path_).revision());
      fill(*m.mutable_edit()->add_changes());
    });
    EXPECT_TRUE(answer.ok()) << answer.error();
  }
  void rename(const std::string& page, const std::string& node, const std::string& name) {
    edit([&](Change& change) {
      change.mutable_rename()->set_page(page);
      change.mutable_rename()->set_node(node);
      change.mutable_rename()->set_name(name);
    });
  }
  /// By typing: the whole text is another one.
  void type(const std::string& word, const std::string& by) {
    std::string text = desk_.document(path_).text();
    for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos; at += by.size())
      text.replace(at, word.size(), by);
    desk_.type(path_, text);
  }
  Mark mark(std::uint32_t id) {
    const MarkList all = desk_.marks(path_);
    for (const Mark& one : all.marks()) {
      if (one.id() == id) return one;
    }
    ADD_FAILURE() << "no mark " << id;
    return {};
  }

  LiveDesk desk_;
  std::string path_;
};

std::string shown(const Mark& mark) {
  const console::Breakpoint::Transition& t = mark.breakpoint().transition();
  return t.sequence() + " " + t.from() + " " + t.to() + " " + mark.page() + " " + mark.drawn() +
         (mark.is_lost() ? " lost" : "");
}

TEST_F(MarkTest, OnATransitionFollowsItsStatesHoweverTheyAreRenamed) {
  const std::uint32_t id = set_transition("Waiting", "Moving");
  rename("Inner", "Waiting", "Idling");
  EXPECT_EQ(shown(mark(id)), "movement.Acting Idling Moving Inner Idling/0");
  type("Moving", "Driving");
  EXPECT_EQ(shown(mark(id)), "movement.Acting Idling Driving Inner Idling/0");
  rename("", "Inner", "Within");
  EXPECT_EQ(shown(mark(id)), "movement.Acting Idling Driving Within Idling/0");
}

TEST_F(MarkTest, FollowsThePlaceInWhichItsPageRuns) {
  const std::uint32_t id = set_transition("Waiting", "");
  rename("Outer", "Acting", "Going");
  EXPECT_EQ(shown(mark(id)), "movement.Going Waiting  Inner Waiting");
  type("Going", "Doing");
  EXPECT_EQ(shown(mark(id)), "movement.Doing Waiting  Inner Waiting");
}

TEST_F(MarkTest, IsLostWithItsTransitionAndComesBackWithIt) {
  const std::uint32_t id = set_transition("Moving", "Waiting");
  edit([](Change& change) {
    change.mutable_remove_transition()->set_page("Inner");
    change.mutable_remove_transition()->set_from("Moving");
  });
  EXPECT_TRUE(mark(id).is_lost());
  desk_.ask([&](ToDesigner& m) { m.mutable_undo()->set_document(path_); });
  EXPECT_EQ(shown(mark(id)), "movement.Acting Moving Waiting Inner Moving/0");
}

TEST_F(MarkTest, OnAValueFollowsTheNodeThatGivesIt) {
  Mark probe;
  probe.set_page("Inner.Moving");
  probe.set_place("movement.Acting.Moving");
  const Drawing drawing = desk_.drawing(path_, "Inner.Moving");
  std::string second;
  for (const Node& node : drawing.nodes()) {
    if (node.name().find("Noise") != std::string::npos) second = node.name();
  }
  probe.set_node(second);
  probe.set_port("movement.Acting.Moving." + second);
  const std::uint32_t id = set(probe);
  rename("Inner.Moving", second, "wobble");
  EXPECT_EQ(mark(id).node(), "wobble");
  EXPECT_EQ(mark(id).port(), "movement.Acting.Moving.wobble");
  rename("Inner", "Moving", "Driving");
  EXPECT_EQ(mark(id).page(), "Inner.Driving");
  EXPECT_EQ(mark(id).port(), "movement.Acting.Driving.wobble");
  edit([](Change& change) {
    change.mutable_remove()->set_page("Inner.Driving");
    change.mutable_remove()->add_nodes("wobble");
  });
  EXPECT_TRUE(mark(id).is_lost());
}

TEST_F(MarkTest, OnAConditionOfATriggerStopsTheRunAndFollowsItsState) {
  const Drawing drawing = desk_.drawing(path_, "Inner");
  std::vector<std::string> told;
  for (const Transition& transition : drawing.transitions()) {
    for (const Transition::Condition& one : transition.conditions())
      told.push_back(one.text() + " = " + one.live() + (one.is_negated() ? " not" : ""));
  }
  ASSERT_TRUE(desk_.browser().wait([&] { return desk_.browser().roster().programs_size() == 1; }));
  std::set<std::string> ports;
  for (const console::Port& port : desk_.browser().roster().programs(0).ports()) ports.insert(port.path());
  int with_port = 0;
  for (const std::string& one : told) {
    const std::string live = one.substr(one.rfind(" = ") + 3);
    with_port += ports.contains("movement.Acting." + live.substr(0, live.find(' '))) ? 1 : 0;
  }
  EXPECT_GE(told.size(), 4U);
  EXPECT_EQ(with_port, static_cast<int>(told.size())) << ::testing::PrintToString(told);

  const std::string live = drawing.transitions(0).conditions(0).live();
  Mark mark_of;
  mark_of.set_page("Inner");
  mark_of.set_place("movement.Acting");
  mark_of.set_from("Waiting");
  mark_of.set_to("Moving");
  mark_of.set_trigger(live);
  mark_of.mutable_breakpoint()->mutable_condition()->set_port("movement.Acting." + live);
  mark_of.mutable_breakpoint()->mutable_condition()->set_value("true");
  const std::uint32_t id = set(mark_of);
  console::ToServer stop;
  *stop.mutable_set_breakpoint()->mutable_breakpoint() = mark_of.breakpoint();
  const console::Reply reply = desk_.browser().ask(stop);
  ASSERT_TRUE(reply.ok()) << reply.error();
  EXPECT_TRUE(desk_.browser().wait([&] { return desk_.browser().halted().hits_size() > 0; }, 60.0));
  EXPECT_EQ(desk_.browser().halted().hits(0).port(), "movement.Acting." + live);
  rename("Inner", "Waiting", "Idling");
  EXPECT_EQ(mark(id).breakpoint().condition().port(), "movement.Acting.Idling" + live.substr(live.find('.')));
  EXPECT_EQ(mark(id).drawn(), "Idling/0");
}

TEST_F(MarkTest, GoesWithItsPageToWhereThatRunsNow) {
  const std::uint32_t on_transition = set_transition("Waiting", "Moving");
  Mark probe;
  probe.set_page("Inner.Moving");
  probe.set_place("movement.Acting.Moving");
  probe.set_node("cooperate");
  probe.set_port("movement.Acting.Moving");
  const std::uint32_t on_node = set(probe);
  ASSERT_TRUE(desk_.try_out(path_, "Inner").ok());
  EXPECT_EQ(shown(mark(on_transition)), "movement Waiting Moving Inner ");
  EXPECT_EQ(mark(on_node).port(), "movement.Moving");
  rename("Inner", "Waiting", "Idling");
  EXPECT_EQ(shown(mark(on_transition)), "movement Idling Moving Inner Idling/0");
  ASSERT_TRUE(desk_.try_out(path_, "Outer").ok());
  EXPECT_EQ(shown(mark(on_transition)), "movement.Acting Idling Moving Inner Idling/0");
  EXPECT_EQ(mark(on_node).port(), "movement.Acting.Moving");
  rename("Outer", "Acting", "Going");
  EXPECT_EQ(mark(on_node).port(), "movement.Going.Moving");
}

TEST_F(MarkTest, SurvivesTheEndOfEveryWindow) {
  const std::uint32_t id = set_transition("Waiting", "Moving");
  desk_.ask([&](ToDesigner& m) { m.mutable_close()->set_document(path_); });
  desk_.open(path_);
  EXPECT_EQ(mark(id).from(), "Waiting");
  desk_.ask([&](ToDesigner& m) {
    m.mutable_remove_mark()->set_document(path_);
    m.mutable_remove_mark()->set_id(id);
  });
  EXPECT_EQ(desk_.marks(path_).marks_size(), 0);
}

TEST_F(MarkTest, SetBeforeAnythingRanFollowsNamesOnceItDoes) {
  desk_.folder().write("project/two.cdl", kTurns);
  path_ = desk_.open("two.cdl");
  const std::uint32_t id = set_transition("Waiting", "Moving");
  ASSERT_TRUE(desk_.try_out(path_, "Outer").ok());
  rename("Outer", "Acting", "Doing");
  EXPECT_EQ(shown(mark(id)), "movement.Doing Waiting Moving Inner Waiting/0");
}

TEST_F(MarkTest, ThatCannotBeIsRefused) {
  Mark mark;
  mark.set_page("Nobody");
  const Answer answer = desk_.ask([&](ToDesigner& m) {
    m.mutable_set_mark()->set_document(path_);
    *m.mutable_set_mark()->mutable_mark() = mark;
  });
  EXPECT_FALSE(answer.ok());
}

}  // namespace
}  // namespace mlab::designer
