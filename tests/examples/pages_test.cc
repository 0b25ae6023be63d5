// What the pages show of the command line is true: each command line is carried out as far as that is cheap,
// every option in it exists, and what a page shows of its output is what comes.

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include "pages.h"

namespace mlab::examples {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> guides() {
  std::vector<fs::path> out = pages_in({"docs", "missions", "editors", "bench"});
  out.push_back(root() / "README.md");
  return out;
}

/// The project's missions, and the files of his own that the pages speak of.
class Pages : public testing::Test {
 protected:
  void SetUp() override {
    for (const char* folder : {"missions", "library/assemblages", "examples/18_tests"})
      here_.take(folder, folder);
    for (const char* file : {"patrol.mdl", "patrol.odl"})
      here_.take(fs::path("missions/patrol") / file, fs::path("my") / file);
    for (const char* file : {"wander.mdl", "wander.cnl", "field.odl"})
      here_.take(fs::path("docs/examples/own_behavior") / file, fs::path("my") / file);
    here_.take("missions/forage/forager.cdl", "forager.cdl");
    here_.take("docs/examples/own_behavior/mine.cnl", "walker.cnl");
    here_.take("docs/examples/own_behavior/field.odl", "field.odl");
    here_.take("src/mlab/lang/cdl_historic/testdata/robots.cdl", "old.cdl");
    std::ofstream(here_.folder() / "walk.mdl")
        << "OVERLAY field.odl\nNEW-ROBOT walker \"./walker\" (pace = 2)\nUNIT <u> walker\n"
           "COMMAND LIST:\n0. UNIT u START Camp\n";
  }

  Answer mlab(const Words& words) const {
    return here_.carry_out(fmt::format("./mlab {}", fmt::join(words, " ")));
  }

  const std::string& help_of(const std::string& command) {
    std::string& help = helps_[command];
    if (!help.empty()) return help;
    if (command == "test")
      return help = fmt::format("{}", fmt::join(lines_of(root() / "tools/test/run"), "\n"));
    if (command == "python")
      return help = fmt::format("Usage: {}", fmt::join(lines_of(root() / "tools/launcher/help.txt"), "\n"));
    const Answer answer = mlab({"help", command.starts_with("-") ? "" : command});
    EXPECT_EQ(answer.status, 0) << answer.output;
    return help = answer.output;
  }

  Workplace here_;
  std::map<std::string, std::string> helps_;
};

/// Those with commands in blocks, from the root.
std::vector<std::string> guides_with_commands() {
  std::vector<std::string> out;
  for (const fs::path& page : guides()) {
    if (!commands_in_blocks(page).empty()) out.push_back(page.lexically_relative(root()).string());
  }
  return out;
}

/// By pages, so that those which take long run beside each other.
class Guide : public Pages, public testing::WithParamInterface<std::string> {};

TEST_P(Guide, CommandLinesInBlocksWorkAndPrintWhatIsShown) {
  for (const ShownCommand& shown : commands_in_blocks(root() / GetParam())) expect_as_shown(here_, shown);
}

INSTANTIATE_TEST_SUITE_P(OfTheProject, Guide, testing::ValuesIn(guides_with_commands()),
                         [](const auto& test) {
                           std::string name = test.param;
                           std::ranges::replace_if(
                               name, [](unsigned char c) { return !std::isalnum(c); }, '_');
                           return name;
                         });

TEST_F(Pages, ShowCommandsAndWhatTheyPrint) {
  std::size_t commands = 0;
  std::size_t outputs = 0;
  for (const std::string& page : guides_with_commands()) {
    const std::vector<ShownCommand> all = commands_in_blocks(root() / page);
    commands += all.size();
    outputs += static_cast<std::size_t>(
        std::ranges::count_if(all, [](const ShownCommand& shown) { return !shown.output.empty(); }));
  }
  EXPECT_GT(commands, 30U);
  EXPECT_GE(outputs, 2U);
}

TEST_F(Pages, EveryCommandAndOptionThatIsNamedExists) {
  std::vector<ShownCommand> all;
  std::vector<fs::path> pages = guides();
  std::ranges::copy(pages_in({"examples"}), std::back_inserter(pages));
  for (const fs::path& page : pages) {
    std::ranges::move(commands_in_blocks(page), std::back_inserter(all));
    std::ranges::move(commands_in_sentences(page), std::back_inserter(all));
  }
  std::size_t calls = 0;
  for (const ShownCommand& shown : all) {
    const Words words = command_words(shown.command);
    if (words.empty() || words.front() == "COMMAND" || words.front() == "WORDS") continue;
    ++calls;
    const std::string& command = words.front();
    const std::string& help = help_of(command);
    EXPECT_TRUE(help.find(command.starts_with("-") ? command : "Usage") != std::string::npos ||
                command == "test")
        << shown.place << ": " << command;
    for (const std::string& word : words) {
      if (!word.starts_with("-") || word == "-") continue;
      EXPECT_NE(help.find(word.substr(0, word.find('='))), std::string::npos) << shown.place << ": " << word;
    }
  }
  EXPECT_GT(calls, 80U);
}

TEST(PagesThemselves, AnOutputThatDiffersIsFound) {
  EXPECT_TRUE(is_shown_by({"a", "...", "c"}, "a\nb\nc\n"));
  EXPECT_TRUE(is_shown_by({"a", "..."}, "a\nb\nc\n"));
  EXPECT_TRUE(is_shown_by({"a ... c, ..."}, "a b c, d\n"));
  EXPECT_FALSE(is_shown_by({"a"}, "a\nb\n"));
  EXPECT_FALSE(is_shown_by({"a", "c"}, "a\nb\nc\n"));
  EXPECT_FALSE(is_shown_by({"a", "...", "d"}, "a\nb\nc\n"));
  EXPECT_FALSE(is_shown_by({"a ... c"}, "a b d\n"));
  EXPECT_EQ(command_words("./mlab run x.mdl --seed 2   # again"), (Words{"run", "x.mdl", "--seed", "2"}));
  EXPECT_EQ(command_words("cmake --build ."), Words{});
}

}  // namespace
}  // namespace mlab::examples
