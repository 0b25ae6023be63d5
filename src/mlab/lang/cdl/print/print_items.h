#pragma once

#include <variant>

#include "mlab/lang/cdl/print/printer.h"

namespace mlab::cdl {

inline const Item& item_of(const Item& item) {
  return item;
}
inline const Item& item_of(const Item* item) {
  return *item;
}

/// Declarations with an empty line between them, but not between those of one line each.
template <class Out>
void put_items(Out& out, const auto& items) {
  bool was_short = true;
  for (const auto& one : items) {
    const Item& item = item_of(one);
    const bool is_short = std::holds_alternative<Use>(item) || std::holds_alternative<Architecture>(item);
    is_short&& was_short ? out.line() : out.paragraph();
    was_short = is_short;
    Printer(out).put(item);
  }
}

}  // namespace mlab::cdl
