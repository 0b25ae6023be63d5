#pragma once

#include "mlab/binding/body.h"
#include "mlab/binding/kinematics.h"

namespace mlab::sim {

// What the simulator's bodies are made of; everybody's, since it is what a binding speaks of.
using binding::BodyIndex;
using binding::BodySetup;
using binding::BodySpec;
using binding::CameraSpec;
using binding::Drive;
using binding::Kinematics;
using binding::kSameContact;
using binding::Momentum;
using binding::Placement;
using binding::RadioSpec;
using binding::RangeRing;
using binding::WantedMotion;

/// One that is no number, or less than 0, is 0 [m].
double usable_range(double range);
/// With every number within what can be computed with.
BodySpec usable(BodySpec spec);

}  // namespace mlab::sim
