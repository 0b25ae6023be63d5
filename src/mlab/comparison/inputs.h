#pragma once

#include <optional>
#include <string>

#include "mlab/comparison/comparison.h"
#include "mlab/history/history.h"

namespace mlab::comparison {

/// What came in, as a person would say it: `Execute`, `parameter speed of robot 3: 2`.
std::string words_of(const wire::HistoryInput& input);

/// The first thing that came into one of them and not, or not then, into the other. What came in behind the
/// end of the shorter one does not count.
std::optional<InputDifference> first_difference(const Both<const history::History*>& histories);

}  // namespace mlab::comparison
