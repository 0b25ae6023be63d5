#include <gtest/gtest.h>

#include "mlab/dds/reader_state.h"

namespace mlab::dds {
namespace {

using Kind = Arrival::Kind;

Arrival message(std::string key, std::string body) {
  Arrival arrival;
  arrival.key = std::move(key);
  arrival.body = std::move(body);
  return arrival;
}

Arrival ended(std::string key) {
  Arrival arrival = message(std::move(key), "");
  arrival.kind = Kind::kEnded;
  return arrival;
}

TEST(DdsWaiting, KeepsOfEachKeyTheNewest) {
  Waiting waiting(true);
  waiting.add(message("a", "1"));
  waiting.add(message("b", "1"));
  waiting.add(message("a", "2"));
  const auto taken = waiting.take();
  ASSERT_EQ(taken.size(), 2U);
  EXPECT_EQ(taken[0].body, "2");
  EXPECT_EQ(taken[1].key, "b");
  EXPECT_TRUE(waiting.take().empty());
}

TEST(DdsWaiting, KeepsWhatEndsBetweenTwoMessagesOfAKey) {
  Waiting waiting(true);
  waiting.add(message("a", "1"));
  waiting.add(ended("a"));
  waiting.add(message("a", "2"));
  waiting.add(message("a", "3"));
  const auto taken = waiting.take();
  ASSERT_EQ(taken.size(), 3U);
  EXPECT_EQ(taken[0].body, "1");
  EXPECT_EQ(taken[1].kind, Kind::kEnded);
  EXPECT_EQ(taken[2].body, "3");
}

TEST(DdsWaiting, TellsHowManyItDidNotKeepAfterThoseThatItKept) {
  Waiting waiting(false);
  for (std::size_t i = 0; i < Reader::kMaxWaiting + 7; ++i) waiting.add(message("", "x"));
  auto taken = waiting.take();
  ASSERT_EQ(taken.size(), Reader::kMaxWaiting + 1);
  EXPECT_EQ(taken.back().kind, Kind::kLost);
  EXPECT_EQ(taken.back().lost, 7U);
  waiting.add(message("", "y"));
  taken = waiting.take();
  ASSERT_EQ(taken.size(), 1U);
  EXPECT_EQ(taken[0].body, "y");
}

TEST(DdsWaiting, KeepsNoMoreBytesThanItMay) {
  Waiting waiting(false);
  const std::size_t fit = Reader::kMaxWaitingBytes / kMaxBody;
  for (std::size_t i = 0; i < fit + 3; ++i) waiting.add(message("", std::string(kMaxBody, 'x')));
  const auto taken = waiting.take();
  ASSERT_EQ(taken.size(), fit + 1);
  EXPECT_EQ(taken.back().lost, 3U);
}

TEST(DdsWaiting, CountsBytesOfTheNewestOnly) {
  Waiting waiting(true);
  for (std::size_t i = 0; i < 3 * Reader::kMaxWaitingBytes / kMaxBody; ++i)
    waiting.add(message("a", std::string(kMaxBody, 'x')));
  EXPECT_EQ(waiting.take().size(), 1U);
}

}  // namespace
}  // namespace mlab::dds
