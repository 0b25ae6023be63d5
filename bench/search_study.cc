// What a search sees: units that search areas drawn by seeds, with rocks that their map shows or that nobody
// knows of. Prints a line, and with --table writes a row for each run.
//
//     search_study [--robots N] [--rocks known|unknown|none] [--swath METRES] [--runs N] [--lost N]
//                  [--ground SQUARE_METRES] [--table FILE] [--unseen FILE] [--write FOLDER]
//
// There is a rock on each 4,000 square metres, or on as many as --ground says.
// --lost lets so many robots fail within the first minute, --unseen lists the places that nobody saw, and
// --write leaves the mission, the map and what happens of each run in a folder, for `mlab run`.
//
// What is seen is told by places half a metre apart, from where the bodies really are.

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "mission_of.h"
#include "mlab/base/random.h"
#include "mlab/cell/testing/permission.h"
#include "mlab/geom/outline.h"
#include "mlab/robot/program/robot_program.h"
#include "mlab/simulated/run.h"
#include "mlab/text/diagnostic.h"

namespace mlab::bench {
namespace {

constexpr double kStep = 0.5;          // from place to place [m]
constexpr double kEdge = 60.0;         // round the area [m]
constexpr double kLongest = 20'000.0;  // a run takes [s]

struct Options {
  std::string rocks = "unknown";
  int robots = 4;
  int runs = 40;
  int lost = 0;
  double swath = 10.0;
  double ground_of_a_rock = 4000.0;  ///< [m^2]
  std::string table;
  std::string unseen;
  std::string folder;  ///< where the mission and the map of each run are left
};

/// An area to be searched, and what stands there.
struct Field {
  std::vector<geom::Point> outline;
  std::vector<ways::Round> rocks;
};

/// A rectangle of 200 to 400 m, each corner of it moved inwards, with rocks of 2 to 10 m.
Field field_of(std::uint64_t seed, double ground_of_a_rock) {
  base::Random random(seed);
  const double width = random.uniform(200.0, 400.0);
  const double height = random.uniform(200.0, 400.0);
  Field out;
  for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
    const double in_x = random.uniform(0.0, 0.25) * width;
    const double in_y = random.uniform(0.0, 0.25) * height;
    out.outline.push_back({kEdge + (x == 0 ? in_x : width - in_x), kEdge + (y == 0 ? in_y : height - in_y)});
  }
  constexpr double kBeyond = 20.0;  // rocks stand round the area, too [m]
  const auto count = static_cast<int>((width + 2 * kBeyond) * (height + 2 * kBeyond) / ground_of_a_rock);
  for (int tried = 0; tried < 20 * count && std::ssize(out.rocks) < count; ++tried) {
    const ways::Round rock{{kEdge + random.uniform(-kBeyond, width + kBeyond),
                            kEdge + random.uniform(-kBeyond, height + kBeyond)},
                           random.uniform(2.0, 10.0)};
    if (std::ranges::all_of(out.rocks, [&](const ways::Round& one) {
          return geom::distance(one.center, rock.center) > one.radius + rock.radius + 12.0;
        }))
      out.rocks.push_back(rock);
  }
  return out;
}

/// Places side by side that are free, and whether somebody has come near enough to see them.
class Seen {
 public:
  Seen(const Field& field, double swath) : reach_(0.5 * swath) {
    for (const geom::Point corner : field.outline) {
      columns_ = std::max(columns_, static_cast<int>(corner.x / kStep) + 1);
      rows_ = std::max(rows_, static_cast<int>(corner.y / kStep) + 1);
    }
    is_unseen_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
    for (int row = 0; row < rows_; ++row) {
      for (int column = 0; column < columns_; ++column) {
        const geom::Point p = place(column, row);
        const bool is_free =
            geom::is_within(field.outline, p) && std::ranges::all_of(field.rocks, [&](const auto& rock) {
              return geom::distance(rock.center, p) > rock.radius;
            });
        is_unseen_[index(column, row)] = is_free;
        all_ += is_free ? 1 : 0;
      }
    }
    left_ = all_;
  }

  void look(geom::Segment from) {
    const auto first = [&](double at) { return std::max(0, static_cast<int>((at - reach_) / kStep) - 1); };
    const auto last = [&](double at, int count) {
      return std::min(count - 1, static_cast<int>((at + reach_) / kStep) + 1);
    };
    const int last_row = last(std::max(from.a.y, from.b.y), rows_);
    const int last_column = last(std::max(from.a.x, from.b.x), columns_);
    for (int row = first(std::min(from.a.y, from.b.y)); row <= last_row; ++row) {
      for (int column = first(std::min(from.a.x, from.b.x)); column <= last_column; ++column) {
        if (!is_unseen_[index(column, row)]) continue;
        const geom::Point p = place(column, row);
        if (geom::distance(geom::nearest_point(from, p), p) > reach_) continue;
        is_unseen_[index(column, row)] = false;
        --left_;
      }
    }
  }
  double area() const { return kStep * kStep * static_cast<double>(all_); }  // [m^2]
  double share() const { return 1.0 - static_cast<double>(left_) / static_cast<double>(all_); }
  std::vector<geom::Point> unseen() const {
    std::vector<geom::Point> out;
    for (int row = 0; row < rows_; ++row) {
      for (int column = 0; column < columns_; ++column) {
        if (is_unseen_[index(column, row)]) out.push_back(place(column, row));
      }
    }
    return out;
  }

 private:
  static geom::Point place(int column, int row) { return {(column + 0.5) * kStep, (row + 0.5) * kStep}; }
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }

  double reach_;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<bool> is_unseen_;
  std::size_t all_ = 0;
  std::size_t left_ = 0;
};

struct Row {
  std::uint64_t seed = 0;
  bool is_done = false;
  double seen = 0.0;
  double longest = 0.0;  ///< way of one, in units of their mean
  double total = 0.0;    ///< ways together, in units of the area by the swath
  double within = 0.0;   ///< the same, from where each came to the area on
  double time = 0.0;     ///< [s]
  unsigned contacts = 0;
  std::vector<geom::Point> unseen = {};
  std::string why = {};
};

std::string written(const std::vector<ways::Round>& rocks, std::string_view word) {
  std::string out;
  for (const auto& [center, radius] : rocks)
    out += fmt::format("{} {:.3f} {:.3f} {:.3f}\n", word, center.x, center.y, radius);
  return out;
}

std::unique_ptr<run::MissionRun> run_of(const Options& options, const Field& field, std::uint64_t seed) {
  std::string mission = fmt::format("OVERLAY map.odl\nSET SEED {}\n", seed);
  if (options.lost > 0)
    mission += fmt::format("SET FAILING-ROBOTS {}\nSET FAILURES-WITHIN 60\n", options.lost);
  mission += "UNIT <team>";
  for (int i = 0; i < options.robots; ++i) mission += " ROBOT";
  mission += fmt::format(
      "\nCOMMAND LIST:\n0. UNIT team START 15 60 0 10\n1. UNIT team SEARCH Field SWATH {}\n", options.swath);
  std::string map = fmt::format("MISSION-AREA 520 520\nCONTROL MEASURES:\nOBJ Field");
  for (const geom::Point corner : field.outline) map += fmt::format(" {:.3f} {:.3f}", corner.x, corner.y);
  map += "\n";
  const bool is_known = options.rocks == "known";
  if (is_known) map += written(field.rocks, "OBSTACLE");
  if (!options.folder.empty()) write_mission(options.folder, "search", seed, mission, map);
  const auto checked = mission_of(mission, map, seed);
  if (!checked) return nullptr;
  text::Diagnostics sink;
  run::RunSettings settings;
  settings.executive.proceed_all = true;
  if (!is_known) {
    overlay::EnvironmentEvent event;
    event.start = 1.0;
    for (const auto& [center, radius] : field.rocks)
      event.changes.emplace_back(overlay::AddObstacle{center, radius});
    settings.environment.events.push_back(event);
  }
  robot::ProgramSources sources;
  sources.permission = cell::testing::code_permitted();
  auto out = simulated::make_run(checked, sources, settings, sink);
  if (!out) fmt::print(stderr, "{}\n", text::render(sink));
  return out;
}

Row row_of(const Options& options, std::uint64_t seed) {
  const Field field = field_of(seed, options.rocks == "none" ? 1e9 : options.ground_of_a_rock);
  Row out{.seed = seed};
  const auto run = run_of(options, field, seed);
  if (!run) std::exit(1);
  run->set_observer([&](const mission::Effect& effect) {
    if (const auto* told = std::get_if<mission::effect::Tell>(&effect)) out.why = told->text;
  });
  run->post(mission::event::Execute{});
  run->step();
  Seen seen(field, options.swath);
  const auto places = [&] {
    std::vector<geom::Point> all;
    for (const fleet::FleetRobot& robot : run->fleet().robots())
      all.push_back(run->fleet().pose(robot).position);
    return all;
  };
  std::vector<geom::Point> before = places();
  std::vector<double> way_there(before.size(), -1.0);
  while (run->time() < kLongest && run->step() == run::MissionRun::Progress::kStepped) {
    const std::vector<geom::Point> now = places();
    for (std::size_t i = 0; i < now.size(); ++i) {
      seen.look({before[i], now[i]});
      if (way_there[i] < 0.0 && geom::is_within(field.outline, now[i]))
        way_there[i] = run->world().body(run->fleet().robots()[i].body).distance_driven;
    }
    before = now;
  }
  out.is_done = run->state().outcome == mission::Outcome::kDone;
  if (out.is_done) out.why.clear();
  out.seen = seen.share();
  out.unseen = seen.unseen();
  out.time = run->time();
  double all = 0.0;
  for (const fleet::FleetRobot& robot : run->fleet().robots()) {
    const binding::BodyState body = run->world().body(robot.body);
    out.contacts += body.contacts + body.run_over;
    all += body.distance_driven;
    out.longest = std::max(out.longest, body.distance_driven);
  }
  out.longest /= all / options.robots;
  double there = 0.0;
  for (const double way : way_there) there += std::max(way, 0.0);
  out.total = all * options.swath / seen.area();
  out.within = (all - there) * options.swath / seen.area();
  return out;
}

struct Spread {
  double mean = 0.0;
  double least = 1e300;
  double most = 0.0;
};

Spread spread_of(const std::vector<Row>& rows, double Row::* value) {
  Spread out;
  for (const Row& row : rows) {
    out.mean += row.*value / static_cast<double>(rows.size());
    out.least = std::min(out.least, row.*value);
    out.most = std::max(out.most, row.*value);
  }
  return out;
}

void write_table(const std::vector<Row>& rows, const std::string& name) {
  std::ofstream out(name);
  out << "seed,done,seen,longest,total,time_s,contacts,why\n";
  for (const Row& row : rows)
    out << fmt::format("{},{},{:.4f},{:.3f},{:.3f},{:.1f},{},\"{}\"\n", row.seed, row.is_done, row.seen,
                       row.longest, row.total, row.time, row.contacts, row.why);
}

void write_unseen(const std::vector<Row>& rows, const std::string& name) {
  std::ofstream out(name);
  out << "seed,x_m,y_m\n";
  for (const Row& row : rows) {
    for (const geom::Point p : row.unseen) out << fmt::format("{},{:.2f},{:.2f}\n", row.seed, p.x, p.y);
  }
}

int study(const Options& options) {
  std::vector<Row> rows(static_cast<std::size_t>(options.runs));
  std::atomic<std::size_t> next = 0;
  {
    std::vector<std::jthread> threads;
    for (unsigned i = 0; i < std::max(1U, std::thread::hardware_concurrency()); ++i) {
      threads.emplace_back([&] {
        for (std::size_t at = next++; at < rows.size(); at = next++) rows[at] = row_of(options, at + 1);
      });
    }
  }
  const Spread seen = spread_of(rows, &Row::seen);
  const Spread longest = spread_of(rows, &Row::longest);
  const Spread total = spread_of(rows, &Row::total);
  const Spread within = spread_of(rows, &Row::within);
  const auto count = [&](auto&& is_so) { return std::ranges::count_if(rows, is_so); };
  unsigned contacts = 0;
  for (const Row& row : rows) contacts += row.contacts;
  fmt::print(
      "{} robots, swath {:g} m, rocks {}{}: {} of {} done, {} contacts; seen {:.2f} % ({:.2f} least, {} of "
      "{} 99.5 or more); longest {:.2f} of the mean ({:.2f} most, {} above 1.25); total {:.2f} of area by "
      "swath ({:.2f} most), without the way there {:.2f} ({:.2f} most, {} above 1.3); {:.0f} s\n",
      options.robots, options.swath, options.rocks, options.lost > 0 ? ", some lost" : "",
      count([](const Row& row) { return row.is_done; }), rows.size(), contacts, 100.0 * seen.mean,
      100.0 * seen.least, count([](const Row& row) { return row.seen >= 0.995; }), rows.size(), longest.mean,
      longest.most, count([](const Row& row) { return row.longest > 1.25; }), total.mean, total.most,
      within.mean, within.most, count([](const Row& row) { return row.within > 1.3; }),
      spread_of(rows, &Row::time).mean);
  if (!options.table.empty()) write_table(rows, options.table);
  if (!options.unseen.empty()) write_unseen(rows, options.unseen);
  return 0;
}

}  // namespace
}  // namespace mlab::bench

int main(int argc, char** argv) {
  mlab::bench::Options options;
  bool is_good = true;
  for (int i = 1; i < argc; i += 2) {
    const std::string_view word = argv[i];
    const char* const value = i + 1 < argc ? argv[i + 1] : "";
    if (word == "--rocks") {
      options.rocks = value;
    } else if (word == "--runs") {
      options.runs = std::max(1, std::atoi(value));
    } else if (word == "--robots") {
      options.robots = std::max(1, std::atoi(value));
    } else if (word == "--lost") {
      options.lost = std::atoi(value);
    } else if (word == "--swath") {
      options.swath = std::atof(value);
    } else if (word == "--ground") {
      options.ground_of_a_rock = std::max(500.0, std::atof(value));
    } else if (word == "--write") {
      options.folder = value;
    } else if (word == "--unseen") {
      options.unseen = value;
    } else if (word == "--table") {
      options.table = value;
    } else {
      is_good = false;
    }
  }
  is_good = is_good && options.swath > 0.0 &&
            (options.rocks == "known" || options.rocks == "unknown" || options.rocks == "none");
  if (is_good) return mlab::bench::study(options);
  fmt::print(stderr,
             "search_study [--robots N] [--rocks known|unknown|none] [--swath METRES] [--runs N] [--lost N]\n"
             "             [--ground SQUARE_METRES] [--table FILE] [--unseen FILE] [--write FOLDER]\n");
  return 2;
}
