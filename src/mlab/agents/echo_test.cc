#include "mlab/agents/echo.h"

#include <chrono>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <unistd.h>

#include <gtest/gtest.h>

#include "mlab/agents/topics.h"
#include "mlab/presence.pb.h"

namespace mlab::agents {
namespace {

using std::chrono::milliseconds;

const Clock::time_point kBegin = Clock::now();
const Clock::time_point kLater = kBegin + LinkHistory::kPatience;  // all that was asked at first is due

TEST(LinkHistory, KnowsNothingBeforeTheFirstAnswer) {
  LinkHistory link;
  EXPECT_FALSE(link.quality(kBegin));
  link.asked(1, kBegin);
  EXPECT_FALSE(link.quality(kLater));
}

TEST(LinkHistory, TakesTheOffsetOfTheFastestAnswer) {
  LinkHistory link;
  for (std::uint64_t i = 1; i <= 3; ++i) link.asked(i, kBegin);
  link.answered(1, 0.020, 0.5);
  link.answered(2, 0.004, 0.25);
  link.answered(3, 0.100, 0.9);
  ASSERT_TRUE(link.quality(kLater));
  EXPECT_EQ(link.quality(kLater)->round_trip, 0.004);
  EXPECT_EQ(link.quality(kLater)->clock_offset, 0.25);
  EXPECT_EQ(link.quality(kLater)->lost, 0.0);
}

TEST(LinkHistory, CountsWhatWasNotAnswered) {
  LinkHistory link;
  for (std::uint64_t i = 1; i <= 4; ++i) link.asked(i, kBegin);
  link.answered(1, 0.01, 0.0);
  link.answered(3, 0.01, 0.0);
  EXPECT_NEAR(link.quality(kBegin)->lost, 1.0 / 3.0, 1e-12) << "the fourth may be on its way";
  link.asked(5, kBegin + milliseconds(1));
  EXPECT_NEAR(link.quality(kBegin + milliseconds(1))->lost, 1.0 / 3.0, 1e-12);
  EXPECT_NEAR(link.quality(kLater)->lost, 0.5, 1e-12);
  EXPECT_NEAR(link.quality(kLater + milliseconds(1))->lost, 0.6, 1e-12);
}

TEST(LinkHistory, LosesNothingWhereTheWayTakesLongerThanFromOneQuestionToTheNext) {
  LinkHistory link;
  Clock::time_point now = kBegin;
  for (std::uint64_t i = 1; i <= 30; ++i, now += milliseconds(20)) {
    link.asked(i, now);
    if (i > 12) link.answered(i - 12, 0.24, 0.0);
    const auto quality = link.quality(now);
    if (quality) {
      EXPECT_EQ(quality->lost, 0.0) << i;
    }
  }
  ASSERT_TRUE(link.quality(now));
  EXPECT_EQ(link.quality(now)->round_trip, 0.24);
}

TEST(LinkHistory, CountsNothingOfWhatWasAskedBeforeBothHadFoundEachOther) {
  LinkHistory link;
  for (std::uint64_t i = 1; i <= 5; ++i) link.asked(i, kBegin);
  link.answered(4, 0.01, 0.0);
  link.answered(5, 0.01, 0.0);
  EXPECT_EQ(link.quality(kLater)->lost, 0.0);
  for (std::uint64_t i = 6; i <= 7; ++i) link.asked(i, kLater);
  link.answered(7, 0.01, 0.0);
  EXPECT_NEAR(link.quality(kLater)->lost, 0.25, 1e-12) << "from then on all count";
}

TEST(LinkHistory, ForgetsWhatIsLongAgo) {
  LinkHistory link;
  link.asked(1, kBegin);
  link.answered(1, 0.001, 7.0);
  for (std::uint64_t i = 2; i < 2 + LinkHistory::kKept; ++i) {
    link.asked(i, kBegin);
    link.answered(i, 0.01, 1.0);
  }
  EXPECT_EQ(link.quality(kLater)->clock_offset, 1.0);
}

TEST(LinkHistory, TakesNoNonsense) {
  LinkHistory link;
  link.asked(1, kBegin);
  for (const double nonsense : {-1.0, 1e9, std::numeric_limits<double>::quiet_NaN()})
    link.answered(1, nonsense, 0.0);
  link.answered(2, 0.1, 0.0);
  EXPECT_FALSE(link.quality(kLater));
  link.answered(1, 0.1, 2.0);
  link.answered(1, 0.01, 3.0);
  EXPECT_EQ(link.quality(kLater)->clock_offset, 2.0) << "an answer that comes twice";
}

dds::Participant participant() {
  auto out = dds::Participant::open(
      {.fleet = "echo-" + std::to_string(::getpid()), .interface_name = {}, .peers = {}});
  EXPECT_TRUE(out) << out.error();
  return std::move(*out);
}

// Two consoles look at a fleet whose agent was busy for a moment: no answer takes the place of another one.
TEST(EchoAnswerer, AnswersAllWhoHaveAskedMeanwhile) {
  dds::Participant there = participant();
  dds::Participant here = participant();
  const auto waiter = dds::Waiter::make().value();
  auto answerer = EchoAnswerer::open(there, waiter, "north").value();
  auto asks = here.writer(kEchoQuestionTopic, dds::ChannelKind::kEchoes).value();
  auto hears = here.reader(kEchoTopic, dds::ChannelKind::kEchoes, waiter).value();
  const std::vector<std::string> all = {"one 1", "one 2", "two 1"};
  std::vector<std::string> echoes;
  // Again until both have found each other; what is lost on the way stays lost.
  for (const auto end = Clock::now() + std::chrono::seconds(30); echoes != all && Clock::now() < end;) {
    wire::EchoQuestion question;
    for (const auto& [asker, number] : {std::pair("one", 1), std::pair("one", 2), std::pair("two", 1)}) {
      question.set_number(static_cast<std::uint64_t>(number));
      ASSERT_EQ(asks.write(asker, question.SerializeAsString()), dds::Written::kDone);
    }
    std::this_thread::sleep_for(milliseconds(50));
    answerer.answer();
    std::this_thread::sleep_for(milliseconds(50));
    echoes.clear();
    for (const dds::Arrival& arrival : hears.take()) {
      wire::Echo echo;
      if (arrival.kind != dds::Arrival::Kind::kMessage || !echo.ParseFromString(arrival.body)) continue;
      EXPECT_EQ(arrival.key, "north");
      echoes.push_back(echo.asker() + " " + std::to_string(echo.number()));
    }
  }
  EXPECT_EQ(echoes, all);
}

}  // namespace
}  // namespace mlab::agents
