#include "mlab/text/escape.h"

#include <gtest/gtest.h>

namespace mlab::text {
namespace {

TEST(Markup, HasNothingThatABrowserWouldTakeForATag) {
  EXPECT_EQ(markup("a < b & \"c\" > d"), "a &lt; b &amp; &quot;c&quot; &gt; d");
  EXPECT_EQ(markup("two\nlines\tand\x01more"), "two\nlines\tand more");
}

TEST(CsvField, IsQuotedWhereItHasTo) {
  EXPECT_EQ(csv_field("1.5"), "1.5");
  EXPECT_EQ(csv_field(""), "");
  EXPECT_EQ(csv_field("a,b"), "\"a,b\"");
  EXPECT_EQ(csv_field("say \"no\""), "\"say \"\"no\"\"\"");
  EXPECT_EQ(csv_field("two\nlines"), "\"two\nlines\"");
}

TEST(CsvField, IsNoFormula) {
  for (const char* formula : {"=1+1", "+a", "-2+3", "@SUM(A1)", "-", "\tx"})
    EXPECT_EQ(csv_field(formula), std::string("'") + formula);
  EXPECT_EQ(csv_field("=a,b"), "\"'=a,b\"");
  for (const char* other : {"-1.5", "+3", "-inf", "-1e-07", "a=b", "1+1"}) EXPECT_EQ(csv_field(other), other);
}

}  // namespace
}  // namespace mlab::text
