#include "mlab/text/shown.h"

#include <gtest/gtest.h>

namespace mlab::text {
namespace {

TEST(Shown, KeepsWhatCanBePrinted) {
  EXPECT_EQ(shown("AA-1 \xc3\xa4\xe2\x82\xac\xf0\x9f\x98\x80"), "AA-1 \xc3\xa4\xe2\x82\xac\xf0\x9f\x98\x80");
}

TEST(Shown, EscapesControlCharactersAndBrokenUtf8) {
  EXPECT_EQ(shown("a\x1b[b\n\x7f"), "a\\x1b[b\\x0a\\x7f");
  EXPECT_EQ(shown("\xff\xc3"), "\\xff\\xc3");
  EXPECT_EQ(shown("\xc0\xaf"), "\\xc0\\xaf");           // overlong
  EXPECT_EQ(shown("\xed\xa0\x80"), "\\xed\\xa0\\x80");  // surrogate
  EXPECT_EQ(shown("\xc2\x9b"), "\\xc2\\x9b");           // a terminal's control sequence introducer
}

TEST(Shown, CutsWhatIsLong) {
  EXPECT_EQ(shown(std::string(100, 'x'), 5), "xxxxx...");
}

}  // namespace
}  // namespace mlab::text
