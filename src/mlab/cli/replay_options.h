#pragma once

#include "mlab/cli/commands.h"

namespace CLI {  // NOLINT(readability-identifier-naming): of the library
class App;
}

namespace mlab::cli {

inline constexpr const char* kReplayDescription =
    "Show any moment of a recorded run, in the browser; with --headless compute it again here, cycle by "
    "cycle, and compare it with what was recorded (docs/recording.md). Without a file, list the project's.";
inline constexpr const char* kTraceDescription =
    "Say what any port of any robot held in any cycle of a recorded run, recorded or not, as CSV.";
inline constexpr const char* kCompareDescription =
    "Say where two recorded runs part, and why: both are computed again, cycle by cycle, and all of their "
    "values are compared.";

/// Of `run` and `edit`.
void add_record(CLI::App* c, RunOptions& o);
void add_replay_options(CLI::App* c, ReplayOptions& o);
void add_trace_options(CLI::App* c, TraceOptions& o);
void add_compare_options(CLI::App* c, CompareOptions& o);

}  // namespace mlab::cli
