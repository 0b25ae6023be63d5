#include "pages.h"

#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <optional>
#include <regex>
#include <sstream>

#include <fmt/core.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include "mlab/base/testing/source_folder.h"

namespace mlab::examples {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kIndent = "    ";
constexpr std::string_view kPrompt = "    $ ";
constexpr std::string_view kAnything = "...";

std::string place_of(const fs::path& page, std::size_t line) {
  return fmt::format("{}:{}", page.lexically_relative(root()).string(), line + 1);
}

// Change `FROM` to `TO` in `FILE`, at the begin of a line; or Change it back.
std::optional<Change> change_in(std::string_view line) {
  if (line.starts_with("Change it back")) return Change{};
  static const std::regex kChange("(^|[^\"])Change `([^`]+)` to `([^`]*)` in `([^`]+)`");
  std::cmatch match;
  if (!std::regex_search(line.data(), line.data() + line.size(), match, kChange)) return std::nullopt;
  EXPECT_EQ(match.position(0), 0) << "what is to be changed has to stand at the begin of a line: " << line;
  return Change{match[2], match[3], match[4].str()};
}

int expected_status(const ShownCommand& shown) {
  const auto shows = [&](std::string_view words) {
    return std::ranges::any_of(
        shown.output, [&](const std::string& line) { return line.find(words) != std::string::npos; });
  };
  if (shows("  FAIL  ")) return 1;
  if (shows("error:")) return 2;
  if (shown.command.starts_with("./mlab compare ")) return shows("Where they part") ? 1 : 0;
  if (shown.command.starts_with("./mlab diff ")) return shown.output.empty() ? 0 : 1;
  return shows("mission failed") || shows("mission aborted") ? 1 : 0;
}

// What the page shows as typed behind a question.
std::string answers_in(const ShownCommand& shown) {
  constexpr std::string_view kQuestion = "[y/n] ";
  std::string out;
  for (const std::string& line : shown.output) {
    const std::size_t at = line.find(kQuestion);
    if (at != std::string::npos) out += line.substr(at + kQuestion.size()) + "\n";
  }
  return out;
}

// `...` in the pattern stands for anything.
bool is_line_shown_by(std::string_view pattern, std::string_view line) {
  const std::size_t gap = pattern.find(kAnything);
  if (gap == std::string_view::npos) return pattern == line;
  if (!line.starts_with(pattern.substr(0, gap))) return false;
  const std::string_view rest = pattern.substr(gap + kAnything.size());
  for (std::size_t at = gap; at <= line.size(); ++at) {
    if (is_line_shown_by(rest, line.substr(at))) return true;
  }
  return false;
}

bool are_shown_by(const std::vector<std::string>& expected, std::size_t i,
                  const std::vector<std::string>& lines, std::size_t at) {
  for (; i < expected.size(); ++i, ++at) {
    if (expected[i] == kAnything) {
      for (; at <= lines.size(); ++at) {
        if (are_shown_by(expected, i + 1, lines, at)) return true;
      }
      return false;
    }
    if (at >= lines.size() || !is_line_shown_by(expected[i], lines[at])) return false;
  }
  return at == lines.size();
}

}  // namespace

const fs::path& root() {
  static const fs::path kRoot = base::source_folder();
  return kRoot;
}

Workplace::Workplace() {
  std::string name = (fs::temp_directory_path() / "mlab_examples_XXXXXX").string();
  all_ = mkdtemp(name.data());
  folder_ = all_ / "here";
  fs::create_directories(folder_ / "build");
  fs::create_symlink(MLAB_COMMAND, folder_ / "mlab");
}

Workplace::~Workplace() {
  std::error_code ignored;
  fs::remove_all(all_, ignored);
}

void Workplace::take(const fs::path& from, const fs::path& to) const {
  fs::create_directories((folder_ / to).parent_path());
  fs::copy(root() / from, folder_ / to, fs::copy_options::recursive | fs::copy_options::overwrite_existing);
}

void Workplace::make(const Change& change, const fs::path& page) {
  if (change.file.empty()) {
    for (const auto& [file, text] : unchanged_) std::ofstream(file) << text;
    return;
  }
  const fs::path beside = folder_ / page.parent_path() / change.file;
  const fs::path file = fs::exists(beside) ? beside : folder_ / change.file;
  std::string text = text_of(file);
  const std::size_t at = text.find(change.from);
  ASSERT_NE(at, std::string::npos) << page << ": there is no `" << change.from << "` in " << change.file;
  EXPECT_EQ(text.find(change.from, at + 1), std::string::npos)
      << page << ": `" << change.from << "` stands in " << change.file << " more than once";
  unchanged_.try_emplace(file, text);
  std::ofstream(file) << text.replace(at, change.from.size(), change.to);
}

bool Workplace::is_unchanged() const {
  return std::ranges::all_of(unchanged_, [](const auto& file) { return text_of(file.first) == file.second; });
}

Answer Workplace::carry_out(const std::string& command, const std::string& typed) const {
  std::ofstream(all_ / "typed") << typed;
  std::ofstream(all_ / "command") << command << "\n";
  const std::string line = fmt::format(
      "cd '{0}/here' && PATH=\"$PWD:$PATH\" XDG_CACHE_HOME='{0}/cache' sh '{0}/command' <'{0}/typed' 2>&1",
      all_.string());
  Answer answer;
  std::FILE* pipe = popen(line.c_str(), "r");
  if (pipe == nullptr) return answer;
  std::array<char, 4096> block{};
  for (std::size_t n = 0; (n = fread(block.data(), 1, block.size(), pipe)) > 0;)
    answer.output.append(block.data(), n);
  const int ended = pclose(pipe);
  answer.status = WIFEXITED(ended) ? WEXITSTATUS(ended) : -1;
  return answer;
}

std::vector<std::string> lines_of(const fs::path& file) {
  std::ifstream stream(file);
  std::vector<std::string> out;
  for (std::string line; std::getline(stream, line);) out.push_back(line);
  return out;
}

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<fs::path> pages_in(const std::vector<std::string>& folders) {
  std::vector<fs::path> out;
  for (const std::string& folder : folders) {
    for (const auto& entry : fs::recursive_directory_iterator(root() / folder)) {
      const bool is_ours = entry.path().string().find("node_modules") == std::string::npos;
      if (is_ours && entry.path().extension() == ".md") out.push_back(entry.path());
    }
  }
  std::ranges::sort(out);
  return out;
}

Words command_words(std::string_view command) {
  if (command.starts_with("./")) command.remove_prefix(2);
  if (!command.starts_with("mlab ")) return {};
  std::istringstream stream{
      std::string(command.substr(5, std::min(command.find(" #"), command.find(" |")) - 5))};
  return {std::istream_iterator<std::string>(stream), {}};
}

std::vector<ShownCommand> commands_in_blocks(const fs::path& page) {
  std::vector<ShownCommand> out;
  std::vector<Change> changes;
  const std::vector<std::string> lines = lines_of(page);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const bool has_prompt = lines[i].starts_with(kPrompt);
    const std::string_view line = lines[i];
    if (const auto change = change_in(line)) changes.push_back(*change);
    if (!line.starts_with(kIndent)) continue;
    ShownCommand shown{place_of(page, i),
                       std::string(line.substr((has_prompt ? kPrompt : kIndent).size())),
                       has_prompt,
                       {},
                       {}};
    if (!has_prompt && command_words(shown.command).empty()) continue;
    while (has_prompt && i + 1 < lines.size() && lines[i + 1].starts_with(kIndent) &&
           !lines[i + 1].starts_with(kPrompt))
      shown.output.push_back(lines[++i].substr(kIndent.size()));
    shown.changes.swap(changes);
    out.push_back(std::move(shown));
  }
  if (!changes.empty()) out.push_back({place_of(page, lines.size() - 1), {}, false, {}, std::move(changes)});
  return out;
}

std::vector<ShownCommand> commands_in_sentences(const fs::path& page) {
  std::vector<ShownCommand> out;
  const std::vector<std::string> lines = lines_of(page);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].starts_with(kIndent)) continue;
    for (std::size_t open = lines[i].find('`'); open != std::string::npos;) {
      const std::size_t close = lines[i].find('`', open + 1);
      if (close == std::string::npos) break;
      const std::string quoted = lines[i].substr(open + 1, close - open - 1);
      if (!command_words(quoted).empty()) out.push_back({place_of(page, i), quoted, false, {}, {}});
      open = lines[i].find('`', close + 1);
    }
  }
  return out;
}

std::string trial_of(const ShownCommand& shown) {
  if (shown.has_prompt || shown.command.empty()) return shown.command;
  Words words = command_words(shown.command);
  for (std::string& word : words) {
    constexpr std::string_view kInstalled = "/usr/share/mlab/";
    if (word.starts_with(kInstalled)) word.erase(0, kInstalled.size());
  }
  const auto says = [&](std::string_view option) { return std::ranges::find(words, option) != words.end(); };
  const std::string command = words.front();
  // `diff` may ask git of revisions that only the reader has.
  // `python` is the launcher's, whose tests are elsewhere.
  if (command == "test" || command == "python" || command == "bench" || command == "diff" ||
      (words.size() == 1 && command != "--version"))
    return {};
  const bool opens_page = (command == "run" || command == "replay") && !says("--headless");
  const bool has_mission = command == "run" && !says("--resume");
  if ((opens_page && has_mission) || command == "edit") words = {"check", words[1]};
  // A few runs show as well as hundreds that it works.
  if (command == "batch" && !says("--merge")) {
    const auto runs = std::ranges::find(words, "--runs");
    if (words.end() - runs > 1) words.erase(runs, runs + 2);
    words.insert(words.end(), {"--runs", "5"});
  }
  // It would wait for runs or for people for ever, or wants what others have left.
  if (command == "agent" || command == "robot" || command == "preflight" || (opens_page && !has_mission) ||
      says("--merge"))
    words.emplace_back("--help");
  if (command == "build" && !says("--emit")) words.insert(words.end(), {"--emit", "cnl"});
  return fmt::format("./mlab {}", fmt::join(words, " "));
}

void expect_as_shown(Workplace& here, const ShownCommand& shown) {
  SCOPED_TRACE(shown.place);
  for (const Change& change : shown.changes) here.make(change, shown.place.substr(0, shown.place.rfind(':')));
  const std::string command = trial_of(shown);
  if (command.empty()) return;
  const Answer answer = here.carry_out(command, answers_in(shown));
  EXPECT_EQ(answer.status, expected_status(shown)) << command << "\n" << answer.output;
  EXPECT_TRUE(!shown.has_prompt || is_shown_by(shown.output, answer.output)) << command << "\n"
                                                                             << answer.output;
}

bool is_shown_by(const std::vector<std::string>& expected, const std::string& output) {
  std::istringstream stream(output);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return are_shown_by(expected, 0, lines, 0);
}

}  // namespace mlab::examples
