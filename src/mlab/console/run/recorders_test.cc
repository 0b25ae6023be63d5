#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include "mlab/base/testing/source_folder.h"
#include "mlab/console/run/live_run.h"
#include "mlab/console/run/measure_series.h"
#include "mlab/console/run/series_recorder.h"
#include "mlab/console/run/trail_recorder.h"
#include "mlab/console/testing/run_of.h"

namespace mlab::console {
namespace {

Series series_of(Series::Quantity quantity, std::uint32_t robot, const std::string& unit = "",
                 const std::string& port = "") {
  Series out;
  out.set_quantity(quantity);
  out.set_robot(robot);
  out.set_unit(unit);
  out.set_port(port);
  return out;
}

std::vector<SeriesRecorder::Sample> samples_of(const std::string& bytes) {
  std::vector<SeriesRecorder::Sample> out(bytes.size() / sizeof(SeriesRecorder::Sample));
  std::memcpy(out.data(), bytes.data(), out.size() * sizeof(SeriesRecorder::Sample));
  return out;
}

TEST(Measure, TellsEveryQuantityOfRobotsAndUnits) {
  const auto run = testing::run_of(testing::kTravel);
  EXPECT_FALSE(measure(*run, series_of(Series::SPEED, 1)).has_value()) << "not started";
  run->post(mission::event::Execute{});
  testing::step(*run, 50);
  EXPECT_GT(measure(*run, series_of(Series::SPEED, 1)).value_or(0), 1.0);
  EXPECT_GT(measure(*run, series_of(Series::DISTANCE_DRIVEN, 1)).value_or(0), 1.0);
  EXPECT_NEAR(measure(*run, series_of(Series::DISTANCE_TO_GOAL, 0, "pair")).value_or(0), 590.0, 40.0);
  EXPECT_TRUE(measure(*run, series_of(Series::FORMATION_ERROR, 0, "pair")).has_value());
  EXPECT_EQ(measure(*run, series_of(Series::CONTACTS, 0, "pair")), 0.0);
  EXPECT_FALSE(measure(*run, series_of(Series::NEAREST_OBSTACLE, 1)).has_value()) << "there is none";
  EXPECT_TRUE(measure(*run, series_of(Series::HEADING, 1)).has_value());
  EXPECT_EQ(measure(*run, series_of(Series::PORT, 1, "", "base_velocity")), 5.0);
}

TEST(Measure, SaysWhyThereIsNothing) {
  const auto run = testing::run_of(testing::kTravel);
  EXPECT_EQ(problem_of(*run, series_of(Series::SPEED, 1)), "");
  EXPECT_NE(problem_of(*run, series_of(Series::SPEED, 77)), "");
  EXPECT_NE(problem_of(*run, series_of(Series::SPEED, 0, "nobody")), "");
  EXPECT_NE(problem_of(*run, series_of(Series::PORT, 1, "", "nothing")), "");
}

TEST(SeriesRecorder, RecordsWhatIsWatchedAndAMinuteLonger) {
  const auto run = testing::run_of(testing::kTravel);
  run->post(mission::event::Execute{});
  SeriesRecorder recorder;
  const Series speed = series_of(Series::SPEED, 1);
  recorder.watch({speed}, 0.0);
  for (int i = 0; i < 30; ++i) {
    run->step();
    recorder.look(*run);
  }
  std::string bytes;
  recorder.encode_since(speed, -1.0, bytes);
  const auto all = samples_of(bytes);
  ASSERT_EQ(all.size(), 30U);
  bytes.clear();
  recorder.encode_since(speed, all[19].time, bytes);
  EXPECT_EQ(samples_of(bytes).size(), 10U);
  recorder.watch({}, 10.0);
  EXPECT_TRUE(recorder.is_recorded(speed));
  recorder.watch({}, 69.0);
  EXPECT_TRUE(recorder.is_recorded(speed));
  recorder.watch({}, 71.0);
  EXPECT_FALSE(recorder.is_recorded(speed));
}

TEST(SeriesRecorder, ThinsOutWhatBecomesTooLong) {
  const auto run = testing::run_of(testing::kTravel);
  run->post(mission::event::Execute{});
  testing::step(*run, 5);
  SeriesRecorder recorder;
  const Series speed = series_of(Series::SPEED, 1);
  recorder.watch({speed}, 0.0);
  for (std::size_t i = 0; i < 3 * SeriesRecorder::kMost; ++i) recorder.look(*run);
  std::string bytes;
  recorder.encode_since(speed, -1.0, bytes);
  EXPECT_LT(samples_of(bytes).size(), SeriesRecorder::kMost);
  EXPECT_GT(samples_of(bytes).size(), SeriesRecorder::kMost / 4);
}

TEST(TrailRecorder, KeepsWhereRobotsHaveBeen) {
  const auto run = testing::run_of(testing::kTravel);
  run->post(mission::event::Execute{});
  TrailRecorder recorder;
  for (int i = 0; i < 300; ++i) {
    run->step();
    recorder.look(*run);
  }
  Trails trails;
  recorder.encode(trails);
  ASSERT_EQ(trails.trails_size(), 2) << "two of four were started";
  const std::string& bytes = trails.trails(0).points();
  ASSERT_EQ(bytes.size() % 12, 0U);
  const std::size_t count = bytes.size() / 12;
  EXPECT_GT(count, 20U);
  std::vector<float> values(bytes.size() / 4);
  std::memcpy(values.data(), bytes.data(), bytes.size());
  for (std::size_t i = 1; i < count; ++i) {
    EXPECT_GE(std::hypot(values[3 * i] - values[3 * i - 3], values[3 * i + 1] - values[3 * i - 2]), 0.49F);
    EXPECT_GT(values[3 * i + 2], values[3 * i - 1]) << "time goes on";
  }
}

TEST(TransitionRecorder, KnowsNothingOfAProgramThatIsGone) {
  text::Diagnostics sink;
  const std::string folder = base::source_folder() + "/missions/herd";
  const auto mission = mdl::load_mission(folder + "/herd.mdl", sink);
  ASSERT_NE(mission, nullptr) << text::render(sink);
  const auto crew = [&] { return run::make_crew(mission, {{}, folder}, sink); };
  std::shared_ptr<const run::Crew> first = crew();
  ASSERT_NE(first, nullptr) << text::render(sink);
  auto run = simulated::make_run(first, {});
  EventLog log;
  LiveRun live(std::exchange(first, nullptr), std::move(run), log);
  live.notes().transitions().watch(std::vector<std::uint32_t>{1});
  live.run().post(mission::event::Execute{});
  const auto told = [&] {
    RobotDetail out;
    live.notes().transitions().encode(1, out);
    return out.transitions_size();
  };
  for (int i = 0; i < 5000 && told() == 0; ++i) live.step();
  ASSERT_GT(told(), 0) << "no wolf came near";
  ASSERT_TRUE(live.take_over(crew()));
  EXPECT_EQ(told(), 0);
  EXPECT_TRUE(live.notes().transitions().before(1).empty());
  // From then on it is looked at again.
  live.step();
  EXPECT_FALSE(live.notes().transitions().before(1).empty());
}

}  // namespace
}  // namespace mlab::console
