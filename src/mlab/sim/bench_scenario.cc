#include "mlab/sim/bench_scenario.h"

#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <unordered_map>

#include "mlab/base/random.h"

namespace mlab::sim {
namespace {

using geom::Point;

constexpr double kRobotRadius = 0.085036758;
constexpr double kDiscRadius = 0.5;
constexpr double kAreaOfRobot = 10.0;  // [m^2]
constexpr double kCoverage = 0.05;
constexpr double kWallMargin = 0.3;
constexpr double kDiscGap = 0.3;
constexpr double kRobotGap = 0.05;
constexpr std::uint64_t kBeforeFirst =
    26;                        // draws that come out untypical for 1,000 robots, which seed 1 skips
constexpr double kCell = 1.5;  // >= the largest distance at which two things can be too near

/// Draws places that keep their distance from all drawn before.
class Scatter {
 public:
  Scatter(double side, std::uint64_t seed) : half_(side / 2), random_(seed) {}

  Point place(double margin, double radius, double gap) {
    for (;;) {
      const double x = random_.uniform(-half_ + margin, half_ - margin);
      const double y = random_.uniform(-half_ + margin, half_ - margin);
      if (!is_free({x, y}, radius, gap)) continue;
      cells_[key(x, y, 0, 0)].push_back({{x, y}, radius});
      return {x, y};
    }
  }
  double angle() { return random_.angle(); }

 private:
  static std::uint64_t key(double x, double y, int column, int row) {
    const auto cell = [](double v, int offset) {
      return static_cast<std::uint32_t>(static_cast<std::int32_t>(std::floor(v / kCell)) + offset);
    };
    return (std::uint64_t{cell(x, column)} << 32) | cell(y, row);
  }
  bool is_free(Point p, double radius, double gap) const {
    for (int column = -1; column <= 1; ++column) {
      for (int row = -1; row <= 1; ++row) {
        const auto found = cells_.find(key(p.x, p.y, column, row));
        if (found == cells_.end()) continue;
        for (const Disc& disc : found->second) {
          if (distance(disc.center, p) < radius + disc.radius + gap) return false;
        }
      }
    }
    return true;
  }

  double half_;
  base::Random random_;
  std::unordered_map<std::uint64_t, std::vector<Disc>> cells_;  // only looked up, never walked through
};

/// One line of the CSV: a word and up to three numbers.
struct Row {
  std::string_view word;
  std::array<double, 3> numbers{};
  std::size_t count = 0;  ///< of the numbers, up to the first field that is none
};

Row row_of(std::string_view line) {
  Row row;
  const auto next = [&] {
    const std::size_t comma = line.find(',');
    const std::string_view field = line.substr(0, comma);
    line = comma == std::string_view::npos ? std::string_view() : line.substr(comma + 1);
    return field;
  };
  row.word = next();
  for (double& number : row.numbers) {
    const std::string_view field = next();
    const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), number);
    if (error != std::errc() || end != field.data() + field.size() || !std::isfinite(number)) break;
    ++row.count;
  }
  return row;
}

std::unexpected<text::Diagnostic> bad_positions(const text::SourcePtr& source, std::size_t begin,
                                                std::size_t end, std::string message) {
  text::Diagnostic diagnostic;
  diagnostic.kind = "bad-positions";
  diagnostic.message = std::move(message);
  diagnostic.place = {source, {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)}};
  return std::unexpected(std::move(diagnostic));
}

}  // namespace

BenchScenario make_bench_scenario(std::uint32_t robots, std::uint64_t seed) {
  BenchScenario scenario;
  scenario.side = std::sqrt(kAreaOfRobot * robots);
  Scatter scatter(scenario.side, base::combine_bits(seed + kBeforeFirst, robots));
  const auto discs =
      std::lround(kCoverage * scenario.side * scenario.side / (std::numbers::pi * kDiscRadius * kDiscRadius));
  for (long i = 0; i < discs; ++i) {
    scenario.discs.push_back({scatter.place(kDiscRadius + kWallMargin, kDiscRadius, kDiscGap), kDiscRadius});
  }
  for (std::uint32_t i = 0; i < robots; ++i) {
    const Point place = scatter.place(kWallMargin, kRobotRadius, kRobotGap);
    scenario.robots.push_back({place, scatter.angle()});
  }
  return scenario;
}

text::Result<BenchScenario> read_bench_scenario(const text::SourcePtr& source) {
  BenchScenario scenario;
  const std::string_view all = source->text();
  std::size_t begin = 0;
  while (begin < all.size()) {
    std::size_t end = std::min(all.find('\n', begin), all.size());
    const std::size_t next = end + 1;
    while (end > begin && (all[end - 1] == '\r' || all[end - 1] == ' ')) --end;
    const Row row = row_of(all.substr(begin, end - begin));
    const auto& [a, b, c] = row.numbers;
    if (row.word == "# side_m" && row.count >= 1 && a > 0.0) {
      scenario.side = a;
    } else if (row.word == "obstacle" && row.count == 3 && c >= 0.0) {
      scenario.discs.push_back({{a, b}, c});
    } else if (row.word == "robot" && row.count == 3) {
      scenario.robots.push_back({{a, b}, c});
    } else if (end > begin) {
      return bad_positions(source, begin, end,
                           "expected `# side_m,SIDE`, `obstacle,X,Y,RADIUS` or `robot,X,Y,HEADING`");
    }
    begin = next;
  }
  if (scenario.side <= 0.0)
    return bad_positions(source, 0, 0, "no line `# side_m,SIDE` tells the arena's size");
  if (scenario.robots.empty()) return bad_positions(source, 0, 0, "no line `robot,X,Y,HEADING`");
  return scenario;
}

World bench_world(const BenchScenario& scenario) {
  World world;
  world.discs = scenario.discs;
  const double h = scenario.side / 2;
  const Point corners[] = {{-h, -h}, {h, -h}, {h, h}, {-h, h}};
  for (std::uint32_t i = 0; i < 4; ++i) world.walls.push_back({{corners[i], corners[(i + 1) % 4]}, i});
  return world;
}

BodySpec bench_body(double range) {
  BodySpec spec;
  spec.radius = kRobotRadius;
  spec.kinematics.drive = Drive::kDifferential;
  spec.kinematics.axle = 0.14;
  spec.kinematics.max_speed = kBenchCruise;
  spec.kinematics.max_turn_rate = kBenchTurnRate;
  spec.ring.count = 24;
  spec.ring.first_angle = 0.5 * 15.0 * std::numbers::pi / 180.0;
  spec.ring.range = range;
  return spec;
}

}  // namespace mlab::sim
