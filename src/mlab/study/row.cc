#include "mlab/study/row.h"

#include <algorithm>
#include <iterator>

#include <fmt/core.h>

namespace mlab::study {

std::string column(const NumberInfo& info) {
  return info.unit.empty() ? std::string(info.name) : fmt::format("{}_{}", info.name, info.unit);
}

bool is_table_column(std::string_view name) {
  constexpr std::string_view kOthers[] = {"mission", "combination", "seed",   "success",  "outcome",
                                          "cause",   "message",     "repeat", "recording"};
  return std::ranges::find(kOthers, name) != std::end(kOthers) ||
         std::ranges::any_of(kNumbers, [&](const NumberInfo& info) { return column(info) == name; });
}

}  // namespace mlab::study
