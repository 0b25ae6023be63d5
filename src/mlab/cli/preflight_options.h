#pragma once

#include <CLI/CLI.hpp>

#include "mlab/cli/commands.h"

namespace mlab::cli {

void add_preflight(CLI::App& app, PreflightOptions& o);

}  // namespace mlab::cli
