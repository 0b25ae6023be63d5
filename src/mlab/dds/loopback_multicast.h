#pragma once

namespace mlab::dds {

/// Whether what is sent to a group on the loopback arrives there, as it does on Linux though the interface
/// does not say so: tried with a datagram. One that is for all is sent once then, not to each participant of
/// the machine.
bool carries_loopback_multicast();

}  // namespace mlab::dds
