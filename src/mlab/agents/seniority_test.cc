#include "mlab/agents/seniority.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace mlab::agents {
namespace {

Claimant claimant(std::uint8_t number, double uptime) {
  Claimant out;
  out.guid.bytes[0] = number;
  out.uptime = uptime;
  return out;
}

TEST(Seniority, WhoHasBeenThereForLongerKeepsTheName) {
  EXPECT_TRUE(keeps_name(claimant(9, 3600.0), claimant(1, 5.0)));
  EXPECT_FALSE(keeps_name(claimant(1, 5.0), claimant(9, 3600.0)));
}

TEST(Seniority, OfTwoThatBeganAtOnceTheNumberDecidesWhateverMessagesTake) {
  EXPECT_TRUE(keeps_name(claimant(1, 10.0), claimant(2, 12.0)));
  EXPECT_FALSE(keeps_name(claimant(2, 12.0), claimant(1, 10.0)));
}

RC_GTEST_PROP(Seniority, ExactlyOneOfTwoKeepsTheName, (std::uint8_t one, std::uint8_t other)) {
  RC_PRE(one != other);
  const double uptime = *rc::gen::inRange(0, 20000) / 100.0;
  const double others = *rc::gen::inRange(0, 20000) / 100.0;
  RC_ASSERT(keeps_name(claimant(one, uptime), claimant(other, others)) !=
            keeps_name(claimant(other, others), claimant(one, uptime)));
}

}  // namespace
}  // namespace mlab::agents
