#pragma once

#include <cstddef>
#include <stop_token>
#include <string>
#include <vector>

#include "mlab/cell/means.h"
#include "mlab/lang/cnl/compiler_room.h"

namespace mlab::cnl {

/// What a program may use before it is stopped.
struct ProcessLimits {
  double time = 300.0;                        ///< by the clock on the wall [s]
  unsigned processor_time = 60;               ///< of each of its processes [s]
  std::size_t memory = std::size_t{3} << 30;  ///< of address space, each of its processes [bytes]
  std::size_t output = std::size_t{1} << 20;  ///< what it prints beyond this is dropped [bytes]
  std::stop_token ends = {};                  ///< nobody waits for it any more
};

struct ProcessResult {
  enum class End {
    kExited,
    kNotFound,  ///< no such program
    kFailed,    ///< could not be started; `output` says why
    kTimedOut,
    kStopped,  ///< by `ends`
    kSignalled,
  };
  End end = End::kFailed;
  int status = 0;      ///< of its exit, or the signal
  std::string output;  ///< standard output and standard error, as they came
};

/// Where a compiler works: in a cell.
struct CompilerRoom {
  cell::Wall wall;      ///< of the cell; whoever may compile was given it (cell/permission.h)
  CompilerFiles files;  ///< what it may read
  std::string own;      ///< the folder that it may write into; it has to be there
};

/// Runs a compiler or linker in its room, without a shell, and waits for it. It gets no input, an environment
/// of its own (`LC_ALL=C`, PATH, and TMPDIR, which is its folder), and a process group of its own, which is
/// ended as a whole where it takes too long or is to end: asked first, so that it can take its own files
/// away, and killed a second later. Where this process ends before it, it is killed with all that it has
/// started.
///
/// @param words  the program, looked for in PATH where it has no slash, and its arguments
ProcessResult run_process(const std::vector<std::string>& words, const CompilerRoom& room,
                          const ProcessLimits& limits);

/// Where PATH has the program; empty: nowhere.
std::string find_program(const std::string& name);

}  // namespace mlab::cnl
