#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "begun_run.h"
#include "mlab/lang/mdl/mdl.h"

namespace mlab {

using Places = std::vector<geom::Point>;

/// Places side by side in a rectangle that are free of rocks, and whether somebody has come near enough to
/// see them, on their side of all walls.
class Seen {
 public:
  struct Rock {
    geom::Point center;
    double radius;
  };
  Seen(geom::Point low, geom::Point high, const std::vector<Rock>& rocks, double swath, double step = 2.0)
      : reach_(swath / 2.0), step_(step) {
    for (double y = low.y + step / 2.0; y < high.y; y += step) {
      for (double x = low.x + step / 2.0; x < high.x; x += step) {
        const geom::Point p{x, y};
        if (std::ranges::all_of(rocks,
                                [&](const Rock& one) { return geom::distance(one.center, p) > one.radius; }))
          unseen_.push_back(p);
      }
    }
    all_ = static_cast<double>(unseen_.size());
  }
  void add_wall(geom::Segment wall) { walls_.push_back(wall); }
  void look(geom::Segment from) {
    std::erase_if(unseen_, [&](geom::Point p) {
      const geom::Point near = geom::nearest_point(from, p);
      return geom::distance(near, p) <= reach_ &&
             std::ranges::none_of(
                 walls_, [&](const geom::Segment& wall) { return geom::intersects({near, p}, wall); });
    });
  }
  double area() const { return step_ * step_ * all_; }  // [m^2]
  double share() const { return 1.0 - static_cast<double>(unseen_.size()) / all_; }

 private:
  double reach_;
  double step_;  // from place to place [m]
  std::vector<geom::Point> unseen_;
  std::vector<geom::Segment> walls_;
  double all_ = 0.0;
};

/// A run of a mission of one unit.
class SharedTasks : public testing::Test {
 protected:
  static constexpr double kTolerance = 2.0;  // of the standard robot: so near to a place it was there [m]

  /// @param measures  control measures of the map
  /// @param unknown   rocks that no map shows
  void make(int robots, const std::string& preamble, const std::string& command,
            const std::string& measures = "", const std::vector<Seen::Rock>& unknown = {}) {
    std::string text = "OVERLAY map.odl\nMISSION-AREA 600 400\n" + preamble + "UNIT <team>";
    for (int i = 0; i < robots; ++i) text += " ROBOT";
    text += "\nCOMMAND LIST:\n0. UNIT team START 20 150 0 10\n1. UNIT team " + command + "\n";
    text::Diagnostics sink;
    mdl::LoadOptions options;
    options.files.is_file = [](const std::string& path) { return path == "map.odl"; };
    options.files.read = [&](const std::string& path) -> text::Result<text::SourcePtr> {
      return std::make_shared<const text::Source>(path, "CONTROL MEASURES:\n" + measures);
    };
    const auto mission =
        mdl::check_mission(std::make_shared<const text::Source>("test.mdl", text), "", sink, options);
    ASSERT_NE(mission, nullptr) << text::render(sink);
    overlay::EnvironmentEvent rocks;
    rocks.start = 1.0;
    for (const Seen::Rock& one : unknown)
      rocks.changes.push_back(overlay::AddObstacle{one.center, one.radius});
    run_ = begun_run(mission, 120.0, told_, {rocks});
    ASSERT_NE(run_, nullptr);
  }

  bool is_done() const { return run_->state().outcome == mission::Outcome::kDone; }
  /// Until it is over, or so much time has passed [s].
  template <class Look>
  void go(double seconds, const Look& look) {
    while (run_->time() < seconds && run_->step() != run::MissionRun::Progress::kOver) look();
  }
  void go(double seconds) {
    go(seconds, [] {});
  }

  /// @return  how near some robot came to each of the places [m]
  std::vector<double> go_and_look(double seconds, const Places& places) {
    std::vector<double> nearest(places.size(), std::numeric_limits<double>::infinity());
    go(seconds, [&] {
      for (std::size_t i = 0; i < places.size(); ++i) {
        for (std::uint32_t robot = 1; robot <= robots(); ++robot)
          nearest[i] = std::min(nearest[i], geom::distance(places[i], place_of(robot)));
      }
    });
    return nearest;
  }

  geom::Point place_of(std::uint32_t robot) const {
    return run_->fleet().pose(*run_->fleet().find({robot})).position;
  }
  std::uint32_t robots() const { return static_cast<std::uint32_t>(run_->fleet().robots().size()); }
  double driven() const {
    double out = 0.0;
    for (const fleet::FleetRobot& robot : run_->fleet().robots())
      out += run_->world().body(robot.body).distance_driven;
    return out;
  }
  unsigned contacts() const {
    unsigned out = 0;
    for (const fleet::FleetRobot& robot : run_->fleet().robots())
      out += run_->world().body(robot.body).contacts;
    return out;
  }

  std::vector<std::uint32_t> lost() const {
    std::vector<std::uint32_t> out;
    for (const fleet::FleetRobot& robot : run_->fleet().robots()) {
      if (robot.life == fleet::RobotLife::kFaulted) out.push_back(robot.id.value);
    }
    return out;
  }

  static Places random_places(base::Random& random, int count) {
    Places out;
    while (static_cast<int>(out.size()) < count) {
      const geom::Point p{random.uniform(40, 560), random.uniform(20, 380)};
      if (std::ranges::all_of(out, [&](geom::Point q) { return geom::distance(p, q) > 15.0; }))
        out.push_back(p);
    }
    return out;
  }
  void search(Seen& seen) {
    int cycle = 0;
    Places before;
    go(3000, [&] {
      if (++cycle % 3 != 0) return;
      Places now;
      for (std::uint32_t robot = 1; robot <= robots(); ++robot) now.push_back(place_of(robot));
      if (before.empty()) before = now;  // not yet where they start
      for (std::size_t i = 0; i < now.size(); ++i) seen.look({before[i], now[i]});
      before = now;
    });
  }
  static std::vector<Seen::Rock> random_rocks(std::uint64_t seed, geom::Point low, geom::Point high,
                                              std::size_t count) {
    base::Random random(seed);
    std::vector<Seen::Rock> out;
    while (out.size() < count) {
      const Seen::Rock rock{
          {random.uniform(low.x + 20, high.x - 20), random.uniform(low.y + 20, high.y - 20)},
          random.uniform(2, 10)};
      if (std::ranges::all_of(out, [&](const Seen::Rock& one) {
            return geom::distance(one.center, rock.center) > one.radius + rock.radius + 12.0;
          }))
        out.push_back(rock);
    }
    return out;
  }
  static std::string written(const std::vector<Seen::Rock>& rocks) {
    std::string out;
    for (const Seen::Rock& one : rocks)
      out += fmt::format("OBSTACLE {:.3f} {:.3f} {:.3f}\n", one.center.x, one.center.y, one.radius);
    return out;
  }
  static std::string written(const Places& places) {
    std::string out;
    for (const geom::Point p : places) out += fmt::format(" {:.3f} {:.3f}", p.x, p.y);
    return out;
  }

  std::unique_ptr<run::MissionRun> run_;
  std::string told_;
};

}  // namespace mlab
