#pragma once

#include <string>

#include "mlab/flow/network.h"

namespace mlab::cdl {

/// The network as a CNL file. Reading it gives the same network, node names and so the random streams of
/// nodes included; only places differ.
std::string cnl_text(const flow::Network& network);

}  // namespace mlab::cdl
