#include "mlab/mavlink/firmware.h"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "mlab/mavlink/testing/drive.h"

namespace mlab::mavlink {
namespace {

using testing::Pair;
using vehicle::Check;
using enum vehicle::CheckResult;

Check firmware_of(Pair& pair) {
  for (const Check& one : pair.device->checks(pair.now)) {
    if (one.name == "firmware") return one;
  }
  return {};
}

auto questions_to(const Pair& pair) {
  return std::ranges::count_if(pair.rover.commands, [](const CommandLong& one) {
    return one.command == kRequestMessage && one.params[0] == static_cast<float>(AutopilotVersion::kInfo.id);
  });
}

TEST(Firmware, IsReadByItsBytes) {
  EXPECT_EQ(version_text(0x040507ff), "4.5.7");
  EXPECT_EQ(version_text(0x040600c1), "4.6.0-rc");
  EXPECT_EQ(version_text(0x04070080), "4.7.0-beta");
  EXPECT_EQ(version_text(0x04070040), "4.7.0-alpha");
  EXPECT_EQ(version_text(0xffffff00), "255.255.255-dev");
}

TEST(Firmware, IsAskedForOnceWhereTheRoverTells) {
  Pair pair;
  EXPECT_EQ(firmware_of(pair), (Check{"firmware", kUnknown, "has not told its version yet", ""}));
  pair.pass(3.0);
  EXPECT_EQ(firmware_of(pair), (Check{"firmware", kPass, "is ArduPilot 4.5.7, revision 9c2f1e4a", ""}));
  pair.pass(30.0);
  EXPECT_EQ(questions_to(pair), 1);
}

TEST(Firmware, IsAskedForAgainWhereTheQuestionGetsLost) {
  Pair pair;
  pair.link.random = base::Random(3);
  pair.link.loss = 0.5;
  pair.pass(60.0);
  EXPECT_EQ(firmware_of(pair).is, "is ArduPilot 4.5.7, revision 9c2f1e4a");
}

TEST(Firmware, OfARoverThatDoesNotTellIsNotKnown) {
  using Version = decltype(testing::ToyRover::version);
  for (const Version version : {Version::kUnsupported, Version::kMute}) {
    Pair pair;
    pair.rover.version = version;
    pair.pass(10.0);
    EXPECT_EQ(firmware_of(pair), (Check{"firmware", kUnknown, "does not tell its version", ""}));
    const auto before = questions_to(pair);
    EXPECT_LE(before, 6);
    pair.pass(30.0);
    EXPECT_LE(questions_to(pair), before + 3) << "it is asked now and then";
    pair.rover.version = Version::kTold;  // of another one, say
    pair.pass(11.0);
    EXPECT_EQ(firmware_of(pair).result, kPass);
    EXPECT_EQ(pair.why(), "is not armed") << "nothing else depends on it";
  }
}

TEST(Firmware, IsAskedForAnewWhereTheRoverHasBegunAgain) {
  Pair pair;
  pair.pass(10.0);
  pair.rover.version = testing::ToyRover::Version::kMute;
  pair.rover.restart(pair.now);
  pair.pass(2.0);
  EXPECT_EQ(firmware_of(pair).is, "has not told its version yet");
}

}  // namespace
}  // namespace mlab::mavlink
