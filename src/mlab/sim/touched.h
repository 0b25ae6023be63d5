#pragma once

#include "mlab/sim/bodies.h"
#include "mlab/sim/statics.h"

namespace mlab::sim {

/// Contacts with things that have become others are over.
void forget_changed(Bodies& bodies, const Statics& before, const Statics& now, double time);
/// All contacts with roamers are over.
void forget_roamers(Bodies& bodies);

}  // namespace mlab::sim
