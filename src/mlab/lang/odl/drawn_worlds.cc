#include "mlab/lang/odl/drawn_worlds.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "mlab/base/random.h"

namespace mlab::odl {
namespace {

std::string disc(double x, double y, double radius) {
  return fmt::format("OBSTACLE {:.2f} {:.2f} {:.2f}\n", x, y, radius);
}
std::string wall(int& number, double x, double y, double to_x, double to_y) {
  return fmt::format("WALL W{} {:.2f} {:.2f} {:.2f} {:.2f} 2\n", ++number, x, y, to_x, to_y);
}

// Four by three rooms of 30 m; each door stands anywhere in its wall, and some walls have none.
DrawnWorld rooms(base::Random& random) {
  constexpr int kAcross = 4;
  constexpr int kUp = 3;
  constexpr double kRoom = 30.0;
  DrawnWorld out{.size = {kAcross * kRoom, kUp * kRoom}, .start = {15, 15}, .goal = {105, 75}};
  int number = 0;
  // Doors of a tree that joins all rooms, and of half the other walls.
  std::vector<int> group(std::size_t{kAcross} * kUp);
  for (std::size_t i = 0; i < group.size(); ++i) group[i] = static_cast<int>(i);
  struct Side {
    int a, b;
    bool is_upright;
  };
  std::vector<Side> sides;
  for (int y = 0; y < kUp; ++y) {
    for (int x = 0; x < kAcross; ++x) {
      if (x + 1 < kAcross) sides.push_back({y * kAcross + x, y * kAcross + x + 1, true});
      if (y + 1 < kUp) sides.push_back({y * kAcross + x, (y + 1) * kAcross + x, false});
    }
  }
  for (std::size_t i = sides.size(); i-- > 1;) std::swap(sides[i], sides[random.below(i + 1)]);
  for (const Side& side : sides) {
    const int x = side.b % kAcross;
    const int y = side.b / kAcross;
    const int from = group[static_cast<std::size_t>(side.a)];
    const int to = group[static_cast<std::size_t>(side.b)];
    const bool joins = from != to;
    for (int& one : group) one = one == from ? to : one;
    const double at = random.uniform(3, kRoom - 6);
    const double width = joins || random.uniform() < 0.5 ? random.uniform(2, 4) : 0.0;
    const double left = x * kRoom;
    const double low = y * kRoom;
    if (side.is_upright) {
      out.features +=
          wall(number, left, low, left, low + at) + wall(number, left, low + at + width, left, low + kRoom);
    } else {
      out.features +=
          wall(number, left, low, left + at, low) + wall(number, left + at + width, low, left + kRoom, low);
    }
  }
  return out;
}

// A corridor of 8 m that turns at random, with a pillar here and there.
DrawnWorld corridor(base::Random& random) {
  DrawnWorld out{.size = {340, 200}, .start = {20, 100}, .goal = {320, 0}};
  constexpr double kHalf = 4.0;
  int number = 0;
  std::string pillars;
  std::string walls;
  double y = 100;
  double x = 0;
  std::vector<geom::Point> line{{x, y}};
  while (x < 290) {
    x += random.uniform(30, 60);
    line.push_back({std::min(x, 300.0), y});
    y = std::clamp(y + random.uniform(-60, 60), 20.0, 180.0);
    line.push_back({std::min(x, 300.0), y});
  }
  line.push_back({340, y});
  out.goal.y = y;
  // Walls lie beside the line, whose corners are square.
  for (const double side : {-kHalf, kHalf}) {
    geom::Point last{0, line[0].y + side};
    for (std::size_t i = 1; i + 1 < line.size(); i += 2) {
      const double turn = line[i + 1].y > line[i].y ? 1.0 : -1.0;
      const geom::Point corner{line[i].x - side * turn, last.y};
      walls += wall(number, last.x, last.y, corner.x, corner.y);
      last = {corner.x, line[i + 1].y + side};
      walls += wall(number, corner.x, corner.y, last.x, last.y);
    }
    walls += wall(number, last.x, last.y, 340, last.y);
  }
  for (std::size_t i = 0; i + 1 < line.size(); i += 2) {
    if (line[i + 1].x - line[i].x <= 25 || i == 0) continue;
    const geom::Point at{random.uniform(line[i].x + 10, line[i + 1].x - 10),
                         line[i].y + random.uniform(-2, 2)};
    if (distance(at, out.goal) > 5.0) pillars += disc(at.x, at.y, 0.5);
  }
  out.features = pillars + walls;
  return out;
}

// Ten by eight cells of 12 m, joined by a tree.
DrawnWorld maze(base::Random& random) {
  constexpr int kAcross = 10;
  constexpr int kUp = 8;
  constexpr double kSide = 12.0;
  DrawnWorld out{.size = {kAcross * kSide, kUp * kSide},
                 .start = {6, 6},
                 .goal = {kAcross * kSide - 6, kUp * kSide - 6}};
  std::array<std::array<bool, kUp>, kAcross> was{};
  std::array<std::array<bool, kUp>, kAcross> is_open_east{};
  std::array<std::array<bool, kUp>, kAcross> is_open_north{};
  std::vector<std::pair<int, int>> path{{0, 0}};
  was[0][0] = true;
  while (!path.empty()) {
    const auto [x, y] = path.back();
    std::vector<std::pair<int, int>> next;
    for (const auto& [dx, dy] : {std::pair{1, 0}, std::pair{-1, 0}, std::pair{0, 1}, std::pair{0, -1}}) {
      const int to_x = x + dx;
      const int to_y = y + dy;
      if (to_x >= 0 && to_y >= 0 && to_x < kAcross && to_y < kUp &&
          !was.at(static_cast<std::size_t>(to_x)).at(static_cast<std::size_t>(to_y)))
        next.emplace_back(to_x, to_y);
    }
    if (next.empty()) {
      path.pop_back();
      continue;
    }
    const auto [to_x, to_y] = next[random.below(next.size())];
    was.at(static_cast<std::size_t>(to_x)).at(static_cast<std::size_t>(to_y)) = true;
    const auto low_x = static_cast<std::size_t>(std::min(x, to_x));
    const auto low_y = static_cast<std::size_t>(std::min(y, to_y));
    (to_x != x ? is_open_east : is_open_north).at(low_x).at(low_y) = true;
    path.emplace_back(to_x, to_y);
  }
  int number = 0;
  for (std::size_t x = 0; x < kAcross; ++x) {
    for (std::size_t y = 0; y < kUp; ++y) {
      const double right = static_cast<double>(x + 1) * kSide;
      const double top = static_cast<double>(y + 1) * kSide;
      if (x + 1 < kAcross && !is_open_east.at(x).at(y))
        out.features += wall(number, right, top - kSide, right, top);
      if (y + 1 < kUp && !is_open_north.at(x).at(y))
        out.features += wall(number, right - kSide, top, right, top);
    }
  }
  return out;
}

// Twelve bows of rocks that lie across the way, most of them open towards those who come.
DrawnWorld bows(base::Random& random) {
  DrawnWorld out{.size = {1000, 400}, .start = {100, 200}, .goal = {900, 200}};
  for (int bow = 0; bow < 12; ++bow) {
    const double x = random.uniform(220, 780);
    const double y = random.uniform(60, 340);
    const double size = random.uniform(20, 60);
    const double towards = random.normal() * 0.7;
    const int rocks = static_cast<int>(size * 2.6 / 8.0);
    for (int i = -rocks / 2; i <= rocks / 2; ++i) {
      const double angle = towards + 2.6 / rocks * i;
      const double rock_x = x + size * std::cos(angle);
      const double rock_y = y + size * std::sin(angle);
      if (std::abs(rock_x - 500) < 370) out.features += disc(rock_x, rock_y, 5);
    }
  }
  return out;
}

// Rocks on 3 per cent of the field, and forty discs that go to and fro across it.
DrawnWorld traffic(base::Random& random) {
  DrawnWorld out{.size = {1000, 400}, .start = {200, 200}, .goal = {800, 200}};
  double covered = 0.0;
  while (covered < 0.03 * 1000 * 400) {
    const geom::Point at{random.uniform(0, 1000), random.uniform(0, 400)};
    const double radius = random.uniform(2, 12);
    if (std::min(std::abs(at.x - 200), std::abs(at.x - 800)) < 25) continue;
    covered += std::numbers::pi * radius * radius;
    out.features += disc(at.x, at.y, radius);
  }
  for (int i = 0; i < 40; ++i) {
    const double x = random.uniform(300, 700);
    const double y = random.uniform(20, 380);
    const double radius = random.uniform(1, 4);
    const double to_x = x + random.uniform(-60, 60);
    const double to_y = random.uniform(20, 380);
    out.features += fmt::format("OBSTACLE {:.2f} {:.2f} {:.2f} ROUTE {:.2f} {:.2f} SPEED {:.2f}\n", x, y,
                                radius, to_x, to_y, random.uniform(0.5, 3));
  }
  return out;
}

// Two units that change sides through one gap of 12 m, which is not straight ahead.
DrawnWorld gap(base::Random& random) {
  DrawnWorld out{.size = {400, 300}, .start = {100, 150}, .goal = {300, 150}};
  const double middle = random.uniform(60, 240);
  int number = 0;
  out.features = wall(number, 200, 0, 200, middle - 6) + wall(number, 200, middle + 6, 200, 300);
  return out;
}

}  // namespace

DrawnWorld drawn_world(WorldKind kind, std::uint64_t seed) {
  base::Random random(seed);
  switch (kind) {
    case WorldKind::kRooms:
      return rooms(random);
    case WorldKind::kCorridor:
      return corridor(random);
    case WorldKind::kMaze:
      return maze(random);
    case WorldKind::kBows:
      return bows(random);
    case WorldKind::kTraffic:
      return traffic(random);
    case WorldKind::kGap:
      break;
  }
  return gap(random);
}

std::string text_of(const DrawnWorld& world, WorldKind kind, std::uint64_t seed) {
  const std::string_view name = kWorldKinds.at(static_cast<std::size_t>(kind)).name;
  return fmt::format(
      "-- mlab world {0} --seed {1}\n\nSCENARIO \"{0} {1}\"\nMISSION-AREA {2:g} {3:g}\n\nCONTROL "
      "MEASURES:\n\n"
      "PP Start {4:.2f} {5:.2f}\nPP Goal {6:.2f} {7:.2f}\n{8}",
      name, seed, world.size.width, world.size.height, world.start.x, world.start.y, world.goal.x,
      world.goal.y, world.features);
}

}  // namespace mlab::odl
