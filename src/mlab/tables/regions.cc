#include "mlab/tables/regions.h"

#include <algorithm>

#include <fmt/core.h>

namespace mlab::tables {
namespace {

constexpr std::string_view kBegin = "[[table ";
constexpr std::string_view kEnd = "[[end]]";

// Where what is between two marks begins and ends.
struct Between {
  std::size_t begin;
  std::size_t end;
};

Between between(std::string_view text, std::size_t begin_mark, std::size_t end_mark) {
  const std::size_t line_end = text.find('\n', begin_mark);
  if (line_end < end_mark) return {line_end + 1, text.rfind('\n', end_mark) + 1};
  const std::size_t closing = std::min(text.find(')', begin_mark), end_mark);
  const std::size_t opening = text.rfind('(', end_mark);
  return {closing + 1, opening == std::string_view::npos ? 0 : opening};
}

BadMark bad(std::string_view text, std::size_t at, std::string message) {
  return {1 + static_cast<std::size_t>(std::ranges::count(text.substr(0, at), '\n')), std::move(message)};
}

}  // namespace

std::expected<std::string, BadMark> refreshed(std::string_view text, std::span<const Region> regions) {
  std::string out;
  std::size_t done = 0;
  for (std::size_t mark = text.find(kBegin); mark != std::string_view::npos; mark = text.find(kBegin, done)) {
    const std::size_t name_begin = mark + kBegin.size();
    const std::size_t name_end = text.find("]]", name_begin);
    const std::string_view name = text.substr(name_begin, name_end - name_begin);
    const auto region = std::ranges::find(regions, name, &Region::name);
    if (region == regions.end())
      return std::unexpected(bad(text, mark, fmt::format("there is no table `{}`", name.substr(0, 60))));
    const std::size_t end_mark = text.find(kEnd, name_end);
    if (end_mark == std::string_view::npos || text.find(kBegin, name_end) < end_mark)
      return std::unexpected(
          bad(text, mark, fmt::format("the table `{}` has no `{}` behind it", name, kEnd)));
    const auto [begin, end] = between(text, mark, end_mark);
    if (begin > end)
      return std::unexpected(bad(text, mark, "the marks of one line stand in no comments `(?#...)`"));
    out += text.substr(done, begin - done);
    out += region->write();
    done = end;
  }
  out += text.substr(done);
  return out;
}

}  // namespace mlab::tables
