#include "mlab/console/published/channel.h"

#include <gtest/gtest.h>

namespace mlab::console {
namespace {

Channel with_rate(std::uint32_t rate) {
  Channel channel({1});
  Watch watch;
  watch.set_rate(rate);
  channel.watch(watch);
  return channel;
}

TEST(Channel, HasAtMostTwoFramesUnderWay) {
  Channel channel = with_rate(60);
  EXPECT_EQ(channel.begin_frame(1.0), 1U);
  ASSERT_TRUE(channel.wants_frame(2.0));
  EXPECT_EQ(channel.begin_frame(2.0), 2U);
  EXPECT_FALSE(channel.wants_frame(100.0)) << "it has acknowledged none";
  channel.acknowledge(1);
  EXPECT_TRUE(channel.wants_frame(100.0));
}

TEST(Channel, AnAcknowledgementCountsForAllFramesBefore) {
  Channel channel = with_rate(60);
  channel.begin_frame(1.0);
  channel.begin_frame(2.0);
  channel.acknowledge(2);
  channel.begin_frame(3.0);
  EXPECT_TRUE(channel.wants_frame(4.0));
  channel.acknowledge(77);  // nonsense does no harm
  EXPECT_TRUE(channel.wants_frame(4.0));
}

TEST(Channel, SendsNoMoreFramesThanWanted) {
  for (const auto& [rate, least, most] : {std::tuple(30U, 29, 31), std::tuple(60U, 59, 61),
                                          std::tuple(1000U, 59, 61), std::tuple(0U, 29, 31)}) {
    Channel channel = with_rate(rate);
    int sent = 0;
    for (double wall = 10.0; wall < 11.0; wall += 0.001) {
      if (!channel.wants_frame(wall)) continue;
      channel.acknowledge(channel.begin_frame(wall));
      ++sent;
    }
    EXPECT_GE(sent, least) << rate;
    EXPECT_LE(sent, most) << rate;
  }
}

TEST(Channel, CutsListsThatAreTooLong) {
  Channel channel({1});
  Watch watch;
  for (std::uint32_t i = 0; i < 1000; ++i) {
    watch.add_details(i);
    watch.add_series()->set_id(i);
  }
  channel.watch(watch);
  EXPECT_EQ(channel.watched().details_size(), 64);
  EXPECT_EQ(channel.watched().series_size(), 64);
}

}  // namespace
}  // namespace mlab::console
