#include "mlab/documents/merge.h"

#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace mlab::documents {
namespace {

TEST(Merged, TakesWhatEachSideChanged) {
  EXPECT_EQ(merged("a\nb\nc\n", "A\nb\nc\n", "a\nb\nC\n"), "A\nb\nC\n");
  EXPECT_EQ(merged("a\nb\nc\n", "a\nx\nc\n", "a\ny\nc\n"), std::nullopt);
  EXPECT_EQ(merged("a\nb\n", "a\nb\n", "a\nb\nc\n"), "a\nb\nc\n");
  EXPECT_EQ(merged("", "a\n", ""), "a\n");
  EXPECT_EQ(merged("a\nb\nc\nd\n", "a\nc\nd\n", "a\nb\nc\ne\nd\n"), "a\nc\ne\nd\n");
}

RC_GTEST_PROP(Merged, GivesOneSideWhereTheOtherDidNothing, ()) {
  const auto lines = [] {
    std::string out;
    for (const int one : *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 5)))
      out += std::to_string(one) + "\n";
    return out;
  };
  const std::string base = lines();
  const std::string other = lines();
  RC_ASSERT(merged(base, other, base) == other);
  RC_ASSERT(merged(base, base, other) == other);
  RC_ASSERT(merged(base, other, other) == other);
}

}  // namespace
}  // namespace mlab::documents
