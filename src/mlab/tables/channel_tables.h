#pragma once

#include <string>

// What follows from dds::kChannels.

namespace mlab::tables {

/// How what is said on each kind of channel arrives, and why, as a table of the documentation.
std::string channel_documentation();

}  // namespace mlab::tables
