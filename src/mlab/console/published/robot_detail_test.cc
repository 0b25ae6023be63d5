#include "mlab/console/published/robot_detail.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/console/testing/run_of.h"

namespace mlab::console {
namespace {

double number_at(const RobotDetail& detail, int place) {
  double out = 0.0;
  std::memcpy(&out, detail.numbers().data() + static_cast<std::size_t>(place) * sizeof out, sizeof out);
  return out;
}

class Ports : public ::testing::Test {
 protected:
  Ports() { testing::step(*run_, 20); }

  RobotDetail detail(const DetailWishes& wishes) {
    RobotDetail out;
    encode_detail(*run_, estimates_, run_->fleet().robots().front(), wishes, out);
    return out;
  }
  const flow::Program& program() { return *run_->fleet().robots().front().workings().program; }

 private:
  std::unique_ptr<run::MissionRun> run_ = testing::run_of(testing::kTravel);
  Estimates estimates_;
};

TEST_F(Ports, ThatAreWantedAloneHaveTheValuesThatTheyHaveAmongAll) {
  const RobotDetail all = detail({.ports = true});
  ASSERT_EQ(all.ports_size(), static_cast<int>(program().ports().size()));
  EXPECT_FALSE(all.has_some_ports());
  std::vector<std::uint32_t> wanted;
  for (std::uint32_t i = 0; i < program().ports().size(); i += 3) wanted.push_back(i);
  const RobotDetail some = detail({.ports = true, .some_ports = wanted});
  EXPECT_TRUE(some.has_some_ports());
  ASSERT_EQ(some.ports_size(), static_cast<int>(wanted.size()));
  ASSERT_EQ(some.active().size(), wanted.size());
  for (int i = 0; i < some.ports_size(); ++i) {
    const auto index = static_cast<int>(wanted[static_cast<std::size_t>(i)]);
    EXPECT_EQ(some.port_indices(i), wanted[static_cast<std::size_t>(i)]);
    EXPECT_EQ(some.ports(i), all.ports(index)) << program().ports()[static_cast<std::size_t>(index)].path;
    EXPECT_EQ(some.active()[static_cast<std::size_t>(i)], all.active()[static_cast<std::size_t>(index)]);
    const double number = number_at(all, index);
    if (std::isfinite(number)) {
      EXPECT_EQ(number_at(some, i), number);
    }
  }
  EXPECT_LT(some.ByteSizeLong(), all.ByteSizeLong());
}

TEST(Ways, AreShownOfRobotsThatPlanThem) {
  const auto run = testing::run_of(
      "MISSION-AREA 1000 1000\n"
      "OBSTACLE 400 100 20\n"
      "NEW-ROBOT reactor \"robot\" blue \"\" (plans_ways = false)\n"
      "UNIT <pair> ROBOT reactor\n"
      "COMMAND LIST:\n"
      "0. UNIT pair START 100 100 0 40\n"
      "1. UNIT pair MOVETO 700 100 FORMATION Line\n");
  run->post(mission::event::Execute{});
  testing::step(*run, 20);
  const Estimates estimates;
  const auto ways = [&](std::size_t robot) {
    RobotDetail out;
    encode_detail(*run, estimates, run->fleet().robots()[robot], {}, out);
    std::vector<float> numbers(out.ways().size() / sizeof(float));
    if (!numbers.empty()) std::memcpy(numbers.data(), out.ways().data(), numbers.size() * sizeof(float));
    return numbers;
  };
  const std::vector<float> planned = ways(0);
  ASSERT_GT(planned.size(), 8U);
  EXPECT_EQ(planned.size() % 2, 0U);
  EXPECT_EQ(std::ranges::count_if(planned, [](float number) { return std::isnan(number); }), 2)
      << "the unit's and its own";
  bool leads_to_goal = false;
  for (std::size_t i = 0; i < planned.size(); i += 2)
    leads_to_goal = leads_to_goal || (planned[i] == 700.0F && planned[i + 1] == 100.0F);
  EXPECT_TRUE(leads_to_goal);
  EXPECT_TRUE(ways(1).empty());
}

TEST_F(Ports, AreFoundByTheirPathsEachOnce) {
  const std::string first = program().ports().front().path;
  const std::string last = program().ports().back().path;
  const std::vector<std::string> paths = {last, "no such port", first, last};
  EXPECT_EQ(port_indices(program(), paths),
            (std::vector<std::uint32_t>{0, static_cast<std::uint32_t>(program().ports().size() - 1)}));
  EXPECT_EQ(detail({.ports = true, .some_ports = port_indices(program(), {})}).ports_size(), 0);
}

}  // namespace
}  // namespace mlab::console
