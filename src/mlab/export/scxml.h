#pragma once

#include <optional>
#include <string>

#include "mlab/export/format.h"

namespace mlab::exports {

/// The sequences of the robot as a state chart (SCXML 1.0, ECMAScript data model). Each control cycle is one
/// event `cycle`, whose data hold the value of each trigger and selector by the path of its node; then the
/// chart is in the states in which the robot is. States are called `SEQUENCE.STATE`.
///
/// @errors  `no-sequence`; `shared-sequence`: one that several states or several readers in parallel need,
/// which
///          state charts can't share; `sequence-in-trigger`
std::optional<std::string> write_scxml(const Subject& subject, text::Diagnostics& sink);

}  // namespace mlab::exports
