#pragma once

#include "mlab/mission/mission.h"
#include "mlab/text/diagnostic.h"

namespace mlab::mdl {

/// Warns of rows of the table of failsafes that look at batteries and guard no robot that could have one: a
/// vehicle is named as the host of its robot's type.
void check_batteries(const mission::Mission& mission, text::Diagnostics& diagnostics);

}  // namespace mlab::mdl
