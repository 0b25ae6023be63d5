#pragma once

#include "mlab/cli/commands.h"

namespace CLI {  // NOLINT(readability-identifier-naming): of the library
class App;
}

namespace mlab::cli {

void add_fleet(CLI::App& app, FleetOptions& o);
void add_keys(CLI::App& app, KeysOptions& o);

}  // namespace mlab::cli
