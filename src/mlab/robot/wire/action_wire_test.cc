#include "mlab/robot/wire/action_wire.h"

#include <string>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "mlab/robot/wire/testing/any_value.h"
#include "mlab/robot/wire/testing/same_bits.h"

namespace mlab::robot_wire {
namespace {

TEST(ActionWire, KeepsEveryBitOfWhatARobotDoes) {
  wire::Action message;
  EXPECT_TRUE(rc::check("decode(encode(action)) == action", [&] {
    const percept::Action action = testing::any_action();
    encode(action, message);
    wire::Action arrived;
    RC_ASSERT(arrived.ParseFromString(message.SerializeAsString()));
    percept::Action decoded = testing::any_action();  // nothing of it may stay
    RC_ASSERT(!decode(arrived, decoded));
    RC_ASSERT(testing::same(decoded, action));
  }));
}

TEST(ActionWire, RefusesRequestsThatThereAreNot) {
  wire::Action message;
  message.add_requests()->set_kind(static_cast<wire::Request::Kind>(22));
  percept::Action action;
  EXPECT_EQ(decode(message, action), "an action makes a request that there is not");
  message.mutable_requests(0)->set_kind(wire::Request::NOTIFY);
  message.mutable_requests(0)->set_audience(static_cast<wire::Request::Audience>(3));
  EXPECT_EQ(decode(message, action), "a request is for an audience that there is not");
  message.mutable_requests(0)->set_audience(wire::Request::SELF);
  message.mutable_requests(0)->set_object_class(static_cast<wire::ObjectClass>(11));
  EXPECT_EQ(decode(message, action), "a request is about a class that there is not");
  message.Clear();
  for (int i = 0; i < percept::Action::kMaxRequests; ++i) message.add_requests();
  EXPECT_FALSE(decode(message, action));
  EXPECT_EQ(action.request_count, percept::Action::kMaxRequests);
  message.add_requests();
  EXPECT_EQ(decode(message, action), "an action makes too many requests");
}

TEST(ActionWire, EndsAnAlertAtItsFirstZero) {
  wire::Action message;
  message.set_alert(std::string("fire\0smoke", 10));
  percept::Action action;
  ASSERT_FALSE(decode(message, action));
  wire::Action again;
  encode(action, again);
  EXPECT_EQ(again.alert(), "fire");
  percept::Action decoded_again;
  ASSERT_FALSE(decode(again, decoded_again));
  EXPECT_TRUE(testing::same(action, decoded_again));
}

}  // namespace
}  // namespace mlab::robot_wire
