#include "mlab/text/line_ends.h"

#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace mlab::text {
namespace {

TEST(LineEnds, AreDosWhereEveryLineEndsSo) {
  EXPECT_TRUE(has_dos_lines("a\r\nb\r\n"));
  EXPECT_TRUE(has_dos_lines("a\r\nb"));
  EXPECT_FALSE(has_dos_lines("a\r\nb\n"));
  EXPECT_FALSE(has_dos_lines("\na\r\n"));
  EXPECT_FALSE(has_dos_lines("a"));
  EXPECT_FALSE(has_dos_lines(""));
}

TEST(LineEnds, OfAMixedTextStayAsTheyAre) {
  EXPECT_EQ(unix_lines("a\r\nb\n"), "a\r\nb\n");
  EXPECT_EQ(lines_as_in("a\r\nb\n", "a\nb\nc\n"), "a\nb\nc\n");
}

TEST(LineEnds, OfWhatIsNewAreThoseOfTheFile) {
  EXPECT_EQ(unix_lines("a\r\nb\rc\r\n"), "a\nb\rc\n");
  EXPECT_EQ(lines_as_in("a\r\nb\r\n", "a\nnew\nb\n"), "a\r\nnew\r\nb\r\n");
  EXPECT_EQ(lines_as_in("", "a\n"), "a\n");
}

RC_GTEST_PROP(LineEnds, OfATextThatNobodyChangedAreWrittenAsTheyWereRead, (const std::string& text)) {
  std::string dos;
  for (const char c : text) dos += c == '\n' ? "\r\n" : std::string(1, c);
  for (const std::string& file : {text, dos}) RC_ASSERT(lines_as_in(file, unix_lines(file)) == file);
}

}  // namespace
}  // namespace mlab::text
