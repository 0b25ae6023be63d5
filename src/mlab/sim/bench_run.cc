#include "mlab/sim/bench_run.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <numbers>
#include <vector>

#include <unistd.h>

#include "mlab/base/angle.h"
#include "mlab/sim/simulator.h"

namespace mlab::sim {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kRobotsAtOnce = 64;

double seconds_between(Clock::time_point a, Clock::time_point b) {
  return std::chrono::duration<double>(b - a).count();
}

/// Bytes of memory that the process has in use.
double resident_bytes() {
  std::ifstream statm("/proc/self/statm");
  double total = 0.0;
  double resident = 0.0;
  statm >> total >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

int timed_cycles(std::size_t robots) {
  if (robots <= 10) return 20000;
  if (robots <= 100) return 2000;
  if (robots <= 1000) return 200;
  return robots <= 10000 ? 40 : 20;
}

/// A simulator with the scenario's robots, stepped by a control.
class Bench {
 public:
  Bench(const BenchScenario& scenario, const BenchOptions& options, const BenchControl& control)
      : options_(options),
        control_(control),
        simulator_(bench_world(scenario),
                   {.seed = options.seed, .threads = options.threads, .measures_times = true}),
        workers_(static_cast<std::size_t>(simulator_.workers().count())),
        actions_(scenario.robots.size()) {
    const BodySpec spec = bench_body(options.range);
    std::uint32_t id = 0;
    for (const geom::Pose& pose : scenario.robots)
      simulator_.add_body({.spec = spec, .pose = pose, .robot = {++id}});
    for (Worker& worker : workers_) {
      worker.buffers.resize(kRobotsAtOnce);
      worker.percepts.resize(kRobotsAtOnce);
      for (SenseBuffer& buffer : worker.buffers) buffer.reserve(8, 8, 8, spec.ring.count);
    }
  }

  Simulator& simulator() { return simulator_; }

  /// Sense and behave in pieces that stay in the cache, then step.
  void cycle(bool counts_hits) {
    const auto begin = Clock::now();
    simulator_.workers().run(actions_.size(), kRobotsAtOnce,
                             [&](std::size_t first, std::size_t last, int index) {
                               for (std::size_t i = first; i < last; i += kRobotsAtOnce) {
                                 run_piece(workers_[static_cast<std::size_t>(index)], i,
                                           std::min(last, i + kRobotsAtOnce), counts_hits);
                               }
                             });
    perceiving_ += seconds_between(begin, Clock::now());
    simulator_.step(actions_, options_.cycle_duration);
  }

  void report_times(BenchResult& result) const {
    double sense = 0.0;
    double behave = 0.0;
    for (const Worker& worker : workers_) {
      sense += worker.sense;
      behave += worker.behave;
    }
    // Threads overlap; what counts is the share of the wall clock.
    result.sense += perceiving_ * sense / std::max(1e-12, sense + behave);
    result.behave += perceiving_ * behave / std::max(1e-12, sense + behave);
    result.move += simulator_.step_times().move;
    result.contact += simulator_.step_times().contact;
  }
  void report_hits(BenchResult& result) const {
    double rays = 0.0;
    double hits = 0.0;
    double distance = 0.0;
    for (const Worker& worker : workers_) {
      rays += static_cast<double>(worker.rays);
      hits += static_cast<double>(worker.hits);
      distance += worker.distance;
    }
    result.hit_share = hits / std::max(1.0, rays);
    result.mean_hit_distance = distance / std::max(1.0, hits);
  }

 private:
  struct Worker {
    std::vector<SenseBuffer> buffers;
    std::vector<percept::Percepts> percepts;
    double sense = 0.0;   // [s]
    double behave = 0.0;  // [s]
    std::uint64_t rays = 0;
    std::uint64_t hits = 0;
    double distance = 0.0;  // of all hits [m]
  };

  void run_piece(Worker& worker, std::size_t first, std::size_t last, bool counts_hits) {
    const percept::Needs needs{{percept::Sensor::kRanges}};
    const auto begin = Clock::now();
    for (std::size_t i = first; i < last; ++i) {
      simulator_.sense({static_cast<std::uint32_t>(i)}, needs, worker.buffers[i - first],
                       worker.percepts[i - first]);
    }
    const auto sensed = Clock::now();
    for (std::size_t i = first; i < last; ++i) {
      actions_[i] = {};
      control_(static_cast<std::uint32_t>(i), worker.percepts[i - first], actions_[i]);
    }
    worker.sense += seconds_between(begin, sensed);
    worker.behave += seconds_between(sensed, Clock::now());
    if (!counts_hits) return;
    for (std::size_t i = first; i < last; ++i) {
      for (const percept::RangeReading& reading : worker.percepts[i - first].ranges) {
        ++worker.rays;
        if (!reading.hit) continue;
        ++worker.hits;
        worker.distance += reading.distance;
      }
    }
  }

  const BenchOptions& options_;
  const BenchControl& control_;
  Simulator simulator_;
  std::vector<Worker> workers_;
  std::vector<percept::Action> actions_;
  double perceiving_ = 0.0;  // wall clock of sensing and behaving together [s]
};

void run_timed(const BenchScenario& scenario, const BenchOptions& options, const BenchControl& control,
               BenchResult& result) {
  const double memory = resident_bytes();
  Bench bench(scenario, options, control);
  for (int i = 0; i < options.warm_up; ++i) bench.cycle(false);
  std::vector<geom::Point> from;
  const auto count = static_cast<std::uint32_t>(bench.simulator().body_count());
  for (std::uint32_t i = 0; i < count; ++i) from.push_back(bench.simulator().pose({i}).position);
  BenchResult before;
  bench.report_times(before);
  const auto begin = Clock::now();
  for (int i = 0; i < result.cycles; ++i) bench.cycle(false);
  result.seconds = seconds_between(begin, Clock::now());
  bench.report_times(result);
  result.sense -= before.sense;
  result.behave -= before.behave;
  result.move -= before.move;
  result.contact -= before.contact;
  result.robot_cycles_per_second =
      static_cast<double>(count) * result.cycles / std::max(1e-9, result.seconds);
  result.bytes_per_robot = std::max(0.0, resident_bytes() - memory) / count;
  for (std::uint32_t i = 0; i < count; ++i) {
    result.mean_displacement += distance(from[i], bench.simulator().pose({i}).position) / count;
    result.contacts += bench.simulator().contacts({i});
  }
}

}  // namespace

void diffusion_control(std::uint32_t /*robot*/, const percept::Percepts& percepts, percept::Action& out) {
  double x = 0.0;
  double y = 0.0;
  double nearest_ahead = 0.0;
  for (const percept::RangeReading& reading : percepts.ranges) {
    if (!reading.hit) continue;
    const double proximity = 1.0 - reading.distance / percepts.range_limit;
    const double angle = reading.angle;
    x += proximity * std::cos(angle);
    y += proximity * std::sin(angle);
    if (std::abs(angle) <= std::numbers::pi / 2) nearest_ahead = std::max(nearest_ahead, proximity);
  }
  const double count = std::max<double>(1.0, static_cast<double>(percepts.ranges.size()));
  const bool is_free =
      std::sqrt(x * x + y * y) / count < 0.01 || std::abs(std::atan2(y, x)) > base::radians(100.0);
  out.drives = true;
  out.spins = true;
  out.velocity.x = is_free ? kBenchCruise : nearest_ahead > 0.5 ? 0.0 : kBenchCruise / 2;
  out.spin = is_free ? 0.0 : y > 0.0 ? -kBenchTurnRate : kBenchTurnRate;
}

BenchResult run_bench(const BenchScenario& scenario, const BenchOptions& options,
                      const BenchControl& control) {
  BenchResult result;
  if (scenario.robots.empty()) return result;
  result.cycles = options.cycles > 0 ? options.cycles : timed_cycles(scenario.robots.size());
  run_timed(scenario, options, control, result);
  Bench counting(scenario, options, control);
  const int cycles = scenario.robots.size() <= 20000 ? 100 : 20;
  for (int i = 0; i < cycles; ++i) counting.cycle(true);
  counting.report_hits(result);
  return result;
}

}  // namespace mlab::sim
