// Words of a text moved and swapped, for changes of several nodes at once.

#include "mlab/designer/edit_words.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

namespace mlab::designer {

Fragment swapped(const Workspace& work, text::Span span, std::vector<Swap> swaps) {
  std::ranges::sort(swaps, {}, [](const Swap& swap) { return swap.span.begin; });
  Fragment out;
  std::uint32_t done = span.begin;
  for (const Swap& swap : swaps) {
    if (swap.span.begin < done || swap.span.end > span.end) continue;
    if (swap.span.begin > done) out.add(work.moved({done, swap.span.begin}));
    out.add(swap.by);
    done = swap.span.end;
  }
  if (done < span.end) out.add(work.moved({done, span.end}));
  return out;
}

std::string swapped(std::string_view text, text::Span span, std::vector<Swap> swaps) {
  std::ranges::sort(swaps, {}, [](const Swap& swap) { return swap.span.begin; });
  std::string out;
  std::uint32_t done = span.begin;
  for (const Swap& swap : swaps) {
    if (swap.span.begin < done || swap.span.end > span.end) continue;
    out += text.substr(done, swap.span.begin - done);
    out += swap.by;
    done = swap.span.end;
  }
  return out + std::string(text.substr(done, span.end - done));
}

const Arrange::At* place_of(const Places& places, std::string_view node) {
  const auto found = std::ranges::find_if(places, [&](const Arrange::At& at) { return at.node() == node; });
  return found == places.end() ? nullptr : &*found;
}

std::string below(std::string_view path, std::string_view whole) {
  const bool is_below =
      !whole.empty() && path.size() > whole.size() && path.starts_with(whole) && path[whole.size()] == '.';
  return std::string(is_below ? path.substr(whole.size() + 1) : path);
}

std::string unique(const std::string& wanted, const std::set<std::string>& taken) {
  std::string out = wanted;
  for (int number = 2; taken.contains(out); ++number) out = fmt::format("{}_{}", wanted, number);
  return out;
}

}  // namespace mlab::designer
