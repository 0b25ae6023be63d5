// `mlab compare`: two recorded runs, computed again in step.

#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>

#include <fmt/core.h>

#include "mlab/cli/clock.h"
#include "mlab/cli/commands.h"
#include "mlab/cli/interrupt.h"
#include "mlab/cli/permission.h"
#include "mlab/cli/places.h"
#include "mlab/cli/recorded_run.h"
#include "mlab/cli/terminal.h"
#include "mlab/cli/version.h"
#include "mlab/comparison/comparer.h"
#include "mlab/comparison/report.h"
#include "mlab/comparison/words.h"
#include "mlab/history/recording_file.h"
#include "mlab/text/shown.h"

namespace mlab::cli {
namespace {

constexpr double kRedrawn = 0.2;  // [s]

/// One of the two. Of one that is damaged nobody can say that it is the same.
struct Side {
  comparison::Recorded recorded;
  bool is_damaged = false;
};

// Nothing where it is no recording, which is told.
std::optional<Side> open_side(const std::string& path, const CompareOptions& options) {
  auto recording = history::read_recording(path);
  if (!recording) {
    tell(recording.error());
    return std::nullopt;
  }
  Side side{{}, recording->is_damaged};
  comparison::Recorded& out = side.recorded;
  out.name = path;
  out.history = std::move(recording->history);
  if (!recording->cut.empty()) {
    out.remarks.push_back(recording->cut);
    // The report has it; a verdict alone would be taken for one on whole runs.
    if (options.quiet)
      fmt::print(stderr, "mlab compare: warning: {}: {}\n", text::shown(path, 200), recording->cut);
  }
  for (std::string& remark : remarks_on(out.history->beginning())) out.remarks.push_back(std::move(remark));
  text::Diagnostics problems;
  out.replay = history::Replay::make(
      out.history, {permission_to_replay(), include_root(), kVersion, options.limits, options.threads},
      problems);
  if (out.replay) {
    out.replay->run().set_meanwhile(was_interrupted);
    return side;
  }
  out.why_not = out.history->why_not_recomputed();
  for (const text::Diagnostic& problem : problems.items()) {
    if (out.why_not.empty() && problem.severity == text::Severity::kError) out.why_not = problem.message;
  }
  return side;
}

bool page_is_usable(const CompareOptions& options) {
  const std::string problem = problem_with_outputs(
      {{"--html", options.page}}, {{"first recording", options.first}, {"second recording", options.second}});
  if (!problem.empty()) fmt::print(stderr, "mlab compare: {}\n", problem);
  return problem.empty();
}

// A line on a terminal that says how far it is.
class Progress {
 public:
  explicit Progress(bool is_quiet) : is_shown_(!is_quiet && isatty(STDERR_FILENO) == 1) {}
  ~Progress() {
    if (is_drawn_) fmt::print(stderr, "\r\x1b[K");
  }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  void show(double share) {
    if (!is_shown_ || steady_seconds() < last_ + kRedrawn) return;
    last_ = steady_seconds();
    is_drawn_ = true;
    fmt::print(stderr, "\r\x1b[Kcomparing: {:.0f} %", 100.0 * share);
    std::fflush(stderr);
  }

 private:
  bool is_shown_;
  bool is_drawn_ = false;
  double last_ = steady_seconds();
};

void compute(comparison::Comparer& comparer, bool is_quiet) {
  Progress progress(is_quiet);
  note_interrupts();
  while (!was_interrupted() && comparer.step()) progress.show(comparer.share_done());
}

// Once all that is known is told, so that it is the last that is read.
void tell_interrupted(double share, const std::string& page) {
  std::fflush(stdout);
  fmt::print(stderr, "mlab compare: interrupted after {:.0f} % of the two runs; what is told{} goes as far\n",
             std::floor(100.0 * share), page.empty() ? "" : fmt::format(", also in {},", page));
}

}  // namespace

int compare(const CompareOptions& options) {
  if (!page_is_usable(options)) return kBadInput;
  std::optional<Side> first = open_side(options.first, options);
  std::optional<Side> second = open_side(options.second, options);
  if (!first || !second) return kBadInput;
  const bool is_damaged = first->is_damaged || second->is_damaged;
  comparison::Comparer comparer({std::move(first->recorded), std::move(second->recorded)});
  compute(comparer, options.quiet);
  const double share = comparer.share_done();
  const comparison::Comparison result = comparer.finish();
  if (options.json)
    fmt::print("{}", comparison::json_of(result));
  else if (options.quiet)
    fmt::print("{}\n", comparison::verdict(result));
  else
    fmt::print("{}", comparison::report_of(result));
  if (!options.page.empty()) {
    if (!write_file(options.page, comparison::page_of(result, kVersion), was_interrupted)) {
      fmt::print(stderr, "mlab compare: the page {} could not be written{}\n", options.page,
                 why_not_written());
      return kFailed;
    }
    if (!options.json) fmt::print("page: {}\n", options.page);
  }
  if (!result.is_whole) tell_interrupted(share, options.page);
  return result.is_same() && result.is_whole && !is_damaged ? kDone : kFailed;
}

}  // namespace mlab::cli
