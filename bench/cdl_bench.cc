// How long configurations take from their text to a running program, and whether a robot that is built from
// one is as fast as one from a network written by hand.
//
// usage: cdl_bench [ROUNDS]

#include <time.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "mlab/base/testing/source_folder.h"
#include "mlab/lang/cnl/elaborate.h"
#include "mlab/lang/cnl/load.h"
#include "mlab/robot/program/configuration_file.h"
#include "mlab/sim/bench_run.h"

namespace {

using Clock = std::chrono::steady_clock;
using mlab::flow::Program;

constexpr std::uint32_t kRobots = 1000;

// Of this process alone [s]: what other programs take of the machine doesn't count.
double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double milliseconds_since(Clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

constexpr const char* kCart =
    "class Cart {\n  sensor bumper: DetectObstacles() binds sense_obstacles;\n"
    "  actuator wheels: Drive() binds movement;\n}\n";

// Twenty states of twenty nodes each: what one robot of a large mission has.
std::string twenty_states() {
  std::string text = std::string(kCart) + "assemblage Move(gain: gain, range: length) {\n  cooperate {\n";
  for (int i = 0; i < 5; ++i) text += fmt::format("    gain: Noise(persistence = {} s);\n", i + 1);
  for (int i = 0; i < 5; ++i)
    text += fmt::format("    0.{}: AvoidStaticObstacles(sense_obstacles(range = range), sphere = {} m);\n",
                        i + 1, i + 1);
  text += "  }\n}\nassemblage All() {\n  sequence {\n";
  for (int i = 0; i < 20; ++i) {
    text +=
        fmt::format("    {}S{}: Move(gain = {}, range = {} m);\n", i == 0 ? "start " : "", i, i + 1, i + 2);
    text += fmt::format("      when Wait(delay = {} s) and not (IsHalted() or Detect(Flag)) goto S{};\n",
                        i + 1, (i + 1) % 20);
  }
  return text + "  }\n}\nrobot R is Cart { movement = All(); }\n";
}

// A hundred assemblages, each a little more than the one inside of it.
std::string hundred_deep() {
  std::string text = std::string(kCart) + "assemblage A0() { cooperate { Noise(persistence = 5 s); } }\n";
  for (int i = 1; i < 100; ++i)
    text += fmt::format("assemblage A{}() {{ cooperate {{ 0.9: A{}(); 0.01: Noise(); }} }}\n", i, i - 1);
  return text + "robot R is Cart { movement = A99(); }\n";
}

std::string ten_thousand_nodes() {
  std::string text = std::string(kCart) + "assemblage Ten() { cooperate {";
  for (int i = 0; i < 9; ++i) text += fmt::format(" 0.{}: Noise(persistence = {} s);", i + 1, i + 1);
  text += " } }\nassemblage Hundred() { cooperate {";
  for (int i = 0; i < 10; ++i) text += " Ten();";
  text += " } }\nassemblage All() { cooperate {";
  for (int i = 0; i < 100; ++i) text += " Hundred();";
  return text + " } }\nrobot R is Cart { movement = All(); }\n";
}

bool time_compilation(const char* what, const std::string& text, int rounds) {
  const auto source = std::make_shared<const mlab::text::Source>("bench.cdl", text);
  std::vector<double> milliseconds;
  std::size_t nodes = 0;
  for (int i = 0; i < rounds; ++i) {
    mlab::text::Diagnostics sink;
    const auto start = Clock::now();
    const auto robot = mlab::robot::configure(source, "", "R", {}, {}, sink);
    milliseconds.push_back(milliseconds_since(start));
    if (!robot) {
      fmt::print(stderr, "{}", mlab::text::render(sink));
      return false;
    }
    nodes = robot->lowered.network.nodes.size();
  }
  std::ranges::sort(milliseconds);
  fmt::print("{:<22} {:>6} nodes: {:.2f} ms at best, {:.2f} ms in the middle\n", what, nodes,
             milliseconds.front(), milliseconds[milliseconds.size() / 2]);
  return true;
}

std::shared_ptr<const Program> written_by_hand(mlab::text::Diagnostics& sink) {
  const auto source = mlab::text::read_source(mlab::base::source_folder() + "/bench/schemas.cnl");
  if (!source) {
    sink.report(source.error());
    return nullptr;
  }
  return build_program(mlab::cnl::elaborate(mlab::cnl::load(*source, sink), sink),
                       mlab::robot::component_library(), sink);
}

std::shared_ptr<const Program> from_configuration(mlab::text::Diagnostics& sink) {
  const auto source = mlab::text::read_source(mlab::base::source_folder() + "/bench/schemas.cdl");
  if (!source) {
    sink.report(source.error());
    return nullptr;
  }
  const auto robot = mlab::robot::configure(*source, "", "Schemas", {}, {}, sink);
  return robot ? robot->built.program : nullptr;
}

mlab::sim::BenchResult run(const mlab::sim::BenchScenario& scenario, const Program& program) {
  mlab::flow::Frame initial = program.make_frame();
  if (const mlab::flow::Port* half = program.find("half"))
    program.set(initial.data(), *half, fmt::format("{}", 0.45 * scenario.side));
  std::vector<mlab::flow::Frame> frames(scenario.robots.size());
  return mlab::sim::run_bench(
      scenario, {},
      [&](std::uint32_t robot, const mlab::percept::Percepts& percepts, mlab::percept::Action& out) {
        if (percepts.time == 0.0) frames[robot] = initial;
        program.step(frames[robot].data(), percepts, out, 1, robot + 1);
      });
}

// The two programs in turns, so that whatever else the machine does falls on both.
bool compare_robots(int rounds) {
  mlab::text::Diagnostics sink;
  const auto hand = written_by_hand(sink);
  const auto configured = from_configuration(sink);
  fmt::print(stderr, "{}", mlab::text::render(sink));
  if (!hand || !configured) return false;
  const mlab::sim::BenchScenario scenario = mlab::sim::make_bench_scenario(kRobots);
  const Program* const programs[2] = {hand.get(), configured.get()};
  std::vector<double> seconds[2];
  for (int round = 0; round < rounds; ++round) {
    mlab::sim::BenchResult results[2];
    for (int turn = 0; turn < 2; ++turn) {
      const int i = (round + turn) % 2;  // each is first as often as second
      const double begin = processor_seconds();
      results[i] = run(scenario, *programs[i]);
      seconds[i].push_back(processor_seconds() - begin);
    }
    if (results[0].mean_displacement != results[1].mean_displacement ||
        results[0].contacts != results[1].contacts) {
      fmt::print(stderr, "the two robots do different things\n");
      return false;
    }
  }
  for (std::vector<double>& list : seconds) std::ranges::sort(list);
  const std::size_t middle = seconds[0].size() / 2;
  fmt::print(
      "{} robots, processor time: by hand {:.3f} s, from a configuration {:.3f} s: ratio {:.3f} at best, "
      "{:.3f} "
      "in the middle\n",
      kRobots, seconds[0].front(), seconds[1].front(), seconds[1].front() / seconds[0].front(),
      seconds[1][middle] / seconds[0][middle]);
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  const int rounds = argc > 1 ? std::max(1, std::atoi(argv[1])) : 20;
  const auto begin = Clock::now();
  mlab::robot::library_environment();
  mlab::robot::component_library();
  fmt::print("the component library, once: {:.2f} ms\n", milliseconds_since(begin));
  const bool is_done =
      time_compilation("twenty states", twenty_states(), rounds) &&
      time_compilation("a hundred deep", hundred_deep(), rounds) &&
      time_compilation("ten thousand nodes", ten_thousand_nodes(), std::max(1, rounds / 5)) &&
      compare_robots(rounds);
  return is_done ? 0 : 1;
}
