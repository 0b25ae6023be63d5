#include "mlab/text/splice.h"

#include <algorithm>

namespace mlab::text {

std::string spliced(std::string_view text, const Splice& splice) {
  std::string out;
  out.reserve(text.size() + splice.text.size());
  out.append(text.substr(0, splice.span.begin)).append(splice.text).append(text.substr(splice.span.end));
  return out;
}

Splice difference(std::string_view before, std::string_view after) {
  const std::size_t shorter = std::min(before.size(), after.size());
  std::size_t begin = 0;
  while (begin < shorter && before[begin] == after[begin]) ++begin;
  std::size_t same = 0;
  while (same < shorter - begin && before[before.size() - 1 - same] == after[after.size() - 1 - same]) ++same;
  return {{static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(before.size() - same)},
          std::string(after.substr(begin, after.size() - same - begin))};
}

}  // namespace mlab::text
