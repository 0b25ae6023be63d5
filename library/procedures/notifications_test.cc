#include <algorithm>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "../testing/library_probe.h"
#include "mlab/base/hash.h"

namespace mlab::library_test {
namespace {

using percept::Audience;
using Kind = percept::Request::Kind;

TEST(Notify, TellsOnceEachTimeItStarts) {
  for (const char* name : {"Notify", "NotifyTeam", "NotifySelf"}) {
    flow::BehaviorProbe p = probe(name);
    p.set_text("message", "Enemy found.");
    p.step();
    ASSERT_EQ(p.action.request_count, 1);
    EXPECT_EQ(p.action.requests[0].kind, Kind::kNotify);
    EXPECT_EQ(p.action.requests[0].notification, base::hash_text("Enemy found."));
    p.step();
    EXPECT_EQ(p.action.request_count, 0);
    p.skip();
    p.step();
    EXPECT_EQ(p.action.request_count, 1);
  }
}

TEST(Notify, ReachesWhomItsNameSays) {
  for (const auto& [name, audience] :
       {std::pair("Notify", Audience::kAll), std::pair("NOTIFY_ROBOTS", Audience::kAll),
        std::pair("NotifyTeam", Audience::kTeam), std::pair("NotifySelf", Audience::kSelf),
        std::pair("NOTIFY", Audience::kSelf)}) {
    flow::BehaviorProbe p = probe(name);
    p.set_text("message", "Enemy found.");
    p.step();
    ASSERT_EQ(p.action.request_count, 1);
    EXPECT_EQ(p.action.requests[0].audience, audience);
  }
}

std::vector<std::uint64_t> arrived() {
  std::vector<std::uint64_t> out = {base::hash_text("a"), base::hash_text("b"), base::hash_text("c")};
  std::ranges::sort(out);
  return out;
}

TEST(NotifiedOnce, HearsItsOwnMessageOnlyAndTakesIt) {
  const std::vector<std::uint64_t> inbox = arrived();
  for (const char* name : {"NotifiedOnce", "NOTIFIED_ONCE", "Notified"}) {
    flow::BehaviorProbe p = probe(name);
    p.percepts.notifications = inbox;
    p.set_text("message", "d").step();
    EXPECT_FALSE(p.output<bool>());
    EXPECT_EQ(p.action.request_count, 0);
    p.set_text("message", "b").step();
    EXPECT_TRUE(p.output<bool>());
    ASSERT_EQ(p.action.request_count, 1);
    EXPECT_EQ(p.action.requests[0].kind, Kind::kTakeNotification);
    EXPECT_EQ(p.action.requests[0].notification, base::hash_text("b"));
    p.percepts.notifications = {};
    p.action = {};
    p.step();
    EXPECT_FALSE(p.output<bool>());
    EXPECT_EQ(p.action.request_count, 0);
  }
}

TEST(IsNotified, LeavesTheNotificationWhereItIs) {
  const std::vector<std::uint64_t> inbox = arrived();
  flow::BehaviorProbe p = probe("IsNotified");
  p.percepts.notifications = inbox;
  p.set_text("message", "c").step();
  EXPECT_TRUE(p.output<bool>());
  EXPECT_EQ(p.action.request_count, 0);
  p.set_text("message", "d").step();
  EXPECT_FALSE(p.output<bool>());
}

}  // namespace
}  // namespace mlab::library_test
