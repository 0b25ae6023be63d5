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
using binding::RangeRing;
using binding::WantedMotion;

}  // namespace mlab::sim
