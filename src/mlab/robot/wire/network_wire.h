#pragma once

#include "mlab/flow/network.h"
#include "mlab/robot.pb.h"

namespace mlab::robot_wire {

/// A network as a message. Places in the author's text do not travel.
void encode(const flow::Network& network, wire::Network& out);

/// The network of a message. Nothing is checked: whoever builds a program of it finds what is wrong.
flow::Network decode(const wire::Network& message);

}  // namespace mlab::robot_wire
