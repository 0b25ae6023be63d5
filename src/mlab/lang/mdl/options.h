#pragma once

#include <initializer_list>
#include <optional>
#include <string_view>

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

/// The number that SET gives under this word, in any letter case; nothing where there is none.
std::optional<mission::NumberOption> number_option(std::string_view word);

/// Reports a coordinate or length that no map has.
///
/// @param what  as the message begins: `a coordinate`
/// @return  whether all of them are good
bool check_lengths(std::initializer_list<const Number*> lengths, std::string_view what,
                   const text::SourcePtr& source, text::Diagnostics& diagnostics);

/// Puts the value of a SET command into the options; any other command changes nothing.
void apply_set(const mission::Command& command, mission::Options& options);

/// Whether a command is a SET that sets what is set already.
bool sets_nothing_new(const mission::Command& command, const mission::Options& options);

/// What follows from a new mission area: some options go back to what fits it.
void reset_for_area(overlay::Area area, mission::Options& options);

}  // namespace mlab::mdl
