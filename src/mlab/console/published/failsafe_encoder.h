#pragma once

#include "mlab/console.pb.h"
#include "mlab/console/published/scene_encoder.h"
#include "mlab/fleet/what_if.h"
#include "mlab/run/mission_run.h"

namespace mlab::console {

/// The mission's table.
void encode_failsafes(const mission::Mission& mission, const PlaceOf& place_of, Failsafes& out);

/// How its rows stand for a robot, in steps that a person can tell apart: what is told changes no oftener.
void encode_standings(const run::MissionRun& run, const fleet::FleetRobot& robot, FailsafeStandings& out);

/// What would come of conditions that somebody sets.
void encode_trial(const fleet::Failsafes& failsafes, const fleet::WhatIfOutcome& outcome, bool has_fence,
                  FailsafeTrial& out);

}  // namespace mlab::console
