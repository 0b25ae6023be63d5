#include "mlab/console/server/token.h"

#include <gtest/gtest.h>

namespace mlab::console {
namespace {

TEST(Token, Has160BitsThatDifferEachTime) {
  const std::string token = make_token();
  EXPECT_EQ(token.size(), 40U);
  EXPECT_EQ(token.find_first_not_of("0123456789abcdef"), std::string::npos);
  EXPECT_NE(token, make_token());
}

TEST(Token, OnlyTheWholeTokenIsTheToken) {
  EXPECT_TRUE(is_same_token("abcd", "abcd"));
  for (const char* wrong : {"", "a", "abc", "abce", "xbcd", "abcdd", "ABCD"})
    EXPECT_FALSE(is_same_token(wrong, "abcd")) << wrong;
}

}  // namespace
}  // namespace mlab::console
