#include "mlab/console/published/frame_encoder.h"

#include <cstring>
#include <numbers>

#include <gtest/gtest.h>

#include "mlab/base/testing/count_allocations.h"
#include "mlab/base/testing/processor_time.h"
#include "mlab/console/testing/run_of.h"

namespace mlab::console {
namespace {

std::vector<RobotRows::Row> rows_of(const std::string& bytes) {
  std::vector<RobotRows::Row> out(bytes.size() / sizeof(RobotRows::Row));
  std::memcpy(out.data(), bytes.data(), out.size() * sizeof(RobotRows::Row));
  return out;
}

TEST(PackedHeading, AFullTurnIs65536) {
  EXPECT_EQ(packed_heading(0.0), 0);
  EXPECT_EQ(packed_heading(std::numbers::pi / 2), 16384);
  EXPECT_EQ(packed_heading(-std::numbers::pi / 2), 49152);
  EXPECT_EQ(packed_heading(4 * std::numbers::pi), 0);
  EXPECT_EQ(packed_heading(-1e-12), 0);
}

TEST(RobotRows, HoldTheStartedRobotsOfTheView) {
  const auto run = testing::run_of(testing::kTravel);
  run->post(mission::event::Execute{});
  testing::step(*run, 20);
  RobotRows rows;
  const std::vector<base::RobotId> teleoperated = {{2}};
  rows.gather(*run, {}, teleoperated);
  std::string bytes;
  EXPECT_EQ(rows.encode(std::nullopt, bytes), 0U);
  ASSERT_EQ(bytes.size(), 32U) << "two of four are started";
  const auto all = rows_of(bytes);
  EXPECT_EQ(all[0].id, 1U);
  EXPECT_EQ(all[0].flags & 7, 1) << "running";
  EXPECT_EQ(all[0].flags >> 5 & 1, 0);
  EXPECT_EQ(all[1].flags >> 5 & 1, 1) << "teleoperated";
  EXPECT_NEAR(all[1].y, run->fleet().pose(*run->fleet().find({2})).position.y, 1e-3);
  Box view;
  view.set_x_min(0);
  view.set_x_max(1000);
  view.set_y_min(all[0].y - 1);
  view.set_y_max(all[0].y + 1);
  EXPECT_EQ(rows.encode(view, bytes), 1U);
  ASSERT_EQ(rows_of(bytes).size(), 1U);
  EXPECT_EQ(rows_of(bytes)[0].id, 1U);
}

TEST(Frames, TellWhereRobotsWillStartAsTheyThenDo) {
  const std::string text =
      "MISSION-AREA 100 100\nUNIT <a> (ROBOT ROBOT)\nUNIT <b> (ROBOT ROBOT ROBOT)\nCOMMAND LIST:\n"
      "0. UNIT a START 10 20 5 0\n1. UNIT b START 12 20\n2. UNIT a MOVETO 50 50\n";
  const auto run = testing::run_of(text);
  const auto untouched = testing::run_of(text);
  std::string bytes;
  encode_starts(*run, bytes);
  const auto planned = rows_of(bytes);
  ASSERT_EQ(planned.size(), 5U);
  EXPECT_FLOAT_EQ(planned[1].x, 15.0F);
  EXPECT_EQ(planned[0].flags, 0);
  EXPECT_EQ(run->robots_in_world(), 0U) << "nothing was started by asking";
  run->post(mission::event::Execute{});
  testing::step(*run, 1);
  run->post(mission::event::Pause{});
  for (const auto& row : planned) {
    const fleet::FleetRobot& robot = *run->fleet().find({row.id});
    EXPECT_NEAR(row.x, robot.start.position.x, 1e-3);
    EXPECT_NEAR(row.y, robot.start.position.y, 1e-3);
  }
  bytes.clear();
  encode_starts(*run, bytes);
  EXPECT_TRUE(bytes.empty()) << "all have been started";
  // And the run is the same as one of which nobody asked.
  untouched->post(mission::event::Execute{});
  testing::step(*untouched, 1);
  run->post(mission::event::Resume{});
  testing::step(*run, 100);
  testing::step(*untouched, 100);
  for (std::uint32_t id = 1; id <= 5; ++id)
    EXPECT_EQ(run->fleet().pose(*run->fleet().find({id})),
              untouched->fleet().pose(*untouched->fleet().find({id})));
}

TEST(RobotRows, ThousandsOfRobotsCostNoHeapForEachOfThem) {
  constexpr int kRobots = base::kIsSlowBuild ? 200 : 10000;
  std::string text = "MISSION-AREA 2000 2000\nUNIT <all>";
  for (int i = 0; i < kRobots; ++i) text += " ROBOT";
  text += "\nCOMMAND LIST:\n0. UNIT all START 1 1000 0.19 0\n1. UNIT all MOVETO 1900 1000\n";
  const auto run = testing::run_of(text);
  run->post(mission::event::Execute{});
  testing::step(*run, 2);
  RobotRows rows;
  std::string bytes;
  rows.gather(*run, {}, {});
  rows.encode(std::nullopt, bytes);
  ASSERT_EQ(bytes.size(), 16U * kRobots);
  const std::size_t before = base::allocation_count();
  rows.gather(*run, {}, {});
  rows.encode(std::nullopt, bytes);
  EXPECT_LE(base::allocation_count() - before, 2U);
}

TEST(Frames, TellStationsAndWantedVelocities) {
  const auto run = testing::run_of(testing::kTravel);
  run->post(mission::event::Execute{});
  testing::step(*run, 20);
  std::string stations;
  encode_stations(*run, stations);
  EXPECT_EQ(stations.size(), 2 * 12U);
  std::string vectors;
  encode_vectors(*run, vectors);
  ASSERT_EQ(vectors.size(), 2 * 12U);
  float x = 0.0F;
  std::memcpy(&x, vectors.data() + 4, sizeof x);
  EXPECT_GT(x, 0.0F) << "they go to the east";
}

}  // namespace
}  // namespace mlab::console
