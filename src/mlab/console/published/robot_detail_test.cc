#include "mlab/console/published/robot_detail.h"

#include <cmath>
#include <cstring>

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
