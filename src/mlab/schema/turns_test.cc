#include "mlab/schema/turns.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/schema/requests.h"

namespace mlab::schema {
namespace {

using geom::Offset;
using geom::Point;

constexpr Offset kEast{3.0, 0.0};
constexpr Offset kWest{-3.0, 0.0};
constexpr Offset kNothing{};

// Robots of 0.2 m that look east and see and hear each other, in cycles of 0.1 s. They stand where they are
// put.
class Turns : public testing::Test {
 protected:
  struct Robot {
    Point at;
    Offset wanted;
    double left = 100.0;
    TurnTaker turns;
    Turn turn;
  };

  void put(Point at, Offset wanted, double left = 100.0) { robots_.push_back({at, wanted, left, {}, {}}); }

  void run(double seconds) {
    for (double left = seconds; left > 0.05; left -= 0.1) cycle();
  }

  void cycle() {
    std::vector<percept::AskedPassage> told = told_;
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      percept::Percepts percepts;
      percepts.id = id_of(i);
      percepts.time = time_;
      percepts.pose = {robots_[i].at, 0.0};
      percepts.ground.walls = walls_;
      percepts.ground.revision = walls_.empty() ? 0 : revision_;
      percepts.ground.bounds = {-100, -100, 100, 100};
      percepts.asked_passages = told_;
      const auto seen = readings(i);
      percepts.robots = seen;
      flow::Robots all;
      for (std::size_t k = 0; k < seen.size(); ++k) all.add(k);
      percept::Action action;
      robots_[i].turn = robots_[i].turns.take(percepts, {all, seen}, robots_[i].wanted, robots_[i].left, 0.2,
                                              0.6, 2.0, action);
      for (int k = 0; k < action.request_count; ++k)
        hear(told, id_of(i), action.requests[static_cast<std::size_t>(k)]);
    }
    told_ = told;
    time_ += 0.1;
  }

  static std::uint64_t next_revision() {
    static std::uint64_t last = 0x7a4e5;
    return ++last;
  }

  static base::RobotId id_of(std::size_t i) { return {static_cast<std::uint32_t>(i + 1)}; }

  std::vector<percept::RobotReading> readings(std::size_t of) const {
    std::vector<percept::RobotReading> out;
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      const Offset to = robots_[i].at - robots_[of].at;
      if (i != of) out.push_back({.id = id_of(i), .center = {to.x, to.y, 0.0}, .radius = 0.2});
    }
    std::ranges::sort(out, {}, [](const percept::RobotReading& one) { return length(one.center); });
    return out;
  }

  void hear(std::vector<percept::AskedPassage>& told, base::RobotId from,
            const percept::Request& request) const {
    EXPECT_EQ(request.kind, percept::Request::Kind::kAskPassage) << "nothing that it told is lost by it";
    std::erase_if(told, [&](const percept::AskedPassage& one) { return one.from == from; });
    told.push_back({from, request.place, request.cost, time_});
    std::ranges::sort(told, {}, &percept::AskedPassage::from);
  }

  /// What that robot has told.
  std::optional<PassageWish> wish(std::size_t i) const {
    for (const percept::AskedPassage& one : told_) {
      if (one.from == id_of(i)) return wish_in(one);
    }
    return std::nullopt;
  }

  std::vector<Robot> robots_;
  std::vector<geom::Segment> walls_;
  const std::uint64_t revision_ = next_revision();  // of them
  std::vector<percept::AskedPassage> told_;
  double time_ = 10.0;
};

TEST(Priority, TheLowerNumberGoesFirstAndWhoItCornersBeforeIt) {
  const Priority one({1});
  const Priority two({2});
  EXPECT_LT(one, two);
  EXPECT_LT(two.of_cornered(), two);
  EXPECT_LT(one, two.of_cornered());
  EXPECT_LT(Priority({9}), Priority()) << "who wants nothing";
  EXPECT_EQ(two.of_cornered().robot(), base::RobotId{2});
  EXPECT_TRUE(two.of_cornered().is_cornered());
  EXPECT_FALSE(two.is_cornered());
}

TEST(PassageWish, ComesOutAsItWasTold) {
  for (const Priority priority : {Priority({12}), Priority({12}).of_cornered()}) {
    const percept::Request told = tell_wish({{3.0, 4.0}, priority});
    const auto wish = wish_in({{5}, told.place, told.cost, 0.0});
    ASSERT_TRUE(wish);
    EXPECT_EQ(wish->to, (Point{3.0, 4.0}));
    EXPECT_EQ(wish->priority, priority);
  }
  for (const double cost : {-1.0, 16777216.0, 1e300, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_FALSE(wish_in({{5}, {}, cost, 0.0})) << cost;
}

TEST(PassageWish, IsHeardOfWhoIsNearAndNotLong) {
  const percept::Request told = tell_wish({{3.0, 0.0}, Priority({12})});
  const std::vector<percept::AskedPassage> passages{{{5}, told.place, told.cost, 10.0}};
  percept::Percepts percepts;
  percepts.asked_passages = passages;
  percepts.time = 11.0;
  flow::Robots first;
  first.add(0);
  const auto hears = [&](std::uint32_t id, double away) {
    const std::vector<percept::RobotReading> seen{{.id = {id}, .center = {away, 0.0, 0.0}, .radius = 0.2}};
    return hears_wish(percepts, {first, seen});
  };
  EXPECT_TRUE(hears(5, 2.0));
  EXPECT_FALSE(hears(6, 2.0)) << "who tells nothing";
  EXPECT_FALSE(hears(5, 9.0)) << "too far away to be in its way";
  percepts.time = 12.0;
  EXPECT_FALSE(hears(5, 2.0)) << "that was a while ago";
}

TEST_F(Turns, NobodyAsksWhoIsAloneOrHasRoom) {
  put({0, 0}, kEast);
  put({0, 5}, kEast);
  run(20.0);
  EXPECT_TRUE(told_.empty());
  EXPECT_FALSE(robots_[0].turn.is_taken);
  EXPECT_EQ(robots_[0].turn.wanted, kEast);
}

TEST_F(Turns, WhoStandsForSomeSecondsBeforeAnotherOneAsks) {
  put({0, 0}, kEast);
  put({0.9, 0}, kWest);
  run(4.5);
  EXPECT_TRUE(told_.empty());
  run(1.0);
  ASSERT_TRUE(wish(0));
  EXPECT_EQ(wish(0)->to, (Point{4.0, 0.0}));
  EXPECT_EQ(wish(0)->priority.robot(), base::RobotId{1});
}

TEST_F(Turns, WhoIsCarriedAlongByOthersStandsAllTheSame) {
  put({0, 0}, kEast);
  put({0.9, 0}, kWest);
  for (int i = 0; i < 55; ++i) {
    cycle();
    for (Robot& robot : robots_) robot.at.x -= 0.03;
  }
  ASSERT_TRUE(wish(0));
  EXPECT_EQ(wish(0)->priority, Priority({1}));
  EXPECT_FALSE(wish(1) && wish(1)->priority == Priority({2})) << "it gets on";
}

TEST_F(Turns, WhoHasArrivedMakesWayForAllAndTheLowerNumberForNone) {
  put({0, 0}, kNothing, 0.0);
  put({-0.9, 0}, kEast);
  run(7.0);
  EXPECT_TRUE(robots_[0].turn.is_taken);
  EXPECT_GT(length(robots_[0].turn.wanted), 0.1);
  EXPECT_EQ(robots_[1].turn.wanted, kEast);
  robots_.clear();
  told_.clear();
  put({0, 0}, kWest);
  put({-0.9, 0}, kEast);
  run(7.0);
  EXPECT_EQ(robots_[0].turn.wanted, kWest);
  EXPECT_NE(robots_[1].turn.wanted, kEast);
}

TEST_F(Turns, WhoWasPushedAwayHasArrivedAllTheSame) {
  put({0, 0}, kWest, 0.0);
  put({-0.9, 0}, kEast);
  run(1.0);
  robots_[0].left = 3.0;
  run(6.0);
  EXPECT_NE(robots_[0].turn.wanted, kWest) << "though it has the lower number";
}

TEST_F(Turns, WhoIsBesideTheWayOrBehindAWallStaysWhereItIs) {
  put({-0.9, 0}, kEast);
  put({0, 0}, kEast);            // who is in front
  put({1, 1.2}, kNothing, 0.0);  // beside
  walls_ = {{{-5, -0.25}, {5, -0.25}}};
  put({1, -0.5}, kNothing, 0.0);  // behind a wall
  run(7.0);
  ASSERT_TRUE(wish(0));
  EXPECT_FALSE(robots_[1].turn.is_taken && length(robots_[1].turn.wanted - kEast) > 0.0) << "the same way";
  EXPECT_FALSE(robots_[2].turn.is_taken);
  EXPECT_FALSE(robots_[3].turn.is_taken);
}

TEST_F(Turns, WhoMakesWayAsksForTheSameOne) {
  put({0, 0}, kEast);
  walls_ = {{{-30, -0.35}, {30, -0.35}}, {{-30, 0.35}, {30, 0.35}}};
  put({0.9, 0}, kWest);
  put({1.8, 0}, kWest);
  run(6.5);
  ASSERT_TRUE(wish(1));
  EXPECT_EQ(wish(1)->priority.robot(), base::RobotId{1});
  EXPECT_GT(robots_[2].turn.wanted.x, 0.0) << "it goes back, too";
}

// A corridor: who has arrived is between an earlier one and a later one that want past it.
TEST_F(Turns, WhoIsCorneredByALaterOneDoesNotDriveAnEarlierOneBack) {
  walls_ = {{{-30, -0.35}, {30, -0.35}}, {{-30, 0.35}, {30, 0.35}}};
  put({0, 0}, kEast);
  put({0.9, 0}, kNothing, 0.0);
  put({1.8, 0}, kWest);
  run(12.0);
  EXPECT_EQ(robots_[0].turn.wanted, kEast);
  EXPECT_GT(robots_[2].turn.wanted.x, 0.0);
}

TEST_F(Turns, WhoCanNotMakeWayIsMadeWayFor) {
  // A dead end in the east.
  walls_ = {{{-30, -0.35}, {1.5, -0.35}}, {{-30, 0.35}, {1.5, 0.35}}, {{1.5, -0.35}, {1.5, 0.35}}};
  put({0, 0}, kEast);
  put({0.9, 0}, kWest);
  run(8.0);
  ASSERT_TRUE(wish(1));
  EXPECT_TRUE(wish(1)->priority.is_cornered());
  EXPECT_EQ(robots_[1].turn.wanted, kWest);
  EXPECT_LT(robots_[0].turn.wanted.x, 0.0);
}

}  // namespace
}  // namespace mlab::schema
