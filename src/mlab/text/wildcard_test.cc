#include "mlab/text/wildcard.h"

#include <gtest/gtest.h>

namespace mlab::text {
namespace {

TEST(Wildcard, StandsForAnyNumberOfCharacters) {
  EXPECT_TRUE(matches("movement.avoid.gain", "movement.*"));
  EXPECT_TRUE(matches("movement.avoid.gain", "*.gain"));
  EXPECT_TRUE(matches("movement.avoid.gain", "m*avoid*"));
  EXPECT_TRUE(matches("movement.", "movement.*"));
  EXPECT_TRUE(matches("", "*"));
}

TEST(Wildcard, IsNoPartOfAWord) {
  EXPECT_FALSE(matches("movement", "movement.*"));
  EXPECT_FALSE(matches("movement.gain", "movement"));
  EXPECT_FALSE(matches("movement.gain", "*.gai"));
  EXPECT_FALSE(matches("", "a*"));
  EXPECT_TRUE(matches("", ""));
}

TEST(Wildcard, GoesBackToAnEarlierStarOnlyAsFarAsNeeded) {
  EXPECT_TRUE(matches("aXbXc", "a*X*c"));
  EXPECT_TRUE(matches("abcabd", "*abd"));
}

}  // namespace
}  // namespace mlab::text
