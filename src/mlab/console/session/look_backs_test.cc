#include <cstdint>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "mlab/console/testing/browser.h"
#include "mlab/history/testing/written_run.h"

namespace mlab::console {
namespace {

using testing::Browser;
using testing::TestSession;

ToServer look_at(double time, double speed = 0.0) {
  ToServer out;
  out.mutable_look_back()->set_time(time);
  out.mutable_look_back()->set_speed(speed);
  return out;
}

ToServer look_at_now() {
  ToServer out;
  out.mutable_look_back()->set_now(true);
  return out;
}

bool reaches(Browser& browser, double time) {
  return browser.wait([&] { return browser.status().time() >= time; });
}

TEST(LookBacks, ShowAnotherMomentToOneWhileTheRunGoesOn) {
  TestSession session("demo_c/demo_c.mdl", 20.0);
  Browser anna(session, "Anna");
  Browser ben(session, "Ben");
  ASSERT_TRUE(anna.wait([&] { return anna.status().mode() == Status::READY; }));
  EXPECT_TRUE(anna.moment().is_now());
  EXPECT_EQ(Browser::error_of(anna.ask(look_at(1.0))), "nothing has run yet");
  ASSERT_EQ(anna.control(Control::EXECUTE), "");
  ASSERT_TRUE(reaches(anna, 12.0));

  ASSERT_EQ(Browser::error_of(anna.ask(look_at(3.0))), "");
  ASSERT_TRUE(anna.wait([&] { return !anna.moment().is_coming() && anna.moment().cycle() == 30; }));
  EXPECT_NEAR(anna.frame().time(), 3.0, 1e-6);
  EXPECT_NEAR(anna.status().time(), 3.0, 1e-6);
  EXPECT_DOUBLE_EQ(anna.status().speed(), 20.0) << "so fast the run goes on meanwhile";
  EXPECT_EQ(anna.control(Control::PAUSE), "you are looking at 0:03.0 of the run: return to now first");
  // To the other one it is the run as it goes on.
  const double before = ben.status().time();
  ASSERT_TRUE(reaches(ben, before + 5.0));
  EXPECT_TRUE(ben.moment().is_now());
  EXPECT_NEAR(anna.status().time(), 3.0, 1e-6);
  EXPECT_GT(anna.time_line().end(), 3.0);

  ToServer step;
  step.mutable_look_back()->set_cycles(-1);
  ASSERT_EQ(Browser::error_of(anna.ask(step)), "");
  ASSERT_TRUE(anna.wait([&] { return anna.frame().cycle() == 29; }));

  ASSERT_EQ(Browser::error_of(anna.ask(look_at_now())), "");
  ASSERT_TRUE(anna.wait([&] { return anna.moment().is_now() && anna.frame().time() > 12.0; }));
  EXPECT_EQ(anna.control(Control::PAUSE), "");
}

TEST(LookBacks, PlayForwardsAndBackwards) {
  TestSession session("demo_c/demo_c.mdl", 50.0);
  Browser anna(session, "Anna");
  ASSERT_TRUE(anna.wait([&] { return anna.status().mode() == Status::READY; }));
  ASSERT_EQ(anna.control(Control::EXECUTE), "");
  ASSERT_TRUE(reaches(anna, 20.0));
  ASSERT_EQ(anna.control(Control::PAUSE), "");
  ASSERT_EQ(Browser::error_of(anna.ask(look_at(10.0, -20.0))), "");
  ASSERT_TRUE(anna.wait([&] { return anna.frame().cycle() == 0 && anna.moment().speed() == 0.0; }));
  const std::uint64_t frames = anna.frame_count();
  // From where it is to begin, wherever somebody looked before.
  ASSERT_EQ(Browser::error_of(anna.ask(look_at(15.0))), "");
  ASSERT_TRUE(anna.wait([&] { return anna.frame().cycle() == 150; }));
  ASSERT_EQ(Browser::error_of(anna.ask(look_at(1.0, 10.0))), "");
  ASSERT_TRUE(anna.wait([&] { return anna.frame().time() < 5.0; }));
  ASSERT_TRUE(anna.wait([&] { return anna.frame().time() > 6.0; }));
  EXPECT_GT(anna.frame_count(), frames + 3);
  // It catches up with a run that stands.
  ASSERT_TRUE(anna.wait([&] { return anna.moment().is_now(); }));
  ASSERT_TRUE(anna.wait([&] { return anna.frame().time() >= 20.0; }));
}

TEST(LookBacks, FollowWhatSomebodyWatchesThere) {
  TestSession session("demo_c/demo_c.mdl", 50.0);
  Browser anna(session, "Anna");
  ASSERT_TRUE(anna.wait([&] { return anna.status().mode() == Status::READY; }));
  ASSERT_EQ(anna.control(Control::EXECUTE), "");
  ASSERT_TRUE(reaches(anna, 10.0));
  ASSERT_EQ(Browser::error_of(anna.ask(look_at(5.0))), "");
  ASSERT_TRUE(anna.wait([&] { return anna.frame().cycle() == 50; }));
  EXPECT_EQ(anna.frame().details_size(), 0);
  auto watch = std::make_unique<ToServer>();
  watch->mutable_watch()->add_details(2);
  watch->mutable_watch()->set_with_ports(true);
  anna.send(std::move(watch));
  ASSERT_TRUE(anna.wait([&] { return anna.frame().details_size() == 1; }));
  EXPECT_EQ(anna.frame().cycle(), 50U);
  EXPECT_GT(anna.frame().details(0).ports_size(), 0);
}

TEST(LookBacks, AnswerWhatIsAskedOfTheWholeRun) {
  TestSession session("demo_c/demo_c.mdl", 50.0);
  Browser anna(session, "Anna");
  ASSERT_TRUE(anna.wait([&] { return anna.status().mode() == Status::READY; }));
  ASSERT_EQ(anna.control(Control::EXECUTE), "");
  ASSERT_TRUE(reaches(anna, 10.0));
  ToServer read;
  Series& series = *read.mutable_read_past()->add_series();
  series.set_id(1);
  series.set_robot(1);
  series.set_quantity(Series::SPEED);
  const Reply reply = anna.ask(read);
  ASSERT_EQ(Browser::error_of(reply), "");
  EXPECT_GT(reply.past().samples(0).samples().size(), 50U * 16U);
  ToServer find;
  find.mutable_find_moments()->set_condition("any robot speed > 0.1");
  const Reply found = anna.ask(find);
  ASSERT_EQ(Browser::error_of(found), "");
  EXPECT_GT(found.found().moments_size(), 0);
  find.mutable_find_moments()->set_condition("robot one");
  const Reply wrong = anna.ask(find);
  EXPECT_NE(Browser::error_of(wrong).find("expected a robot's number"), std::string::npos);
  EXPECT_FALSE(wrong.has_found()) << "an error that comes with an answer is taken for one";
}

TEST(LookBacks, EndWithTheRunThatTheyShow) {
  TestSession session("demo_c/demo_c.mdl", 50.0);
  Browser anna(session, "Anna");
  Browser ben(session, "Ben");
  ASSERT_TRUE(anna.wait([&] { return anna.status().mode() == Status::READY; }));
  ASSERT_EQ(anna.control(Control::EXECUTE), "");
  ASSERT_TRUE(reaches(anna, 10.0));
  ASSERT_EQ(Browser::error_of(ben.ask(look_at(5.0))), "");
  ASSERT_TRUE(ben.wait([&] { return ben.frame().cycle() == 50; }));
  ASSERT_EQ(anna.control(Control::RESTART), "");
  ASSERT_TRUE(ben.wait([&] { return ben.moment().is_now() && ben.status().mode() == Status::READY; }));
}

// What robots answered there is known, though nobody could compute it again.
TEST(LookBacks, ShowMomentsOfARunInRealTime) {
  TestSession session("demo_c/demo_c.mdl", 1.0,
                      [](SessionSettings& settings) { settings.run.is_in_real_time = true; });
  Browser anna(session, "Anna");
  ASSERT_TRUE(anna.wait([&] { return anna.status().mode() == Status::READY; }));
  ASSERT_EQ(anna.control(Control::EXECUTE), "");
  std::map<std::uint64_t, std::string> lives;  // by cycle: where robots were
  ASSERT_TRUE(anna.wait([&] {
    lives[anna.frame().cycle()] = anna.frame().robots();
    return anna.frame().time() > 3.0;
  }));
  int compared = 0;
  for (const auto& [cycle, robots] : lives) {
    if (cycle < 5 || cycle > 28) continue;
    ASSERT_EQ(Browser::error_of(anna.ask(look_at(static_cast<double>(cycle) / 10.0))), "");
    ASSERT_TRUE(anna.wait([&] { return !anna.moment().is_coming() && anna.frame().cycle() == cycle; }));
    EXPECT_EQ(anna.frame().robots(), robots) << cycle;
    ++compared;
  }
  EXPECT_GT(compared, 0);
  ASSERT_EQ(Browser::error_of(anna.ask(look_at_now())), "");
  ASSERT_TRUE(anna.wait([&] { return anna.moment().is_now() && anna.frame().time() > 3.0; }));
}

// A session that has nothing but a recording.
TEST(LookBacks, ShowARecording) {
  history::testing::WrittenRun written("demo_c/demo_c.mdl", 3, true);
  written.run().post(mission::event::Execute{});
  for (int i = 0; i < 600; ++i) written.step();
  written.end();
  auto history = std::make_shared<history::History>();
  for (const wire::HistoryEntry& entry : written.entries()) ASSERT_FALSE(history->add(entry));
  TestSession session("", 50.0, [&](SessionSettings& settings) { settings.recording = {"demo", history}; });
  Browser anna(session, "Anna");
  ASSERT_TRUE(anna.wait([&] { return anna.documents().documents_size() > 0 && !anna.moment().is_coming(); }));
  EXPECT_EQ(anna.time_line().recording(), "demo");
  EXPECT_EQ(anna.time_line().last_cycle(), 600U);
  EXPECT_EQ(anna.documents().documents(0).path(), "demo_c.mdl");
  EXPECT_TRUE(anna.documents().documents(0).is_read_only());
  EXPECT_GT(anna.plan().steps_size(), 0);
  ASSERT_TRUE(anna.wait([&] { return anna.time_line().known_to() >= 59.9; }));
  ASSERT_EQ(Browser::error_of(anna.ask(look_at(45.0))), "");
  ASSERT_TRUE(anna.wait([&] { return anna.frame().cycle() == 450; }));
  EXPECT_FALSE(anna.log().empty());
  EXPECT_EQ(anna.control(Control::EXECUTE), "this is a recording: it can't be told anything");
  ASSERT_EQ(Browser::error_of(anna.ask(look_at_now())), "");
  ASSERT_TRUE(anna.wait([&] { return anna.frame().cycle() == 600; }));
}

}  // namespace
}  // namespace mlab::console
