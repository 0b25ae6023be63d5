// The ladder of examples: each page is carried out as it stands, in a folder of its own, and what comes is
// what it shows. Where it says Change `A` to `B` in `FILE`, that is done.

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "pages.h"

namespace mlab::examples {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostLines = 100;

const fs::path& ladder() {
  static const fs::path kLadder = root() / "examples";
  return kLadder;
}

std::vector<std::string> rungs() {
  std::vector<std::string> out;
  for (const auto& entry : fs::directory_iterator(ladder())) {
    if (entry.is_directory()) out.push_back(entry.path().filename().string());
  }
  std::ranges::sort(out);
  return out;
}

class Rung : public testing::TestWithParam<std::string> {
 protected:
  fs::path page() const { return ladder() / GetParam() / "README.md"; }

  // They are right, and in the canonical layout where their language has one.
  void check_files(const Workplace& here) const {
    std::string checked;
    std::string laid_out;
    for (const auto& entry : fs::directory_iterator(ladder() / GetParam())) {
      const std::string ending = entry.path().extension().string();
      if (ending == ".md") continue;
      const std::string file = " " + entry.path().lexically_relative(root()).string();
      checked += file;
      laid_out += ending == ".env" ? "" : file;
    }
    if (checked.empty()) return;
    const Answer answer =
        here.carry_out(fmt::format("./mlab check{} && ./mlab fmt --check{}", checked, laid_out));
    EXPECT_EQ(answer.status, 0) << answer.output;
  }
};

TEST_P(Rung, HasFilesWithoutAMistakeAndDoesWhatItsPageSays) {
  Workplace here;
  here.take("examples", "examples");
  check_files(here);
  const std::vector<ShownCommand> all = commands_in_blocks(page());
  EXPECT_TRUE(std::ranges::any_of(all, &ShownCommand::has_prompt))
      << "the page shows nothing that is printed";
  for (const ShownCommand& shown : all) expect_as_shown(here, shown);
  EXPECT_TRUE(here.is_unchanged()) << "whoever goes on to other pages has changed files";
}

TEST_P(Rung, IsAPageThatNamesItsFilesAndTheNextRung) {
  const std::string text = text_of(page());
  EXPECT_LE(lines_of(page()).size(), kMostLines);
  for (const auto& entry : fs::directory_iterator(ladder() / GetParam())) {
    const std::string name = entry.path().filename().string();
    EXPECT_TRUE(name == "README.md" || text.find("](" + name + ")") != std::string::npos)
        << "the page has no link to " << name;
  }
  const std::vector<std::string> all = rungs();
  const auto next = std::ranges::find(all, GetParam()) + 1;
  EXPECT_TRUE(next == all.end() || text.find("](../" + *next + "/README.md)") != std::string::npos)
      << "the page does not lead to the next rung";
}

INSTANTIATE_TEST_SUITE_P(OfTheLadder, Rung, testing::ValuesIn(rungs()),
                         [](const auto& test) { return test.param; });

TEST(Ladder, IsCountedFromOneAndListed) {
  const std::string list = text_of(ladder() / "README.md");
  std::size_t number = 0;
  for (const std::string& rung : rungs()) {
    EXPECT_TRUE(rung.starts_with(fmt::format("{:02}_", ++number))) << rung;
    EXPECT_NE(list.find("](" + rung + "/README.md)"), std::string::npos)
        << "examples/README.md does not list " << rung;
  }
  EXPECT_GE(number, 10U);
}

}  // namespace
}  // namespace mlab::examples
