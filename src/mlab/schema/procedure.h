#pragma once

// Everything that the bodies of CNL procedures are written against. Generated code includes this file and
// uses the namespace mlab::schema.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "mlab/base/angle.h"
#include "mlab/base/hash.h"
#include "mlab/base/up_to.h"
#include "mlab/flow/behavior.h"
#include "mlab/flow/lists.h"
#include "mlab/flow/port_types.h"
#include "mlab/geom/pose.h"
#include "mlab/geom/vector.h"
#include "mlab/percept/action.h"
#include "mlab/percept/formation.h"
#include "mlab/percept/percepts.h"
#include "mlab/schema/camera.h"
#include "mlab/schema/clearance.h"
#include "mlab/schema/constants.h"
#include "mlab/schema/contracts.h"
#include "mlab/schema/drive.h"
#include "mlab/schema/errands.h"
#include "mlab/schema/field.h"
#include "mlab/schema/formation_offset.h"
#include "mlab/schema/historic.h"
#include "mlab/schema/indoor.h"
#include "mlab/schema/local_map.h"
#include "mlab/schema/messages.h"
#include "mlab/schema/narrow.h"
#include "mlab/schema/objects.h"
#include "mlab/schema/ranges.h"
#include "mlab/schema/reciprocal.h"
#include "mlab/schema/requests.h"
#include "mlab/schema/robots.h"
#include "mlab/schema/route.h"
#include "mlab/schema/route_way.h"
#include "mlab/schema/sectors.h"
#include "mlab/schema/signal.h"
#include "mlab/schema/stick.h"
#include "mlab/schema/surroundings.h"
#include "mlab/schema/task_progress.h"
#include "mlab/schema/tour.h"
#include "mlab/schema/turns.h"
#include "mlab/schema/vector_sum.h"
#include "mlab/schema/way.h"

namespace mlab::schema {

// Places, directions, angles.
using base::degrees;
using base::radians;
using base::wrap_angle;
using geom::ahead_of;
using geom::cross;
using geom::direction;
using geom::distance;
using geom::dot;
using geom::intersects;
using geom::kZeroLength;
using geom::length;
using geom::nearest_point;
using geom::Offset;
using geom::Point;
using geom::polar;
using geom::Pose;
using geom::rotated;
using geom::Segment;
using geom::unit;
using geom::Vector;

// What flows on wires.
using flow::ObjectClasses;
using flow::Objects;
using flow::Obstacles;
using flow::Ranges;
using flow::Robots;
using flow::Text;
using percept::Door;
using percept::Formation;
using percept::FormationReference;
using percept::Hallway;
using percept::ObjectClass;
using percept::ObjectReading;
using percept::ObjectStyle;
using percept::Obstacle;
using percept::RadioContact;
using percept::RangeReading;
using percept::RobotReading;
using percept::Task;
using ways::PlannedWay;
using ways::WayEnd;

// Perceiving and acting.
using base::hash_text;
using base::Random;
using base::UpTo;
using percept::Action;
using percept::Audience;
using percept::Contract;
using percept::ContractState;
using percept::Percepts;
using percept::Request;
using percept::SharedPlace;

}  // namespace mlab::schema
