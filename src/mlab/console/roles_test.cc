#include "mlab/console/roles.h"

#include <gtest/gtest.h>

#include "mlab/console.pb.h"

namespace mlab::console {
namespace {

TEST(Roles, TheFirstWhoComesIsTheOperator) {
  Roles roles;
  const auto a = roles.join({1}, "Anna", "ka", 0.0).client;
  const auto b = roles.join({2}, "Ben", "kb", 1.0).client;
  EXPECT_TRUE(roles.is_operator(a));
  EXPECT_FALSE(roles.is_operator(b));
  EXPECT_EQ(roles.of({2})->name, "Ben");
}

TEST(Roles, WhoComesBackWithinAMinuteIsTheSameClientAndStillTheOperator) {
  Roles roles;
  const auto a = roles.join({1}, "Anna", "ka", 0.0).client;
  roles.join({2}, "Ben", "kb", 0.0);
  ASSERT_TRUE(roles.leave({1}, 10.0));
  EXPECT_FALSE(roles.forget(69.0));
  EXPECT_EQ(roles.join({3}, "Anna", "ka", 69.0).client, a);
  EXPECT_TRUE(roles.is_operator(a));
}

TEST(Roles, AfterAMinuteThePlaceIsFreeAndTheNextOneWhoComesGetsIt) {
  Roles roles;
  roles.join({1}, "Anna", "ka", 0.0);
  roles.leave({1}, 10.0);
  EXPECT_EQ(roles.next_to_forget(), 70.0);
  EXPECT_TRUE(roles.forget(70.0));
  EXPECT_EQ(roles.operator_id(), 0U);
  EXPECT_TRUE(roles.is_operator(roles.join({2}, "Ben", "kb", 71.0).client));
}

TEST(Roles, TheHolderIsAskedAndGivesOrDeclines) {
  Roles roles;
  const auto a = roles.join({1}, "Anna", "ka", 0.0).client;
  const auto b = roles.join({2}, "Ben", "kb", 0.0).client;
  EXPECT_FALSE(roles.take(b));
  EXPECT_EQ(roles.asks(), b);
  EXPECT_FALSE(roles.pass(a, 0).has_value());
  EXPECT_EQ(roles.asks(), 0U);
  EXPECT_TRUE(roles.is_operator(a));
  roles.take(b);
  EXPECT_FALSE(roles.pass(a, b).has_value());
  EXPECT_TRUE(roles.is_operator(b));
  EXPECT_TRUE(roles.pass(a, a).has_value()) << "no longer the operator";
  EXPECT_TRUE(roles.pass(b, 99).has_value()) << "nobody of that number";
}

TEST(Roles, ThePlaceIsGivenAtOnceWhereItsHolderHasLeft) {
  Roles roles;
  roles.join({1}, "Anna", "ka", 0.0);
  const auto b = roles.join({2}, "Ben", "kb", 0.0).client;
  roles.leave({1}, 1.0);
  EXPECT_TRUE(roles.take(b));
  EXPECT_TRUE(roles.is_operator(b));
}

TEST(Roles, WhoAsksGetsThePlaceWhenItsHolderLeavesWithoutAnAnswer) {
  Roles roles;
  roles.join({1}, "Anna", "ka", 0.0);
  const auto b = roles.join({2}, "Ben", "kb", 0.0).client;
  roles.take(b);
  roles.leave({1}, 1.0);
  EXPECT_TRUE(roles.is_operator(b));
  EXPECT_EQ(roles.asks(), 0U);
}

TEST(Roles, ADuplicatedTabTakesThePlaceAndTheOldOneIsSomebodyElse) {
  Roles roles;
  const auto a = roles.join({1}, "Anna", "ka", 0.0).client;
  const Roles::Joined again = roles.join({2}, "Anna", "ka", 1.0);
  EXPECT_EQ(again.client, a);
  EXPECT_EQ(again.displaced, ConnectionId{1});
  ASSERT_NE(roles.of({1}), nullptr);
  EXPECT_NE(roles.of({1})->id, a);
}

TEST(Roles, TellsWhoIsThere) {
  Roles roles;
  roles.join({1}, "Anna", "ka", 0.0);
  roles.join({2}, "", "", 0.0);
  roles.leave({2}, 1.0);
  Clients out;
  roles.encode(out);
  ASSERT_EQ(out.clients_size(), 2);
  EXPECT_EQ(out.operator_(), 1U);
  EXPECT_EQ(out.clients(1).name(), "Browser 2");
  EXPECT_FALSE(out.clients(1).is_connected());
}

}  // namespace
}  // namespace mlab::console
