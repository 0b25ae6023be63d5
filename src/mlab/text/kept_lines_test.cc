#include "mlab/text/kept_lines.h"

#include <string>

#include <gtest/gtest.h>

namespace mlab::text {
namespace {

using Kept = std::vector<int>;

TEST(KeptLines, AreThoseThatBothTextsHaveInTheSameOrder) {
  EXPECT_EQ(kept_lines(lines_of("a\nb\nc\n"), lines_of("a\nx\nc\n")), (Kept{0, -1, 2}));
  EXPECT_EQ(kept_lines(lines_of("a\nb\n"), lines_of("new\na\nb\n")), (Kept{1, 2}));
  EXPECT_EQ(kept_lines(lines_of(""), lines_of("a")), Kept{});
  EXPECT_EQ(kept_lines(lines_of("a"), lines_of("")), Kept{-1});
}

TEST(KeptLines, AreNoneWhereNearlyEverythingIsAnother) {
  std::string before;
  std::string after = "same\n";
  for (int i = 0; i < 2000; ++i) {
    before += "before " + std::to_string(i) + "\n";
    after += "after " + std::to_string(i) + "\n";
  }
  before += "same\n";
  EXPECT_EQ(kept_lines(lines_of(before), lines_of(after)), Kept(2001, -1));
}

TEST(KeptLines, EndWithTheirEnds) {
  EXPECT_EQ(lines_of("one\n\ntwo"), (std::vector<std::string_view>{"one\n", "\n", "two"}));
}

}  // namespace
}  // namespace mlab::text
