#pragma once

#include <cstdint>
#include <expected>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "mlab/history/history.h"
#include "mlab/mission/mission.h"

namespace mlab::history {

/// Where another future departs from a run, and with what.
struct Departure {
  std::uint64_t cycle = 0;  ///< after it, before anything else comes in
  double time = 0.0;        ///< then [s]
  /// By path: contents in place of those of texts that the mission and its programs are made from.
  std::map<std::string, std::string> texts;
  std::vector<std::string> lines;  ///< that an operator types
  bool with_later = true;          ///< what came in afterwards comes in here, too
};

/// A history of its own: what came in up to the departure, what departs, and what came in later. Other
/// versions of the mission that came later are left out where this is another one by then.
struct Branch {
  std::shared_ptr<History> history;
  bool takes_over = false;  ///< programs of robots that run are to be others
};

/// @param mission  as it is at the departure
/// @errors  a sentence: what departs is nonsense
std::expected<Branch, std::string> branch(const History& from, const Departure& departure,
                                          const mission::Mission& mission);

}  // namespace mlab::history
