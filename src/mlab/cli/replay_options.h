#pragma once

#include "mlab/cli/commands.h"

namespace CLI {  // NOLINT(readability-identifier-naming): of the library
class App;
}

namespace mlab::cli {

inline constexpr const char* kReplayDescription =
    "Compute a recorded run again, cycle by cycle, and compare it with what was recorded "
    "(docs/recording.md).";
inline constexpr const char* kTraceDescription =
    "Say what any port of any robot held in any cycle of a recorded run, recorded or not, as CSV.";

/// Of `run` and `edit`.
void add_record(CLI::App* c, RunOptions& o);
void add_replay_options(CLI::App* c, ReplayOptions& o);
void add_trace_options(CLI::App* c, TraceOptions& o);

}  // namespace mlab::cli
