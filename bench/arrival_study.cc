// Who arrives: units that cross worlds drawn by seeds and come to their goal or not, beside an independent
// planner that says who could. Prints a line, and with --table writes a row for each run.
//
//     arrival_study [--world NAME] [--runs N] [--robots N] [--formation NAME] [--coverage PERCENT]
//                   [--reactive] [--table FILE] [--write FOLDER]
//
// --write leaves the mission and the map of each run in a folder, for `mlab run`.
//
// The planner knows everything: a search in a grid of 0.25 m, for each robot alone, as a disc of its radius
// and its margin. A run is possible where each robot's start reaches a free place within 10 m of the goal. It
// shares nothing with the ways that robots plan.

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <limits>
#include <memory>
#include <numbers>
#include <span>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "mission_of.h"
#include "mlab/cell/testing/permission.h"
#include "mlab/lang/odl/drawn_worlds.h"
#include "mlab/mission/known_map.h"
#include "mlab/robot/program/robot_program.h"
#include "mlab/simulated/run.h"
#include "mlab/text/diagnostic.h"

namespace mlab::bench {
namespace {

constexpr double kCell = 0.25;  // [m]
constexpr double kNear = 10.0;  // of the goal [m]
constexpr double kSpeed = 4.0;  // of a standard robot that its goal alone pulls [m/s]

constexpr double kOutdoors = 5.2;  // body and margin [m]
constexpr double kIndoors = 0.3;   // body and what is left of the margin [m]

/// A world, and how a unit sets out in it.
struct World {
  odl::DrawnWorld map;
  geom::Offset step{0, 20};  ///< from one robot to the next at the start; their row has its middle there
  double spacing = 50.0;     ///< of formations [m]
  double clearance = kOutdoors;
  std::string settings = {};  ///< lines of the mission
  bool has_others = false;    ///< another unit of as many goes the other way
};

/// @param coverage  of fields [per cent]
World world_of(std::string_view name, double coverage, std::uint64_t seed) {
  const auto kind = std::ranges::find(odl::kWorldKinds, name, &odl::WorldKindInfo::name);
  if (kind == odl::kWorldKinds.end()) {
    return {.map = {{1000, 400}, {200, 200}, {800, 200}, ""},
            .settings = fmt::format("SET OBSTACLE-COVERAGE {}\nSET MIN-OBSTACLE-RADIUS 2\n"
                                    "SET MAX-OBSTACLE-RADIUS 12\nCREATE-OBSTACLES\n",
                                    coverage)};
  }
  World out{.map = odl::drawn_world(static_cast<odl::WorldKind>(kind - odl::kWorldKinds.begin()), seed)};
  if (name == "rooms" || name == "corridor") {
    out.step = name == "rooms" ? geom::Offset{0, 1.5} : geom::Offset{-1.5, 0};
    out.spacing = 5;
  } else if (name == "maze") {
    out.step = {0, 0.8};
    out.spacing = 3;
  } else {
    out.has_others = name == "gap";
    return out;
  }
  out.clearance = kIndoors;
  return out;
}

struct Options {
  std::string world = "field";
  std::string formation = "Column";
  int runs = 20;
  int robots = 4;
  double coverage = 10.0;
  bool is_reactive = false;
  std::string table;
  std::string folder;  ///< where the mission and the map of each run are left
};

// ---- the independent planner

class Grid {
 public:
  explicit Grid(geom::Point size)
      : across_(static_cast<int>(size.x / kCell) + 1),
        up_(static_cast<int>(size.y / kCell) + 1),
        is_blocked_(count()) {}

  void block_disc(geom::Point center, double radius) {
    each_cell(center.x - radius, center.y - radius, center.x + radius, center.y + radius, [&](int x, int y) {
      if (std::hypot(x * kCell - center.x, y * kCell - center.y) < radius) is_blocked_[index(x, y)] = true;
    });
  }
  void block_wall(geom::Segment wall, double radius) {
    const auto [low_x, high_x] = std::minmax(wall.a.x, wall.b.x);
    const auto [low_y, high_y] = std::minmax(wall.a.y, wall.b.y);
    each_cell(low_x - radius, low_y - radius, high_x + radius, high_y + radius, [&](int x, int y) {
      const geom::Point here{x * kCell, y * kCell};
      if (geom::distance(nearest_point(wall, here), here) < radius) is_blocked_[index(x, y)] = true;
    });
  }
  /// For each start the length of a way to within kNear of the goal, infinite where there is none: Dijkstra's
  /// search from all free places there, and what it finds drawn taut.
  std::vector<double> ways(std::span<const geom::Point> starts, geom::Point goal) const {
    constexpr double kNever = std::numeric_limits<double>::infinity();
    std::vector<double> far(count(), kNever);
    std::vector<std::int32_t> from(count(), -1);
    // By length in cells: no step is shorter than one, so that nothing within a bucket is found nearer from
    // within it.
    std::vector<std::vector<std::int32_t>> open(1);
    each_cell(goal.x - kNear, goal.y - kNear, goal.x + kNear, goal.y + kNear, [&](int x, int y) {
      const std::size_t at = index(x, y);
      if (is_blocked_[at] || std::hypot(x * kCell - goal.x, y * kCell - goal.y) > kNear) return;
      far[at] = 0.0;
      open[0].push_back(static_cast<std::int32_t>(at));
    });
    for (std::size_t length = 0; length < open.size(); ++length) {
      for (const std::int32_t at : std::exchange(open[length], {})) {
        const double here = far[static_cast<std::size_t>(at)];
        if (static_cast<std::size_t>(here) != length) continue;
        for (int dx = -1; dx <= 1; ++dx) {
          for (int dy = -1; dy <= 1; ++dy) {
            const int x = at % across_ + dx;
            const int y = at / across_ + dy;
            if (!is_free(x, y)) continue;
            const double next = here + (dx != 0 && dy != 0 ? std::numbers::sqrt2 : 1.0);
            const std::size_t to = index(x, y);
            if (next >= far[to]) continue;
            far[to] = next;
            from[to] = at;
            const auto bucket = static_cast<std::size_t>(next);
            if (open.size() <= bucket) open.resize(bucket + 1);
            open[bucket].push_back(static_cast<std::int32_t>(to));
          }
        }
      }
    }
    std::vector<double> out;
    for (const geom::Point start : starts) {
      const int x = static_cast<int>(std::lround(start.x / kCell));
      const int y = static_cast<int>(std::lround(start.y / kCell));
      const bool is_there = is_free(x, y) && far[index(x, y)] < kNever;
      out.push_back(is_there ? taut(static_cast<std::int32_t>(index(x, y)), from) : kNever);
    }
    return out;
  }

 private:
  std::size_t count() const { return static_cast<std::size_t>(across_) * static_cast<std::size_t>(up_); }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(across_) + static_cast<std::size_t>(x);
  }
  bool is_free(int x, int y) const {
    return x >= 0 && y >= 0 && x < across_ && y < up_ && !is_blocked_[index(x, y)];
  }
  void each_cell(double x0, double y0, double x1, double y1,
                 const std::function<void(int, int)>& visit) const {
    for (int y = std::max(0, static_cast<int>(y0 / kCell));
         y <= std::min(up_ - 1, static_cast<int>(y1 / kCell) + 1); ++y) {
      for (int x = std::max(0, static_cast<int>(x0 / kCell));
           x <= std::min(across_ - 1, static_cast<int>(x1 / kCell) + 1); ++x)
        visit(x, y);
    }
  }
  bool sees(std::int32_t a, std::int32_t b) const {
    const double x0 = a % across_;
    const double y0 = a / across_;
    const double x1 = b % across_;
    const double y1 = b / across_;
    const int steps = static_cast<int>(2.0 * std::hypot(x1 - x0, y1 - y0)) + 1;
    for (int i = 1; i < steps; ++i) {
      const double t = static_cast<double>(i) / steps;
      if (!is_free(static_cast<int>(std::lround(x0 + t * (x1 - x0))),
                   static_cast<int>(std::lround(y0 + t * (y1 - y0)))))
        return false;
    }
    return true;
  }
  double taut(std::int32_t at, const std::vector<std::int32_t>& from) const {
    std::vector<std::int32_t> cells;
    for (; at >= 0; at = from[static_cast<std::size_t>(at)]) cells.push_back(at);
    double out = 0.0;
    for (std::size_t i = 0; i + 1 < cells.size();) {
      std::size_t next = i + 1;
      for (std::size_t step = 1; i + step < cells.size(); step *= 2) {
        if (!sees(cells[i], cells[i + step])) break;
        next = i + step;
      }
      while (next + 1 < cells.size() && sees(cells[i], cells[next + 1])) ++next;
      out += kCell * std::hypot(cells[i] % across_ - cells[next] % across_,
                                cells[i] / across_ - cells[next] / across_);
      i = next;
    }
    return out;
  }

  int across_;
  int up_;
  std::vector<bool> is_blocked_;
};

// ---- runs

struct Row {
  std::uint64_t seed = 0;
  bool is_possible = false;
  bool has_arrived = false;
  unsigned contacts = 0;
  double ratio = 0.0;     ///< time, in units of the longest way at kSpeed
  double farthest = 0.0;  ///< of all robots from the goal, at the end [m]
  std::string why = {};
};

std::unique_ptr<run::MissionRun> run_of(const Options& options, const World& world, std::uint64_t seed) {
  std::string mission = "OVERLAY map.odl\n" + world.settings;
  mission += fmt::format("SET SEED {}\n", seed);
  if (options.is_reactive) mission += "SET NAVIGATION REACTIVE\n";
  mission +=
      fmt::format("NEW-ROBOT one \"robot\" blue \"\" (formation_spacing = {})\nUNIT <team>", world.spacing);
  for (int i = 0; i < options.robots; ++i) mission += " one";
  const geom::Offset half_row = world.step * (0.5 * (options.robots - 1));
  const auto start = [&](std::string_view unit, geom::Point at) {
    const geom::Point first = at - half_row;
    return fmt::format("UNIT {} START {:.2f} {:.2f} {} {}", unit, first.x, first.y, world.step.x,
                       world.step.y);
  };
  const auto go = [&](std::string_view unit, geom::Point to) {
    return fmt::format("UNIT {} MOVETO {} {} FORMATION {}", unit, to.x, to.y, options.formation);
  };
  std::string starts = start("team", world.map.start);
  std::string goes = go("team", world.map.goal);
  if (world.has_others) {
    mission += "\nUNIT <others>";
    for (int i = 0; i < options.robots; ++i) mission += " one";
    starts += " AND\n" + start("others", world.map.goal);
    goes += " AND\n" + go("others", world.map.start);
  }
  mission += "\nCOMMAND LIST:\n0. " + starts + "\n1. " + goes + "\n";
  const std::string map =
      fmt::format("MISSION-AREA {} {}\nCONTROL MEASURES:\n", world.map.size.width, world.map.size.height) +
      world.map.features;
  if (!options.folder.empty()) write_mission(options.folder, "study", seed, mission, map);
  const auto checked = mission_of(mission, map, seed);
  if (!checked) return nullptr;
  text::Diagnostics sink;
  run::RunSettings settings;
  settings.executive.proceed_all = true;
  robot::ProgramSources sources;
  sources.permission = cell::testing::code_permitted();
  std::shared_ptr<const mission::Mission> ready = checked;
  if (options.world == "unknown") {
    // What lies there is found out on the way.
    const auto blind = std::make_shared<mission::Mission>(*checked);
    overlay::EnvironmentEvent event;
    event.start = 0.2;
    for (const overlay::ObstacleDisc& one : blind->overlay.obstacles)
      event.changes.push_back(overlay::AddObstacle{one.center, one.radius});
    blind->overlay.obstacles.clear();
    settings.environment.events.push_back(event);
    ready = blind;
  }
  auto out = simulated::make_run(ready, sources, settings, sink);
  if (!out) fmt::print(stderr, "{}\n", text::render(sink));
  return out;
}

Row row_of(const Options& options, std::uint64_t seed) {
  World world = world_of(options.world, options.coverage, seed);
  if (options.robots > 4) world.spacing = std::min(world.spacing, 20.0);
  Row out{.seed = seed};
  const auto run = run_of(options, world, seed);
  if (!run) std::exit(1);
  run->set_observer([&](const mission::Effect& effect) {
    if (const auto* told = std::get_if<mission::effect::Tell>(&effect)) out.why = told->text;
  });
  run->post(mission::event::Execute{});
  run->step();
  std::vector<geom::Point> starts;
  for (const fleet::FleetRobot& robot : run->fleet().robots())
    starts.push_back(run->fleet().pose(robot).position);
  while (run->time() < 0.5) run->step();  // until what nobody knows of is there
  Grid grid({world.map.size.width, world.map.size.height});
  for (const binding::Disc& one : run->world().discs())
    grid.block_disc(one.center, one.radius + world.clearance);
  for (const overlay::Barrier& one : overlay::barriers(run->mission().overlay))
    grid.block_wall(one.segment, world.clearance);
  double longest = 0.0;
  const auto look = [&](std::span<const geom::Point> from, geom::Point goal) {
    for (const double way : grid.ways(from, goal)) longest = std::max(longest, way);
  };
  const auto count = static_cast<std::size_t>(options.robots);
  look({starts.data(), count}, world.map.goal);
  if (world.has_others) look({starts.data() + count, count}, world.map.start);
  out.is_possible = std::isfinite(longest);
  const double began = run->time();
  while (run->time() < 20'000.0 && run->step() == run::MissionRun::Progress::kStepped) {
  }
  out.has_arrived = run->state().outcome == mission::Outcome::kDone;
  if (out.has_arrived) out.why.clear();
  out.ratio = (run->time() - began) * kSpeed / longest;
  for (const fleet::FleetRobot& robot : run->fleet().robots()) {
    const binding::BodyState body = run->world().body(robot.body);
    out.contacts += body.contacts + body.run_over;
    const geom::Point at = run->fleet().pose(robot).position;
    const bool is_other = robot.id.value > static_cast<std::uint32_t>(options.robots);
    out.farthest = std::max(out.farthest, geom::distance(at, is_other ? world.map.start : world.map.goal));
  }
  return out;
}

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::ranges::sort(values);
  return values[std::min(values.size() - 1,
                         static_cast<std::size_t>(share * static_cast<double>(values.size())))];
}

int study(const Options& options) {
  std::vector<Row> rows(static_cast<std::size_t>(options.runs));
  std::atomic<std::size_t> next = 0;
  std::atomic<std::size_t> done = 0;
  {
    std::vector<std::jthread> threads;
    for (unsigned i = 0; i < std::max(1U, std::thread::hardware_concurrency()); ++i) {
      threads.emplace_back([&] {
        for (std::size_t at = next++; at < rows.size(); at = next++) {
          rows[at] = row_of(options, at + 1);
          fmt::print(stderr, "\r{} of {}", ++done, rows.size());
        }
      });
    }
  }
  fmt::print(stderr, "\r");
  int possible = 0;
  int arrived = 0;
  int arrived_of_possible = 0;
  unsigned contacts = 0;
  std::vector<double> ratios;
  for (const Row& row : rows) {
    possible += row.is_possible ? 1 : 0;
    arrived += row.has_arrived ? 1 : 0;
    contacts += row.contacts;
    if (!row.has_arrived || !row.is_possible) continue;
    ++arrived_of_possible;
    ratios.push_back(row.ratio);
  }
  fmt::print(
      "{} {} robots {}{}: {} of {} possible, {} of these arrive ({} of all), {} contacts; time {:.2f} "
      "median, {:.2f} nine of ten\n",
      options.world == "field" || options.world == "unknown"
          ? fmt::format("{} {} %", options.world, options.coverage)
          : options.world,
      options.robots, options.formation, options.is_reactive ? " reactive" : "", possible, rows.size(),
      arrived_of_possible, arrived, contacts, quantile(ratios, 0.5), quantile(ratios, 0.9));
  if (options.table.empty()) return 0;
  std::FILE* const out = std::fopen(options.table.c_str(), "w");
  if (out == nullptr) {
    std::perror(options.table.c_str());
    return 1;
  }
  fmt::print(out, "seed,possible,arrived,contacts,time,farthest_m,why\n");
  for (const Row& row : rows)
    fmt::print(out, "{},{},{},{},{:.3f},{:.1f},\"{}\"\n", row.seed, row.is_possible, row.has_arrived,
               row.contacts, row.ratio, row.farthest, row.why);
  return std::fclose(out) == 0 ? 0 : 1;
}

}  // namespace
}  // namespace mlab::bench

int main(int argc, char** argv) {
  mlab::bench::Options options;
  bool is_good = true;
  for (int i = 1; i < argc; i += 2) {
    const std::string_view word = argv[i];
    if (word == "--reactive") {
      options.is_reactive = true;
      --i;
      continue;
    }
    const char* const value = i + 1 < argc ? argv[i + 1] : "";
    if (word == "--world") {
      options.world = value;
    } else if (word == "--formation") {
      options.formation = value;
    } else if (word == "--runs") {
      options.runs = std::max(1, std::atoi(value));
    } else if (word == "--robots") {
      options.robots = std::max(1, std::atoi(value));
    } else if (word == "--coverage") {
      options.coverage = std::atof(value);
    } else if (word == "--write") {
      options.folder = value;
    } else if (word == "--table") {
      options.table = value;
    } else {
      is_good = false;
    }
  }
  const bool is_known =
      options.world == "field" || options.world == "unknown" ||
      std::ranges::count(mlab::odl::kWorldKinds, options.world, &mlab::odl::WorldKindInfo::name) == 1;
  if (is_good && is_known) return mlab::bench::study(options);
  fmt::print(
      stderr,
      "arrival_study [--world field|unknown|rooms|corridor|maze|bows|traffic|gap] [--runs N] [--robots N]\n"
      "              [--formation NAME] [--coverage PERCENT] [--reactive] [--table FILE] [--write FOLDER]\n");
  return 2;
}
