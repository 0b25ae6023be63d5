#include "mlab/mavlink/signing.h"

#include <string>

#include <gtest/gtest.h>

#include "mlab/mavlink/frame.h"

namespace mlab::mavlink {
namespace {

constexpr SigningTime kNow = 30'000'000'000'000;
constexpr SigningTime kSecond = 100'000;

Key key() {
  return *parse_key("passphrase:correct horse");
}

// What a reader makes of one signed frame more.
bool is_accepted(FrameReader& reader, std::span<const std::byte> frame) {
  reader.feed(frame);
  return reader.next(kNow).has_value();
}

std::vector<std::byte> signed_frame(SigningTime time, std::uint8_t link = 0, const Key& by = key()) {
  Signatures signatures(by);
  FrameWriter writer(1, 1, &signatures, link);
  const auto frame = writer.write(Heartbeat{}, time);
  return {frame.begin(), frame.end()};
}

TEST(MavlinkKey, IsReadAsDigitsOrMadeOfAPassphrase) {
  const auto digits = parse_key(std::string(62, '0') + "fF");
  ASSERT_TRUE(digits);
  EXPECT_EQ((*digits)[31], std::byte{0xff});
  // SHA-256 of "abc", as its standard has it.
  EXPECT_EQ((*parse_key("passphrase:abc"))[0], std::byte{0xba});
  EXPECT_EQ((*parse_key("passphrase:abc"))[31], std::byte{0xad});
  const auto wrong = parse_key("secret");
  ASSERT_FALSE(wrong);
  EXPECT_EQ(
      wrong.error().message,
      "a key of 6 characters (not shown); expected 64 hexadecimal digits, or `passphrase:` and a passphrase");
  EXPECT_FALSE(parse_key(std::string(64, 'g')));
  EXPECT_FALSE(parse_key("passphrase:"));
}

TEST(Signing, AcceptsWhatWasSignedWithTheKey) {
  Signatures signatures(key());
  FrameReader reader(&signatures);
  EXPECT_TRUE(is_accepted(reader, signed_frame(kNow)));
  EXPECT_TRUE(is_accepted(reader, signed_frame(kNow + 1)));
}

TEST(Signing, RefusesWhatIsNotSignedOrWithAnotherKey) {
  Signatures signatures(key());
  FrameReader reader(&signatures);
  FrameWriter writer(1, 1);
  EXPECT_FALSE(is_accepted(reader, writer.write(Heartbeat{})));
  EXPECT_FALSE(is_accepted(reader, signed_frame(kNow, 0, *parse_key("passphrase:another"))));
  auto changed = signed_frame(kNow);
  changed.back() ^= std::byte{1};
  EXPECT_FALSE(is_accepted(reader, changed));
  EXPECT_EQ(reader.refusals().not_signed, 1U);
  EXPECT_EQ(reader.refusals().wrong_signatures, 2U);
}

TEST(Signing, RefusesWhatWasHeardBefore) {
  Signatures signatures(key());
  FrameReader reader(&signatures);
  const auto frame = signed_frame(kNow);
  EXPECT_TRUE(is_accepted(reader, frame));
  EXPECT_FALSE(is_accepted(reader, frame));
  EXPECT_FALSE(is_accepted(reader, signed_frame(kNow - 1)));
  EXPECT_TRUE(is_accepted(reader, signed_frame(kNow - 1, 3))) << "each link has times of its own";
  EXPECT_EQ(reader.refusals().replayed, 2U);
}

TEST(Signing, LetsANewSenderBeAMinuteBehind) {
  Signatures signatures(key());
  FrameReader reader(&signatures);
  EXPECT_FALSE(is_accepted(reader, signed_frame(kNow - 61 * kSecond)));
  EXPECT_TRUE(is_accepted(reader, signed_frame(kNow - 59 * kSecond)));
}

TEST(Signing, SignsWithTimesThatGrowWhateverTheClockSays) {
  Signatures signatures(key());
  const SigningTime first = signatures.next_time(kNow);
  EXPECT_EQ(first, kNow);
  EXPECT_EQ(signatures.next_time(kNow), kNow + 1);
  EXPECT_EQ(signatures.next_time(kNow - kSecond), kNow + 2);
  FrameReader reader(&signatures);
  EXPECT_TRUE(is_accepted(reader, signed_frame(kNow + kSecond)));
  EXPECT_EQ(signatures.next_time(kNow), kNow + kSecond + 1) << "later than who was heard";
}

TEST(Signing, WithoutAKeySignedFramesAreReadAsOthers) {
  FrameReader reader;
  reader.feed(signed_frame(kNow));
  const auto frame = reader.next();
  ASSERT_TRUE(frame);
  EXPECT_TRUE(frame->is_signed);
}

TEST(Signing, TakesTheTimeSince2015) {
  // 2026 began 347155200 s after 2015.
  EXPECT_GT(signing_time_now(), SigningTime{347'155'200} * kSecond);
}

}  // namespace
}  // namespace mlab::mavlink
