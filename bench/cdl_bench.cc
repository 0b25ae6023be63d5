// How long a configuration takes from its text to a running program.
//
// usage: cdl_bench [ROUNDS]

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "mlab/robot/configuration_file.h"

namespace {

// Twenty states of twenty nodes each: what one robot of a large mission has.
std::string configuration_of_400_nodes() {
  std::string text =
      "class Cart {\n  sensor bumper: DetectObstacles() binds sense_obstacles;\n"
      "  actuator wheels: Drive() binds movement;\n}\n"
      "assemblage Move(gain: gain, range: length) {\n  cooperate {\n";
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

}  // namespace

int main(int argc, char** argv) {
  using Clock = std::chrono::steady_clock;
  const int rounds = argc > 1 ? std::max(1, std::atoi(argv[1])) : 50;
  const auto source = std::make_shared<const mlab::text::Source>("bench.cdl", configuration_of_400_nodes());
  std::vector<double> milliseconds;
  std::size_t nodes = 0;
  const auto begin = Clock::now();
  mlab::robot::library_environment();
  mlab::robot::component_library();
  const double library = std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
  for (int i = 0; i < rounds; ++i) {
    mlab::text::Diagnostics sink;
    const auto start = Clock::now();
    const auto robot = mlab::robot::configure(source, "", "R", {}, {}, sink);
    milliseconds.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
    if (!robot) {
      fmt::print(stderr, "{}", mlab::text::render(sink));
      return 1;
    }
    nodes = robot->lowered.network.nodes.size();
  }
  std::ranges::sort(milliseconds);
  fmt::print(
      "{} nodes: {:.2f} ms at best, {:.2f} ms in the middle, {:.2f} ms at worst; once for the library {:.2f} "
      "ms\n",
      nodes, milliseconds.front(), milliseconds[milliseconds.size() / 2], milliseconds.back(), library);
}
