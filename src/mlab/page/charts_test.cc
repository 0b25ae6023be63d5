#include "mlab/page/charts.h"

#include <limits>

#include <gtest/gtest.h>

#include "mlab/page/document.h"

namespace mlab::page {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

bool has(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

TEST(Document, ProseShowsWhatStandsBetweenBackticksAsCode) {
  EXPECT_EQ(prose("`a<b` is not `c`"),
            R"(<code class="word">a&lt;b</code> is not <code class="word">c</code>)");
  EXPECT_EQ(prose("one ` alone & nothing"), "one ` alone &amp; nothing");
  EXPECT_EQ(prose(""), "");
}

TEST(Charts, ALineIsInterruptedWhereThereIsNoNumber) {
  const Axis axis = number_axis(0.0, 10.0);
  const std::string row =
      line_row({"robot 1", {{{{0.0, 0.0}, {5.0, kNone}, {10.0, 2.0}}, false}}, 2.0, "2 m", 5.0}, axis);
  EXPECT_TRUE(has(row, R"(d="M0.0 29.0M1000.0 1.0")")) << row;
  EXPECT_TRUE(has(row, R"(class="median" d="M500.0 0V30")")) << row;
}

TEST(Charts, WaysHaveOneScaleAndYUpwards) {
  const std::string map =
      ways({{{{0.0, 0.0}, {20.0, 10.0}}, false}, {{{0.0, 10.0}, {kNone, 3.0}}, true}}, "two");
  EXPECT_TRUE(has(map, R"(d="M0.0 500.0L1000.0 0.0")")) << map;
  EXPECT_TRUE(has(map, R"(class="line two" d="M0.0 0.0")")) << map;
  EXPECT_EQ(ways({{{{kNone, kNone}}, false}}, "nothing"), "");
  EXPECT_EQ(ways({}, "nothing"), "");
}

TEST(Charts, CellsOfATableSayWhatTheyAre) {
  const std::vector<std::string> head = {"run", "a", "b", "c", "d", "f [m]"};
  const std::vector<std::string> row = {"all runs", "1", "2", "3", "4", "17 (1 to 30)"};
  const std::string narrow = table("Runs", {head, row}, 1);
  EXPECT_FALSE(has(narrow, "wide")) << narrow;
  EXPECT_TRUE(has(narrow, "<th scope=\"row\" class=\"left\" data-head=\"run\">all runs</th>")) << narrow;
  EXPECT_TRUE(has(narrow, "<td data-head=\"f [m]\">17 (1\u00a0to\u00a030)</td>")) << narrow;
  std::vector<std::string> wide_head = head;
  wide_head.insert(wide_head.begin() + 1, "\"kind\"");
  std::vector<std::string> wide_row = row;
  wide_row.insert(wide_row.begin() + 1, "a b");
  const std::string wide = table("Runs", {wide_head, wide_row}, 2);
  EXPECT_TRUE(has(wide, "<table class=\"wide\">")) << wide;
  EXPECT_TRUE(has(wide, "<td class=\"left\" data-head=\"&quot;kind&quot;\">a b</td>")) << wide;
}

TEST(Charts, WhatIsNotOursIsNoMarkup) {
  const std::string page = document("<script>", table("a\"b", {{"<x>"}, {"&"}}, 1));
  EXPECT_FALSE(has(page, "<script>"));
  EXPECT_FALSE(has(page, "<x>"));
  EXPECT_TRUE(has(page, "a&quot;b"));
  EXPECT_TRUE(has(page, "default-src 'none'"));
}

}  // namespace
}  // namespace mlab::page
