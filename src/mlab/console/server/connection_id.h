#pragma once

#include "mlab/base/id.h"

namespace mlab::console {

/// A browser's connection, numbered by the server from 1, never used again.
using ConnectionId = base::Id<struct ConnectionTag>;

}  // namespace mlab::console
