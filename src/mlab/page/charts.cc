#include "mlab/page/charts.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/core.h>

#include "mlab/page/numbers.h"
#include "mlab/text/escape.h"

namespace mlab::page {
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
  const std::vector<std::uint64_t> counts = statistics::histogram(*row.sample, axis.low, axis.high, width);
  const std::uint64_t most = *std::ranges::max_element(counts);
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

namespace {

bool is_number(const std::pair<double, double>& point) {
  return std::isfinite(point.first) && std::isfinite(point.second);
}

template <class Placed>
std::string path_of(const Line& line, Placed placed) {
  std::string d;
  bool is_open = false;
  for (const auto& point : line.points) {
    if (!is_number(point)) {
      is_open = false;
      continue;
    }
    const auto [x, y] = placed(point);
    d += fmt::format("{}{:.1f} {:.1f}", is_open ? 'L' : 'M', x, y);
    is_open = true;
  }
  return fmt::format(R"(<path class="line{}" d="{}"/>)", line.is_second ? " two" : "", d);
}

}  // namespace

std::string line_row(const LineRow& row, const Axis& axis) {
  std::string drawing = grid(axis);
  if (row.mark)
    drawing += fmt::format(R"(<path class="median" d="M{:.1f} 0V{}"/>)", axis.at(*row.mark), kHeight);
  for (const Line& line : row.lines) {
    drawing += path_of(line, [&](const std::pair<double, double>& point) {
      const double share = row.top > 0.0 ? std::clamp(point.second / row.top, 0.0, 1.0) : 0.0;
      return std::pair(axis.at(point.first), (kHeight - 2.0) * (1.0 - share) + 1.0);
    });
  }
  return row_of(row.label, false, fmt::format("{}: {}", row.label, row.figure), drawing, row.figure);
}

std::string ways(const std::vector<Line>& lines, std::string_view said) {
  constexpr double kWidth = 1000.0;
  constexpr double kFar = std::numeric_limits<double>::infinity();
  double low_x = kFar;
  double low_y = kFar;
  double high_x = -kFar;
  double high_y = -kFar;
  for (const Line& line : lines) {
    for (const auto& point : line.points) {
      if (!is_number(point)) continue;
      low_x = std::min(low_x, point.first);
      high_x = std::max(high_x, point.first);
      low_y = std::min(low_y, point.second);
      high_y = std::max(high_y, point.second);
    }
  }
  if (low_x > high_x) return "";
  const double size = std::max({high_x - low_x, high_y - low_y, 1.0});
  const double scale = kWidth / size;
  std::string out =
      fmt::format(R"(<svg class="map" viewBox="-10 -10 {:.1f} {:.1f}" role="img" aria-label="{}">)",
                  (high_x - low_x) * scale + 20.0, (high_y - low_y) * scale + 20.0, text::markup(said));
  for (const Line& line : lines) {
    out += path_of(line, [&](const std::pair<double, double>& point) {
      return std::pair((point.first - low_x) * scale, (high_y - point.second) * scale);
    });
  }
  return out + "</svg>\n";
}

namespace {

constexpr std::size_t kMostBeside = 6;  // columns that lie beside each other on any screen but a telephone's

// Broken before what stands in parentheses and nowhere else: a number and its unit, or a range, stay
// together.
std::string kept_together(std::string text) {
  for (std::size_t at = 0; (at = text.find(' ', at)) != std::string::npos; ++at) {
    if (at + 1 < text.size() && text[at + 1] != '(') text.replace(at, 1, "\u00a0");
  }
  return text;
}

// What the column of a cell is called, for where its head is not to be seen.
std::string named(const std::string& head) {
  return fmt::format(" data-head=\"{}\"", text::markup(head));
}

}  // namespace

std::string table(std::string_view caption, const std::vector<std::vector<std::string>>& rows,
                  std::size_t left_columns) {
  const bool is_wide = rows.front().size() > kMostBeside;
  std::string out = fmt::format(R"(<div class="scroll" tabindex="0" role="region" )"
                                "aria-label=\"{0}\"><table{1}><caption>{0}</caption>\n",
                                text::markup(caption), is_wide ? " class=\"wide\"" : "");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    out += i == 0 ? "<thead><tr>" : i == 1 ? "<tbody>\n<tr>" : "<tr>";
    for (std::size_t k = 0; k < rows[i].size(); ++k) {
      const char* const side = k < left_columns ? R"( class="left")" : "";
      const std::string& cell = rows[i][k];
      if (i == 0)
        out += fmt::format(R"(<th scope="col"{}>{}</th>)", side, text::markup(cell));
      else if (k == 0)
        out += fmt::format(R"(<th scope="row"{}{}>{}</th>)", side, named(rows[0][k]), text::markup(cell));
      else
        out += fmt::format("<td{}{}>{}</td>", side, named(rows[0][k]),
                           text::markup(k < left_columns ? cell : kept_together(cell)));
    }
    out += i == 0 ? "</tr></thead>\n" : "</tr>\n";
  }
  return out + (rows.size() > 1 ? "</tbody>" : "") + "</table></div>\n";
}

}  // namespace mlab::page
