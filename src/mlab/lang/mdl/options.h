#pragma once

#include "mlab/lang/mdl/tree.h"
#include "mlab/mission/mission.h"
#include "mlab/text/diagnostic.h"

namespace mlab::mdl {

/// The command that a SET statement is, its value checked against the range that holds in an area of this
/// size.
///
/// @param options  in force so far: SCALE-ROBOTS decides what ROBOT-LENGTH means
/// @return  nothing where the value is out of range
std::optional<mission::Command> read_set(const statement::Set& set, const mission::Options& options,
                                         overlay::Area area, const text::SourcePtr& source,
                                         text::Diagnostics& diagnostics);

/// Puts the value of a SET command into the options; any other command changes nothing.
void apply_set(const mission::Command& command, mission::Options& options);

/// What follows from a new mission area: some options go back to what fits it.
void reset_for_area(overlay::Area area, mission::Options& options);

}  // namespace mlab::mdl
