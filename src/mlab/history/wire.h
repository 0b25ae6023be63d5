#pragma once

#include <optional>

#include "mlab/history.pb.h"
#include "mlab/mission/executive.h"
#include "mlab/run/input.h"

namespace mlab::history {

/// What does not need texts, as messages.
wire::HistoryExecutive to_wire(const mission::ExecutiveOptions& options);
mission::ExecutiveOptions from_wire(const wire::HistoryExecutive& options);

/// All but input::Exchanged, which is left empty.
void encode(const run::Input& input, wire::HistoryInput& out);
/// @return nothing for what needs texts to be understood (EXCHANGED, TYPED), and for what is nonsense
std::optional<run::Input> decode(const wire::HistoryInput& input);

}  // namespace mlab::history
