// The robots of the benchmark, which live by range sensors alone.

#include <cmath>
#include <cstring>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "../testing/network.h"

#include "mlab/base/testing/source_folder.h"

namespace mlab::library_test {
namespace {

std::shared_ptr<const flow::Program> robot(const std::string& name) {
  const std::ifstream file(base::source_folder() + "/bench/" + name);
  std::stringstream text;
  text << file.rdbuf();
  return program_of(name, text.str());
}

// 24 beams of 1 m range, the first 7.5 degrees left of ahead; those with an index below `hits` hit something
// half way.
std::vector<percept::RangeReading> ring(int hits) {
  std::vector<percept::RangeReading> out;
  for (int i = 0; i < 24; ++i)
    out.push_back({(static_cast<float>(i) + 0.5F) * 0.2617994F, i < hits ? 0.5F : 1.0F, i < hits});
  return out;
}

percept::Action act(const flow::Program& program, const std::vector<percept::RangeReading>& beams) {
  flow::Frame frame = program.make_frame();
  percept::Percepts percepts;
  percepts.ranges = beams;
  percepts.range_limit = 1.0;
  percept::Action action;
  program.step(frame.data(), percepts, action, 1, 1);
  EXPECT_TRUE(program.needs(frame.data()).has(percept::Sensor::kRanges));
  return action;
}

TEST(DiffusionRobot, GoesStraightOnAndTurnsAwayFromTheLeft) {
  const auto program = robot("diffusion.cnl");
  ASSERT_NE(program, nullptr);
  EXPECT_DOUBLE_EQ(act(*program, ring(0)).velocity.x, 0.2);
  const percept::Action action = act(*program, ring(4));
  EXPECT_DOUBLE_EQ(action.velocity.x, 0.1);
  EXPECT_DOUBLE_EQ(action.spin, -1.4286);
}

// What the schemas robot wants in its first cycle: the same noise and the same place whatever the beams say.
geom::Vector wanted(const flow::Program& program, const std::vector<percept::RangeReading>& beams) {
  flow::Frame frame = program.make_frame();
  percept::Percepts percepts;
  percepts.ranges = beams;
  percepts.range_limit = 1.0;
  percept::Action action;
  program.step(frame.data(), percepts, action, 1, 1);
  EXPECT_TRUE(action.drives && action.spins);
  const flow::Port* motion = program.find("motion");
  EXPECT_NE(motion, nullptr);
  geom::Vector out;
  if (motion != nullptr) std::memcpy(&out, frame.data() + motion->offset, sizeof out);
  return out;
}

TEST(SchemasRobot, IsPushedAwayFromWhatItsSensorsSee) {
  const auto program = robot("schemas.cnl");
  ASSERT_NE(program, nullptr);
  // One of 24 beams, half way, axis 7.5 degrees left of ahead, gain 8.
  const geom::Vector push = wanted(*program, ring(1)) - wanted(*program, ring(0));
  EXPECT_NEAR(push.x, -8.0 * 0.5 / 24.0 * std::cos(0.1308997), 1e-6);
  EXPECT_NEAR(push.y, -8.0 * 0.5 / 24.0 * std::sin(0.1308997), 1e-6);
}

}  // namespace
}  // namespace mlab::library_test
