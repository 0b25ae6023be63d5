// What planning costs: 1,000 units of ten standard robots that each go somewhere in formation, once as they
// are and once with SET NAVIGATION REACTIVE; on open ground, and with a rock in the way of each unit. The two
// runs take turns of a second of the mission, so that what else the machine does slows both alike. Prints
// processor time for 2,000,000 robot-cycles, and a sum of where all robots are then, which a change that is
// only to be faster must not change.
//
//     navigation_bench [TURNS] [UNITS] [planned|reactive [open|rocks]]   the last: only these, for a profiler

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <string>
#include <string_view>

#include <fmt/core.h>

#include "mission_of.h"
#include "mlab/cell/testing/permission.h"
#include "mlab/robot/program/robot_program.h"
#include "mlab/simulated/run.h"
#include "mlab/text/diagnostic.h"

namespace mlab {
namespace {

constexpr int kSeconds = 20;  // of each run

struct Took {
  double processor = 0.0;  // [s]
  std::uint64_t places = 0;
};

double processor_seconds() {
  std::timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Units stand in rows of forty, too far apart to meet.
std::string map_of(int units, bool has_rocks) {
  std::string out = "MISSION-AREA 12000 12000\n\nCONTROL MEASURES:\n\n";
  for (int unit = 0; unit < units; ++unit) {
    const int x = 100 + 290 * (unit % 40);
    const int y = 100 + 440 * (unit / 40);
    out += fmt::format("OBJ S{} {} {} 60\nOBJ G{} {} {} 60\n", unit, x, y, unit, x, y + 300);
    if (has_rocks) out += fmt::format("OBSTACLE {} {} 6\n", x + 5, y + 150);
  }
  return out;
}

std::string mission_of(int units, bool is_reactive) {
  std::string out = "OVERLAY map.odl\n";
  if (is_reactive) out += "SET NAVIGATION REACTIVE\n";
  std::string start;
  std::string go;
  for (int unit = 0; unit < units; ++unit) {
    out += fmt::format("UNIT <u{}> ROBOT ROBOT ROBOT ROBOT ROBOT ROBOT ROBOT ROBOT ROBOT ROBOT\n", unit);
    const char* const more = unit + 1 < units ? " AND\n     " : "\n";
    start += fmt::format("UNIT u{} START OBJ-S{} 0 10{}", unit, unit, more);
    go += fmt::format("UNIT u{} MOVETO OBJ-G{} FORMATION Wedge{}", unit, unit, more);
  }
  return out + "\nCOMMAND LIST:\n\n  0. " + start + "  1. " + go;
}

std::unique_ptr<run::MissionRun> run_of(const std::string& mission, const std::string& map) {
  const auto checked = bench::mission_of(mission, map, 0);
  text::Diagnostics sink;
  robot::ProgramSources sources;
  sources.permission = cell::testing::code_permitted();
  if (!checked) return nullptr;
  auto out = simulated::make_run(checked, sources, {}, sink);
  if (!out) fmt::print(stderr, "{}\n", text::render(sink));
  return out;
}

void go_on(run::MissionRun& run, double until, Took& took) {
  const double began = processor_seconds();
  while (run.time() < until && run.step() == run::MissionRun::Progress::kStepped) {
  }
  took.processor += processor_seconds() - began;
}

std::uint64_t places(const run::MissionRun& run) {
  std::uint64_t out = 0xcbf29ce484222325;
  for (const fleet::FleetRobot& robot : run.fleet().robots()) {
    const geom::Pose pose = run.fleet().pose(robot);
    for (const double value : {pose.position.x, pose.position.y, pose.heading})
      out = (out ^ std::bit_cast<std::uint64_t>(value)) * 0x100000001b3U;
  }
  return out;
}

/// Adds what both runs take.
/// @param only  empty: both
bool measure(const std::string& map, int units, std::string_view only, Took& planned, Took& reactive) {
  const auto plans = run_of(mission_of(units, false), map);
  const auto reacts = run_of(mission_of(units, true), map);
  if (!plans || !reacts) return false;
  plans->post(mission::event::Execute{});
  reacts->post(mission::event::Execute{});
  for (int second = 1; second <= kSeconds; ++second) {
    if (only != "reactive") go_on(*plans, second, planned);
    if (only != "planned") go_on(*reacts, second, reactive);
  }
  planned.places = places(*plans);
  reactive.places = places(*reacts);
  return true;
}

int run_all(int turns, int units, std::string_view only, std::string_view ground) {
  for (const bool has_rocks : {false, true}) {
    if (ground == (has_rocks ? "open" : "rocks")) continue;
    const std::string map = map_of(units, has_rocks);
    Took planned;
    Took reactive;
    for (int turn = 0; turn < turns; ++turn) {
      if (!measure(map, units, only, planned, reactive)) return 1;
    }
    fmt::print("{}: planned {:.2f} s ({:016x}), reactive {:.2f} s ({:016x}): {:.0f} % of the speed\n",
               has_rocks ? "a rock in each way" : "open ground", planned.processor / turns, planned.places,
               reactive.processor / turns, reactive.places, 100.0 * reactive.processor / planned.processor);
  }
  return 0;
}

}  // namespace
}  // namespace mlab

int main(int argc, char** argv) {
  const auto number = [&](int place, int otherwise) {
    return argc > place ? std::max(1, std::atoi(argv[place])) : otherwise;
  };
  return mlab::run_all(number(1, 3), number(2, 1000), argc > 3 ? argv[3] : "", argc > 4 ? argv[4] : "");
}
