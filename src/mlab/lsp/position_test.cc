#include "mlab/lsp/position.h"

#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "mlab/base/testing/processor_time.h"

namespace mlab::lsp {
namespace {

TEST(Position, CountsUtf16Units) {
  const std::string text = "ab\n\xc3\xa9\xe2\x82\xac\xf0\x9f\x98\x80x\r\nlast";  // é € and a face, then x
  const LineIndex lines(text);
  EXPECT_EQ(lines.line_count(), 3U);
  EXPECT_EQ(lines.position(0), (Position{0, 0}));
  EXPECT_EQ(lines.position(3), (Position{1, 0}));
  EXPECT_EQ(lines.position(5), (Position{1, 1}));   // behind é
  EXPECT_EQ(lines.position(8), (Position{1, 2}));   // behind €
  EXPECT_EQ(lines.position(12), (Position{1, 4}));  // the face takes two
  EXPECT_EQ(lines.offset({1, 4}), 12U);
  EXPECT_EQ(lines.offset({1, 3}), 8U) << "in the middle of a pair";
  EXPECT_EQ(lines.offset({1, 99}), 13U) << "the line's end, without its line end";
  EXPECT_EQ(lines.offset({9, 0}), text.size());
  EXPECT_EQ(lines.position(999), (Position{2, 4}));
}

TEST(Position, KnowsAllLineEnds) {
  const LineIndex lines("a\rb\r\nc\n");
  EXPECT_EQ(lines.line_count(), 4U);
  EXPECT_EQ(lines.position(2), (Position{1, 0}));
  EXPECT_EQ(lines.position(5), (Position{2, 0}));
  EXPECT_EQ(lines.position(7), (Position{3, 0}));
}

TEST(Position, CountsOnLongLines) {
  std::string text = "first\n";
  for (int i = 0; i < 300; ++i) text += "ab\xc3\xa9\xf0\x9f\x98\x80";  // 8 bytes, 5 units
  text += "\r\nlast";
  const LineIndex lines(text);
  for (std::uint32_t i = 0; i < 300; ++i) {
    const std::uint32_t offset = 6 + i * 8;
    ASSERT_EQ(lines.position(offset), (Position{1, i * 5}));
    ASSERT_EQ(lines.offset({1, i * 5}), offset);
    ASSERT_EQ(lines.offset({1, i * 5 + 3}), offset + 4);
    ASSERT_EQ(lines.offset({1, i * 5 + 4}), offset + 4) << "in the middle of a pair";
    ASSERT_EQ(lines.position(offset + 5), (Position{1, i * 5 + 3})) << "inside of a character";
  }
  EXPECT_EQ(lines.position(6 + 2400 + 2), (Position{2, 0}));
  EXPECT_EQ(lines.offset({1, 9999}), 6U + 2400U);
}

TEST(Position, IsFoundOnALineOfMegabytesWithoutReadingItFromItsBeginning) {
  const auto ask = [](std::size_t size) {
    const std::string text(size, 'x');
    const LineIndex lines(text);
    for (std::uint32_t i = 0; i < text.size(); i += 16) ASSERT_EQ(lines.offset(lines.position(i)), i);
  };
  EXPECT_LT(base::growth(ask, base::kMegabyte / 8), base::kGrowthOfLine);
}

RC_GTEST_PROP(Position, AnOffsetComesBackWhereACharacterBegins, (const std::string& text)) {
  const LineIndex lines(text);
  for (std::uint32_t i = 0; i <= text.size(); ++i) {
    const std::uint32_t back = lines.offset(lines.position(i));
    RC_ASSERT(back <= i);
    RC_ASSERT(lines.offset(lines.position(back)) == back);
  }
}

}  // namespace
}  // namespace mlab::lsp
