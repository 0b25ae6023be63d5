#include "mlab/console/session.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <thread>

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>
#include <gtest/gtest.h>

#include "mlab/console/published/frame_encoder.h"
#include "mlab/console/testing/browser.h"
#include "mlab/run/stop_line.h"

namespace mlab::console {
namespace {

using testing::Browser;
using testing::TestSession;

constexpr const char* kDemo = "demo_c/demo_c.mdl";

bool wait_for(Browser& browser, Status::Mode mode) {
  return browser.wait([&] { return browser.status().mode() == mode; });
}

RobotRows::Row row_in(const std::string& rows, std::uint32_t id) {
  RobotRows::Row row{};
  for (std::size_t i = 0; i + sizeof row <= rows.size(); i += sizeof row) {
    std::memcpy(&row, rows.data() + i, sizeof row);
    if (row.id == id) return row;
  }
  return {};
}

RobotRows::Row robot_in(const Frame& frame, std::uint32_t id) {
  return row_in(frame.robots(), id);
}

double distance(const RobotRows::Row& a, const RobotRows::Row& b) {
  return std::hypot(static_cast<double>(a.x) - b.x, static_cast<double>(a.y) - b.y);
}

// Runs on with every question answered by yes.
bool carry_out(Browser& browser, int* answered = nullptr) {
  return browser.wait([&] {
    if (browser.questions().questions_size() > 0) {
      browser.answer(browser.questions().questions(0).id(), true);
      browser.forget_questions();
      if (answered != nullptr) ++*answered;
    }
    return browser.status().mode() == Status::ENDED;
  });
}

// What of a report does not depend on the machine.
std::string run_of_report(const std::string& report) {
  return report.substr(0, report.find("\"performance\""));
}

TEST(Session, SaysWhoAndWhatThereIsAfterHello) {
  TestSession session(kDemo);
  Browser anna(session, "Anna");
  ASSERT_TRUE(wait_for(anna, Status::READY));
  EXPECT_EQ(anna.welcome().client(), 1U);
  EXPECT_EQ(anna.plan().steps_size(), 12);
  EXPECT_EQ(anna.roster().robots_size(), 4);
  EXPECT_EQ(anna.roster().units_size(), 3);
  EXPECT_FALSE(anna.scene().measures().empty());
  EXPECT_EQ(anna.documents().documents_size(), 2);
  EXPECT_EQ(anna.plan().steps(0).document(), anna.documents().documents(0).path());
  EXPECT_TRUE(anna.wait([&] { return anna.clients().operator_() == 1U; }));
  EXPECT_EQ(anna.project().mission(), "examples:demo_c/demo_c.mdl");
}

TEST(Session, ShowsWhereRobotsWillStartUntilTheyDo) {
  TestSession session(kDemo, 1.0);
  Browser anna(session, "Anna");
  ASSERT_TRUE(wait_for(anna, Status::READY));
  ASSERT_EQ(anna.starts().robots().size(), 4 * sizeof(RobotRows::Row));
  const Starts planned = anna.starts();
  ASSERT_EQ(anna.control(Control::SINGLE_CYCLE), "");
  ASSERT_TRUE(anna.wait([&] { return anna.frame().robots().size() == planned.robots().size(); }));
  EXPECT_TRUE(anna.starts().robots().empty()) << "told before the robots stand there";
  for (std::uint32_t id = 1; id <= 4; ++id)
    EXPECT_LT(distance(row_in(planned.robots(), id), robot_in(anna.frame(), id)), 1.0);
  ASSERT_EQ(anna.control(Control::RESTART), "");
  EXPECT_TRUE(anna.wait([&] { return anna.starts().robots() == planned.robots(); }));
}

TEST(Session, AnswersAConnectionThatDoesNotBeginWithHello) {
  TestSession session("");
  const ConnectionId stranger = session.connect();
  auto message = std::make_unique<ToServer>();
  message->set_request(5);
  message->mutable_control()->set_action(Control::EXECUTE);
  session->receive(stranger, std::move(message));
  const auto bytes = session.next(stranger, std::chrono::seconds(20));
  ASSERT_NE(bytes, nullptr);
  ToBrowser answer;
  ASSERT_TRUE(answer.ParseFromString(*bytes));
  EXPECT_EQ(answer.reply().request(), 5U);
  EXPECT_FALSE(answer.reply().ok());
}

TEST(Session, StartsEmpty) {
  TestSession session("");
  Browser anna(session, "Anna");
  ASSERT_TRUE(anna.wait([&] { return anna.clients().operator_() == 1; }));
  EXPECT_EQ(anna.status().mode(), Status::NO_MISSION);
  EXPECT_NE(anna.control(Control::EXECUTE), "");
  EXPECT_EQ(session->report(), "");
}

TEST(Session, CarriesDemoCOutFromExecuteThroughAllQuestionsToTheEnd) {
  TestSession session(kDemo, 0.0);
  Browser anna(session, "Anna");
  ASSERT_TRUE(wait_for(anna, Status::READY));
  EXPECT_EQ(anna.control(Control::EXECUTE), "");
  int answered = 0;
  ASSERT_TRUE(carry_out(anna, &answered));
  EXPECT_EQ(anna.status().outcome(), Status::DONE);
  EXPECT_EQ(answered, 5);
  EXPECT_EQ(anna.status().steps_size(), 12);
  EXPECT_TRUE(session->has_ended());
  EXPECT_NE(session->report().find("\"outcome\": \"done\""), std::string::npos);
  EXPECT_TRUE(anna.wait([&] { return anna.has_log("mission done") && anna.frame_count() > 0; }));
}

TEST(Session, ARestartIsTheSameRunBitForBitWithAndWithoutPeopleWhoLook) {
  std::string report;
  {
    TestSession session(kDemo, 0.0, [](SessionSettings& s) { s.run.executive.proceed_all = true; });
    Browser anna(session, "Anna");
    ASSERT_TRUE(wait_for(anna, Status::READY));
    Browser ben(session, "Ben");  // looks at everything
    ToServer watch;
    watch.mutable_watch()->set_rate(60);
    watch.mutable_watch()->add_details(2);
    watch.mutable_watch()->set_with_ports(true);
    watch.mutable_watch()->set_with_readings(true);
    watch.mutable_watch()->set_with_stations(true);
    watch.mutable_watch()->set_with_vectors(true);
    watch.mutable_watch()->add_series()->set_robot(1);
    ben.ask(watch);
    ASSERT_EQ(anna.control(Control::EXECUTE), "");
    ASSERT_TRUE(carry_out(anna));
    report = run_of_report(session->report());
    ben.watch_for(0.1);
    ASSERT_EQ(anna.control(Control::RESTART), "");
    ASSERT_TRUE(wait_for(anna, Status::READY));
    ASSERT_EQ(anna.control(Control::EXECUTE), "");
    ASSERT_TRUE(carry_out(anna));
    EXPECT_EQ(run_of_report(session->report()), report);
  }
  {
    TestSession alone(kDemo, 1000.0, [](SessionSettings& s) { s.run.executive.proceed_all = true; });
    {
      Browser anna(alone, "Anna");
      ASSERT_TRUE(wait_for(anna, Status::READY));
      ASSERT_EQ(anna.control(Control::EXECUTE), "");
    }
    for (int i = 0; i < 600 && !alone->has_ended(); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    EXPECT_EQ(run_of_report(alone->report()), report) << "at another speed, with nobody there";
  }
}

TEST(Session, ARestartWithAnotherSeedIsAnotherRun) {
  TestSession session(kDemo, 0.0, [](SessionSettings& s) { s.run.executive.proceed_all = true; });
  Browser anna(session, "Anna");
  ASSERT_TRUE(wait_for(anna, Status::READY));
  ASSERT_EQ(anna.control(Control::EXECUTE), "");
  ASSERT_TRUE(carry_out(anna));
  const std::string report = run_of_report(session->report());
  ToServer restart;
  restart.mutable_control()->set_action(Control::RESTART);
  restart.mutable_control()->set_seed(4711);
  ASSERT_TRUE(anna.ask(restart).ok());
  ASSERT_TRUE(
      anna.wait([&] { return anna.status().seed() == 4711 && anna.status().mode() == Status::READY; }));
  ASSERT_EQ(anna.control(Control::EXECUTE), "");
  ASSERT_TRUE(carry_out(anna));
  EXPECT_NE(run_of_report(session->report()), report);
}

TEST(Session, TheEmergencyStopHoldsAllRobotsUntilItIsReleased) {
  TestSession session(kDemo, 10.0);
  Browser anna(session, "Anna");
  ASSERT_TRUE(wait_for(anna, Status::READY));
  Browser ben(session, "Ben");
  ASSERT_EQ(anna.control(Control::EXECUTE), "");
  const auto start = [&] { return robot_in(anna.frame(), 1); };
  ASSERT_TRUE(anna.wait([&] { return anna.status().time() > 5.0 && start().id == 1; }));
  ToServer stop;
  stop.mutable_emergency_stop();
  EXPECT_TRUE(ben.ask(stop).ok()) << "it is for everybody";
  ASSERT_TRUE(wait_for(anna, Status::STOPPED));
  anna.watch_for(0.2);
  const RobotRows::Row stands = start();
  EXPECT_NE(anna.control(Control::EXECUTE), "");
  EXPECT_NE(anna.type("UNIT scouts MOVETO 10 10"), "");
  anna.watch_for(0.3);
  EXPECT_EQ(distance(start(), stands), 0.0);
  EXPECT_EQ(anna.control(Control::RELEASE_STOP), "");
  ASSERT_TRUE(wait_for(anna, Status::PAUSED));
  anna.watch_for(0.2);
  EXPECT_EQ(distance(start(), stands), 0.0) << "it is paused then";
  EXPECT_EQ(anna.control(Control::RESUME), "");
  EXPECT_TRUE(anna.wait([&] { return distance(start(), stands) > 1.0; }));
}

TEST(Session, TheEmergencyStopIsConfirmedRobotByRobotOnceTheyStand) {
  TestSession session(kDemo, 10.0);
  Browser anna(session, "Anna");
  ASSERT_TRUE(wait_for(anna, Status::READY));
  ASSERT_EQ(anna.control(Control::EXECUTE), "");
  ASSERT_TRUE(anna.wait([&] { return anna.status().time() > 5.0; }));
  EXPECT_FALSE(anna.status().has_stop());
  session->emergency_stop();
  ASSERT_TRUE(anna.wait([&] {
    return anna.status().has_stop() && anna.status().stop().standing() == anna.status().stop().robots();
  }));
  EXPECT_EQ(anna.status().mode(), Status::STOPPED);
  EXPECT_EQ(anna.status().stop().robots(), 4U);
  EXPECT_EQ(anna.control(Control::RELEASE_STOP), "");
  ASSERT_TRUE(anna.wait([&] { return !anna.status().has_stop(); }));
}

/// A stop that two consoles share, and a machine that has not confirmed it.
class SharedStop final : public run::StopLine {
 public:
  State state() const override {
    const std::scoped_lock lock(mutex_);
    return state_;
  }
  void engage() override { change({true, "here"}); }
  void release() override { change({false, "here"}); }
  std::vector<Unreached> unreached() const override {
    return {{.name = "south"}, {.name = "west", .by = "agent north", .silent = 7.0}};
  }
  std::vector<std::string> take_alerts() override {
    return std::exchange(has_alert_, false) ? std::vector<std::string>{"somebody was withdrawn"}
                                            : std::vector<std::string>{};
  }
  void tell(std::function<void()> changed) override {
    const std::scoped_lock lock(mutex_);
    changed_ = std::move(changed);
  }
  void change(State state) {
    const std::scoped_lock lock(mutex_);
    state_ = std::move(state);
    if (changed_) changed_();
  }

 private:
  mutable std::mutex mutex_;
  State state_;
  std::function<void()> changed_;
  bool has_alert_ = true;
};

TEST(Session, AnEmergencyStopThatOthersShareIsFollowedAndSaid) {
  const auto line = std::make_shared<SharedStop>();
  TestSession session(kDemo, 10.0, [&](SessionSettings& s) { s.run.stop_line = line; });
  Browser anna(session, "Anna");
  ASSERT_TRUE(wait_for(anna, Status::READY));
  ASSERT_EQ(anna.control(Control::EXECUTE), "");
  ASSERT_TRUE(anna.wait([&] { return anna.status().time() > 1.0; }));
  line->change({true, "the other console"});
  ASSERT_TRUE(wait_for(anna, Status::STOPPED));
  ASSERT_EQ(anna.status().stop().unreached_size(), 2);
  EXPECT_EQ(anna.status().stop().unreached(0), "south");
  EXPECT_EQ(anna.status().stop().unreached(1), "west (known by agent north)");
  EXPECT_TRUE(anna.wait([&] {
    return std::ranges::any_of(anna.log(), [](const Log::Entry& entry) {
      return entry.is_alert() && entry.text() == "somebody was withdrawn";
    });
  }));
  line->change({false, "the other console"});
  ASSERT_TRUE(wait_for(anna, Status::PAUSED)) << "it does not go on by itself";
  session->emergency_stop();
  EXPECT_TRUE(line->state().is_engaged) << "the session's thread need not look at it";
  ASSERT_TRUE(wait_for(anna, Status::STOPPED));
  EXPECT_EQ(anna.control(Control::RELEASE_STOP), "");
  EXPECT_FALSE(line->state().is_engaged);
  ASSERT_TRUE(wait_for(anna, Status::PAUSED));
}

TEST(Session, AfterAnAbortAJumpIsRefusedAndWithARewindTrailsAndAlertsOfBeforeGo) {
  TestSession session(kDemo, 10.0);
  Browser anna(session, "Anna");
  ASSERT_TRUE(wait_for(anna, Status::READY));
  ASSERT_EQ(anna.control(Control::EXECUTE), "");
  ASSERT_TRUE(anna.wait([&] { return anna.status().time() > 5.0; }));
  ASSERT_EQ(anna.control(Control::ABORT), "");
  ASSERT_TRUE(wait_for(anna, Status::ENDED));
  Browser before(session, "Ben");
  ASSERT_TRUE(before.wait([&] { return before.trails().trails_size() > 0; }));
  EXPECT_NE(anna.control(Control::JUMP, 1), "") << "its robots are stopped";
  ASSERT_EQ(anna.control(Control::REWIND), "");
  ASSERT_TRUE(anna.wait([&] { return anna.alerts_after() > 1; }));
  ASSERT_TRUE(before.wait([&] { return before.trails().trails_size() == 0; }));
  ASSERT_EQ(anna.control(Control::EXECUTE), "");
  ASSERT_TRUE(wait_for(anna, Status::RUNNING));
}

TEST(Session, BeatsComeUnaskedAndEachOneThatIsSentIsAnsweredWithItsNumber) {
  TestSession session("", 10.0);
  Browser anna(session, "Anna");
  ASSERT_TRUE(anna.wait([&] { return anna.beat_count() > 2; })) << "nothing runs, and nothing is asked";
  auto message = std::make_unique<ToServer>();
  message->mutable_beat()->set_number(77);
  anna.send(std::move(message));
  ASSERT_TRUE(anna.wait([&] { return anna.beat() == 77; }));
  const std::uint64_t count = anna.beat_count();
  EXPECT_TRUE(anna.wait([&] { return anna.beat_count() > count + 2; }));
  EXPECT_EQ(anna.beat(), 77U) << "who sends no more is told the last";
}

TEST(Session, APageThatFallsSilentLosesItsStickAndNothingElse) {
  TestSession session(kDemo, 10.0);
  Browser anna(session, "Anna");
  ASSERT_TRUE(wait_for(anna, Status::READY));
  ASSERT_EQ(anna.control(Control::EXECUTE), "");
  ASSERT_TRUE(anna.wait([&] { return anna.status().time() > 2.0; }));
  ToServer start;
  start.mutable_start_teleoperation()->set_robot(1);
  ASSERT_EQ(Browser::error_of(anna.ask(start)), "");
  ASSERT_TRUE(anna.wait([&] { return anna.status().teleoperations_size() == 1; }));
  Browser ben(session, "Ben");
  ToServer stick;
  stick.mutable_stick()->set_unit("robot 1");
  stick.mutable_stick()->set_y(1.0);
  const auto row = [&] { return robot_in(ben.frame(), 1); };
  ASSERT_TRUE(ben.wait([&] { return row().id == 1; }));
  const RobotRows::Row before = row();
  anna.send(std::make_unique<ToServer>(stick));
  ASSERT_TRUE(ben.wait([&] { return distance(row(), before) > 0.1; }));
  // No beat and no stick from here on. It comes to rest, and all else is as it was.
  RobotRows::Row last = row();
  ASSERT_TRUE(ben.wait([&] {
    ben.watch_for(0.3);
    const RobotRows::Row now = row();
    return distance(now, std::exchange(last, now)) == 0.0;
  }));
  EXPECT_EQ(ben.clients().operator_(), anna.welcome().client());
  EXPECT_EQ(ben.status().teleoperations_size(), 1);
  EXPECT_EQ(anna.control(Control::PAUSE), "") << "it goes on where it was";
}

TEST(Session, TheEmergencyStopOutlivesARestart) {
  TestSession session(kDemo, 10.0);
  Browser anna(session, "Anna");
  ASSERT_TRUE(wait_for(anna, Status::READY));
  session->emergency_stop();
  ASSERT_TRUE(wait_for(anna, Status::STOPPED));
  ASSERT_EQ(anna.control(Control::RESTART), "");
  anna.watch_for(0.3);
  EXPECT_EQ(anna.status().mode(), Status::STOPPED);
  EXPECT_NE(anna.control(Control::EXECUTE), "");
  EXPECT_EQ(anna.control(Control::RELEASE_STOP), "");
  EXPECT_EQ(anna.control(Control::EXECUTE), "");
}

TEST(Session, TeleoperationMovesARobotWhileTheStickIsHeldAndEndsByMessage) {
  TestSession session(kDemo, 10.0);
  Browser anna(session, "Anna");
  ASSERT_TRUE(wait_for(anna, Status::READY));
  ToServer start;
  start.mutable_start_teleoperation()->set_robot(3);
  EXPECT_FALSE(anna.ask(start).ok()) << "it has not been started";
  ASSERT_EQ(anna.control(Control::EXECUTE), "");
  ASSERT_TRUE(anna.wait([&] { return anna.status().time() > 2.0; }));
  ASSERT_EQ(Browser::error_of(anna.ask(start)), "");
  ToServer other;
  other.mutable_start_teleoperation()->set_robot(1);
  ASSERT_EQ(Browser::error_of(anna.ask(other)), "") << "several at once";
  ASSERT_TRUE(anna.wait([&] { return anna.status().teleoperations_size() == 2; }));
  ToServer end_other;
  end_other.mutable_end_teleoperation()->set_unit("robot 1");
  ASSERT_EQ(Browser::error_of(anna.ask(end_other)), "");
  ASSERT_TRUE(anna.wait([&] { return anna.status().teleoperations_size() == 1; }));
  EXPECT_EQ(anna.status().teleoperations(0).unit(), "robot 3");
  const Status::Command& steered = anna.status().steps(anna.status().steps_size() - 2).commands(0);
  EXPECT_EQ(steered.unit(), "robot 3");
  EXPECT_LT(steered.progress(), 0.0) << "nobody knows where to";
  EXPECT_LT(steered.remaining(), 0.0);
  anna.watch_for(0.3);
  const RobotRows::Row before = robot_in(anna.frame(), 3);
  EXPECT_EQ(before.flags >> 5 & 1, 1);
  for (int i = 0; i < 8; ++i) {
    ToServer stick;
    stick.mutable_stick()->set_unit("robot 3");
    stick.mutable_stick()->set_y(1.0);
    ASSERT_EQ(Browser::error_of(anna.ask(stick)), "");
    anna.watch_for(0.1);
  }
  const RobotRows::Row moved = robot_in(anna.frame(), 3);
  EXPECT_GT(moved.y, before.y + 5.0F) << "to the north";
  anna.watch_for(1.0);  // the hand is off the stick
  const RobotRows::Row stands = robot_in(anna.frame(), 3);
  anna.watch_for(0.5);
  EXPECT_LT(distance(robot_in(anna.frame(), 3), stands), 0.5);
  ToServer end;
  end.mutable_end_teleoperation()->set_unit("robot 3");
  EXPECT_EQ(Browser::error_of(anna.ask(end)), "");
  EXPECT_TRUE(anna.wait([&] { return anna.status().teleoperations_size() == 0; }));
  EXPECT_NE(Browser::error_of(anna.ask(end)), "");
  EXPECT_EQ(anna.roster().units_size(), 3) << "an order to a robot makes no unit of the mission";
}

TEST(Session, OnlyTheOperatorCommandsAndThePlaceIsHandedOver) {
  TestSession session(kDemo);
  Browser anna(session, "Anna");
  ASSERT_TRUE(wait_for(anna, Status::READY));
  Browser ben(session, "Ben");
  EXPECT_NE(ben.control(Control::EXECUTE).find("Anna"), std::string::npos);
  ToServer take;
  take.mutable_take_operator();
  EXPECT_TRUE(ben.ask(take).ok());
  ASSERT_TRUE(anna.wait([&] { return anna.clients().asks() == 2; }));
  EXPECT_EQ(anna.clients().operator_(), 1U);
  ToServer pass;
  pass.mutable_pass_operator()->set_client(2);
  EXPECT_TRUE(anna.ask(pass).ok());
  ASSERT_TRUE(ben.wait([&] { return ben.clients().operator_() == 2; }));
  EXPECT_EQ(ben.control(Control::EXECUTE), "");
  EXPECT_NE(anna.control(Control::PAUSE), "");
}

// Whatever message there is, and those that come.
TEST(Session, WhoOnlyWatchesIsRefusedAllThatIsTheOperators) {
  TestSession session(kDemo);
  Browser anna(session, "Anna");
  ASSERT_TRUE(wait_for(anna, Status::READY));
  Browser ben(session, "Ben");
  const std::set<std::string> for_anybody = {
      "hello",     "acknowledge",  "watch",           "beat",          "emergency_stop", "complete",
      "check",     "list_files",   "read_series",     "take_operator", "pass_operator",  "find_definition",
      "find_uses", "read_text",    "read_said",       "try_failsafes", "check_vehicles", "look_back",
      "read_past", "find_moments", "read_changeable", "what_if",       "forget_future",  "save_future"};
  const google::protobuf::OneofDescriptor& all = *ToServer::descriptor()->FindOneofByName("body");
  for (int i = 0; i < all.field_count(); ++i) {
    if (for_anybody.contains(all.field(i)->name())) continue;
    ToServer message;
    ToServer::GetReflection()->MutableMessage(&message, all.field(i));
    EXPECT_NE(Browser::error_of(ben.ask(message)).find("Anna"), std::string::npos) << all.field(i)->name();
  }
}

TEST(Session, WhoReloadsThePageIsTheSameClientAndTheRunGoesOn) {
  TestSession session(kDemo, 10.0);
  auto anna = std::make_unique<Browser>(session, "Anna", "key");
  ASSERT_TRUE(wait_for(*anna, Status::READY));
  ASSERT_EQ(anna->control(Control::EXECUTE), "");
  ASSERT_TRUE(anna->wait([&] { return anna->status().time() > 2.0; }));
  const double time = anna->status().time();
  Browser ben(session, "Ben");
  anna.reset();
  ASSERT_TRUE(ben.wait([&] { return ben.status().time() > time + 3.0; }));
  Browser again(session, "Anna", "key");
  ASSERT_TRUE(wait_for(again, Status::RUNNING));
  EXPECT_EQ(again.welcome().client(), 1U);
  EXPECT_TRUE(again.wait([&] { return again.clients().operator_() == 1U; }));
  EXPECT_GT(again.status().time(), time + 3.0);
  EXPECT_TRUE(again.wait([&] { return again.trails().trails_size() == 4; }));
  EXPECT_GT(again.log().size(), 3U);
}

TEST(Session, ASlowBrowserGetsFewerFramesButEveryQuestion) {
  TestSession session(kDemo, 20.0);
  Browser slow(session, "Slow");
  ASSERT_TRUE(wait_for(slow, Status::READY));
  slow.acknowledge_frames(false);
  const std::uint64_t before = slow.frame_count();
  Browser fast(session, "Fast");
  ASSERT_EQ(slow.control(Control::EXECUTE), "");
  ASSERT_TRUE(slow.wait([&] {
    fast.watch_for(0.02);
    return slow.questions().questions_size() == 1 && fast.questions().questions_size() == 1;
  }));
  EXPECT_LE(slow.frame_count(), before + 2);
  EXPECT_GT(fast.frame_count(), 3U);
}

TEST(Session, ASlowBrowserIsToldThatTimePassesOnceItHasDrawn) {
  TestSession session(kDemo, 20.0);
  Browser slow(session, "Slow");
  ASSERT_TRUE(wait_for(slow, Status::READY));
  slow.acknowledge_frames(false);
  Browser fast(session, "Fast");
  ASSERT_EQ(slow.control(Control::EXECUTE), "");
  ASSERT_TRUE(slow.wait([&] { return slow.questions().questions_size() == 1; }));
  slow.watch_for(0.3);  // the robots stand, and wait for the answer
  const double known = slow.status().time();
  ASSERT_TRUE(fast.wait([&] { return fast.status().time() > known + 20.0; }));
  slow.watch_for(0.1);
  EXPECT_EQ(slow.status().time(), known);
  slow.acknowledge_frames(true);
  EXPECT_TRUE(slow.wait([&] { return slow.status().time() > known + 20.0; }));
}

TEST(Session, AnAnswerOfNoAbortsTheMission) {
  TestSession session(kDemo, 0.0);
  Browser anna(session, "Anna");
  ASSERT_TRUE(wait_for(anna, Status::READY));
  ASSERT_EQ(anna.control(Control::EXECUTE), "");
  ASSERT_TRUE(anna.wait([&] { return anna.questions().questions_size() == 1; }));
  EXPECT_TRUE(anna.wait([&] { return anna.status().outcome() == Status::UNDER_WAY; }));
  EXPECT_NE(anna.answer(99, true), "");
  EXPECT_EQ(anna.answer(anna.questions().questions(0).id(), false), "");
  ASSERT_TRUE(wait_for(anna, Status::ENDED));
  EXPECT_EQ(anna.status().outcome(), Status::ABORTED);
}

TEST(Session, StepsCyclesAndJumpsOneByOne) {
  TestSession session(kDemo, 0.0);
  Browser anna(session, "Anna");
  ASSERT_TRUE(wait_for(anna, Status::READY));
  ASSERT_EQ(anna.control(Control::SINGLE_CYCLE), "");
  ASSERT_TRUE(anna.wait([&] { return anna.status().cycle() == 1; }));
  EXPECT_EQ(anna.status().mode(), Status::PAUSED);
  ASSERT_EQ(anna.control(Control::SINGLE_CYCLE), "");
  ASSERT_TRUE(anna.wait([&] { return anna.status().cycle() == 2; }));
  EXPECT_NE(anna.control(Control::JUMP, 77), "");
  ASSERT_EQ(anna.control(Control::REWIND), "");
  ASSERT_TRUE(anna.wait([&] { return anna.status().current_step() == 0; }));
  ASSERT_EQ(anna.control(Control::JUMP, 4), "");
  ASSERT_TRUE(anna.wait([&] { return anna.status().current_step() == 4; }));
}

TEST(Session, AStepFinishesWhatRunsAndStopsAndSkippingGivesItUp) {
  TestSession session(kDemo, 0.0);
  Browser anna(session, "Anna");
  ASSERT_TRUE(wait_for(anna, Status::READY));
  const auto outcome_of = [&](int step) {
    return anna.status().steps_size() > step ? anna.status().steps(step).outcome() : Status::PENDING;
  };
  ASSERT_EQ(anna.control(Control::SINGLE_STEP), "");
  ASSERT_TRUE(anna.wait([&] { return outcome_of(0) == Status::DONE; }));
  EXPECT_EQ(anna.status().mode(), Status::PAUSED);
  EXPECT_EQ(anna.status().current_step(), 1U);

  ASSERT_EQ(anna.control(Control::SINGLE_CYCLE), "");  // step 1 runs, paused
  ASSERT_TRUE(anna.wait([&] { return outcome_of(1) == Status::UNDER_WAY; }));
  ASSERT_EQ(anna.control(Control::SINGLE_STEP), "");
  ASSERT_TRUE(anna.wait([&] { return anna.questions().questions_size() == 1; }));
  ASSERT_TRUE(anna.wait([&] { return anna.status().stops_after_step(); }));
  EXPECT_EQ(anna.answer(anna.questions().questions(0).id(), true), "");
  ASSERT_TRUE(anna.wait([&] { return outcome_of(1) == Status::DONE; }));
  EXPECT_FALSE(anna.status().stops_after_step());
  EXPECT_EQ(anna.status().steps_size(), 2);
  EXPECT_EQ(anna.status().mode(), Status::PAUSED);

  ASSERT_EQ(anna.control(Control::SKIP_STEP), "");  // nothing runs: the next one is 3
  ASSERT_TRUE(anna.wait([&] { return anna.status().current_step() == 3; }));
  ASSERT_EQ(anna.control(Control::SINGLE_CYCLE), "");
  ASSERT_EQ(anna.control(Control::SKIP_STEP), "");
  ASSERT_TRUE(anna.wait([&] { return outcome_of(2) == Status::SKIPPED; }));
  EXPECT_EQ(anna.status().current_step(), 4U);

  ASSERT_EQ(anna.control(Control::REWIND), "");
  ASSERT_EQ(anna.control(Control::JUMP, 11), "");
  EXPECT_NE(anna.control(Control::SKIP_STEP), "") << "there is none after it";
  ASSERT_EQ(anna.control(Control::RESUME), "") << "it executes where nothing runs";
  ASSERT_TRUE(anna.wait([&] { return outcome_of(anna.status().steps_size() - 1) != Status::SKIPPED; }));
}

TEST(Session, SetsTheSpeedAndKeepsIt) {
  TestSession session(kDemo, 1.0);
  Browser anna(session, "Anna");
  ASSERT_TRUE(wait_for(anna, Status::READY));
  ToServer speed;
  speed.mutable_set_speed()->set_speed(20.0);
  ASSERT_TRUE(anna.ask(speed).ok());
  speed.mutable_set_speed()->set_speed(0.01);
  EXPECT_FALSE(anna.ask(speed).ok());
  ASSERT_EQ(anna.control(Control::EXECUTE), "");
  ASSERT_TRUE(anna.wait([&] { return anna.status().time() > 10.0; }));
  const double time = anna.status().time();
  const auto began = std::chrono::steady_clock::now();
  ASSERT_TRUE(anna.wait([&] { return anna.status().time() > time + 20.0; }));
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
  EXPECT_GT(took.count(), 0.6) << "no faster than 20 times real time";
}

}  // namespace
}  // namespace mlab::console
