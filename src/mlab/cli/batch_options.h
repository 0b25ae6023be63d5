#pragma once

#include "mlab/cli/commands.h"

namespace CLI {  // NOLINT(readability-identifier-naming): of the library
class App;
}

namespace mlab::cli {

/// What can be said to `mlab batch`.
void add_batch(CLI::App& app, BatchOptions& o);

}  // namespace mlab::cli
