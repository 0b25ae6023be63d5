#pragma once

#include <cstdint>
#include <string>

#include "descriptor.h"

namespace mlab::network {

/// A socket for asking the kernel about the network namespace that this process is in now.
/// @errors  Failure
Descriptor open_netlink();

/// Two interfaces, each of which receives what the other sends.
/// @errors  Failure
void make_veth_pair(const Descriptor& netlink, const std::string& name, const std::string& other);

/// How many frames wait on it before the kernel drops some. (The ioctl for it wants more rights.)
/// @errors  Failure
void set_queue(const Descriptor& netlink, const std::string& name, std::uint32_t frames);

/// Moves an interface from the namespace that the socket was opened in to the one that this process is in
/// now.
/// @errors  Failure
void move_here(const Descriptor& netlink, const std::string& name);

}  // namespace mlab::network
