#pragma once

#include "mlab/cli/commands.h"
#include "mlab/dds/network.h"

namespace mlab::cli {

inline dds::Network network_of(const NetworkOptions& options) {
  return {.fleet = options.fleet.empty() ? "default" : options.fleet,
          .interface_name = options.interface_name,
          .peers = options.peers};
}

}  // namespace mlab::cli
