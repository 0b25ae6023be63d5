#include "mlab/study/page.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "mlab/base/counted.h"
#include "mlab/page/charts.h"
#include "mlab/page/document.h"
#include "mlab/study/words.h"
#include "mlab/text/escape.h"

namespace mlab::study {
namespace {

using page::Axis;
using page::axis_row;
using page::number_axis;
using page::sample_row;
using page::share_axis;
using page::share_row;
using page::ShareRow;
using page::table;

constexpr std::size_t kMostDrawn = 40;  // combinations in a plot; the table has all
constexpr std::size_t kMostBins = 40;   // of a distribution
constexpr std::size_t kMostPieces = 8;  // of the range of a drawn value

std::string heading_of(std::string_view text) {
  return fmt::format("<h2>{}</h2>\n", text::markup(text));
}

// As a page in one file refers to another file.
std::string link(const std::string& from, const std::string& to) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(from).parent_path();
  const fs::path target(to);
  fs::path path = target;
  if (folder.is_absolute() == target.is_absolute())
    path = target.lexically_relative(folder.empty() ? "." : folder);
  if (path.empty()) path = target;
  const std::string plain = path.generic_string();
  std::string out = plain.starts_with('/') ? "file://" : "./";
  for (const char c : plain) {
    const bool is_kept =
        std::isalnum(static_cast<unsigned char>(c)) != 0 || std::string_view("-_.~/").contains(c);
    out += is_kept ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return out;
}

/// Builds the page, piece by piece.
class PageMaker {
 public:
  PageMaker(const Batch& batch, const Summary& summary, const Definition& definition, const Plan& plan,
            const PageWords& words)
      : batch_(batch), summary_(summary), definition_(definition), plan_(plan), words_(words) {}

  std::string make() {
    const std::string title =
        fmt::format("Batch: {}", words_.title.empty() ? definition_.mission.text : words_.title);
    add_facts();
    add_verdicts();
    add_shares();
    add_table();
    add_comparisons();
    add_distributions();
    add_drawn();
    add_failures();
    add_definition();
    return page::document(title, out_);
  }

 private:
  std::string label_of(const CellSummary& cell) const {
    std::string out = text_of(cell.settings);
    if (plan_.versions() == 2)
      out += (out.empty() ? "" : ", ") + std::string(cell.version == 0 ? "mission" : "against");
    return out.empty() ? "all runs" : out;
  }
  // Both versions of a combination one below the other.
  std::vector<const CellSummary*> drawn_cells() const {
    std::vector<const CellSummary*> out;
    const std::size_t combinations = plan_.combinations();
    for (std::size_t i = 0; i < combinations && out.size() < kMostDrawn; ++i) {
      for (std::size_t version = 0; version < plan_.versions(); ++version)
        out.push_back(&summary_.cells[version * combinations + i]);
    }
    return out;
  }
  void add_left_out() {
    if (summary_.cells.size() > kMostDrawn)
      out_ += fmt::format("<p class=\"faint\">The first {} of {}; the table below has all.</p>\n", kMostDrawn,
                          base::counted(summary_.cells.size(), "combination"));
  }

  void add_facts() {
    const std::uint64_t succeeded = summary_.runs - summary_.failed;
    out_ +=
        fmt::format("<p>{} in {}, seeds {} to {}. <strong>{} succeeded, {} failed.</strong></p>\n",
                    base::counted(summary_.runs, "run"), base::counted(plan_.combinations(), "combination"),
                    plan_.seed(0), plan_.seed(plan_.runs() - 1), succeeded, summary_.failed);
  }

  void add_verdicts() {
    for (const Verdict& verdict : summary_.verdicts) {
      out_ += fmt::format(R"(<p><span class="{}">{}</span>: {})", verdict.is_met() ? "good" : "bad",
                          verdict.is_met() ? "Met" : "Not met", text::markup(verdict.requirement->text));
      for (std::size_t i = 0; i < std::min<std::size_t>(verdict.unmet.size(), 5); ++i) {
        const std::uint32_t combination = verdict.unmet[i];
        const std::string set = text_of(plan_.settings(combination));
        out_ += fmt::format("{}{}{}", i == 0 ? " (" : "; ", set.empty() ? "" : text::markup(set) + ": ",
                            percents(verdict.intervals[combination]));
      }
      if (verdict.unmet.size() > 5) out_ += fmt::format("; and {} more", verdict.unmet.size() - 5);
      out_ += verdict.unmet.empty() ? "</p>\n" : ")</p>\n";
    }
  }

  void add_shares() {
    out_ += heading_of("Success");
    out_ += fmt::format("<p class=\"faint\">The share of runs that succeed ({}), with {}.</p>\n",
                        text::markup(definition_.success ? definition_.success->text() : "outcome == done"),
                        interval_words());
    const Axis axis = share_axis();
    for (const CellSummary* cell : drawn_cells())
      out_ += share_row({label_of(*cell), cell->successes, cell->interval, cell->version == 1}, axis);
    out_ += axis_row(axis);
    add_left_out();
  }
  std::string interval_words() const {
    return definition_.until
               ? fmt::format("a confidence sequence: it has the true share, at any time, with {:g} %",
                             100.0 * definition_.confidence)
               : fmt::format(
                     "the exact interval (Clopper and Pearson) that has the true share with {:g} % or more",
                     100.0 * definition_.confidence);
  }

  void add_table() {
    const std::vector<NumberInfo> numbers = shown_numbers();
    std::vector<std::vector<std::string>> rows(1);
    rows[0] = {"combination", "runs", "succeed", "share",
               fmt::format("{:g} %", 100.0 * definition_.confidence)};
    for (const NumberInfo& info : numbers) rows[0].push_back(heading(info));
    for (const CellSummary& cell : summary_.cells) {
      std::vector<std::string>& row = rows.emplace_back();
      row = {label_of(cell), std::to_string(cell.successes.trials), std::to_string(cell.successes.successes),
             percent(cell.successes.share()), percents(cell.interval)};
      for (const statistics::Sample& sample : cell.samples) row.push_back(median_and_range(sample));
    }
    out_ += "<h3>In figures</h3>\n";
    out_ += table("Medians, in parentheses where nine of ten runs are", rows, 1);
  }

  void add_comparisons() {
    if (summary_.comparisons.empty()) return;
    out_ += heading_of("The two versions, in pairs");
    out_ += fmt::format(
        R"(<p class="faint">Each pair has the same seed and the same values. Success by McNemar's exact )"
        "test, numbers "
        "by Wilcoxon's signed ranks: p is how likely a difference at least so large is by chance alone. "
        "Differences "
        "are those of {} less {}.</p>\n",
        text::markup(definition_.mission.text), text::markup(definition_.against.text));
    const std::vector<NumberInfo> numbers = shown_numbers();
    std::vector<std::vector<std::string>> rows = {
        {"combination", "number", "pairs", "different", "mean difference", "median difference", "p"}};
    for (const Comparison& one : summary_.comparisons) {
      const std::string set = text_of(plan_.settings(one.combination));
      const statistics::Discordant& success = one.successes;
      rows.push_back({set.empty() ? "all runs" : set, "success", std::to_string(one.pairs),
                      std::to_string(success.only_first + success.only_second),
                      fmt::format("{} only here, {} only there", success.only_first, success.only_second), "",
                      p_words(one.p)});
      for (std::size_t i = 0; i < numbers.size(); ++i) {
        const Comparison::Difference& d = one.differences[i];
        if (d.pairs == 0) continue;
        rows.push_back({set.empty() ? "all runs" : set, heading(numbers[i]), std::to_string(d.pairs),
                        std::to_string(d.ranks.pairs), signed_number(d.mean), signed_number(d.median),
                        p_words(d.ranks.p)});
      }
    }
    out_ += table("Differences", rows, 2);
  }

  void add_distributions() {
    out_ += heading_of("Distributions");
    out_ += "<p class=\"faint\">Bars: how many runs, the highest of each row alike. Line: the median.</p>\n";
    const std::vector<NumberInfo> numbers = shown_numbers();
    const std::vector<const CellSummary*> cells = drawn_cells();
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      std::vector<double> ends;
      for (const CellSummary* cell : cells) {
        if (cell->samples[i].empty()) continue;
        ends.push_back(cell->samples[i].sorted.front());
        ends.push_back(cell->samples[i].sorted.back());
      }
      if (ends.empty()) continue;
      const auto [low, high] = std::ranges::minmax(ends);
      out_ += fmt::format("<h3>{}</h3>\n", text::markup(heading(numbers[i])));
      if (low == high) {
        out_ += fmt::format("<p>{} in all runs.</p>\n", brief(low));
        continue;
      }
      const Axis axis = number_axis(low, high);
      const double width = bin_width(cells, i, axis.high - axis.low);
      for (const CellSummary* cell : cells)
        out_ += sample_row({label_of(*cell), &cell->samples[i], cell->version == 1}, axis, width);
      out_ += axis_row(axis);
    }
    add_left_out();
  }

  // One for all rows, so that they can be compared: that of the sample which shows most.
  static double bin_width(const std::vector<const CellSummary*>& cells, std::size_t number, double span) {
    double width = span;
    bool is_whole = true;  // counts are
    for (const CellSummary* cell : cells) {
      const statistics::Sample& sample = cell->samples[number];
      if (sample.empty()) continue;
      width = std::min(width, statistics::bin_width(sample, span, kMostBins));
      is_whole = is_whole && std::ranges::all_of(sample.sorted, [](double v) { return v == std::floor(v); });
    }
    return is_whole ? std::max(width, 1.0) : width;
  }

  // Success over pieces of the range of each value that was drawn.
  void add_drawn() {
    for (std::size_t i = 0; i < definition_.dimensions.size(); ++i) {
      const Dimension& one = definition_.dimensions[i];
      if (!one.is_drawn()) continue;
      out_ += heading_of(fmt::format("Success by {}", one.name.text));
      out_ += fmt::format("<p class=\"faint\">Over pieces of the range that it was drawn from{}.</p>\n",
                          text::markup(pooled_words()));
      const std::vector<statistics::Count> all = counts_over(i, std::nullopt);
      const Axis axis = share_axis();
      for (std::size_t piece = 0; piece < kMostPieces; ++piece) {
        if (all[piece].trials == 0) continue;
        ShareRow row{piece_of(one, piece) + ": " + base::counted(all[piece].trials, "run"), all[piece],
                     std::nullopt, false};
        // Runs of several combinations have seeds in common: together they are no independent trials.
        if (plan_.combinations() == 1)
          row.interval = interval_of(definition_, all[piece], definition_.confidence);
        out_ += share_row(row, axis);
      }
      out_ += axis_row(axis);
      add_each_combination(i);
    }
  }
  // What is taken together in these shares.
  std::string pooled_words() const {
    std::string out;
    if (plan_.combinations() > 1)
      out = fmt::format(", all {} together", base::counted(plan_.combinations(), "combination"));
    if (drawn_count() > 1) out += ", whatever else was drawn";
    if (plan_.versions() == 2) out += fmt::format("; of {} alone", definition_.mission.text);
    return out;
  }
  std::size_t drawn_count() const {
    return static_cast<std::size_t>(std::ranges::count_if(definition_.dimensions, &Dimension::is_drawn));
  }
  std::string piece_of(const Dimension& one, std::size_t piece) const {
    const double width = (one.high - one.low) / static_cast<double>(kMostPieces);
    const double from = one.low + static_cast<double>(piece) * width;
    return fmt::format("{} to {}", brief(from), brief(from + width));
  }
  // By piece of the range of a value that was drawn; of one combination, or of all.
  std::vector<statistics::Count> counts_over(std::size_t dimension,
                                             std::optional<std::uint32_t> combination) const {
    const Dimension& one = definition_.dimensions[dimension];
    const double width = (one.high - one.low) / static_cast<double>(kMostPieces);
    std::vector<statistics::Count> out(kMostPieces);
    for (std::uint32_t c = 0; c < plan_.combinations(); ++c) {
      if (combination && c != *combination) continue;
      for (const Row& row : batch_.cell(0, c).rows) {
        const double value = plan_.drawn(dimension, row.key.run);
        const auto piece = static_cast<std::size_t>(std::max(0.0, (value - one.low) / width));
        statistics::Count& count = out[std::min(piece, kMostPieces - 1)];
        ++count.trials;
        if (row.success) ++count.successes;
      }
    }
    return out;
  }
  // The same for each combination by itself, of as many as go beside each other.
  void add_each_combination(std::size_t dimension) {
    constexpr std::uint64_t kMostBeside = 8;
    if (plan_.combinations() < 2 || plan_.combinations() > kMostBeside) return;
    const Dimension& one = definition_.dimensions[dimension];
    std::vector<std::vector<std::string>> rows = {{one.name.text}};
    for (std::size_t piece = 0; piece < kMostPieces; ++piece) rows.push_back({piece_of(one, piece)});
    for (std::uint32_t c = 0; c < plan_.combinations(); ++c) {
      rows[0].push_back(text_of(plan_.settings(c)));
      const std::vector<statistics::Count> counts = counts_over(dimension, c);
      for (std::size_t piece = 0; piece < kMostPieces; ++piece)
        rows[piece + 1].push_back(share_text(counts[piece]));
    }
    out_ += table("Of each combination by itself", rows, 1);
  }
  static std::string share_text(statistics::Count count) {
    if (count.trials == 0) return "no run";
    return fmt::format("{} of {}, {}", count.successes, count.trials, percent(count.share()));
  }

  std::string recording_of(const FailureGroup& group) const {
    if (group.recording.empty()) return {};
    return fmt::format("<a href=\"{}\">its recording</a>, computed again by<code>{}</code>",
                       text::markup(link(words_.file, group.recording)),
                       text::markup(replay_of(group.recording)));
  }
  void add_failures() {
    out_ += heading_of("Failures");
    if (summary_.failures.empty()) {
      out_ += "<p>None.</p>\n";
      return;
    }
    out_ +=
        "<p class=\"faint\">By cause, each with the first such run and the command that repeats it: a click "
        "selects "
        "the whole of it.</p>\n"
        "<ol class=\"causes\">\n";
    for (const FailureGroup& group : summary_.failures) {
      const std::string set = text_of(plan_.settings(group.first));
      out_ += fmt::format(
          "<li><strong>{}</strong>: {}<br><span class=\"faint\">seed {}{}{}: "
          "{}</span><code>{}</code>{}</li>\n",
          base::counted(group.count, "run"), text::markup(group.cause), plan_.seed(group.first.run),
          set.empty() ? "" : ", ", text::markup(set), text::markup(group.message),
          text::markup(group.command), recording_of(group));
    }
    out_ += "</ol>\n";
  }

  void add_definition() {
    out_ += heading_of("What was run");
    out_ += "<dl>\n";
    fact("mission", definition_.mission.text);
    if (!definition_.against.empty()) fact("against", definition_.against.text);
    fact("mission clock at the start", definition_.start_time);
    for (const Dimension& one : definition_.dimensions) {
      std::string values;
      for (const Written& value : one.values) values += (values.empty() ? "" : ", ") + value.text;
      if (one.is_drawn())
        values = fmt::format("drawn between {} and {}{}", shortest(one.low), shortest(one.high),
                             definition_.is_latin ? " (Latin hypercube)" : "");
      fact(one.name.text, values);
    }
    if (definition_.duration) fact("for", brief(*definition_.duration) + " s");
    if (definition_.limit) fact("limit", brief(*definition_.limit) + " s");
    if (!definition_.environment.empty()) fact("environment", definition_.environment.text);
    if (definition_.until) fact("until", definition_.until->text);
    fact("program", "mlab " + words_.program_version);
    out_ += "</dl>\n";
  }
  void fact(std::string_view name, std::string_view value) {
    out_ += fmt::format("<dt>{}</dt><dd>{}</dd>\n", text::markup(name), text::markup(value));
  }

  const Batch& batch_;
  const Summary& summary_;
  const Definition& definition_;
  const Plan& plan_;
  const PageWords& words_;
  std::string out_;
};

}  // namespace

std::string page_of(const Batch& batch, const Summary& summary, const Definition& definition,
                    const Plan& plan, const PageWords& words) {
  return PageMaker(batch, summary, definition, plan, words).make();
}

}  // namespace mlab::study
