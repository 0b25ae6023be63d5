// The table of failsafes as browsers see it, and what they ask of it.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "mlab/console/session.h"
#include "mlab/console/testing/browser.h"
#include "mlab/documents/testing/scratch_project.h"

namespace mlab::console {
namespace {

using documents::testing::ScratchProject;
using testing::Browser;
using testing::TestSession;
using Standing = FailsafeStandings::Standing;

constexpr const char* kGuarded =
    "OVERLAY \"field.odl\"\n"
    "FAILSAFE OUTSIDE Field HOLD\n"
    "FAILSAFE LINK-LOST AFTER 5 RETURN\n"
    "FAILSAFE IN-CONTACT AFTER 0.5 STOP\n"
    "UNIT <a> ROBOT\n"
    "COMMAND LIST:\n"
    "0. UNIT a START 100 100\n"
    "1. UNIT a MOVETO 400 100\n";
constexpr const char* kField =
    "MISSION-AREA 500 200\n"
    "CONTROL MEASURES:\n"
    "BOUNDARY Field 20 20 200 20 200 180 20 180\n";

class GuardedSession : public ::testing::Test {
 protected:
  explicit GuardedSession(const std::string& mission = kGuarded)
      : session_((write(mission), ""), 20.0,
                 [&](SessionSettings& s) {
                   s.project_folder = project_.path("project").string();
                   s.state_folder = project_.path("state").string();
                   s.mission = project_.path("project/guarded.mdl").string();
                 }),
        anna_(session_, "Anna"),
        bert_(session_, "Bert") {
    EXPECT_TRUE(anna_.wait([&] { return anna_.status().mode() == Status::READY; }));
  }
  void write(const std::string& mission) {
    project_.write("project/guarded.mdl", mission);
    project_.write("project/field.odl", kField);
  }
  static void look_at(Browser& who, bool with_failsafes) {
    auto message = std::make_unique<ToServer>();
    message->mutable_watch()->add_details(1);
    message->mutable_watch()->set_rate(60);
    message->mutable_watch()->set_with_failsafes(with_failsafes);
    who.send(std::move(message));
  }
  FailsafeStandings::State state(int row) {
    const FailsafeStandings& now = anna_.standings(1);
    return row < now.rows_size() ? now.rows(row).state() : FailsafeStandings::OTHERS;
  }
  Reply try_out(Browser& who, const TryFailsafes& asked) {
    ToServer message;
    *message.mutable_try_failsafes() = asked;
    return who.ask(std::move(message));
  }
  static TryFailsafes asked() {
    TryFailsafes out;
    out.set_robot(1);
    out.set_speed(1.0);
    return out;
  }
  static void add(TryFailsafes& out, const std::string& condition, double seconds) {
    TryFailsafes::Lasting& one = *out.add_lasting();
    one.set_condition(condition);
    one.set_seconds(seconds);
  }

  ScratchProject project_;
  TestSession session_;
  Browser anna_;
  Browser bert_;
};

TEST_F(GuardedSession, TellsTheTableToWhoComes) {
  ASSERT_TRUE(bert_.wait([&] { return bert_.failsafes().rows_size() == 3; }));
  const Failsafes::Row& fence = bert_.failsafes().rows(0);
  EXPECT_EQ(fence.statement(), "FAILSAFE OUTSIDE Field HOLD");
  EXPECT_EQ(fence.fence(), "Field");
  EXPECT_FALSE(fence.may_last());
  EXPECT_EQ(fence.document(), "guarded.mdl");
  EXPECT_EQ(fence.line(), 2U);
  const Failsafes::Row& link = bert_.failsafes().rows(1);
  EXPECT_EQ(link.condition() + " " + link.action(), "LINK-LOST RETURN");
  EXPECT_EQ(link.seconds(), 5.0);
  EXPECT_FALSE(link.means().empty() || link.does().empty());
  EXPECT_EQ(link.watch(), Failsafes::Row::REAL_TIME);
  EXPECT_EQ(bert_.failsafes().bounds().seconds(), 600.0);
  EXPECT_GT(bert_.failsafes().bounds().bearing(), 6.28);
}

TEST_F(GuardedSession, TellsHowRowsStandToWhoLooksAtThem) {
  look_at(anna_, true);
  look_at(bert_, false);
  ASSERT_TRUE(anna_.wait([&] { return state(0) == FailsafeStandings::OFF; })) << "it has not been started";
  EXPECT_EQ(anna_.control(Control::EXECUTE), "");
  ASSERT_TRUE(anna_.wait([&] { return state(0) == FailsafeStandings::ARMED; }));
  EXPECT_GT(anna_.standings(1).rows(0).measure(), 0);
  EXPECT_EQ(state(1), FailsafeStandings::OFF) << "programs are waited for here";
  EXPECT_EQ(state(2), FailsafeStandings::ARMED);
  ASSERT_TRUE(anna_.wait([&] { return state(0) == FailsafeStandings::NEAR; }));
  ASSERT_TRUE(anna_.wait([&] { return state(0) == FailsafeStandings::ACTIVE; }));
  EXPECT_EQ(anna_.standings(1).rows(0).used(), 100U);
  EXPECT_EQ(bert_.standings_count(), 0U) << "who does not look is told nothing";
}

TEST_F(GuardedSession, TellsOnlyWhatHasChanged) {
  look_at(anna_, true);
  EXPECT_EQ(anna_.control(Control::EXECUTE), "");
  ASSERT_TRUE(anna_.wait([&] { return state(0) == FailsafeStandings::ACTIVE; }));
  anna_.watch_for(0.3);
  const std::uint64_t told = anna_.standings_count();
  const std::uint64_t frames = anna_.frame_count();
  ASSERT_TRUE(anna_.wait([&] { return anna_.frame_count() > frames + 10; }));
  EXPECT_EQ(anna_.standings_count(), told) << "it stands";
  look_at(anna_, true);
  EXPECT_TRUE(anna_.wait([&] { return anna_.standings_count() == told + 1; })) << "to who looks anew";
}

TEST_F(GuardedSession, TriesConditionsForAnybodyWithoutTouchingTheRun) {
  const std::size_t entries = bert_.log().size();
  TryFailsafes link = asked();
  add(link, "LINK-LOST", 6.0);
  add(link, "IN-CONTACT", 6.0);
  const Reply reply = try_out(bert_, link);
  ASSERT_TRUE(reply.ok()) << reply.error();
  const FailsafeTrial& trial = reply.failsafes();
  ASSERT_EQ(trial.rows_size(), 3);
  EXPECT_EQ(trial.rows(2).used(), 100U);
  ASSERT_GE(trial.events_size(), 2);
  EXPECT_EQ(trial.events(0).what(), FailsafeTrial::MET);
  EXPECT_EQ(trial.events(0).row(), 2U);
  EXPECT_EQ(trial.events(1).what(), FailsafeTrial::ACTS);
  EXPECT_TRUE(trial.has_stopped()) << "what is stopped is not guarded any more";
  EXPECT_FALSE(trial.has_least_room());
  EXPECT_EQ(bert_.status().cycle(), 0U);
  bert_.watch_for(0.2);
  EXPECT_EQ(bert_.log().size(), entries);
}

TEST_F(GuardedSession, TellsWhereARobotWouldStandBeforeItsFence) {
  TryFailsafes fence = asked();
  fence.set_speed(4.0);
  fence.mutable_fence()->set_depth(10.0);
  const Reply reply = try_out(anna_, fence);
  ASSERT_TRUE(reply.ok()) << reply.error();
  EXPECT_TRUE(reply.failsafes().has_stood());
  EXPECT_GE(reply.failsafes().least_room(), -1e-6);
  EXPECT_LT(reply.failsafes().last_room(), 0.6);
  EXPECT_EQ(reply.failsafes().rows(0).state(), FailsafeStandings::ACTIVE);
}

TEST_F(GuardedSession, RefusesWhatCantBeTried) {
  const auto error = [&](const TryFailsafes& what) { return Browser::error_of(try_out(bert_, what)); };
  TryFailsafes nobody = asked();
  nobody.set_robot(9);
  EXPECT_EQ(error(nobody), "there is no robot 9");
  TryFailsafes no_number = asked();
  add(no_number, "STUCK", std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(error(no_number), "STUCK lasts from 0 to 600 s");
  TryFailsafes endless = asked();
  add(endless, "LINK-LOST", 1e300);
  EXPECT_EQ(error(endless), "LINK-LOST lasts from 0 to 600 s");
  TryFailsafes unknown = asked();
  add(unknown, "TIRED", 1.0);
  EXPECT_EQ(error(unknown), "no failsafe looks for `TIRED`");
  TryFailsafes no_fence = asked();
  no_fence.mutable_fence()->set_row(0xffffffffU);
  EXPECT_EQ(error(no_fence), "row 4294967296 of the table is no OUTSIDE");
}

constexpr const char* kSteered =
    "FAILSAFE OPERATOR-ABSENT AFTER 20 RETURN\n"
    "UNIT <a> ROBOT\n"
    "COMMAND LIST:\n"
    "0. UNIT a START 100 100\n"
    "1. UNIT a MOVETO 110 100\n"
    "2. UNIT a TELEOPERATE 300 100\n"
    "3. UNIT a MOVETO 120 100\n";

class SteeredSession : public GuardedSession {
 protected:
  SteeredSession() : GuardedSession(kSteered) {}
  std::string push(double y) {
    ToServer stick;
    stick.mutable_stick()->set_unit("a");
    stick.mutable_stick()->set_y(y);
    return Browser::error_of(anna_.ask(stick));
  }
  bool tells(const std::string& what) {
    return bert_.wait([&] {
      return std::ranges::any_of(
          bert_.log(), [&](const auto& entry) { return entry.text().find(what) != std::string::npos; });
    });
  }
};

TEST_F(SteeredSession, ARobotGoesHomeWhenItsOperatorIsGoneAndNoSooner) {
  look_at(anna_, true);
  EXPECT_EQ(anna_.control(Control::EXECUTE), "");
  ASSERT_TRUE(anna_.wait([&] { return anna_.status().teleoperations_size() == 1; }));
  ASSERT_TRUE(anna_.wait([&] { return state(0) == FailsafeStandings::ARMED; }));
  const double began = anna_.status().time();
  while (anna_.status().time() < began + 30.0) {
    ASSERT_EQ(push(0.0), "") << "he holds it in its middle, and is there";
    anna_.watch_for(0.05);
  }
  EXPECT_NE(state(0), FailsafeStandings::ACTIVE);
  while (anna_.status().time() < began + 60.0) {
    ASSERT_EQ(push(1.0), "");
    anna_.watch_for(0.05);
  }
  EXPECT_NE(state(0), FailsafeStandings::ACTIVE);
  EXPECT_TRUE(tells("`FAILSAFE OPERATOR-ABSENT AFTER 20 RETURN` acts")) << "nothing comes from his console";
  ASSERT_TRUE(anna_.wait([&] { return state(0) == FailsafeStandings::ACTIVE; }));
  ASSERT_EQ(push(1.0), "");
  EXPECT_TRUE(tells("`FAILSAFE OPERATOR-ABSENT AFTER 20 RETURN` is over")) << "he is back";
}

TEST_F(SteeredSession, NobodyMissesAnOperatorWhoHasEndedTheTeleoperation) {
  look_at(anna_, true);
  EXPECT_EQ(state(0), FailsafeStandings::OTHERS);
  EXPECT_EQ(anna_.control(Control::EXECUTE), "");
  ASSERT_TRUE(anna_.wait([&] { return anna_.status().teleoperations_size() == 1; }));
  ToServer end;
  end.mutable_end_teleoperation()->set_unit("a");
  ASSERT_EQ(Browser::error_of(anna_.ask(end)), "");
  ASSERT_TRUE(anna_.wait([&] { return state(0) == FailsafeStandings::OFF; }));
  ASSERT_TRUE(tells("MOVETO 120 100 done"));
}

class UnguardedSession : public GuardedSession {
 protected:
  UnguardedSession() : GuardedSession("UNIT <a> ROBOT\nCOMMAND LIST:\n0. UNIT a START 100 100\n") {}
};

TEST_F(UnguardedSession, HasAnEmptyTable) {
  look_at(anna_, true);
  EXPECT_EQ(Browser::error_of(try_out(anna_, asked())), "the mission has no FAILSAFE");
  EXPECT_EQ(anna_.failsafes().rows_size(), 0);
  EXPECT_EQ(anna_.standings_count(), 0U);
}

}  // namespace
}  // namespace mlab::console
