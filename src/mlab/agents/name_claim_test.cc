#include "mlab/agents/name_claim.h"

#include <unistd.h>

#include <string>

#include <gtest/gtest.h>

namespace mlab::agents {
namespace {

TEST(NameClaim, HoldsANameUntilItGoes) {
  const std::string fleet = "claims-" + std::to_string(::getpid());
  {
    const NameClaim first(fleet, "north");
    EXPECT_FALSE(first.is_taken());
    EXPECT_TRUE(NameClaim(fleet, "north").is_taken());
    EXPECT_TRUE(NameClaim(fleet, "north").is_taken()) << "who asks does not take it away";
    EXPECT_FALSE(NameClaim(fleet, "south").is_taken());
    EXPECT_FALSE(NameClaim(fleet + "2", "north").is_taken());
  }
  EXPECT_FALSE(NameClaim(fleet, "north").is_taken());
}

}  // namespace
}  // namespace mlab::agents
