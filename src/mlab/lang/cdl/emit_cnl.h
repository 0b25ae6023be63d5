#pragma once

#include <string>

#include "mlab/flow/network.h"
#include "mlab/text/diagnostic.h"

namespace mlab::cdl {

/// Says what of a network can't be said in CNL, which knows no overlay: that a parameter is a named place.
/// @errors  `place-in-cnl`
void check_for_cnl(const flow::Network& network, text::Diagnostics& sink);

/// The network as a CNL file. Reading it gives the same network, node names and so the random streams of
/// nodes included; only places in the text differ.
/// @param network  all of it can be said: `check_for_cnl`
std::string cnl_text(const flow::Network& network);

}  // namespace mlab::cdl
