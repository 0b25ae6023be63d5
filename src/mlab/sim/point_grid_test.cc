#include "mlab/sim/point_grid.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/base/random.h"

namespace mlab::sim {
namespace {

using Item = PointGrid::Item;

/// The ids that a question to the grid comes to, sorted; and how many of them there were no need to look at.
struct Answer {
  Answer(const PointGrid& grid, const std::vector<Item>& items, const Box& box) {
    grid.visit(box, [&](const Item& item) { seen.push_back(item.id); });
    std::ranges::sort(seen);
    for (const Item& item : items) {
      if (is_inside(box, item)) wanted.push_back(item.id);
    }
  }
  bool is_right() const {
    return std::ranges::includes(seen, wanted) && std::ranges::adjacent_find(seen) == seen.end();
  }
  std::vector<std::uint32_t> seen, wanted;
};

std::vector<Item> scattered(std::uint32_t count, base::Random& random, double size, double x = 0,
                            double y = 0) {
  std::vector<Item> items;
  for (std::uint32_t i = 0; i < count; ++i) {
    items.push_back({x + random.uniform(-size, size), y + random.uniform(-size, size), 0.5F, i});
  }
  return items;
}

TEST(PointGrid, FindsWhateverIsInABoxEachOnce) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    base::Random random(seed);
    const double size = std::pow(10.0, random.uniform(-2.0, 7.0));
    std::vector<Item> items = scattered(1 + static_cast<std::uint32_t>(random.below(500)), random, size);
    if (seed % 3 == 0) items[0].x = 9e7;
    if (seed % 4 == 0) {
      for (Item& item : items) item.y = items[0].y;
    }
    PointGrid grid;
    grid.build(items, 0.01);
    for (int i = 0; i < 30; ++i) {
      const double reach = size * std::pow(10.0, random.uniform(-4.0, 1.0));
      const Box box = Box::around(random.uniform(-size, size), random.uniform(-size, size), reach);
      ASSERT_TRUE(Answer(grid, items, box).is_right()) << "seed " << seed;
    }
  }
}

TEST(PointGrid, LooksAtFewThatAreNotWantedHoweverTheyAreSpread) {
  base::Random random(1);
  std::vector<std::vector<Item>> worlds;
  worlds.push_back(scattered(10000, random, 500));
  worlds.push_back(scattered(10000, random, 500, 4e6, -4e6));
  std::vector<Item> two_crowds = scattered(5000, random, 50);
  for (const Item& item : scattered(5000, random, 50, 1e5, 1e5)) {
    two_crowds.push_back({item.x, item.y, 0.5F, item.id + 5000});
  }
  worlds.push_back(two_crowds);
  std::vector<Item> outlier = scattered(10000, random, 500);
  outlier[17].x = 1e8;
  worlds.push_back(outlier);
  for (const std::vector<Item>& items : worlds) {
    PointGrid grid;
    grid.build(items, 0.5);
    std::size_t seen = 0;
    for (std::size_t i = 0; i < items.size(); i += 10) {
      const Answer answer(grid, items, Box::around(items[i].x, items[i].y, 0.5));
      ASSERT_TRUE(answer.is_right());
      seen += answer.seen.size();
    }
    EXPECT_LT(static_cast<double>(seen) / (static_cast<double>(items.size()) / 10), 20.0);
  }
}

/// Robots as they stand in missions: `at(i)` is where the i-th one does.
template <class At>
std::vector<Item> standing(std::uint32_t count, At&& at) {
  std::vector<Item> items;
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto [x, y] = at(i);
    items.push_back({x, y, 0.2F, i});
  }
  return items;
}

/// How many a question about everything within `reach` of a robot looks at, for each that it is about.
double looked_at(const std::vector<Item>& items, double reach) {
  PointGrid grid;
  for (int cycle = 0; cycle < 3; ++cycle) grid.build(items, std::max(0.4, PointGrid::cell_for(reach)));
  std::size_t seen = 0;
  std::size_t wanted = 0;
  for (std::size_t i = 0; i < items.size(); i += 37) {
    grid.visit(Box::around(items[i].x, items[i].y, reach), [&](const Item& item) {
      ++seen;
      const double dx = item.x - items[i].x;
      const double dy = item.y - items[i].y;
      wanted += dx * dx + dy * dy <= reach * reach ? 1 : 0;
    });
  }
  return static_cast<double>(seen) / static_cast<double>(wanted);
}

// NOLINTBEGIN(bugprone-integer-division): places are counted
TEST(PointGrid, RobotsInLineColumnOrBlockLookAtFewThatAreOutOfRange) {
  using Place = std::pair<double, double>;
  const auto in_units = [](std::uint32_t i, double apart, double between) {  // fours in column
    return Place{0.0, (i / 4) * between + (i % 4) * apart};
  };
  base::Random random(1);
  const std::vector<std::pair<const char*, std::vector<Item>>> worlds = {
      {"line", standing(10'000, [](auto i) { return Place{2.0 * i, 50.0}; })},
      {"column", standing(10'000, [](auto i) { return Place{50.0, 2.0 * i}; })},
      {"diagonal", standing(10'000, [](auto i) { return Place{1.5 * i, 1.5 * i}; })},
      {"steep line", standing(10'000, [](auto i) { return Place{1.0 * i, -3.0 * i}; })},
      {"ten columns far apart",
       standing(10'000, [](auto i) { return Place{500.0 * (i % 10), 3.0 * (i / 10)}; })},
      {"hundred columns", standing(10'000, [](auto i) { return Place{20.0 * (i % 100), 2.0 * (i / 100)}; })},
      {"block", standing(10'000, [](auto i) { return Place{1.0 * (i % 100), 1.0 * (i / 100)}; })},
      {"250 units of four", standing(1'000, [&](auto i) { return in_units(i, 1.5, 25.0); })},
      {"250 units of four in a square",
       standing(1'000, [](auto i) { return Place{40.0 * (i / 4 % 16) + 1.5 * (i % 4), 40.0 * (i / 64)}; })},
      {"pairs",
       standing(10'000, [](auto i) { return Place{30.0 * (i / 2 % 71) + 0.5 * (i % 2), 30.0 * (i / 142)}; })},
      {"anywhere", scattered(10'000, random, 158.0)},
  };
  for (const auto& [name, items] : worlds) {
    for (const double reach : {3.0, 10.0, 30.0}) {
      const double share = looked_at(items, reach);
      RecordProperty(std::string(name) + " " + std::to_string(reach), std::to_string(share));
      EXPECT_LT(share, 4.0) << name << ", " << reach << " m";
    }
  }
}
// NOLINTEND(bugprone-integer-division)

TEST(PointGrid, AllAtOnePlaceIsNoTrouble) {
  std::vector<Item> items;
  for (std::uint32_t i = 0; i < 1000; ++i) items.push_back({3, 4, 0.0F, i});
  PointGrid grid;
  grid.build(items, 0.01);
  EXPECT_EQ(Answer(grid, items, Box::around(3, 4, 0.1)).seen.size(), 1000U);
}

TEST(PointGrid, CanBeEmptyAndFilledAgain) {
  PointGrid grid;
  grid.build({}, 1.0);
  EXPECT_TRUE(Answer(grid, {}, Box::around(0, 0, 1e6)).seen.empty());
  const std::vector<Item> items = {{1, 1, 0.0F, 0}};
  grid.build(items, 1.0);
  EXPECT_EQ(Answer(grid, items, Box::around(0, 0, 2)).seen.size(), 1U);
}

TEST(PointGrid, FindsAHandfulAndManyInTurns) {
  base::Random random(1);
  PointGrid grid;
  for (const std::uint32_t count : {100U, 5U, 16U, 17U, 0U, 100U}) {
    const std::vector<Item> items = scattered(count, random, 10.0);
    grid.build(items, 0.01);
    for (const double reach : {0.5, 5.0, 50.0})
      EXPECT_TRUE(Answer(grid, items, Box::around(1, 2, reach)).is_right()) << count;
  }
}

TEST(RoundedUp, IsNeverLess) {
  for (const double value : {0.1, 1.0 / 3, 1e-300, 123456789.123}) {
    EXPECT_GE(static_cast<double>(rounded_up(value)), value);
  }
}

}  // namespace
}  // namespace mlab::sim
