#include "mlab/console/run/estimates.h"

#include <algorithm>
#include <cmath>

namespace mlab::console {
namespace {

bool is_of(const mission::State& state, const mission::Run& run, const mission::RobotState* robot) {
  return robot != nullptr && robot->run == static_cast<std::uint32_t>(&run - state.runs.data());
}

// By hand: where to, only the hand knows.
bool is_steered(const mission::Run& run) {
  return run.command->task == mission::Task::kTeleoperate;
}

double farthest(const mission::State& state, const mission::Run& run) {
  double out = -1.0;
  for (const base::RobotId id : run.needed) out = std::max(out, remaining_of(state, run, id));
  return out;
}

}  // namespace

double remaining_of(const mission::State& state, const mission::Run& run, base::RobotId id) {
  const mission::RobotState* robot = mission::find_robot(state, id);
  if (is_steered(run) || !is_of(state, run, robot)) return -1.0;
  if (robot->done) return 0.0;
  return std::isfinite(robot->remaining) ? robot->remaining : -1.0;
}

void Estimates::look(const mission::State& state) {
  if (state.time < next_ && next_ - state.time <= kApart) return;
  next_ = state.time + kApart;
  std::erase_if(tracks_, [&](const auto& entry) {
    return std::ranges::none_of(state.runs, [&](const mission::Run& r) { return r.record == entry.first; });
  });
  for (const mission::Run& run : state.runs) {
    Track& track = tracks_[run.record];
    for (const base::RobotId id : run.needed) {
      double& initial = track.initial.try_emplace(id, -1.0).first->second;
      initial = std::max(initial, remaining_of(state, run, id));
    }
    const double remaining = farthest(state, run);
    if (remaining < 0.0) continue;
    track.samples.push_back({state.time, remaining});
    while (track.samples.size() > 2 && track.samples[1].time <= state.time - kWindow)
      track.samples.pop_front();
  }
}

Estimates::Estimate Estimates::of(const mission::State& state, const mission::Run& run) const {
  Estimate out;
  out.robots = static_cast<std::uint32_t>(run.needed.size());
  out.robots_done = out.robots - std::min(out.robots, run.missing);
  out.remaining = farthest(state, run);
  const auto at = tracks_.find(run.record);
  double sum = 0.0;
  for (const base::RobotId id : run.needed) {
    const mission::RobotState* robot = mission::find_robot(state, id);
    if (!is_of(state, run, robot)) continue;
    const double initial = at == tracks_.end() ? -1.0 : at->second.initial_of(id);
    const double remaining = remaining_of(state, run, id);
    if (robot->done)
      sum += 1.0;
    else if (initial > 0.0 && remaining >= 0.0)
      sum += std::clamp(1.0 - remaining / initial, 0.0, 1.0);
  }
  if (out.robots > 0) out.progress = is_steered(run) ? -1.0 : sum / out.robots;
  if (run.phase == mission::Run::Phase::kRobots && out.remaining >= 0.0) out.arrival = arrival_of(run.record);
  return out;
}

double Estimates::arrival_of(std::uint32_t record) const {
  constexpr double kLeastRate = 0.01;  // slower than this is no rate that says anything [m/s]
  const auto at = tracks_.find(record);
  if (at == tracks_.end() || at->second.samples.size() < 2) return -1.0;
  const Sample& first = at->second.samples.front();
  const Sample& last = at->second.samples.back();
  const double rate = (first.remaining - last.remaining) / (last.time - first.time);
  return rate >= kLeastRate ? last.time + last.remaining / rate : -1.0;
}

}  // namespace mlab::console
