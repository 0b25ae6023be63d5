#include "mlab/text/source.h"

#include <gtest/gtest.h>

namespace mlab::text {
namespace {

TEST(Source, CountsLinesAndColumnsFromOne) {
  const Source s("a", "one\ntwo\n");
  EXPECT_EQ(s.line_column(0).line, 1U);
  EXPECT_EQ(s.line_column(0).column, 1U);
  EXPECT_EQ(s.line_column(5).line, 2U);
  EXPECT_EQ(s.line_column(5).column, 2U);
  EXPECT_EQ(s.line(2), "two");
  EXPECT_EQ(s.line(9), "");
}

TEST(Source, ColumnsCountCharactersNotBytes) {
  const Source s("a", "\xc3\xa4\xc3\xb6x");
  EXPECT_EQ(s.line_column(4).column, 3U);
}

TEST(Source, AnOffsetPastTheEndIsTheEnd) {
  const Source s("a", "x\ny");
  EXPECT_EQ(s.line_column(99).line, 2U);
  EXPECT_EQ(s.line_column(99).column, 2U);
}

TEST(Source, ALineEndsBeforeItsCarriageReturn) {
  const Source s("a", "one\r\ntwo");
  EXPECT_EQ(s.line(1), "one");
}

}  // namespace
}  // namespace mlab::text
