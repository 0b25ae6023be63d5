// The benchmark scenario with its `diffusion` control written in C++: what the simulator alone costs.
//
// usage: sim_bench ROBOTS|POSITIONS.csv [THREADS [RANGE [CYCLES]]]

#include <cstdlib>

#include <fmt/core.h>

#include "mlab/sim/bench_run.h"

int main(int argc, char** argv) {
  const char* const what = argc > 1 ? argv[1] : "1000";
  const int wanted = std::atoi(what);
  mlab::sim::BenchScenario scenario;
  if (wanted > 0) {
    scenario = mlab::sim::make_bench_scenario(static_cast<std::uint32_t>(wanted));
  } else {
    const auto source = mlab::text::read_source(what);
    auto read = source ? mlab::sim::read_bench_scenario(*source) : std::unexpected(source.error());
    if (!read) {
      fmt::print(stderr, "{}", mlab::text::render(read.error()));
      return 2;
    }
    scenario = std::move(*read);
  }
  mlab::sim::BenchOptions options;
  if (argc > 2) options.threads = std::atoi(argv[2]);
  if (argc > 3) options.range = std::atof(argv[3]);
  if (argc > 4) options.cycles = std::atoi(argv[4]);
  const auto r = mlab::sim::run_bench(scenario, options, mlab::sim::diffusion_control);
  fmt::print("{:.0f} robot-cycles/s, {:.0f} bytes/robot\n", r.robot_cycles_per_second, r.bytes_per_robot);
  const double ns = 1e9 / (static_cast<double>(scenario.robots.size()) * r.cycles);
  fmt::print("sense {:.0f} ns, behave {:.0f} ns, move {:.0f} ns, contact {:.0f} ns\n", r.sense * ns,
             r.behave * ns, r.move * ns, r.contact * ns);
  fmt::print("hits {:.3f} %, mean distance {:.4f} m, displacement {:.4f} m, contacts {}\n", 100 * r.hit_share,
             r.mean_hit_distance, r.mean_displacement, r.contacts);
}
