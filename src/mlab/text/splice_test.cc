#include "mlab/text/splice.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace mlab::text {
namespace {

TEST(Splice, IsAsShortAsTheDifference) {
  EXPECT_EQ(difference("PP a 1 2", "PP a 7 2"), (Splice{{5, 6}, "7"}));
  EXPECT_EQ(difference("aa", "aaa"), (Splice{{2, 2}, "a"}));
  EXPECT_EQ(difference("same", "same"), (Splice{{4, 4}, ""}));
}

RC_GTEST_PROP(Splice, MakesOneTextOfAnother, (const std::string& before, const std::string& after)) {
  RC_ASSERT(spliced(before, difference(before, after)) == after);
}

}  // namespace
}  // namespace mlab::text
