#include "mlab/study/charts.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "mlab/study/words.h"
#include "mlab/text/escape.h"

namespace mlab::study {
namespace {

constexpr double kHeight = 30.0;  // of a drawing, in the units of its view box
constexpr std::size_t kMostMarks = 6;

std::string row_of(const std::string& label, bool is_second, std::string_view said,
                   const std::string& drawing, const std::string& figure) {
  return fmt::format(R"(<div class="row{}"><div class="label">{}</div><svg viewBox="0 0 1000 {}" )"
                     R"(preserveAspectRatio="none" )"
                     "role=\"img\" aria-label=\"{}\">{}</svg><div class=\"figure\">{}</div></div>\n",
                     is_second ? " second" : "", text::markup(label), kHeight, text::markup(said), drawing,
                     text::markup(figure));
}

std::string grid(const Axis& axis) {
  std::string out;
  for (const auto& [value, mark] : axis.marks) out += fmt::format("M{:.1f} 0V{}", axis.at(value), kHeight);
  return fmt::format(R"(<path class="grid" d="{}"/>)", out);
}

}  // namespace

double Axis::at(double value) const {
  return high > low ? 1000.0 * std::clamp((value - low) / (high - low), 0.0, 1.0) : 500.0;
}

Axis share_axis() {
  Axis out;
  for (int i = 0; i <= 4; ++i) out.marks.emplace_back(0.25 * i, fmt::format("{} %", 25 * i));
  return out;
}

Axis number_axis(double low, double high) {
  if (!(high > low)) {
    // A single value stands in the middle.
    const double around = std::max(1.0, std::abs(low) * 0.1);
    low -= low == 0.0 ? 0.0 : around;
    high += around;
  }
  const double step = statistics::round_step(high - low, kMostMarks - 2);
  Axis out{std::floor(low / step) * step, std::ceil(high / step) * step, {}};
  for (int i = 0; i <= static_cast<int>(kMostMarks); ++i) {
    const double value = out.low + i * step;
    if (value <= out.high + 0.01 * step) out.marks.emplace_back(value, brief(value));
  }
  return out;
}

std::string axis_row(const Axis& axis) {
  std::string out =
      R"(<div class="row axis" aria-hidden="true"><div class="label"></div><div class="marks">)";
  for (const auto& [value, mark] : axis.marks) {
    const double at = axis.at(value) / 10.0;
    // The outermost ones stay within.
    const int shift = at < 2.0 ? 0 : at > 98.0 ? -100 : -50;
    out += fmt::format(R"mark(<span style="left:{:.1f}%;transform:translateX({}%)">{}</span>)mark", at, shift,
                       text::markup(mark));
  }
  return out + "</div><div class=\"figure\"></div></div>\n";
}

std::string share_row(const ShareRow& row, const Axis& axis) {
  std::string figure = percent(row.count.share());
  std::string drawing = grid(axis);
  if (row.interval) {
    figure += fmt::format(" ({})", percents(*row.interval));
    drawing += fmt::format(R"(<path class="range" d="M{:.1f} 15H{:.1f}"/>)", axis.at(row.interval->low),
                           axis.at(row.interval->high));
  }
  drawing += fmt::format(R"(<path class="point" d="M{:.1f} 15h.01"/>)", axis.at(row.count.share()));
  const std::string said =
      fmt::format("{}: {} of {} runs succeed, {}", row.label, row.count.successes, row.count.trials, figure);
  return row_of(row.label, row.is_second, said, drawing, figure);
}

std::string sample_row(const SampleRow& row, const Axis& axis, double width) {
  std::vector<std::uint64_t> counts;
  for (const double value : row.sample->sorted) {
    const auto bin = static_cast<std::size_t>(std::max(0.0, std::floor((value - axis.low) / width)));
    if (bin >= counts.size()) counts.resize(bin + 1);
    ++counts[bin];
  }
  const std::uint64_t most = counts.empty() ? 1 : *std::ranges::max_element(counts);
  std::string bars;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] == 0) continue;
    const double x = axis.at(axis.low + static_cast<double>(i) * width);
    const double next = axis.at(axis.low + static_cast<double>(i + 1) * width);
    // Also a single run of many is seen.
    const double height =
        std::max(1.5, (kHeight - 1.0) * static_cast<double>(counts[i]) / static_cast<double>(most));
    bars += fmt::format("M{:.1f} {}V{:.1f}H{:.1f}V{}z", x, kHeight, kHeight - height,
                        std::max(next - 1.0, x + 2.0), kHeight);
  }
  std::string drawing = grid(axis) + fmt::format(R"(<path class="bars" d="{}"/>)", bars);
  if (!row.sample->empty())
    drawing += fmt::format(R"(<path class="median" d="M{:.1f} 0V{}"/>)",
                           axis.at(statistics::quantile(*row.sample, 0.5)), kHeight);
  const std::string figure = row.sample->empty() ? "none" : median_and_range(*row.sample);
  return row_of(row.label, row.is_second,
                fmt::format("{}: median and 90 % of the runs: {}", row.label, figure), drawing, figure);
}

std::string table(std::string_view caption, const std::vector<std::vector<std::string>>& rows,
                  std::size_t left_columns) {
  std::string out = fmt::format(R"(<div class="scroll" tabindex="0" role="region" )"
                                "aria-label=\"{0}\"><table><caption>{0}</caption>\n",
                                text::markup(caption));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    out += i == 0 ? "<thead><tr>" : i == 1 ? "<tbody>\n<tr>" : "<tr>";
    for (std::size_t k = 0; k < rows[i].size(); ++k) {
      const char* const side = k < left_columns ? R"( class="left")" : "";
      const std::string cell = text::markup(rows[i][k]);
      if (i == 0)
        out += fmt::format(R"(<th scope="col"{}>{}</th>)", side, cell);
      else if (k == 0)
        out += fmt::format(R"(<th scope="row"{}>{}</th>)", side, cell);
      else
        out += fmt::format("<td{}>{}</td>", side, cell);
    }
    out += i == 0 ? "</tr></thead>\n" : "</tr>\n";
  }
  return out + (rows.size() > 1 ? "</tbody>" : "") + "</table></div>\n";
}

std::string_view page_style() {
  return R"css(
:root { color-scheme: light dark; --back: #fff; --ink: #1b1f24; --faint: #57606a; --line: #d0d7de; --box: #f6f8fa;
  --one: #0b62b8; --two: #a04800; --good: #116329; --bad: #b3261e; }
@media (prefers-color-scheme: dark) { :root { --back: #0d1117; --ink: #e6edf3; --faint: #9da7b1; --line: #30363d;
  --box: #161b22; --one: #6cb6ff; --two: #f0a35e; --good: #57ab5a; --bad: #ff7b72; } }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 1rem; max-width: 75rem; background: var(--back); color: var(--ink);
  font: 16px/1.5 system-ui, "DejaVu Sans", sans-serif; }
h1 { font-size: 1.5rem; line-height: 1.25; margin: .5rem 0; }
h2 { font-size: 1.2rem; margin: 2rem 0 .5rem; }
h3 { font-size: 1rem; margin: 1.25rem 0 .25rem; }
p { margin: .5rem 0; max-width: 50rem; overflow-wrap: anywhere; }
.faint, .figure, .marks { color: var(--faint); }
.good { color: var(--good); font-weight: 600; }
.bad { color: var(--bad); font-weight: 600; }
.row { display: grid; grid-template-columns: minmax(6rem, 16rem) minmax(0, 1fr) 15rem; gap: 0 .75rem; align-items: center; }
.label { overflow-wrap: anywhere; }
.figure { font-size: .875rem; font-variant-numeric: tabular-nums; }
.row svg { display: block; width: 100%; height: 30px; overflow: visible; margin: 2px 0; --color: var(--one); }
.second svg { --color: var(--two); }
.axis .marks { position: relative; height: 1.5rem; font-size: .8125rem; }
.marks span { position: absolute; top: 0; white-space: nowrap; }
path { vector-effect: non-scaling-stroke; fill: none; }
.grid { stroke: var(--line); stroke-width: 1; }
.range { stroke: var(--color); stroke-width: 3; }
.point { stroke: var(--color); stroke-width: 11; stroke-linecap: round; }
.bars { fill: var(--color); opacity: .75; }
.median { stroke: var(--ink); stroke-width: 2; }
.scroll { overflow-x: auto; border: 1px solid var(--line); border-radius: 6px; }
.scroll:focus-visible { outline: 2px solid var(--one); }
table { border-collapse: collapse; width: 100%; font-size: .875rem; font-variant-numeric: tabular-nums; }
caption { text-align: left; padding: .4rem .6rem; color: var(--faint); }
th, td { padding: .3rem .6rem; text-align: right; white-space: nowrap; border-top: 1px solid var(--line); }
th { font-weight: 600; }
thead th { background: var(--box); }
.left { text-align: left; }
ol.causes { padding: 0; list-style: none; }
ol.causes li { margin: .75rem 0; padding: .5rem .75rem; border: 1px solid var(--line); border-left: 4px solid var(--bad);
  border-radius: 6px; overflow-wrap: anywhere; }
code { display: block; margin-top: .4rem; padding: .4rem .6rem; background: var(--box); border-radius: 4px;
  font: .8125rem/1.5 ui-monospace, "DejaVu Sans Mono", monospace; white-space: pre-wrap; overflow-wrap: anywhere;
  user-select: all; }
dl { display: grid; grid-template-columns: max-content minmax(0, 1fr); gap: .15rem 1rem; margin: .5rem 0; }
dt { color: var(--faint); }
dd { margin: 0; overflow-wrap: anywhere; }
@media (max-width: 45rem) {
  .row { grid-template-columns: minmax(0, 1fr) max-content; margin-bottom: .4rem; }
  .row .figure { grid-row: 1; grid-column: 2; text-align: right; }
  .row svg, .row .marks { grid-column: 1 / -1; }
  .axis .label, .axis .figure { display: none; }
}
@media print { .scroll { overflow: visible; } th, td { white-space: normal; } }
)css";
}

}  // namespace mlab::study
