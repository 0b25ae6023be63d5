#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "mlab/cell/permission.h"
#include "mlab/lang/cnl/compiler_process.h"
#include "mlab/robot/executable/emit_cpp.h"
#include "mlab/text/diagnostic.h"

namespace mlab::robot_build {

/// What turns C++ into executables.
struct Toolchain {
  std::string include_root;  ///< where `mlab/...` headers are; empty: nowhere
  std::string link_file;     ///< lists what a robot program links; empty: it is not there
  std::string compiler = "g++";
  std::string cache_folder;  ///< empty: as cnl::NativeOptions
  std::string version;       ///< of this missionlab; what another one compiled is not used again
  cnl::ProcessLimits limits;
};

struct BuildReport {
  std::vector<std::string> compiled;  ///< names of the files that the cache did not have
  std::size_t reused = 0;
};

/// Called from one thread at a time, when something begins: how much is done of how much, and what begins.
using ProgressFunction = std::function<void(std::size_t done, std::size_t total, const std::string& what)>;

/// Compiles the files, as many at a time as there are processors, and links them to an executable. Objects
/// are kept by the content of what they were made from, and a file whose object is there is not compiled.
///
/// @param output  path of the executable; written whole or not at all
/// @param permission  whether the files may be compiled, and in what cell
/// @return  nothing where there were errors: `code-not-allowed`, `no-headers`, `no-libraries`, `no-compiler`,
/// `compiler-limit`,
///          `compiler-failed`, `cannot-write`, and the compiler's own at the author's places
std::optional<BuildReport> build_executable(const std::vector<CppFile>& files, const std::string& output,
                                            const Toolchain& toolchain, const cell::Permission& permission,
                                            text::Diagnostics& sink, const ProgressFunction& progress = {});

}  // namespace mlab::robot_build
