// The examples of the language's page are checked, so that it does not promise what is not so.

#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/base/testing/source_folder.h"
#include "mlab/lang/mdl/mdl.h"
#include "mlab/lang/mdl/token.h"
#include "mlab/text/testing/golden.h"

namespace mlab::mdl {
namespace {

const std::string kDocumented = base::source_folder() + "/src/mlab/lang/mdl/testdata";

// `what` is behind the language's name: nothing, `preamble`, `steps` or `typed`. An `excerpt` is one of a
// file that other tests check.
std::vector<std::string> examples(const std::string& what) {
  std::vector<std::string> out;
  const std::string text = text::testing::read_all(base::source_folder() + "/docs/languages/mdl.md");
  const std::string fence = "\n```mdl" + (what.empty() ? "" : " " + what) + "\n";
  for (std::size_t at = text.find(fence); at != std::string::npos; at = text.find(fence, at + 1)) {
    const std::size_t begin = at + fence.size();
    out.push_back(text.substr(begin, text.find("\n```", begin) + 1 - begin));
  }
  return out;
}

const char* const kScouts =
    "OVERLAY democ.odl\nUNIT <scouts> (<scouts-1> ROBOT ROBOT) (<scouts-2> ROBOT ROBOT)\nCOMMAND LIST:\n"
    "0. UNIT scouts START AA1 0 20\n";

std::shared_ptr<const mission::Mission> check_silently(const std::string& text) {
  text::Diagnostics sink;
  auto mission = check_mission(std::make_shared<const text::Source>("example.mdl", text), kDocumented, sink);
  EXPECT_EQ(sink.error_count() + sink.warning_count(), 0U) << text::render(sink) << text;
  return mission;
}

TEST(MdlPage, HasMissionsWithoutMistakes) {
  EXPECT_GE(examples("").size(), 1U);
  for (const std::string& text : examples("")) check_silently(text);
}

TEST(MdlPage, ShowsAMistakeAsItIsTold) {
  const std::string page = text::testing::read_all(base::source_folder() + "/docs/languages/mdl.md");
  const std::string before(kScouts);
  const std::string empty_lines(4, '\n');  // so that it stands on the line that the page shows
  text::Diagnostics sink;
  check_mission(std::make_shared<const text::Source>(
                    "demo.mdl", before + empty_lines + "  2. UNIT scouts MOVETO ATK-AP9 FORMATION Column\n"),
                kDocumented, sink);
  std::string told = text::render(sink);
  // The overlay's place is told with its folder.
  if (const std::size_t at = told.find(kDocumented + "/"); at != std::string::npos)
    told.erase(at, kDocumented.size() + 1);
  EXPECT_NE(page.find("```text\n" + told + "```"), std::string::npos) << told;
}

TEST(MdlPage, HasPreamblesWithoutMistakes) {
  EXPECT_GE(examples("preamble").size(), 5U);
  for (const std::string& text : examples("preamble")) check_silently(text + "COMMAND LIST:\n0. QUIT\n");
}

TEST(MdlPage, HasStepsWithoutMistakes) {
  EXPECT_GE(examples("steps").size(), 4U);
  for (const std::string& text : examples("steps")) check_silently(kScouts + text);
}

TEST(MdlPage, HasTypedCommandsWithoutMistakes) {
  const auto mission = check_silently(kScouts);
  ASSERT_NE(mission, nullptr);
  ASSERT_EQ(examples("typed").size(), 1U);
  std::istringstream lines(examples("typed")[0]);
  for (std::string line; std::getline(lines, line);) {
    text::Diagnostics sink;
    EXPECT_TRUE(parse_immediate(line, *mission, sink));
    EXPECT_EQ(text::render(sink), "") << line;
  }
}

TEST(MdlPage, HasAnExampleOfEveryWordButThreeThatDoNothing) {
  std::set<Word> seen;
  for (const char* what : {"", "preamble", "steps", "typed"}) {
    for (const std::string& text : examples(what)) {
      text::Diagnostics sink;
      for (const Token& token : lex(std::make_shared<const text::Source>("example.mdl", text), sink).tokens)
        seen.insert(token.word);
    }
  }
  for (auto word = Word::kScenario; word <= Word::kRobot;
       word = static_cast<Word>(static_cast<int>(word) + 1)) {
    if (word == Word::kHeightMap || word == Word::kInjectTrack || word == Word::kYellow) continue;
    EXPECT_TRUE(seen.contains(word)) << spelling(word);
  }
}

TEST(MdlPage, NamesEveryKindOfWarning) {
  const std::string page = text::testing::read_all(base::source_folder() + "/docs/languages/mdl.md");
  const auto kinds =
      text::testing::kinds_said_in(base::source_folder() + "/src/mlab/lang/mdl", {"warning(", "warn_once("});
  EXPECT_GT(kinds.size(), 15U);
  for (const std::string& kind : kinds) EXPECT_NE(page.find("`" + kind + "`"), std::string::npos) << kind;
}

}  // namespace
}  // namespace mlab::mdl
