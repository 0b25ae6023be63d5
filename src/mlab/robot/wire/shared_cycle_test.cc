#include "mlab/robot/wire/shared_cycle.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "mlab/robot/wire/testing/any_value.h"
#include "mlab/robot/wire/testing/same_bits.h"

namespace mlab::robot_wire {
namespace {

using percept::Action;
using percept::Request;
using Bytes = std::array<std::byte, sizeof(Action)>;

TEST(SharedAction, KeepsEveryBitWhateverStoodThereBefore) {
  Bytes bytes{};
  EXPECT_TRUE(rc::check("read(write(action)) == action", [&] {
    const Action action = testing::any_action();
    write_action(action, bytes);
    Action read = testing::any_action();  // nothing of it may stay
    RC_ASSERT(read_action(bytes, read));
    RC_ASSERT(testing::same(read, action));
  }));
}

TEST(SharedAction, OfAnyBytesHasOnlyFieldsThatThereAre) {
  EXPECT_TRUE(rc::check("what is read can be written and read", [] {
    Bytes bytes;
    for (std::byte& byte : bytes) byte = std::byte{*rc::gen::arbitrary<std::uint8_t>()};
    bytes[offsetof(Action, request_count)] = std::byte{*rc::gen::inRange<std::uint8_t>(0, 8)};
    const bool are_kinds_sound = *rc::gen::arbitrary<bool>();
    for (int i = 0; are_kinds_sound && i < Action::kMaxRequests; ++i) {
      const std::size_t at = offsetof(Action, requests) + static_cast<std::size_t>(i) * sizeof(Request);
      bytes[at + offsetof(Request, kind)] = std::byte{*rc::gen::inRange<std::uint8_t>(0, 15)};
      bytes[at + offsetof(Request, audience)] = std::byte{0};
      bytes[at + offsetof(Request, object_class)] = std::byte{1};
    }
    Action read;
    const bool is_sound = read_action(bytes, read);
    RC_CLASSIFY(is_sound, "sound");
    if (!is_sound) RC_SUCCEED("refused");
    RC_ASSERT(read.alert.back() == 0);
    RC_ASSERT(read.request_count <= Action::kMaxRequests);
    Bytes again{};
    write_action(read, again);
    Action read_again;
    RC_ASSERT(read_action(again, read_again));
    RC_ASSERT(testing::same(read, read_again));
  }));
}

TEST(SharedAction, RefusesRequestsThatThereAreNot) {
  Action action;
  for (int i = 0; i < Action::kMaxRequests; ++i) ASSERT_TRUE(action.ask(Request{}));
  Bytes sound{};
  write_action(action, sound);
  Action read;
  ASSERT_TRUE(read_action(sound, read));
  const std::size_t last = offsetof(Action, requests) + 3 * sizeof(Request);
  for (const std::size_t at : {last + offsetof(Request, kind), last + offsetof(Request, audience),
                               last + offsetof(Request, object_class), offsetof(Action, request_count)}) {
    Bytes unsound = sound;
    unsound[at] = std::byte{200};
    EXPECT_FALSE(read_action(unsound, read)) << at;
  }
}

TEST(Looks, GiveUpWhereTheyDoNotPayAndAreTriedAgain) {
  Looks looks;
  const int most = looks.count();
  EXPECT_GT(most, 0);
  for (int i = 0; i < 20; ++i) looks.learn(looks.count());
  EXPECT_EQ(looks.count(), 0);
  int waits = 0;
  while (looks.count() == 0 && waits < 1000) {
    looks.learn(0);
    ++waits;
  }
  EXPECT_EQ(looks.count(), most);
  looks.learn(1);
  EXPECT_EQ(looks.count(), most) << "it has paid";
  looks.learn(most - 1);
  EXPECT_LT(looks.count(), most) << "to sleep would have been cheaper";
}

TEST(SharedNumber, IsSeenWithoutSleepingWhereItIsAlreadyAsWanted) {
  SharedNumber number;
  number.set(7);
  Looks looks;
  const auto is_seven = [](std::uint32_t at) { return at == 7; };
  EXPECT_TRUE(number.is_soon(is_seven, looks));
  while (looks.count() > 0) looks.learn(looks.count());
  EXPECT_TRUE(number.is_soon(is_seven, looks)) << "also where nobody looks any more";
  number.set(8);
  EXPECT_FALSE(number.is_soon(is_seven, looks));
}

}  // namespace
}  // namespace mlab::robot_wire
