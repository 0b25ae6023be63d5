#include "mlab/tables/regions.h"

#include <array>

#include <gtest/gtest.h>

namespace mlab::tables {
namespace {

constexpr std::array kTwo = {Region{"lines", [] { return std::string("a\nb\n"); }},
                             Region{"words", [] { return std::string("A|B"); }}};

std::string problem(std::string_view text) {
  const auto out = refreshed(text, kTwo);
  return out ? "none" : std::to_string(out.error().line) + ": " + out.error().message;
}

TEST(Regions, AreWrittenBetweenTheLinesOfTheirMarks) {
  EXPECT_EQ(refreshed("x\n// [[table lines]]\nold\n// [[end]]\ny\n", kTwo).value(),
            "x\n// [[table lines]]\na\nb\n// [[end]]\ny\n");
}

TEST(Regions, OfOneLineStandBetweenComments) {
  EXPECT_EQ(refreshed("(?i)(?#[[table words]])X(?#[[end]]))", kTwo).value(),
            "(?i)(?#[[table words]])A|B(?#[[end]]))");
}

TEST(Regions, AreAsManyAsThereAre) {
  const std::string text = "# [[table lines]]\n# [[end]]\n-\n# [[table lines]]\n# [[end]]\n";
  EXPECT_EQ(refreshed(text, kTwo).value(),
            "# [[table lines]]\na\nb\n# [[end]]\n-\n# [[table lines]]\na\nb\n# [[end]]\n");
}

TEST(Regions, ThatAreFreshStayAsTheyAre) {
  const std::string text = refreshed("# [[table lines]]\n# [[end]]\n", kTwo).value();
  EXPECT_EQ(refreshed(text, kTwo).value(), text);
  EXPECT_EQ(refreshed("no marks [[end]]", kTwo).value(), "no marks [[end]]");
}

TEST(Regions, WithBadMarksSayWhereAndWhat) {
  EXPECT_EQ(problem("\n# [[table shapes]]\n# [[end]]\n"), "2: there is no table `shapes`");
  EXPECT_EQ(problem("# [[table lines]]\n"), "1: the table `lines` has no `[[end]]` behind it");
  EXPECT_EQ(problem("# [[table lines]]\n# [[table words]]\n# [[end]]\n"),
            "1: the table `lines` has no `[[end]]` behind it");
  EXPECT_EQ(problem("[[table words]][[end]]"), "1: the marks of one line stand in no comments `(?#...)`");
}

TEST(Regions, HaveNamesOfTheirOwn) {
  for (const Region& one : all_regions()) {
    std::size_t same = 0;
    for (const Region& other : all_regions()) same += one.name == other.name ? 1 : 0;
    EXPECT_EQ(same, 1U) << one.name;
    EXPECT_FALSE(one.write().empty()) << one.name;
  }
}

}  // namespace
}  // namespace mlab::tables
