#pragma once

#include "mlab/cli/commands.h"

namespace CLI {  // NOLINT(readability-identifier-naming): of the library
class App;
}

namespace mlab::cli {

void add_robot(CLI::App& app, RobotOptions& o);

}  // namespace mlab::cli
