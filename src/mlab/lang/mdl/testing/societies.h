#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mlab/text/diagnostic.h"

namespace mlab::mdl::testing {

/// In place of a configuration `x.cdl`: the societies Party, of two Scouts and a Carrier, Swarm, of many,
/// Half, of more than half of what there may be, and Nobody. Whatever is called Prty is missing in it.
inline std::optional<std::vector<std::pair<std::string, int>>> known_society(const std::string& program,
                                                                             const text::Place& place,
                                                                             text::Diagnostics& sink) {
  using Members = std::vector<std::pair<std::string, int>>;
  if (program == "x.cdl#Party") return Members{{"x.cdl#Scout", 2}, {"x.cdl#Carrier", 1}};
  if (program == "x.cdl#Swarm") return Members{{"x.cdl#Scout", 1'000'000}};
  if (program == "x.cdl#Half") return Members{{"x.cdl#Scout", 6'000}};
  if (program == "x.cdl#Nobody") return Members{};
  if (program == "x.cdl#Prty") sink.error("unknown-robot", place, "`x.cdl` has no robot or society `Prty`");
  return std::nullopt;
}

}  // namespace mlab::mdl::testing
