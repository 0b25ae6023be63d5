#pragma once

#include <expected>
#include <string>

#include "mlab/dds/network.h"
#include "mlab/dds/participant_core.h"

namespace mlab::dds {

/// The QoS by which Cyclone learns of a participant's security; empty where the network has none.
///
/// @errors  a sentence: a file that can't be read or is none of its kind; Cyclone's plugins are missing
std::expected<Qos, std::string> identity_of(const Network& network);

}  // namespace mlab::dds
