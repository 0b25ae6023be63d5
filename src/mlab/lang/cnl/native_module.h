#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mlab/cell/means.h"
#include "mlab/lang/cnl/compiler_process.h"
#include "mlab/lang/cnl/tree.h"
#include "mlab/text/diagnostic.h"

namespace mlab::cnl {

/// How procedures that a mission brings along become code.
struct NativeOptions {
  cell::Wall wall = cell::Wall::kLandlock;   ///< of the cell that the compiler works in
  std::vector<std::string> include_folders;  ///< where `mlab/...` headers are
  ProjectPart project = ProjectPart::kAll;   ///< that the code may include
  std::string compiler = "g++";
  std::string cache_folder;  ///< empty: `$XDG_CACHE_HOME/mlab`, or `~/.cache/mlab`
  std::string version;       ///< of this program; libraries of another one are not used again
  ProcessLimits limits;
};

/// `$XDG_CACHE_HOME/mlab`, or `~/.cache/mlab`: where compiled code is kept.
std::string default_cache_folder();

/// True where the file has procedures of its own, which only a C++ compiler can make run.
bool has_procedures(const Tree& tree);

/// The files that the C++ of a file's procedures stands in: it, and those that it includes and that hold any.
std::vector<text::SourcePtr> code_sources(const Tree& tree);

/// Compiles the procedures of a file for their errors only. The tree has passed `check_declarations`.
///
/// @return  whether the compiler accepts them
/// @errors  `cpp-error`, `cpp-warning`, `state-not-copyable` at the author's places; `no-compiler`,
/// `compiler-limit`,
///          `compiler-failed`
bool check_native(const Tree& tree, const NativeOptions& options, text::Diagnostics& diagnostics);

struct NativeModule {
  std::string file;           ///< the shared library; empty: the file has no procedures
  bool was_compiled = false;  ///< false: the cache had it
};

/// Compiles the procedures of a file into a shared library, or takes it from the cache. It is not loaded:
/// only processes in a cell do that (flow/module_file.h).
///
/// @errors  those of `check_native`; `cannot-write` for the cache
std::optional<NativeModule> compile_native(const Tree& tree, const NativeOptions& options,
                                           text::Diagnostics& diagnostics);

}  // namespace mlab::cnl
