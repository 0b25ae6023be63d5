#pragma once

#include <cstddef>
#include <iterator>
#include <string>
#include <string_view>

#include "mlab/text/shown.h"

namespace mlab::mdl {

/// What an author wrote, in backticks, fit for one line of a message.
inline std::string in_backticks(std::string_view text) {
  return "`" + text::shown(text) + "`";
}

/// `a, b or c`
template <class Range>
std::string listed(const Range& words, std::string_view last_separator = " or ") {
  std::string out;
  std::size_t i = 0;
  for (const auto& word : words) {
    if (i > 0) out += i + 1 == std::size(words) ? last_separator : ", ";
    out += word;
    ++i;
  }
  return out;
}

}  // namespace mlab::mdl
