#include <cmath>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "mlab/base/testing/processor_time.h"
#include "mlab/preflight/testing/yard.h"

namespace mlab::preflight {
namespace {

using testing::both_well;
using testing::checklist;
using testing::signature;

std::vector<VehicleFacts> without_link() {
  auto out = both_well();
  out[0].link.reset();
  return out;
}

TEST(Signing, WantsANameAndAllThatAPersonConfirms) {
  EXPECT_EQ(why_not_signed(checklist(), signature()), "");
  Signature nobody = signature();
  nobody.by = " ";
  EXPECT_EQ(why_not_signed(checklist(), nobody), "it is signed with a name, and there is none");
  Signature hasty = signature();
  hasty.confirmed.pop_back();
  EXPECT_EQ(why_not_signed(checklist(), hasty).find("`hardware-sound` is not confirmed: "), 0U);
}

TEST(Signing, WantsEachFailureAcceptedWithAReason) {
  const Checklist failed = checklist(without_link());
  Signature by = signature();
  EXPECT_EQ(why_not_signed(failed, by), "`veh-1/link` has failed: `veh-1`, link: has answered no question");
  by.accepted = {{"veh-1/link", ""}};
  EXPECT_EQ(why_not_signed(failed, by), "`veh-1/link` is accepted without a reason");
  by.accepted = {{"veh-1/link", "it is on the bench"}};
  EXPECT_EQ(why_not_signed(failed, by), "");
  by.accepted.push_back({"veh-2/link", "this one, too"});
  EXPECT_EQ(why_not_signed(failed, by), "`veh-2/link` has not failed, so there is nothing to accept");
  by.accepted.back().item = "veh-3/link";
  EXPECT_EQ(why_not_signed(failed, by), "there is no item `veh-3/link` that could be accepted");
}

TEST(SignedChecklist, HoldsForAnHour) {
  const SignedChecklist one = {checklist(), signature(5000.0)};
  EXPECT_EQ(why_it_does_not_hold(one, checklist(), 5000.0), "");
  EXPECT_EQ(why_it_does_not_hold(one, checklist(), 5000.0 + kHoldsFor), "");
  EXPECT_EQ(why_it_does_not_hold(one, checklist(), 5000.0 + 2.0 * kHoldsFor),
            "Ada signed it 120 minutes ago, and it holds for 60 minutes");
  EXPECT_NE(why_it_does_not_hold(one, checklist(), 3000.0), "") << "of a time that is yet to come";
  EXPECT_NE(why_it_does_not_hold({checklist(), signature(std::nan(""))}, checklist(), 5000.0), "");
}

TEST(SignedChecklist, HoldsForTheseTextsOnly) {
  const SignedChecklist one = {checklist(), signature()};
  Checklist now = checklist();
  now.digest = "0123456789abcdef";
  EXPECT_EQ(why_it_does_not_hold(one, now, 0.0),
            "the mission, or a file that it is made from, was changed since");
  now = checklist();
  now.fleet = "beta";
  EXPECT_EQ(why_it_does_not_hold(one, now, 0.0), "it is of the fleet `alpha`");
}

TEST(SignedChecklist, HoldsForTheseProcessesOnly) {
  const SignedChecklist one = {checklist(), signature()};
  auto facts = both_well();
  facts[1].session = "veh-2 started twice";
  EXPECT_EQ(why_it_does_not_hold(one, checklist(facts), 0.0),
            "the process of the vehicle `veh-2` was started anew since");
  facts.push_back(testing::well("veh-3", {8.0, 24.0}));
  EXPECT_NE(why_it_does_not_hold(one, checklist(facts), 0.0), "");
  facts = both_well();
  facts.pop_back();
  EXPECT_EQ(why_it_does_not_hold(one, checklist(facts), 0.0),
            "`veh-2` is no vehicle of the mission any more");
  facts.push_back({.name = "veh-2", .why_not_there = "has left the fleet"});
  EXPECT_EQ(why_it_does_not_hold(one, checklist(facts), 0.0), "the vehicle `veh-2` is not there any more");
}

TEST(SignedChecklist, DoesNotHoldWhenSomethingHasFailedSince) {
  const SignedChecklist one = {checklist(), signature()};
  EXPECT_EQ(why_it_does_not_hold(one, checklist(without_link()), 0.0),
            "`veh-1/link` has failed since: `veh-1`, link: has answered no question");
  SignedChecklist accepted = {checklist(without_link()), signature()};
  accepted.signature.accepted = {{"veh-1/link", "it is on the bench"}};
  EXPECT_EQ(why_it_does_not_hold(accepted, checklist(without_link()), 0.0), "");
  EXPECT_EQ(why_it_does_not_hold(accepted, checklist(), 0.0), "") << "it works again";
}

TEST(SignedChecklist, IsReadAsItWasWritten) {
  SignedChecklist one = {checklist(without_link()), signature(1772352000.25)};
  one.signature.accepted = {{"veh-1/link", "it is \"on\" the bench"}};
  const auto read = read_signed(json_of(one));
  ASSERT_TRUE(read);
  EXPECT_EQ(*read, one);
}

TEST(SignedChecklist, IsNotReadWhereItIsNotWhole) {
  const std::string whole = json_of(SignedChecklist{checklist(), signature()});
  EXPECT_FALSE(read_signed(json_of(checklist()))) << "nobody has signed";
  EXPECT_FALSE(read_signed(""));
  EXPECT_FALSE(read_signed("[]"));
  EXPECT_FALSE(read_signed(std::string(100'000, '[')));
  for (std::size_t i = 0; i < whole.size() - 2; i += 7 * base::kNextExample)
    EXPECT_FALSE(read_signed(whole.substr(0, i))) << i;
  for (const char* const of : {"\"is\"", "\"session\"", "\"confirmed\"", "\"warn\"", "\"format\": 1"}) {
    std::string other = whole;
    other.replace(other.find(of), std::string_view(of).size(), "\"format\": 2");
    EXPECT_FALSE(read_signed(other)) << of;
  }
}

}  // namespace
}  // namespace mlab::preflight
