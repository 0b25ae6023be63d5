#include "mlab/text/word_changes.h"

#include <cctype>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace mlab::text {
namespace {

std::vector<Span> words_of(const std::string& text) {
  std::vector<Span> out;
  for (std::uint32_t i = 0; i < text.size();) {
    std::uint32_t end = i;
    while (end < text.size() && std::isspace(static_cast<unsigned char>(text[end])) == 0) ++end;
    if (end > i) out.push_back({i, end});
    i = end + 1;
  }
  return out;
}

// The text with its words from the second to the last but one reworded; `=` stands for an old word that
// stays.
std::string reworded(const std::string& text, const std::vector<std::string>& now,
                     const std::vector<std::size_t>& kept = {}) {
  const std::vector<Span> words = words_of(text);
  WordChanges changes(std::make_shared<const Source>("t", text), words);
  std::vector<Word> wanted;
  std::size_t next = 0;
  for (const std::string& one : now) {
    if (one == "=") {
      wanted.push_back({"", words[kept[next++]]});
    } else {
      wanted.push_back({one, std::nullopt});
    }
  }
  changes.reword({words[1].begin, words[words.size() - 2].end}, wanted);
  return spliced(text, changes.joined().value());
}

TEST(WordChanges, RewordsOnlyWhatChanges) {
  EXPECT_EQ(reworded("< PP  a\t1 2 >", {"=", "=", "7", "="}, {1, 2, 4}), "< PP  a\t7 2 >");
}

TEST(WordChanges, PutsMoreWordsBehindTheOneBeforeThem) {
  EXPECT_EQ(reworded("< PL a 1 2\n  5 6 >", {"=", "=", "=", "=", "3", "4", "=", "="}, {1, 2, 3, 4, 5, 6}),
            "< PL a 1 2 3 4\n  5 6 >");
  EXPECT_EQ(reworded("< PP a >", {"=", "=", "9"}, {1, 2}), "< PP a 9 >");
}

TEST(WordChanges, TakesWordsAwayWithTheLineThatOnlyTheyNeeded) {
  EXPECT_EQ(reworded("< PL a 1 2\n  3 4\n  5 6 >", {"=", "=", "=", "=", "=", "="}, {1, 2, 3, 4, 7, 8}),
            "< PL a 1 2\n  5 6 >");
  EXPECT_EQ(reworded("< PL a 1 2 >", {"WALL"}), "< WALL >");
}

RC_GTEST_PROP(WordChanges, SayTheWordsThatWereAskedFor, (const std::vector<bool>& which)) {
  std::string text = "<";
  std::vector<std::string> now;
  std::vector<std::size_t> kept;
  std::string expected = "<";
  for (std::size_t i = 0; i < which.size(); ++i) {
    text += (i % 3 == 1 ? "\n w" : " w") + std::to_string(i);
    if (which[i]) kept.push_back(i + 1);
    for (int n = *rc::gen::inRange(0, 3); n > 0; --n) now.push_back("n" + std::to_string(n));
    if (which[i]) now.emplace_back("=");
  }
  RC_PRE(!which.empty());
  RC_PRE(which.front() && (now.empty() || now.front() == "="));
  std::size_t next = 0;
  for (const std::string& one : now)
    expected += ' ' + (one == "=" ? "w" + std::to_string(kept[next++] - 1) : one);
  expected += " >";
  const std::string out = reworded(text + " >", now, kept);
  std::string plain;
  for (const Span& word : words_of(out))
    plain += (plain.empty() ? "" : " ") + out.substr(word.begin, word.end - word.begin);
  RC_ASSERT(plain == expected);
}

}  // namespace
}  // namespace mlab::text
