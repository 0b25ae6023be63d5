#include "mlab/cli/batch_screen.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include <fmt/core.h>

#include "mlab/base/counted.h"
#include "mlab/cli/clock.h"
#include "mlab/cli/terminal.h"
#include "mlab/study/words.h"
#include "mlab/text/shown.h"
#include "mlab/text/utf8.h"

namespace mlab::cli {
namespace {

constexpr std::size_t kMostRows = 40;
constexpr std::size_t kMostCauses = 8;

std::string duration(double seconds) {
  const auto whole = static_cast<long>(std::ceil(seconds));
  if (whole < 100) return fmt::format("{} s", whole);
  if (whole < 6000) return fmt::format("{} min", (whole + 59) / 60);
  return fmt::format("{} h {} min", whole / 3600, whole % 3600 / 60);
}

std::size_t columns_of(const std::string& text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U; }));
}

// Columns as wide as what stands in them; numbers to the right.
void print_table(const std::vector<std::vector<std::string>>& rows, std::size_t left_columns) {
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], columns_of(row[i]));
  }
  for (const auto& row : rows) {
    std::string line = " ";
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string blanks(widths[i] - columns_of(row[i]), ' ');
      line += " " + (i < left_columns ? row[i] + blanks : blanks + row[i]) + " ";
    }
    line.erase(line.find_last_not_of(' ') + 1);
    fmt::print("{}\n", line);
  }
}

void print_cells(const study::Summary& summary, const study::Definition& definition) {
  const std::vector<study::NumberInfo> numbers = study::shown_numbers();
  const bool is_compared = !definition.against.empty();
  std::vector<std::vector<std::string>> rows(1);
  if (is_compared) rows[0].emplace_back("version");
  rows[0].emplace_back(summary.cells.front().settings.empty() ? "" : "set");
  rows[0].insert(rows[0].end(), {"runs", "success", fmt::format("{:g} %", 100.0 * definition.confidence)});
  for (const study::NumberInfo& info : numbers) rows[0].push_back(study::heading(info));
  for (const study::CellSummary& cell : summary.cells) {
    if (rows.size() > kMostRows) break;
    std::vector<std::string>& row = rows.emplace_back();
    if (is_compared) row.emplace_back(cell.version == 0 ? "mission" : "against");
    row.push_back(text::shown(study::text_of(cell.settings), 60));
    row.push_back(std::to_string(cell.successes.trials));
    row.push_back(study::percent(cell.successes.share()));
    row.push_back(study::percents(cell.interval));
    for (const statistics::Sample& sample : cell.samples) row.push_back(study::median_and_range(sample));
  }
  print_table(rows, is_compared ? 2 : 1);
  if (summary.cells.size() > kMostRows)
    fmt::print("  and {} more combinations, which the table and the page have\n",
               summary.cells.size() - kMostRows);
}

void print_failures(const study::Summary& summary) {
  if (summary.failures.empty()) return;
  fmt::print("failures:\n");
  for (std::size_t i = 0; i < std::min(summary.failures.size(), kMostCauses); ++i) {
    const study::FailureGroup& group = summary.failures[i];
    fmt::print("  {} x {}\n      {}\n", group.count, text::shown(group.cause, 120),
               text::shown(group.command, 1000));
    if (!group.recording.empty())
      fmt::print("      {}\n", text::shown(study::replay_of(group.recording), 1000));
  }
  if (summary.failures.size() > kMostCauses)
    fmt::print("  and {} more causes\n", summary.failures.size() - kMostCauses);
}

void print_comparisons(const study::Summary& summary) {
  const std::vector<study::NumberInfo> numbers = study::shown_numbers();
  for (const study::Comparison& one : summary.comparisons) {
    const std::string set = study::text_of(summary.cells[one.combination].settings);
    fmt::print("in {}{}{}: only the mission succeeds in {}, only the other in {} (McNemar: {})\n",
               base::counted(one.pairs, "pair"), set.empty() ? "" : " of ", text::shown(set, 60),
               one.successes.only_first, one.successes.only_second, study::p_words(one.p));
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const study::Comparison::Difference& difference = one.differences[i];
      if (difference.pairs == 0) continue;
      fmt::print("  {}: {} by the median, {} different (signed ranks: {})\n", study::heading(numbers[i]),
                 study::signed_number(difference.median), base::counted(difference.ranks.pairs, "pair"),
                 study::p_words(difference.ranks.p));
    }
  }
}

}  // namespace

BatchProgress::BatchProgress(bool is_quiet)
    : is_shown_(!is_quiet && isatty(STDERR_FILENO) == 1), began_(steady_seconds()) {}

void BatchProgress::show(const study::Progress& progress) {
  const double now = steady_seconds();
  if (!is_shown_ || now - last_ < 0.2) return;
  last_ = now;
  std::string left;
  if (const std::uint64_t done = progress.done - progress.before; done > 0 && now > began_) {
    const double each = (now - began_) / static_cast<double>(done);
    left = fmt::format(", {} left", duration(each * static_cast<double>(progress.all - progress.done)));
  }
  fmt::print(stderr, "\r\033[K{} of {} runs, {} failed{}", progress.done, progress.all, progress.failed,
             left);
  std::fflush(stderr);
}

void BatchProgress::clear() const {
  if (!is_shown_) return;
  fmt::print(stderr, "\r\033[K");
  std::fflush(stderr);
}

void print_summary(const study::Summary& summary, const study::Definition& definition,
                   const study::Plan& plan, const std::string& mission, double seconds) {
  fmt::print("{}: {} with seeds from {} on, {}; {} failed; {:.1f} s\n",
             text::shown(mission.empty() ? definition.mission.text : mission),
             base::counted(summary.runs, "run"), plan.seed(0),
             base::counted(plan.combinations(), "combination"), summary.failed, seconds);
  print_cells(summary, definition);
  print_failures(summary);
  print_comparisons(summary);
}

void print_verdicts(const study::Summary& summary) {
  for (const study::Verdict& verdict : summary.verdicts) {
    if (verdict.is_met()) {
      fmt::print("{}: {}\n", verdict.requirement->text, colored("met", Color::kGood));
      continue;
    }
    const std::uint32_t first = verdict.unmet.front();
    const std::string set = study::text_of(summary.cells[first].settings);
    fmt::print("{}: {} ({}{}{}){}\n", verdict.requirement->text, colored("not met", Color::kBad),
               text::shown(set, 60), set.empty() ? "" : ": ", study::percents(verdict.intervals[first]),
               verdict.unmet.size() > 1
                   ? fmt::format(", and so in {} more combinations", verdict.unmet.size() - 1)
                   : "");
  }
}

}  // namespace mlab::cli
