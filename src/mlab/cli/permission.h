#pragma once

#include <string>

#include "mlab/cell/permission.h"
#include "mlab/cli/commands.h"

// The one place where it is decided whether code that files bring may be compiled and run.
namespace mlab::cli {

/// Of a command that compiles for mistakes only: `check`, `lsp`.
///
/// @param is_trusted  false: an editor says that its folder is not
cell::Permission permission_to_check(bool is_trusted, bool without_cell);

/// Of `build` and exports: the code is what the command line names.
cell::Permission permission_to_build(const BuildOptions& options);

/// Of `agent`: the code is what runs of its fleet bring, of which what other machines can reach takes none
/// without being told to; or else the executable that it offers, which whoever started it names.
cell::Permission permission_to_carry(const AgentOptions& options);

/// Of `replay`, `trace` and `compare`: the code is what a recording brings, which may be a stranger's. In a
/// cell or not at all.
cell::Permission permission_to_replay();

/// Of `run` and `edit`.
///
/// @param people  who takes part
/// @param folder  of the project: with people elsewhere, only code that lies in it now may be compiled and
/// run
cell::Permission permission_to_run(const RunOptions& options, cell::Grounds::People people,
                                   const std::string& folder);

}  // namespace mlab::cli
