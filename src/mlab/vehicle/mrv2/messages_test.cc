#include "mlab/vehicle/mrv2/messages.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "mlab/base/random.h"

namespace mlab::vehicle::mrv2 {
namespace {

/// All that is found in the bytes, with the types of frames in front.
std::string read_all(FrameReader& reader) {
  std::string all;
  while (const auto frame = reader.next())
    all += static_cast<char>(frame->type) + std::string(frame->payload);
  return all;
}

template <class Kind>
Kind over_the_line(const Kind& message) {
  FrameReader reader;
  reader.add(bytes_of(Message(message)));
  const auto frame = reader.next();
  EXPECT_TRUE(frame.has_value());
  const auto read = message_of(frame.value_or(Frame{}));
  EXPECT_TRUE(read.has_value() && std::holds_alternative<Kind>(*read));
  return std::get<Kind>(read.value_or(Message(Kind{})));
}

TEST(Mrv2Messages, ArriveAsTheyWereSaid) {
  const Identity identity{7, true, 0.4, 0.1, 1.571, 0.5, 1.0, 24, 7.0, 0.15, 0.262};
  EXPECT_EQ(over_the_line(identity), identity);
  const State state{7, 123456, {{-3.5, 1200.25}, -3.14}, 0.1, -0.5, State::kStopPressed, 24.5, 0.87};
  EXPECT_EQ(over_the_line(state), state);
  const Drive drive{7, 4'000'000'000, -0.1, 1.5};
  EXPECT_EQ(over_the_line(drive), drive);
  EXPECT_EQ(over_the_line(Stop{}), Stop{});
  EXPECT_EQ(over_the_line(Ask{}), Ask{});
}

TEST(Mrv2Messages, TellNoEchoAndNoAnswerApart) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const Ranges read = over_the_line(Ranges{7, 5, {1.5F, kInfinity, kNan, 70.0F, -1.0F}});
  ASSERT_EQ(read.distances.size(), 5U);
  EXPECT_FLOAT_EQ(read.distances[0], 1.5F);
  EXPECT_TRUE(std::isinf(read.distances[1]));
  EXPECT_TRUE(std::isnan(read.distances[2]));
  EXPECT_FLOAT_EQ(read.distances[3], 65.533F);
  EXPECT_EQ(read.distances[4], 0.0F);
}

TEST(Mrv2Messages, CarryNothingThatIsNoNumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(over_the_line(Drive{1, 2, nan, 1e300}), (Drive{1, 2, 0.0, 32.767}));
}

TEST(Mrv2Messages, ThatAreNotAsLongAsTheyHaveToBeAreNone) {
  for (const char type : {'I', 'P', 'D', 'S', 'Q', 'R', 'X'}) {
    for (std::size_t length = 0; length < 64; ++length) {
      const std::string payload(length, '\0');
      const auto read = message_of({static_cast<std::uint8_t>(type), payload});
      const bool is_long_enough = (type == 'I' && length == 20) || (type == 'P' && length == 26) ||
                                  (type == 'D' && length == 10) || (type == 'S' && length == 0) ||
                                  (type == 'Q' && length == 0) ||
                                  (type == 'R' && length > 6 && length % 2 == 0);
      EXPECT_EQ(read.has_value(), is_long_enough) << type << ' ' << length;
    }
  }
}

TEST(Mrv2Messages, OfSensorsThatCouldSeeNothingAreNone) {
  Identity identity;
  identity.range = 2.0;
  identity.nearest = 2.001;
  FrameReader reader;
  reader.add(bytes_of(identity));
  const auto frame = reader.next();
  ASSERT_TRUE(frame.has_value());
  EXPECT_FALSE(message_of(*frame).has_value());
}

TEST(Mrv2Frames, AreFoundAmongOtherBytesInPiecesOfAnyLength) {
  const std::uint64_t seed = 3;
  base::Random random(seed);
  std::string bytes;
  std::string expected;
  for (int i = 0; i < 300; ++i) {
    std::string payload(random.below(40), ' ');
    for (char& c : payload) c = static_cast<char>(random.bits());
    const std::string frame = bytes_of(Frame{static_cast<std::uint8_t>(i), payload});
    const bool is_damaged = random.uniform() < 0.2;
    bytes += std::string(random.below(3), '\xA5') + (is_damaged ? frame.substr(0, frame.size() - 3) : frame);
    if (!is_damaged) expected += static_cast<char>(i) + payload;
  }
  bytes += std::string(300, '\0');
  FrameReader at_once;
  at_once.add(bytes);
  EXPECT_EQ(read_all(at_once), expected) << "seed " << seed;
  FrameReader in_pieces;
  std::string read;
  for (std::size_t i = 0; i < bytes.size();) {
    const std::size_t length = 1 + random.below(30);
    in_pieces.add(std::string_view(bytes).substr(i, length));
    read += read_all(in_pieces);
    i += length;
  }
  EXPECT_EQ(read, expected) << "seed " << seed;
}

}  // namespace
}  // namespace mlab::vehicle::mrv2
