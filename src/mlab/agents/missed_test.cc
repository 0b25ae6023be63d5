#include "mlab/agents/missed.h"

#include <unistd.h>

#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace mlab::agents {
namespace {

using std::chrono::hours;
using std::chrono::seconds;

const Clock::time_point kNow = Clock::time_point() + hours(100);

Member member(const std::string& name, Member::State state, Clock::duration silent) {
  Member out;
  out.said.set_name(name);
  out.said.set_host(name + "-machine");
  out.state = state;
  out.heard = kNow - silent;
  return out;
}

std::string names(const std::vector<Missed>& missed) {
  std::string out;
  for (const Missed& one : missed) out += one.name + " ";
  return out;
}

TEST(Missed, AreThoseOfWhichNothingIsHeard) {
  const Member there = member("there", Member::State::kThere, seconds(0));
  const Member silent = member("silent", Member::State::kSilent, seconds(3));
  const Member gone = member("gone", Member::State::kGone, seconds(90));
  Member left = member("left", Member::State::kGone, seconds(5));
  left.has_left = true;
  const auto missed = missed_among({there, silent, gone, left}, {}, kNow);
  EXPECT_EQ(names(missed), "silent gone ");
  EXPECT_DOUBLE_EQ(missed[1].silent, 90.0);
  EXPECT_EQ(missed[1].machine, "gone-machine");
}

TEST(Missed, AreForgottenAfterAnHourUnlessARunWorksWithThem) {
  const Member old = member("old", Member::State::kGone, kMissedFor + seconds(1));
  Member held = member("held", Member::State::kGone, 5 * kMissedFor);
  held.is_held = true;
  const Member recent = member("recent", Member::State::kGone, kMissedFor - seconds(1));
  EXPECT_EQ(names(missed_among({old, recent, held}, {}, kNow)), "held recent ")
      << "those that a run works with first";
}

TEST(Missed, IsWhoIsThereAndHasNotConfirmedAStop) {
  const StopState stop = pulled({}, "anna");
  Member deaf = member("deaf", Member::State::kThere, seconds(0));
  Member stopped = member("stopped", Member::State::kThere, seconds(0));
  encode(stop, *stopped.said.mutable_stop());
  EXPECT_EQ(names(missed_among({deaf, stopped}, stop, kNow)), "deaf ");
  EXPECT_EQ(names(missed_among({deaf, stopped}, released(stop, "anna"), kNow)), "");
}

TEST(Missed, AreAtMostSoManyAndThoseThatWereHeardLast) {
  std::vector<Member> members;
  for (int i = 0; i < 200; ++i)
    members.push_back(member("a" + std::to_string(i), Member::State::kGone, seconds(200 - i)));
  const auto missed = missed_among(members, {}, kNow);
  ASSERT_EQ(missed.size(), kMostMissed);
  EXPECT_EQ(missed.front().name, "a199");
}

TEST(Missed, AreSaidAndRead) {
  const auto read =
      decode_missed(encode(MissedAgents{"agent north", {{"south", "field", 12.5}, {"west", "", 0.0}}}));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->by, "agent north");
  ASSERT_EQ(read->agents.size(), 2U);
  EXPECT_EQ(read->agents[0].name, "south");
  EXPECT_EQ(read->agents[0].machine, "field");
  EXPECT_DOUBLE_EQ(read->agents[0].silent, 12.5);
}

TEST(Missed, ThatCanNotBeAreNotBelieved) {
  const double inf = std::numeric_limits<double>::infinity();
  const MissedAgents odd{"a\nb\x1b[2J" + std::string(500, 'x'),
                         {{"", "", 1.0},
                          {"a b", "", 1.0},
                          {"a\nb", "", 1.0},
                          {std::string(65, 'a'), "", 1.0},
                          {"negative", "", -1.0},
                          {"never", "", inf},
                          {"odd", "", std::nan("")},
                          {"good", "\x1b]0;title\x07", 1.0}}};
  const auto read = decode_missed(encode(odd));
  ASSERT_TRUE(read);
  EXPECT_EQ(names(read->agents), "good ");
  EXPECT_EQ(read->agents[0].machine.find('\x1b'), std::string::npos);
  EXPECT_EQ(read->by.find('\n'), std::string::npos);
  EXPECT_LE(read->by.size(), 410U);
  EXPECT_FALSE(decode_missed("\xff\xff"));
  MissedAgents many{"agent north", {}};
  for (int i = 0; i < 1000; ++i) many.agents.push_back({"a" + std::to_string(i), "", 1.0});
  EXPECT_EQ(decode_missed(encode(many))->agents.size(), kMostMissed);
}

RC_GTEST_PROP(Missed, AreReadFromAnything, (const std::string& bytes)) {
  if (const auto read = decode_missed(bytes)) RC_ASSERT(read->agents.size() <= kMostMissed);
}

dds::Participant participant(const std::string& fleet) {
  auto out = dds::Participant::open({.fleet = fleet, .interface_name = {}, .peers = {}});
  EXPECT_TRUE(out) << out.error();
  return std::move(*out);
}

class Heard : public ::testing::Test {
 protected:
  std::vector<Hearsay::Entry> wait_for(std::size_t count) {
    for (const auto end = Clock::now() + seconds(30); Clock::now() < end;) {
      waiter_.wait(std::chrono::milliseconds(20));
      hearsay_->listen();
      if (hearsay_->all(Clock::now()).size() == count) break;
    }
    return hearsay_->all(Clock::now());
  }

  std::string fleet_ = "missed-" + std::to_string(::getpid());
  dds::Participant here_ = participant(fleet_);
  dds::Waiter waiter_ = dds::Waiter::make().value();
  std::unique_ptr<Hearsay> hearsay_ = Hearsay::open(here_, waiter_).value();
};

TEST_F(Heard, IsWhatThoseSayWhoHaveHeardItLast) {
  dds::Participant north = participant(fleet_);
  dds::Participant west = participant(fleet_);
  MissedTeller by_north(north, "agent north");
  MissedTeller by_west(west, "agent west");
  by_north.say({{"south", "field", 50.0}, {"east", "", 1.0}});
  ASSERT_EQ(wait_for(2).size(), 2U);
  by_west.say({{"south", "field", 7.0}, {"last", "", 1.0}});
  const auto all = wait_for(3);
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[2].agent.name, "south");
  EXPECT_EQ(all[2].by, "agent west");
  EXPECT_GE(all[2].agent.silent, 7.0);
  EXPECT_LT(all[2].agent.silent, 45.0);
  by_west.say({});
  EXPECT_EQ(wait_for(2).size(), 2U) << "who is back for one may be missed by another";
}

TEST_F(Heard, GoesWithWhoSaidItWhereHeLeavesInOrder) {
  dds::Participant north = participant(fleet_);
  {
    MissedTeller teller(north, "agent north");
    teller.say({{"south", "field", 1.0}});
    ASSERT_EQ(wait_for(1).size(), 1U);
  }
  EXPECT_EQ(wait_for(0).size(), 0U);
}

TEST_F(Heard, ReachesWhoComesLate) {
  dds::Participant north = participant(fleet_);
  MissedTeller teller(north, "agent north");
  teller.say({{"south", "field", 1.0}});
  ASSERT_EQ(wait_for(1).size(), 1U);
  auto late = Hearsay::open(here_, waiter_).value();
  for (const auto end = Clock::now() + seconds(30); Clock::now() < end && late->all(Clock::now()).empty();) {
    waiter_.wait(std::chrono::milliseconds(20));
    late->listen();
  }
  EXPECT_EQ(late->all(Clock::now()).size(), 1U);
}

}  // namespace
}  // namespace mlab::agents
