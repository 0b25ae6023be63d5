#include "mlab/text/shell_word.h"

#include <gtest/gtest.h>

namespace mlab::text {
namespace {

TEST(ShellWord, LeavesWhatAShellTakesAsOneWord) {
  EXPECT_EQ(shell_word("./walker-2.1"), "./walker-2.1");
  EXPECT_EQ(shell_word("10.0.0.7"), "10.0.0.7");
}

TEST(ShellWord, QuotesWhatAShellWouldTakeForSomethingElse) {
  EXPECT_EQ(shell_word(""), "''");
  EXPECT_EQ(shell_word("./my walker"), "'./my walker'");
  EXPECT_EQ(shell_word("a;b$c&d"), "'a;b$c&d'");
  EXPECT_EQ(shell_word("~walker"), "'~walker'");
  EXPECT_EQ(shell_word("it's"), R"('it'\''s')");
}

}  // namespace
}  // namespace mlab::text
