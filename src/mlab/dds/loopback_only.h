#pragma once

#include <expected>
#include <string>

namespace mlab::dds {

/// Lets the sockets that Cyclone has opened in this process for the domain hear the loopback alone. Cyclone
/// binds them to all addresses of the machine, whichever interface it is told to use, so anybody on its
/// networks could send to them.
///
/// @errors  a sentence: the kernel does not allow it (Linux before 5.7, without root)
std::expected<void, std::string> hear_loopback_only(int domain);

}  // namespace mlab::dds
