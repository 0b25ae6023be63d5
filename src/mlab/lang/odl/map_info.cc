#include "mlab/lang/odl/map_info.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include <fmt/core.h>

#include "mlab/lang/odl/lexer.h"
#include "mlab/lang/odl/limits.h"
#include "mlab/text/shown.h"

namespace mlab::odl {
namespace {

constexpr std::string_view kBlanks = " \t\r\f\v";

struct Line {
  std::string_view text;  // without white space around it
  text::Place place;
};

// The lines that say something.
std::vector<Line> lines_of(const text::SourcePtr& source) {
  std::vector<Line> out;
  const std::string_view all = source->text();
  for (std::size_t begin = 0; begin < all.size();) {
    const std::size_t end = std::min(all.find('\n', begin), all.size());
    const std::string_view line = all.substr(begin, end - begin);
    const std::size_t first = line.find_first_not_of(kBlanks);
    if (first != std::string_view::npos && line[first] != '#') {
      const std::size_t last = line.find_last_not_of(kBlanks) + 1;
      const text::Span span{static_cast<std::uint32_t>(begin + first),
                            static_cast<std::uint32_t>(begin + last)};
      out.push_back({line.substr(first, last - first), {source, span}});
    }
    if (out.size() == 3) break;  // one too many is enough to say so
    begin = end + 1;
  }
  return out;
}

// The numbers of the second line; a word that is none is an error.
bool read_numbers(const Line& line, std::vector<double>& out, text::Diagnostics& sink) {
  for (std::size_t at = 0; at < line.text.size();) {
    const std::size_t begin = line.text.find_first_not_of(kBlanks, at);
    const std::size_t end = std::min(line.text.find_first_of(kBlanks, begin), line.text.size());
    const std::string_view word = line.text.substr(begin, end - begin);
    const text::Span span{static_cast<std::uint32_t>(line.place.span.begin + begin),
                          static_cast<std::uint32_t>(line.place.span.begin + end)};
    if (!is_number(word) || out.size() == 5) {
      const auto* what = out.size() == 5 ? "the end of the line" : "a number";
      sink.error("map-info-syntax", {line.place.source, span},
                 fmt::format("expected {}, found `{}`", what, text::shown(word)));
      return false;
    }
    out.push_back(number_value(word));
    if (!(std::abs(out.back()) <= kMaxCoordinate)) {
      sink.error("number-out-of-range", {line.place.source, span},
                 fmt::format("`{}` is no number of metres on a map", text::shown(word)));
      return false;
    }
    at = line.text.find_first_not_of(kBlanks, end);
    if (at == std::string_view::npos) break;
  }
  return true;
}

}  // namespace

std::optional<MapInfo> parse_map_info(const text::SourcePtr& source, text::Diagnostics& sink) {
  const std::vector<Line> lines = lines_of(source);
  if (lines.size() < 2) {
    const auto end = static_cast<std::uint32_t>(source->text().size());
    sink.error("map-info-syntax", {source, {end, end}},
               fmt::format("a map-info file has two lines, here {}", lines.empty() ? "is none" : "is one"))
        .hints = {"the first names a picture, the second is `x y width height [scale]`"};
    return std::nullopt;
  }
  if (lines.size() > 2) {
    sink.warning("map-info-extra-line", lines[2].place,
                 "what follows the second line of a map-info file is skipped");
  }
  std::vector<double> numbers;
  if (!read_numbers(lines[1], numbers, sink)) return std::nullopt;
  if (numbers.size() < 4) {
    sink.error("map-info-syntax", lines[1].place, "expected `x y width height [scale]`");
    return std::nullopt;
  }
  const double to_metres = numbers.size() == 5 ? numbers[4] / kPixelsPerScaledMetre : 1.0;
  MapInfo out{std::string(lines[0].text), numbers[0],         numbers[1], numbers[2] * to_metres,
              numbers[3] * to_metres,     numbers.size() == 5};
  if (!(out.width > 0.0 && out.height > 0.0)) {
    sink.error("number-out-of-range", lines[1].place, "a picture's width, height and scale are above 0");
    return std::nullopt;
  }
  return out;
}

}  // namespace mlab::odl
