#include "mlab/percept/action.h"

#include <gtest/gtest.h>

namespace mlab::percept {
namespace {

Request request(Request::Kind kind, std::uint64_t notification = 0) {
  Request out;
  out.kind = kind;
  out.notification = notification;
  return out;
}

Action busy() {
  Action out;
  out.velocity = {1.0, 2.0, 3.0};
  out.spin = 0.5;
  out.drives = out.spins = out.looks = true;
  out.pan = 0.25;
  out.status = {7, true, 12.0};
  out.ask(request(Request::Kind::kNotify, 5));
  out.ask(request(Request::Kind::kHalt));
  out.alert[0] = 'a';
  out.alert[1] = 'b';
  return out;
}

void expect_same(const Action& a, const Action& b) {
  EXPECT_EQ(a.velocity, b.velocity);
  EXPECT_EQ(a.spin, b.spin);
  EXPECT_EQ(a.drives, b.drives);
  EXPECT_EQ(a.spins, b.spins);
  EXPECT_EQ(a.pan, b.pan);
  EXPECT_EQ(a.looks, b.looks);
  EXPECT_EQ(a.status.sequence, b.status.sequence);
  EXPECT_EQ(a.status.done, b.status.done);
  EXPECT_EQ(a.status.remaining, b.status.remaining);
  ASSERT_EQ(a.request_count, b.request_count);
  for (std::size_t i = 0; i < a.request_count; ++i) {
    EXPECT_EQ(a.requests[i].kind, b.requests[i].kind);
    EXPECT_EQ(a.requests[i].notification, b.requests[i].notification);
  }
  EXPECT_EQ(a.alert, b.alert);
}

TEST(Action, BecomesAnotherOneByAllThatCounts) {
  Action action;
  action.become(busy());
  expect_same(action, busy());
  Action other;
  other.ask(request(Request::Kind::kPickUp));
  action.become(other);
  expect_same(action, other);
}

TEST(Action, ThatIsClearedDoesNothing) {
  Action action = busy();
  action.clear();
  expect_same(action, {});
  action.ask(request(Request::Kind::kClaim));
  EXPECT_EQ(action.request_count, 1);
  EXPECT_EQ(action.requests[0].kind, Request::Kind::kClaim);
}

}  // namespace
}  // namespace mlab::percept
