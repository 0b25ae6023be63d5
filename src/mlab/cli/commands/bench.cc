#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "mlab/base/counted.h"
#include "mlab/cli/bench_networks.h"
#include "mlab/cli/commands.h"
#include "mlab/cli/files.h"
#include "mlab/cli/input.h"
#include "mlab/cli/terminal.h"
#include "mlab/cli/version.h"
#include "mlab/flow/program.h"
#include "mlab/lang/cnl/elaborate.h"
#include "mlab/lang/cnl/load.h"
#include "mlab/robot/program/robot_program.h"
#include "mlab/sim/bench_run.h"
#include "mlab/sim/bench_scenario.h"
#include "mlab/text/diagnostic.h"

namespace mlab::cli {
namespace {

std::optional<sim::BenchScenario> scenario_of(const BenchOptions& options, text::Diagnostics& sink) {
  if (options.positions.empty()) return sim::make_bench_scenario(options.robots, options.seed);
  const text::Result<text::SourcePtr> source = read_input(options.positions);
  if (!source) {
    sink.report(source.error());
    return std::nullopt;
  }
  text::Result<sim::BenchScenario> scenario = sim::read_bench_scenario(*source);
  if (!scenario) {
    sink.report(scenario.error());
    return std::nullopt;
  }
  return std::move(*scenario);
}

std::shared_ptr<const flow::Program> program_of(const std::string& control, text::Diagnostics& sink) {
  const char* text = control == "diffusion" ? kDiffusionNetwork : kSchemasNetwork;
  const auto source = std::make_shared<const text::Source>(control + ".cnl", text);
  flow::Network network = cnl::elaborate(cnl::load(source, sink), sink);
  network.name = control;
  return flow::build_program(network, robot::component_library(), sink);
}

nlohmann::ordered_json json_of(const BenchOptions& options, std::size_t robots, const sim::BenchResult& r) {
  nlohmann::ordered_json out;
  out["version"] = 1;
  out["mlab_version"] = kVersion;
  out["robots"] = robots;
  out["threads"] = options.threads;
  out["control"] = options.control;
  out["range_m"] = options.range;
  out["seed"] = options.seed;
  out["cycles"] = r.cycles;
  out["robot_cycles_per_second"] = r.robot_cycles_per_second;
  out["bytes_per_robot"] = r.bytes_per_robot;
  out["hit_share"] = r.hit_share;
  out["mean_hit_distance_m"] = r.mean_hit_distance;
  out["mean_displacement_m"] = r.mean_displacement;
  out["contacts"] = r.contacts;
  out["seconds"] = {
      {"all", r.seconds}, {"sense", r.sense}, {"behave", r.behave}, {"move", r.move}, {"contact", r.contact}};
  return out;
}

void print_result(const BenchOptions& options, std::size_t robots, const sim::BenchResult& r) {
  const auto share = [&](double part) { return r.seconds > 0.0 ? 100.0 * part / r.seconds : 0.0; };
  fmt::print("{}, {} control, {}, {} of 0.1 s, rays of {} m, seed {}\n\n", base::counted(robots, "robot"),
             options.control, base::counted(options.threads, "thread"), base::counted(r.cycles, "cycle"),
             options.range, options.seed);
  fmt::print("  {:>12.0f}  robot-cycles per second\n", r.robot_cycles_per_second);
  fmt::print("  {:>12.0f}  bytes per robot\n", r.bytes_per_robot);
  fmt::print("  {:>12.3f}  s in all: sense {:.0f} %, behave {:.0f} %, move {:.0f} %, contact {:.0f} %\n\n",
             r.seconds, share(r.sense), share(r.behave), share(r.move), share(r.contact));
  fmt::print("  {:>12.2f}  per cent of the rays hit something, {:.3f} m away on average\n",
             100.0 * r.hit_share, r.mean_hit_distance);
  fmt::print("  {:>12.3f}  m from start to end on average; {} contacts\n", r.mean_displacement, r.contacts);
}

}  // namespace

int bench(const BenchOptions& options) {
  text::Diagnostics sink;
  const std::optional<sim::BenchScenario> scenario = scenario_of(options, sink);
  const std::shared_ptr<const flow::Program> program = scenario ? program_of(options.control, sink) : nullptr;
  tell(sink);
  if (!scenario || !program) return kBadInput;
  if (const std::string why = options.json.empty() ? "" : why_not_writable(options.json); !why.empty()) {
    fmt::print(stderr, "mlab bench: --json {}: the file can't be written: {}\n", options.json, why);
    return kBadInput;
  }
  flow::Frame initial = program->make_frame();
  if (const flow::Port* half = program->find("half")) {
    program->set(initial.data(), *half, fmt::format("{}", sim::kShareOfArena * scenario->side / 2.0));
  }
  // The scenario is run twice. Each run begins with a fresh frame, whose memory counts as the robot's.
  std::vector<flow::Frame> frames(scenario->robots.size());
  const auto control = [&](std::uint32_t robot, const percept::Percepts& percepts, percept::Action& out) {
    if (percepts.time == 0.0) frames[robot] = initial;
    program->step(frames[robot].data(), percepts, out, options.seed, robot + 1);
  };
  sim::BenchOptions settings;
  settings.threads = options.threads;
  settings.range = options.range;
  settings.cycles = static_cast<int>(options.cycles);
  settings.seed = options.seed;
  const sim::BenchResult result = sim::run_bench(*scenario, settings, control);
  print_result(options, scenario->robots.size(), result);
  if (!options.json.empty() &&
      !write_file(options.json, json_of(options, scenario->robots.size(), result).dump(2) + "\n")) {
    fmt::print(stderr, "mlab bench: {} could not be written\n", options.json);
    return kFailed;
  }
  return kDone;
}

}  // namespace mlab::cli
