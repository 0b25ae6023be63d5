#pragma once

#include <string>
#include <vector>

#include "mlab/cli/commands.h"

namespace mlab::cli {

/// What `mlab build --emit` can write besides `cnl` and `cpp`: a configuration as other tools take it.
std::vector<std::string> export_formats();
bool is_export(const std::string& format);
/// Writes the configuration in `options.emit`, which is one of `export_formats`.
/// @return the exit status
int export_configuration(const BuildOptions& options);
/// To the file, or to standard output where none is named.
/// @return the exit status
int put(const std::string& text, const std::string& file);

}  // namespace mlab::cli
