#include "mlab/console/session/measuring.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "mlab/console/published/run_metrics.h"
#include "mlab/console/published/status_encoder.h"

namespace mlab::console {
namespace {

using metrics::Exposition;

constexpr double kBetweenLooks = 0.5;  // [s]

// `NO_MISSION` is `no_mission`.
std::string lower(std::string word) {
  std::ranges::transform(word, word.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return word;
}

// One series for each mode, of which one is 1.
void tell_mode(Status::Mode mode, Exposition& out) {
  std::vector<Exposition::Series> series;
  for (int number = Status::Mode_MIN; number <= Status::Mode_MAX; ++number) {
    const auto one = static_cast<Status::Mode>(number);
    series.push_back({{{"mode", lower(Status::Mode_Name(one))}}, one == mode ? 1.0 : 0.0});
  }
  out.gauge("mlab_mode", "1 for what the run is doing, 0 for all else.", series);
}

void tell_events(const EventLog& log, Exposition& out) {
  std::vector<Exposition::Series> series;
  for (int number = Log::Kind_MIN; number <= Log::Kind_MAX; ++number) {
    const auto kind = static_cast<Log::Kind>(number);
    series.push_back({{{"kind", lower(Log::Kind_Name(kind))}}, static_cast<double>(log.count(kind))});
  }
  out.counter("mlab_events_total", "Entries of the console's log since it was started, by kind.", series);
}

}  // namespace

void Measuring::look() {
  const double wall = wall_time();
  if (wall < looked_ + kBetweenLooks) return;
  looked_ = wall;
  const auto seen = std::make_shared<Seen>();
  seen->wall = wall;
  tell_session(seen->told, wall);
  if (const LiveRun* live = parts_.run.live()) {
    tell_run(*live, seen->told);
    tell_robots(*live, seen->told);
  }
  const std::scoped_lock lock(mutex_);
  seen_ = seen;
}

void Measuring::tell_session(Exposition& out, double wall) const {
  const RunControl& run = parts_.run;
  out.gauge("mlab_build_info", "1; which version of mlab this is.", {{{{"version", parts_.version}}, 1.0}});
  Status::Mode mode = run.live() != nullptr ? mode_of(run.live()->run()) : Status::NO_MISSION;
  if (run.is_stopped()) mode = Status::STOPPED;
  tell_mode(mode, out);
  out.counter("mlab_runs_total", "Runs that this console has begun with.",
              static_cast<double>(run.run_number()));
  out.histogram("mlab_cycle_duration_seconds", "How long control cycles took, by the clock.",
                run.cycle_times().wall());
  out.histogram("mlab_cycle_processor_seconds", "What processors worked during control cycles.",
                run.cycle_times().processor());
  out.gauge("mlab_speed_wanted_ratio",
            "Simulated seconds per second that are wanted; 0: as many as there can be.", run.pace().speed());
  out.gauge("mlab_speed_ratio", "Simulated seconds per second over the last second.",
            run.meter().speed(wall));
  out.gauge("mlab_behind_seconds", "How late the next control cycle is.",
            run.time_runs() ? run.pace().behind(wall, run.sim_time()) : 0.0);
  out.gauge("mlab_people", "Pages of the console that are open.",
            static_cast<double>(parts_.people.channels().size()));
  tell_events(parts_.log, out);
}

void Measuring::tell(Exposition& out) const {
  std::shared_ptr<const Seen> seen;
  {
    const std::scoped_lock lock(mutex_);
    seen = seen_;
  }
  if (!seen) return;
  out.append(seen->told);
  out.gauge("mlab_session_age_seconds",
            "How old the numbers of the session are; they are taken each half second unless it hangs.",
            wall_time() - seen->wall);
}

}  // namespace mlab::console
