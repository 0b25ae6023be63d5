#include "mlab/comparison/beginning.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "mlab/comparison/testing/two_runs.h"

namespace mlab::comparison {
namespace {

using testing::of_entries;

struct Text {
  std::string path;
  std::string content;
};

testing::HistoryPtr beginning_of(const std::vector<Text>& texts, std::uint64_t seed,
                                 const std::vector<std::pair<std::string, std::string>>& set = {}) {
  std::vector<wire::HistoryEntry> entries;
  wire::HistoryEntry begun;
  wire::HistoryBeginning& beginning = *begun.mutable_beginning();
  beginning.set_format(history::History::kFormat);
  beginning.set_seed(seed);
  beginning.set_obstacle_seed(seed);
  beginning.mutable_mission()->set_path(texts.front().path);
  for (const Text& text : texts) {
    wire::HistoryEntry& entry = entries.emplace_back();
    entry.mutable_text()->set_id(static_cast<std::uint32_t>(entries.size()));
    entry.mutable_text()->set_path(text.path);
    entry.mutable_text()->set_content(text.content);
    beginning.mutable_mission()->add_texts(static_cast<std::uint32_t>(entries.size()));
  }
  for (const auto& [name, value] : set) {
    wire::HistorySetting& setting = *beginning.mutable_mission()->add_set();
    setting.set_name(name);
    setting.set_value(value);
  }
  entries.push_back(begun);
  return of_entries(entries);
}

Beginning beginnings(const testing::HistoryPtr& a, const testing::HistoryPtr& b) {
  return compare_beginnings({a.get(), b.get()});
}

TEST(Beginnings, OfTheSameAreTheSame) {
  const auto one = beginning_of({{"m.mdl", "MISSION"}}, 1);
  EXPECT_TRUE(beginnings(one, one).facts.empty());
  EXPECT_TRUE(beginnings(one, one).is_same());
}

TEST(Beginnings, SaySeedAndSettings) {
  const Beginning is = beginnings(beginning_of({{"m.mdl", ""}}, 1, {{"speed", "2"}}),
                                  beginning_of({{"m.mdl", ""}}, 7, {{"speed", "3"}, {"gain", "1"}}));
  ASSERT_EQ(is.facts.size(), 3U);
  EXPECT_EQ(is.facts[0].what, "seed");
  EXPECT_EQ(is.facts[0].values, (Both<std::string>{"1", "7"}));
  EXPECT_EQ(is.facts[1].what, "set gain");
  EXPECT_EQ(is.facts[1].values, (Both<std::string>{"", "1"}));
  EXPECT_EQ(is.facts[2].values, (Both<std::string>{"2", "3"}));
  EXPECT_FALSE(is.is_same());
}

TEST(Beginnings, DoNotMindWhereFilesLie) {
  const Beginning is = beginnings(beginning_of({{"here/m.mdl", "x"}, {"here/map.odl", "y"}}, 1),
                                  beginning_of({{"there/m.mdl", "x"}, {"there/map.odl", "y"}}, 1));
  EXPECT_TRUE(is.texts.empty());
  EXPECT_TRUE(is.is_same());
}

TEST(Beginnings, ShowLinesThatDiffer) {
  const Beginning is = beginnings(beginning_of({{"one.mdl", "a\nb\nc\nd\n"}, {"only.odl", "x"}}, 1),
                                  beginning_of({{"two.mdl", "a\nB\nc\nd\ne\n"}}, 1));
  ASSERT_EQ(is.texts.size(), 2U);
  EXPECT_EQ(is.texts[0].paths, (Both<std::string>{"one.mdl", "two.mdl"}));
  EXPECT_EQ(is.texts[0].lines, (std::vector<std::string>{"@ 2", "-b", "+B", "@ 5", "+e"}));
  EXPECT_EQ(is.texts[1].paths, (Both<std::string>{"only.odl", ""}));
}

TEST(Beginnings, ShowStrangersTextsAsTheyMayStandOnATerminal) {
  std::string much;
  for (int i = 0; i < 100; ++i) much += "line " + std::to_string(i) + "\n";
  const Beginning is =
      beginnings(beginning_of({{"m.mdl", "\x1b[31m\xff\n"}}, 1), beginning_of({{"m.mdl", much}}, 1));
  ASSERT_EQ(is.texts.size(), 1U);
  EXPECT_EQ(is.texts[0].lines.size(), 40U);
  EXPECT_EQ(is.texts[0].left_out, 62U);
  EXPECT_TRUE(std::ranges::none_of(is.texts[0].lines, [](const std::string& line) {
    return line.find('\x1b') != std::string::npos || line.find('\xff') != std::string::npos;
  }));
}

}  // namespace
}  // namespace mlab::comparison
