#pragma once

#include "descriptor.h"
#include "keeper/setup.h"

namespace mlab::network {

/// Gives the network namespace of this process `lo` and `net0`, an Ethernet on which nobody asks for hardware
/// addresses (the relay fills them in), with the host's address and a route to everywhere. By a TAP device of
/// /dev/net/tun; where that may not be opened, by a veth whose other end lies in a namespace of its own.
///
/// @return  the wire: non-blocking, a frame for each read(2) and write(2)
/// @errors  Failure
Descriptor make_interfaces(const KeeperSetup& setup);

}  // namespace mlab::network
