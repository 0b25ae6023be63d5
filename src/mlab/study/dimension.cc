#include "mlab/study/dimension.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <unordered_set>
#include <utility>

#include <fmt/core.h>

#include "mlab/text/shown.h"

namespace mlab::study {
namespace {

std::unexpected<text::Diagnostic> wrong(std::string kind, const text::Place& place, std::string message,
                                        std::string hint = "") {
  text::Diagnostic out;
  out.kind = std::move(kind);
  out.message = std::move(message);
  out.place = place;
  if (!hint.empty()) out.hints.push_back(std::move(hint));
  return std::unexpected(std::move(out));
}

std::optional<double> number_in(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

// A part of what was written; where it was put together from several places, all of it is meant.
Written part_of(const Written& all, std::size_t begin, std::size_t end) {
  while (begin < end && all.text[begin] == ' ') ++begin;
  while (end > begin && all.text[end - 1] == ' ') --end;
  Written out{all.text.substr(begin, end - begin), all.place};
  const bool is_verbatim = all.place.source && all.place.source->text(all.place.span) == all.text;
  if (is_verbatim) {
    out.place.span.end = all.place.span.begin + static_cast<std::uint32_t>(end);
    out.place.span.begin += static_cast<std::uint32_t>(begin);
  }
  return out;
}

std::vector<Written> split(const Written& all) {
  std::vector<Written> out;
  int depth = 0;
  std::size_t begin = 0;
  for (std::size_t i = 0; i <= all.text.size(); ++i) {
    const char c = i < all.text.size() ? all.text[i] : ',';
    if (c == '{' || c == '[' || c == '(') ++depth;
    if (c == '}' || c == ']' || c == ')') --depth;
    if (c != ',' || (depth > 0 && i < all.text.size())) continue;
    out.push_back(part_of(all, begin, i));
    begin = i + 1;
  }
  return out;
}

// `a..b`: two numbers; nothing where it is something else.
std::optional<std::pair<double, double>> drawn_between(std::string_view text) {
  const std::size_t dots = text.find("..");
  if (dots == std::string_view::npos) return std::nullopt;
  const auto low = number_in(text.substr(0, dots));
  const auto high = number_in(text.substr(dots + 2));
  if (!low || !high) return std::nullopt;
  return std::pair(*low, *high);
}

struct Range {
  double from = 0.0;
  double to = 0.0;
  double step = 1.0;
};
std::optional<Range> range_in(std::string_view text) {
  const std::size_t first = text.find(':');
  const std::size_t second = first == std::string_view::npos ? first : text.find(':', first + 1);
  if (second == std::string_view::npos) return std::nullopt;
  const auto from = number_in(text.substr(0, first));
  const auto to = number_in(text.substr(first + 1, second - first - 1));
  const auto step = number_in(text.substr(second + 1));
  if (!from || !to || !step) return std::nullopt;
  return Range{*from, *to, *step};
}

// How many decimals a number has where it is written out: 2 of 0.25, none of 300.
int decimals_of(double value) {
  char text[32];  // a double takes up to 24
  const auto written = std::to_chars(std::begin(text), std::end(text), value, std::chars_format::scientific);
  const std::string_view all(text, static_cast<std::size_t>(written.ptr - text));
  const std::size_t e = all.find('e');
  const std::size_t point = all.find('.');
  const auto digits = point < e ? static_cast<int>(e - point) - 1 : 0;
  const std::string_view exponent = all.substr(e + (all[e + 1] == '+' ? 2 : 1));
  int power = 0;
  std::from_chars(exponent.data(), exponent.data() + exponent.size(), power);
  return std::max(0, digits - power);
}

// A tenth is added up to 0.3, not to 0.30000000000000004; and three of them to -0.3 to 0, not to 5.6e-17.
std::string rounded(double value, int decimals) {
  return shortest(number_in(fmt::format("{:.{}f}", value, decimals)).value_or(value) + 0.0);
}

text::Result<std::vector<Written>> values_of(const Range& range, const Written& written) {
  const bool leads_there = range.to == range.from || (range.to > range.from) == (range.step > 0.0);
  if (range.step == 0.0 || !leads_there)
    return wrong("empty-range", written.place,
                 fmt::format("steps of {} don't lead from {} to {}", range.step, range.from, range.to),
                 "a range is FROM:TO:STEP");
  // Halves: what lies between two numbers may be more than a number can be.
  const double steps = (range.to / 2.0 - range.from / 2.0) / range.step * 2.0;
  if (!(steps < static_cast<double>(kMostValues)))
    return wrong("too-many-values", written.place,
                 fmt::format("the range has more than {} values", kMostValues));
  const int decimals = std::max(decimals_of(range.from), decimals_of(range.step));
  std::vector<Written> out;
  for (std::size_t i = 0; i <= static_cast<std::size_t>(steps + 1e-9); ++i)
    out.push_back(
        {rounded(std::fma(static_cast<double>(i), range.step, range.from), decimals), written.place});
  return out;
}

}  // namespace

std::string shortest(double value) {
  return fmt::format("{}", value);
}

Written written_in_option(std::string_view option, std::string_view value) {
  auto source = std::make_shared<const text::Source>(std::string(option), std::string(value));
  const auto size = static_cast<std::uint32_t>(value.size());
  return {std::string(value), {std::move(source), {0, size}}};
}

text::Result<Dimension> dimension_of(Written name, const Written& values) {
  Dimension out;
  out.name = std::move(name);
  if (const auto between = drawn_between(values.text)) {
    std::tie(out.low, out.high) = *between;
    out.drawn_place = values.place;
    if (out.low < out.high) return out;
    return wrong("empty-range", values.place,
                 fmt::format("nothing can be drawn between {} and {}", out.low, out.high));
  }
  if (const auto range = range_in(values.text)) {
    auto all = values_of(*range, values);
    if (!all) return std::unexpected(std::move(all.error()));
    out.values = std::move(*all);
    return out;
  }
  out.values = split(values);
  if (out.values.size() > kMostValues)
    return wrong("too-many-values", values.place, fmt::format("a list has at most {} values", kMostValues));
  for (const Written& value : out.values) {
    if (value.empty())
      return wrong("empty-value", value.place,
                   fmt::format("`{}` has a value that is empty", text::shown(out.name.text)));
  }
  return out;
}

std::optional<std::size_t> repeated_values(std::span<const Dimension* const> lists) {
  std::unordered_set<std::string> seen;
  const std::size_t count = lists.empty() ? 0 : lists.front()->values.size();
  for (std::size_t i = 0; i < count; ++i) {
    std::string key;
    for (const Dimension* const list : lists) {
      const std::string& text = list->values[i].text;
      const std::optional<double> number = number_in(text);
      key += (number ? shortest(*number + 0.0) : text) + '\0';  // of the two zeros one
    }
    if (!seen.insert(std::move(key)).second) return i;
  }
  return std::nullopt;
}

namespace {

struct Sides {
  Written name;
  Written value;
};
text::Result<Sides> sides_of(const Written& both) {
  const std::size_t equals = both.text.find('=');
  if (equals == std::string::npos || equals == 0)
    return wrong("no-value", both.place,
                 fmt::format("expected NAME=VALUE, found `{}`", text::shown(both.text)));
  return Sides{part_of(both, 0, equals), part_of(both, equals + 1, both.text.size())};
}

}  // namespace

text::Result<Dimension> dimension_of(const Written& both) {
  auto sides = sides_of(both);
  if (!sides) return std::unexpected(std::move(sides.error()));
  return dimension_of(std::move(sides->name), sides->value);
}

text::Result<mdl::Setting> setting_of(std::string_view both) {
  auto sides = sides_of(written_in_option("--set", both));
  if (!sides) return std::unexpected(std::move(sides.error()));
  return mdl::Setting{sides->name.text, sides->value.text, sides->name.place, sides->value.place};
}

}  // namespace mlab::study
