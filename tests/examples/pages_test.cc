// What the pages show of the command line is true: each command line is carried out as far as that is cheap,
// every option in it exists, and what a page shows of its output is what comes.

#include <unistd.h>

#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/core.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

namespace mlab {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;
const fs::path kRoot = MLAB_SOURCE_DIR;

/// A command line that a page shows, with the output that stands below it.
struct Shown {
  std::string place;  ///< page:line
  Words words;        ///< without `mlab` and what stands behind `#`
  std::vector<std::string> output;
};

std::vector<std::string> lines_of(const fs::path& file) {
  std::ifstream stream(file);
  std::vector<std::string> out;
  for (std::string line; std::getline(stream, line);) out.push_back(line);
  return out;
}

std::vector<fs::path> pages() {
  std::vector<fs::path> out = {kRoot / "README.md"};
  for (const char* folder : {"docs", "missions", "editors", "bench"}) {
    for (const auto& entry : fs::recursive_directory_iterator(kRoot / folder)) {
      const bool is_ours = entry.path().string().find("node_modules") == std::string::npos;
      if (is_ours && entry.path().extension() == ".md") out.push_back(entry.path());
    }
  }
  std::ranges::sort(out);
  return out;
}

// The words behind `mlab`; nothing where the text is no command line of it.
Words command_words(std::string_view text) {
  if (text.starts_with("$ ")) text.remove_prefix(2);
  if (text.starts_with("./")) text.remove_prefix(2);
  if (!text.starts_with("mlab ")) return {};
  std::istringstream stream{std::string(text.substr(5, text.find(" #") - 5))};
  return {std::istream_iterator<std::string>(stream), {}};
}

void read_blocks(const fs::path& page, std::vector<Shown>& out) {
  constexpr std::string_view kIndent = "    ";
  const std::vector<std::string> lines = lines_of(page);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!lines[i].starts_with(kIndent)) continue;
    const Words words = command_words(std::string_view(lines[i]).substr(kIndent.size()));
    if (words.empty()) continue;
    Shown shown{fmt::format("{}:{}", page.lexically_relative(kRoot).string(), i + 1), words, {}};
    if (lines[i].starts_with("    $ ")) {
      while (i + 1 < lines.size() && lines[i + 1].starts_with(kIndent) && !lines[i + 1].starts_with("    $ "))
        shown.output.push_back(lines[++i].substr(kIndent.size()));
    }
    out.push_back(std::move(shown));
  }
}

// Between back quotes in a sentence: `mlab run MISSION --report FILE.json`.
void read_sentences(const fs::path& page, std::vector<Shown>& out) {
  const std::vector<std::string> lines = lines_of(page);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].starts_with("    ")) continue;
    for (std::size_t open = lines[i].find('`'); open != std::string::npos;) {
      const std::size_t close = lines[i].find('`', open + 1);
      if (close == std::string::npos) break;
      const Words words = command_words(std::string_view(lines[i]).substr(open + 1, close - open - 1));
      if (!words.empty())
        out.push_back({fmt::format("{}:{}", page.lexically_relative(kRoot).string(), i + 1), words, {}});
      open = lines[i].find('`', close + 1);
    }
  }
}

/// A folder as a reader of the pages has it: the project's missions, and the files of his own that the pages
/// speak of.
class Pages : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / ("mlab_pages_" + std::to_string(getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "my");
    fs::copy(kRoot / "missions", folder_ / "missions", fs::copy_options::recursive);
    const auto take = [&](const fs::path& from, const std::string& to) {
      fs::copy_file(kRoot / from, folder_ / to);
    };
    for (const char* file : {"patrol.mdl", "patrol.odl"})
      take(fs::path("missions/patrol") / file, std::string("my/") + file);
    for (const char* file : {"wander.mdl", "wander.cnl", "field.odl"})
      take(fs::path("docs/examples/own_behavior") / file, std::string("my/") + file);
    take("missions/forage/forager.cdl", "forager.cdl");
    take("docs/examples/own_behavior/mine.cnl", "walker.cnl");
    take("docs/examples/own_behavior/field.odl", "field.odl");
    take("src/mlab/lang/cdl_historic/testdata/robots.cdl", "old.cdl");
    std::ofstream(folder_ / "walk.mdl")
        << "OVERLAY field.odl\nNEW-ROBOT walker \"./walker\" (pace = 2)\nUNIT <u> walker\n"
           "COMMAND LIST:\n0. UNIT u START Camp\n";
  }
  void TearDown() override { fs::remove_all(folder_); }

  // Standard output and standard error together, as on a screen.
  std::string mlab(const Words& words, int& status) const {
    const std::string line = fmt::format("cd '{0}' && XDG_CACHE_HOME='{0}/cache' '{1}' {2} 2>&1 </dev/null",
                                         folder_.string(), MLAB_COMMAND, fmt::join(words, " "));
    std::FILE* pipe = popen(line.c_str(), "r");
    std::string out;
    std::array<char, 4096> block{};
    for (std::size_t n = 0; pipe != nullptr && (n = fread(block.data(), 1, block.size(), pipe)) > 0;)
      out.append(block.data(), n);
    const int ended = pipe == nullptr ? -1 : pclose(pipe);
    status = WIFEXITED(ended) ? WEXITSTATUS(ended) : -1;
    return out;
  }

  const std::string& help_of(const std::string& command) {
    std::string& help = helps_[command];
    int status = 0;
    if (help.empty())
      help = command == "test" ? testing_help()
                               : mlab({"help", command.starts_with("-") ? "" : command}, status);
    EXPECT_EQ(status, 0) << help;
    return help;
  }
  static std::string testing_help() {
    std::string out;
    for (const std::string& line : lines_of(kRoot / "tools" / "test" / "run")) out += line + "\n";
    return out;
  }

  fs::path folder_;
  std::map<std::string, std::string> helps_;
};

// What shows that the line works, without a browser and without a compiler; empty: its words are all that is
// looked at.
Words trial_of(Words words) {
  for (std::string& word : words) {
    constexpr std::string_view kInstalled = "/usr/share/mlab/";
    if (word.starts_with(kInstalled)) word.erase(0, kInstalled.size());
  }
  const auto says = [&](std::string_view option) { return std::ranges::find(words, option) != words.end(); };
  const std::string command = words.front();
  if (command == "test" || command == "bench" || words.size() == 1)
    return command == "--version" ? words : Words{};
  if ((command == "run" && !says("--headless")) || command == "edit") return {"check", words[1]};
  if (command == "build" && !says("--emit")) words.insert(words.end(), {"--emit", "cnl"});
  return words;
}

// `...` stands for any lines.
bool is_shown_by(const std::vector<std::string>& expected, const std::string& output) {
  std::size_t at = 0;
  bool may_skip = false;
  for (const std::string& line : expected) {
    if (line == "...") {
      may_skip = true;
      continue;
    }
    const std::size_t found = output.find(line + "\n", at);
    if (found == std::string::npos || (!may_skip && found != at)) return false;
    at = found + line.size() + 1;
    may_skip = false;
  }
  return true;
}

TEST_F(Pages, EveryCommandLineInABlockWorksAndPrintsWhatIsShown) {
  std::vector<Shown> all;
  for (const fs::path& page : pages()) read_blocks(page, all);
  EXPECT_GT(all.size(), 30U);
  std::size_t outputs = 0;
  for (const Shown& shown : all) {
    const Words words = trial_of(shown.words);
    if (words.empty()) continue;
    const bool shows_mistake =
        !shown.output.empty() && shown.output.front().find("error:") != std::string::npos;
    // The reader was told to write `Gat` for `Gate`.
    const fs::path patrol = folder_ / "my" / "patrol.mdl";
    if (shows_mistake) {
      std::string text = fmt::format("{}\n", fmt::join(lines_of(patrol), "\n"));
      text.replace(text.find("MOVETO Gate"), 11, "MOVETO Gat");
      std::ofstream(patrol) << text;
    }
    int status = 0;
    const std::string output = mlab(words, status);
    EXPECT_EQ(status, shows_mistake ? 2 : 0) << shown.place << "\n" << output;
    EXPECT_TRUE(is_shown_by(shown.output, output)) << shown.place << "\n" << output;
    outputs += shown.output.empty() ? 0 : 1;
    if (shows_mistake)
      fs::copy_file(kRoot / "missions/patrol/patrol.mdl", patrol, fs::copy_options::overwrite_existing);
  }
  EXPECT_GE(outputs, 2U);
}

TEST_F(Pages, EveryCommandAndOptionThatIsNamedExists) {
  std::vector<Shown> all;
  for (const fs::path& page : pages()) {
    read_blocks(page, all);
    read_sentences(page, all);
  }
  EXPECT_GT(all.size(), 80U);
  for (const Shown& shown : all) {
    const std::string& command = shown.words.front();
    if (command == "COMMAND" || command == "WORDS") continue;
    const std::string& help = help_of(command);
    EXPECT_TRUE(help.find(command.starts_with("-") ? command : "Usage") != std::string::npos ||
                command == "test")
        << shown.place << ": " << command;
    for (const std::string& word : shown.words) {
      if (!word.starts_with("-") || word == "-") continue;
      EXPECT_NE(help.find(word.substr(0, word.find('='))), std::string::npos) << shown.place << ": " << word;
    }
  }
}

TEST(PagesThemselves, AnOutputThatDiffersIsFound) {
  EXPECT_TRUE(is_shown_by({"a", "...", "c"}, "a\nb\nc\n"));
  EXPECT_TRUE(is_shown_by({}, "a\n"));
  EXPECT_FALSE(is_shown_by({"a", "c"}, "a\nb\nc\n"));
  EXPECT_FALSE(is_shown_by({"a", "...", "d"}, "a\nb\nc\n"));
  EXPECT_EQ(command_words("$ ./mlab run x.mdl --seed 2   # again"), (Words{"run", "x.mdl", "--seed", "2"}));
  EXPECT_EQ(command_words("cmake --build ."), Words{});
}

}  // namespace
}  // namespace mlab
