#include "mlab/mavlink/frame.h"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

namespace mlab::mavlink {
namespace {

using Bytes = std::vector<std::byte>;

Bytes bytes_of(std::initializer_list<int> values) {
  Bytes out;
  for (const int one : values) out.push_back(static_cast<std::byte>(one));
  return out;
}

Bytes joined(std::initializer_list<Bytes> pieces) {
  Bytes out;
  for (const Bytes& one : pieces) out.insert(out.end(), one.begin(), one.end());
  return out;
}

template <class Message>
Bytes frame_of(const Message& message, std::uint8_t system = 1) {
  FrameWriter writer(system, 1);
  const auto bytes = writer.write(message);
  return {bytes.begin(), bytes.end()};
}

// What it reads of these bytes, frame by frame, as the numbers of their messages.
std::vector<std::uint32_t> read_all(FrameReader& reader, std::span<const std::byte> bytes) {
  std::vector<std::uint32_t> out;
  reader.feed(bytes);
  while (const auto frame = reader.next()) out.push_back(frame->id);
  return out;
}

// A message whose bytes are these, as far as it has any.
template <class Message>
Message message_of(const Bytes& bytes) {
  return read_payload<Message>(bytes);
}

Bytes any_bytes(std::size_t most) {
  const auto values =
      *rc::gen::resize(static_cast<int>(most), rc::gen::arbitrary<std::vector<std::uint8_t>>());
  Bytes out(values.size());
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = static_cast<std::byte>(values[i]);
  return out;
}

TEST(Messages, HaveTheFieldsThatTheDictionaryHas) {
  const auto length = [](auto message) {
    return std::apply([](const auto&... field) { return (sizeof(field) + ...); }, base::fields_of(message));
  };
  EXPECT_EQ(length(Heartbeat{}), 9U);
  EXPECT_EQ(length(SysStatus{}), 31U) << "its extensions are not read";
  EXPECT_EQ(length(ParamRequestRead{}), 20U);
  EXPECT_EQ(length(ParamValue{}), 25U);
  EXPECT_EQ(length(ParamSet{}), 23U);
  EXPECT_EQ(length(Attitude{}), 28U);
  EXPECT_EQ(length(LocalPositionNed{}), 28U);
  EXPECT_EQ(length(GlobalPositionInt{}), 28U);
  EXPECT_EQ(length(CommandLong{}), 33U);
  EXPECT_EQ(length(CommandAck{}), 10U);
  EXPECT_EQ(length(SetPositionTargetLocalNed{}), 53U);
  EXPECT_EQ(length(DistanceSensor{}), 39U);
  EXPECT_EQ(length(BatteryStatus{}), 36U) << "its extensions are not read";
  EXPECT_EQ(length(StatusText{}), 54U);
  EXPECT_EQ(length(ObstacleDistance{}), 167U);
}

TEST(Frames, AreTheBytesThatOtherImplementationsWrite) {
  // Checksum of "123456789", as catalogues of CRCs have it, before CRC_EXTRA.
  std::uint16_t crc = 0xffff;
  const Bytes text = bytes_of({'1', '2', '3', '4', '5', '6', '7', '8'});
  crc = checksum(text, '9');
  EXPECT_EQ(crc, 0x6f91);
  Heartbeat heartbeat;
  heartbeat.type = 6;
  heartbeat.autopilot = 8;
  heartbeat.system_status = 4;
  FrameWriter writer(255, 190);
  const auto frame = writer.write(heartbeat);
  const Bytes begin = bytes_of({0xfd, 9, 0, 0, 0, 255, 190, 0, 0, 0, 0, 0, 0, 0, 6, 8, 0, 4, 3});
  EXPECT_EQ(Bytes(frame.begin(), frame.end() - 2), begin);
  EXPECT_EQ(writer.write(heartbeat)[4], std::byte{1}) << "they are numbered";
}

TEST(Frames, CutZerosAtTheEndAndHaveThemBack) {
  const Bytes zeros = frame_of(LocalPositionNed{});
  EXPECT_EQ(zeros[1], std::byte{1}) << "one byte stays";
  LocalPositionNed position;
  position.y = 2.5F;
  const Bytes frame = frame_of(position);
  EXPECT_EQ(frame[1], std::byte{12});
  FrameReader reader;
  reader.feed(frame);
  const auto read = reader.next();
  ASSERT_TRUE(read && read->is<LocalPositionNed>());
  EXPECT_EQ(read->as<LocalPositionNed>().y, 2.5F);
  EXPECT_EQ(read->as<LocalPositionNed>().vz, 0.0F);
}

TEST(Frames, OfMoreBytesThanAreKnownAreReadAsFarAsTheyAreKnown) {
  Bytes frame = bytes_of({0xfd, 12, 0, 0, 0, 1, 1, 0, 0, 0, 15, 0, 0, 0, 10, 3, 128, 4, 3, 7, 8, 9});
  wire::put(frame, checksum(std::span(frame).subspan(1), Heartbeat::kInfo.extra));
  FrameReader reader;
  reader.feed(frame);
  const auto read = reader.next();
  ASSERT_TRUE(read);
  EXPECT_EQ(read->as<Heartbeat>().custom_mode, 15U);
  EXPECT_EQ(read->as<Heartbeat>().mavlink_version, 3U);
}

TEST(FrameReader, FindsTheNextFrameBehindWhatIsNone) {
  FrameReader reader;
  const Bytes heartbeat = frame_of(Heartbeat{});
  Bytes wrong = heartbeat;
  wrong[12] ^= std::byte{1};
  const Bytes junk = bytes_of({1, 2, 0xfd, 3});
  EXPECT_EQ(read_all(reader, joined({junk, heartbeat, wrong, heartbeat})),
            (std::vector<std::uint32_t>{0, 0}));
  EXPECT_EQ(reader.refusals().wrong_checksums, 1U);
  EXPECT_EQ(reader.refusals().skipped_bytes, 4 + wrong.size());
}

TEST(FrameReader, PassesOverWholeFramesThatAreNoneOfOurs) {
  // A message of number 1000 whose payload is a frame of ours: whoever makes vehicles repeat something does
  // not speak by it.
  const Bytes inner = frame_of(Heartbeat{});
  Bytes outer = bytes_of({0xfd, static_cast<int>(inner.size()), 0, 0, 0, 1, 1, 0xe8, 3, 0});
  outer = joined({outer, inner, bytes_of({0x12, 0x34})});
  FrameReader reader;
  EXPECT_EQ(read_all(reader, joined({outer, frame_of(Attitude{})})), (std::vector<std::uint32_t>{30}));
  EXPECT_EQ(reader.refusals().unknown, 1U);
}

TEST(FrameReader, TellsFramesOfTheOldVersion) {
  Bytes frame = bytes_of({0xfe, 9, 0, 1, 1, 0, 0, 0, 0, 0, 10, 3, 0, 4, 3});
  wire::put(frame, checksum(std::span(frame).subspan(1), Heartbeat::kInfo.extra));
  FrameReader reader;
  EXPECT_EQ(read_all(reader, joined({frame, frame_of(Heartbeat{})})), (std::vector<std::uint32_t>{0}));
  EXPECT_EQ(reader.refusals().version_1, 1U);
}

TEST(FrameReader, AcceptsNothingThatAsksForMoreThanItUnderstands) {
  Bytes frame = frame_of(Heartbeat{});
  frame[2] = std::byte{2};
  frame.resize(frame.size() - 2);
  wire::put(frame, checksum(std::span(frame).subspan(1), Heartbeat::kInfo.extra));
  FrameReader reader;
  EXPECT_TRUE(read_all(reader, frame).empty());
}

template <class Message>
void check_round_trip() {
  const Message message = message_of<Message>(any_bytes(200));
  Bytes payload;
  write_payload(message, payload);
  const Message again = message_of<Message>(payload);
  Bytes twice;
  write_payload(again, twice);
  // By bytes: what is no number is not equal to itself.
  RC_ASSERT(payload == twice);
  FrameReader reader;
  reader.feed(frame_of(message, 7));
  const auto frame = reader.next();
  RC_ASSERT(frame.has_value());
  RC_ASSERT(frame->id == Message::kInfo.id && frame->system == 7);
  RC_ASSERT(std::equal(frame->payload.begin(), frame->payload.end(), payload.begin(), payload.end()));
  RC_ASSERT(!reader.next().has_value());
}

TEST(FrameLaws, EveryMessageComesBackAsItWas) {
  EXPECT_TRUE(rc::check("read(write(message)) == message", [] {
    std::apply([](auto... one) { (check_round_trip<decltype(one)>(), ...); }, Messages{});
  }));
}

TEST(FrameLaws, FramesAreTheSameInWhateverPiecesTheyCome) {
  EXPECT_TRUE(rc::check("pieces", [] {
    Bytes stream;
    for (int i = 0; i < 5; ++i) {
      stream = joined({stream, any_bytes(20), frame_of(message_of<ObstacleDistance>(any_bytes(180)))});
    }
    FrameReader whole;
    const auto expected = read_all(whole, stream);
    FrameReader pieces;
    std::vector<std::uint32_t> found;
    for (std::span<const std::byte> rest = stream; !rest.empty();) {
      const std::size_t size = std::min(rest.size(), *rc::gen::inRange<std::size_t>(1, 100));
      for (const std::uint32_t id : read_all(pieces, rest.first(size))) found.push_back(id);
      rest = rest.subspan(size);
    }
    RC_ASSERT(found == expected);
  }));
}

TEST(FrameLaws, AnyBytesAreSurvivedAndFramesBehindThemFound) {
  EXPECT_TRUE(rc::check("garbage", [] {
    FrameReader reader;
    read_all(reader, any_bytes(600));
    // What looked like a frame's begin ends at most 280 bytes later.
    read_all(reader, Bytes(280));
    RC_ASSERT(read_all(reader, frame_of(Heartbeat{})) == std::vector<std::uint32_t>{0});
  }));
}

}  // namespace
}  // namespace mlab::mavlink
