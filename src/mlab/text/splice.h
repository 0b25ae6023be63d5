#pragma once

#include <string>
#include <string_view>

#include "mlab/text/source.h"

namespace mlab::text {

/// A part of a text, and what comes into its place. Whatever changes a text says it so.
struct Splice {
  Span span;
  std::string text;

  friend bool operator==(const Splice&, const Splice&) = default;
};

/// The text afterwards. The span has to lie inside of it.
std::string spliced(std::string_view text, const Splice& splice);

/// What makes `after` of `before`, with nothing in it that both begin or end with.
Splice difference(std::string_view before, std::string_view after);

}  // namespace mlab::text
