#pragma once

#include <optional>
#include <string>

#include "mlab/lang/mdl/tree.h"
#include "mlab/mission/mission.h"

namespace mlab::mdl {

/// A moment of UNTIL or PHASE-LINE as a point in mission time, or what is wrong with it.
struct TimeReading {
  std::optional<mission::MissionTime> time;
  std::string problem;  ///< why there is no time
  text::Span span;      ///< of what is wrong
};

/// Takes the writing of a moment apart.
///
/// After TIMEOUT: a number of seconds, `mm:ss`, `hh:mm:ss`, `+seconds`. Else: `hh:mm[:ss]` is a time of day,
/// on `mm-dd-yy` of this century where a date stands with it; `+hh:mm[:ss]` and `+minutes` count from the
/// start of the mission's clock; a number is minutes after midnight, a negative one seconds as after TIMEOUT.
TimeReading read_moment(const Moment& moment);

}  // namespace mlab::mdl
