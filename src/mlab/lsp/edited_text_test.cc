#include "mlab/lsp/edited_text.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

#include "mlab/base/testing/processor_time.h"
#include "mlab/text/splice.h"

namespace mlab::lsp {
namespace {

// The same the long way.
std::string replaced(const std::string& text, Position begin, Position end, const std::string& with) {
  const LineIndex lines(text);
  const std::uint32_t from = lines.offset(begin);
  return text::spliced(text, {{from, std::max(from, lines.offset(end))}, with});
}

TEST(EditedText, IsReadAsItStandsAfterEachChange) {
  EditedText text("one\ntwo\n");
  text.replace({1, 0}, {1, 3}, "2\n3");
  EXPECT_EQ(text.text(), "one\n2\n3\n");
  text.replace({2, 1}, {2, 1}, "!");
  text.replace({0, 3}, {1, 0}, "");
  EXPECT_EQ(text.text(), "one2\n3!\n");
  text.replace({7, 0}, {9, 9}, "end");
  EXPECT_EQ(text.text(), "one2\n3!\nend");
  text.replace({1, 0}, {0, 0}, "x");
  EXPECT_EQ(text.text(), "one2\nx3!\nend") << "the second position lies before the first";
  EXPECT_EQ(text.size(), 12U);
}

TEST(EditedText, CountsLinesAndCharactersAsALineIndexHoweverLongItIs) {
  const std::string parts[] = {"a",
                               "\n",
                               "\r\n",
                               "\r",
                               "\xc3\xa9",
                               "\xf0\x9f\x98\x80",
                               " some words",
                               "",
                               "\n",
                               std::string(3000, 'x'),
                               std::string(900, '\n')};
  std::uint64_t state = 7;
  const auto any = [&](std::uint64_t below) {
    state = state * 6364136223846793005U + 1442695040888963407U;
    return (state >> 33U) % below;
  };
  std::string plain;
  for (int i = 0; i < 3000; ++i) plain += parts[any(7)];
  EditedText text(plain);
  for (int i = 0; i < 600; ++i) {
    const auto line = static_cast<std::uint32_t>(any(2000));
    const auto character = static_cast<std::uint32_t>(any(30));
    const Position begin{line, character};
    const Position end{line + static_cast<std::uint32_t>(any(4) * any(4) * any(40)),
                       static_cast<std::uint32_t>(any(30))};
    const std::string with = parts[any(std::size(parts))] + parts[any(7)];
    plain = replaced(plain, begin, end, with);
    text.replace(begin, end, with);
    ASSERT_EQ(text.text(), plain) << i;
    ASSERT_EQ(text.size(), plain.size());
  }
}

// Minutes, if each change were one of the whole text.
TEST(EditedText, TakesManyChangesOfALongText) {
  constexpr std::uint32_t kChanges = base::kIsSlowBuild ? 1'000 : 10'000;
  constexpr std::uint32_t kLines = 10 * kChanges;
  std::string lines;
  for (std::uint32_t i = 0; i < kLines; ++i) lines += "  a line of some words that stays\n";
  EditedText text(lines);
  for (std::uint32_t i = 0; i < kChanges; ++i)
    text.replace({i * 7919 % kLines, 2}, {i * 7919 % kLines, 3}, "one");
  EXPECT_EQ(text.size(), lines.size() + 2 * kChanges);
  EXPECT_TRUE(text.text().starts_with("  one line of some words that stays\n"));
}

}  // namespace
}  // namespace mlab::lsp
