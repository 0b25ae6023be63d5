#include "mlab/console/past/past_run.h"

#include <cstring>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/base/testing/source_folder.h"
#include "mlab/cell/testing/permission.h"
#include "mlab/console/past/condition.h"
#include "mlab/console/published/status_encoder.h"
#include "mlab/console/published/watched.h"
#include "mlab/console/run/measure_series.h"
#include "mlab/history/testing/meddler.h"
#include "mlab/history/testing/written_run.h"

namespace mlab::console {
namespace {

using history::testing::Meddler;
using history::testing::WrittenRun;
namespace event = mission::event;

history::ReplayTools tools() {
  return {cell::testing::code_permitted(), base::source_folder() + "/src"};
}

std::unique_ptr<PastRun> past_of(const WrittenRun& written) {
  auto history = std::make_shared<history::History>();
  for (const wire::HistoryEntry& entry : written.entries()) EXPECT_FALSE(history->add(entry));
  text::Diagnostics sink;
  auto out = PastRun::make(std::move(history), tools(), {}, sink);
  EXPECT_NE(out, nullptr) << text::render(sink);
  return out;
}

Watch everything() {
  Watch out;
  for (const std::uint32_t robot : {1U, 2U, 3U, 4U}) out.add_details(robot);
  out.set_with_ports(true);
  out.set_with_readings(true);
  out.set_with_stations(true);
  out.set_with_vectors(true);
  return out;
}

// What a browser would have been told of the run in each of its cycles, by cycle; nothing for cycle 0.
class Witness {
 public:
  explicit Witness(WrittenRun& written) : written_(written) {
    transitions_.watch(std::vector<std::uint32_t>{1, 2, 3, 4});
  }
  void look() {
    const run::MissionRun& run = written_.run();
    transitions_.change(run);
    transitions_.look(run);
    Frame frame;
    frame.set_time(run.time());
    RobotRows rows;
    rows.gather(run, {}, {});
    rows.encode(std::nullopt, *frame.mutable_robots());
    encode_watched(run, watch_, frame);
    for (const std::uint32_t id : watch_.details()) {
      RobotDetail& told = *frame.add_details();
      encode_watched(run, *run.fleet().find({id}), watch_, Estimates(), transitions_, told);
      told.clear_transitions();
    }
    frames_.push_back(frame.SerializeAsString());
    Status status;
    encode_run(run, Estimates(), status);
    statuses_.push_back(status.SerializeAsString());
  }
  const std::string& frame(std::uint64_t cycle) const { return frames_[cycle - 1]; }
  const std::string& status(std::uint64_t cycle) const { return statuses_[cycle - 1]; }

 private:
  WrittenRun& written_;
  const Watch watch_ = everything();
  TransitionRecorder transitions_;
  std::vector<std::string> frames_;
  std::vector<std::string> statuses_;
};

const ToBrowser* find_message(const PastPicture& picture, ToBrowser::BodyCase body) {
  for (const ToBrowser& message : picture.messages) {
    if (message.body_case() == body) return &message;
  }
  return nullptr;
}

TEST(PastRun, ShowsEachMomentAsItWasSeenThen) {
  WrittenRun written("demo_c/demo_c.mdl", 2);
  written.run().post(event::Execute{});
  Meddler meddler(written, 7);
  Witness witness(written);
  // An input changes how the run stands before its next cycle; a moment is as the cycle before left it.
  for (int i = 0; i < 120; ++i) {
    meddler.meddle();
    for (int cycles = meddler.below(25); cycles > 0; --cycles) {
      if (written.step()) witness.look();
    }
  }
  const auto cycles = static_cast<int>(written.history()->last_cycle());
  ASSERT_GT(cycles, 200);
  const auto past = past_of(written);
  PastTold told;
  for (int i = 0; i < 40; ++i) {
    PastWish wish;
    wish.cycle = 1 + static_cast<std::uint64_t>(meddler.below(cycles));
    wish.watch = everything();
    wish.told = i % 2 == 0 ? PastTold() : told;
    const PastPicture picture = past->picture(wish);
    ASSERT_EQ(picture.problem, "");
    ASSERT_EQ(picture.cycle, wish.cycle);
    Frame frame = picture.frame;
    for (RobotDetail& detail : *frame.mutable_details()) {
      detail.clear_waits_for();
      detail.clear_transitions();
    }
    ASSERT_EQ(frame.SerializeAsString(), witness.frame(wish.cycle)) << "cycle " << wish.cycle;
    if (i % 2 == 0) {
      const ToBrowser* const status = find_message(picture, ToBrowser::kStatus);
      ASSERT_NE(status, nullptr);
      Status known = status->status();
      known.clear_options();
      known.clear_zoom_percent();
      ASSERT_EQ(known.SerializeAsString(), witness.status(wish.cycle)) << "cycle " << wish.cycle;
      for (const auto body : {ToBrowser::kScene, ToBrowser::kRoster, ToBrowser::kPlan, ToBrowser::kStarts})
        ASSERT_NE(find_message(picture, body), nullptr) << body;
    }
    told = picture.told;
  }
}

TEST(PastRun, TellsWhatIsKnownNotAgain) {
  WrittenRun written("demo_c/demo_c.mdl");
  written.run().post(event::Execute{});
  for (int i = 0; i < 100; ++i) written.step();
  const auto past = past_of(written);
  PastWish wish;
  wish.cycle = 90;
  PastPicture picture = past->picture(wish);
  EXPECT_NE(find_message(picture, ToBrowser::kRoster), nullptr);
  wish.told = picture.told;
  picture = past->picture(wish);
  EXPECT_TRUE(picture.messages.empty()) << picture.messages.front().DebugString();
  wish.with_trails = true;
  picture = past->picture(wish);
  ASSERT_EQ(picture.messages.size(), 1U);
  const Trails& trails = picture.messages.front().trails();
  ASSERT_GT(trails.trails_size(), 0);
  for (const Trails::Trail& trail : trails.trails()) {
    for (std::size_t at = 8; at < trail.points().size(); at += 12) {
      float time = 0.0F;
      std::memcpy(&time, trail.points().data() + at, sizeof time);
      EXPECT_LE(time, static_cast<float>(picture.time));
    }
  }
}

TEST(PastRun, FindsTheLastCycleThatWasOverByATime) {
  WrittenRun written("demo_c/demo_c.mdl");
  written.run().post(event::Execute{});
  for (int i = 0; i < 100; ++i) written.step();
  const auto past = past_of(written);
  const auto cycle_at = [&](double time) {
    PastWish wish;
    wish.time = time;
    return past->picture(wish).cycle;
  };
  EXPECT_EQ(cycle_at(0.0), 0U);
  EXPECT_EQ(cycle_at(0.0999), 0U);
  EXPECT_EQ(cycle_at(5.0 + 1e-9), 50U);
  for (std::uint64_t cycle = 0; cycle <= 100; ++cycle)
    EXPECT_EQ(cycle_at(static_cast<double>(cycle) / 10.0), cycle) << "as a person types its time";
  EXPECT_EQ(cycle_at(1e9), 100U);
  EXPECT_EQ(cycle_at(-3.0), 0U);
}

// What nobody watched when the run went on.
TEST(PastRun, ReadsQuantitiesAndStatesOfTheWholeRun) {
  WrittenRun written("forage/forage.mdl", 3, true);
  written.run().post(event::Execute{});
  Series speed;
  speed.set_id(5);
  speed.set_quantity(Series::SPEED);
  speed.set_robot(1);
  std::vector<double> expected;
  std::vector<std::string> states;  // of the first sequence of robot 1, as they change
  for (int i = 0; i < 800 && written.step(); ++i) {
    if (const auto value = measure(written.run(), speed)) {
      expected.push_back(written.run().time());
      expected.push_back(*value);
    }
    const fleet::FleetRobot& robot = *written.run().fleet().find({1});
    std::string state;
    if (robot.life == fleet::RobotLife::kRunning) {
      std::vector<flow::Program::SequenceState> now;
      const flow::Program& program = *robot.workings().program;
      program.sequence_states(robot.workings().frame, now);
      if (now.at(0).cycle == flow::Program::cycle(robot.workings().frame))
        state = program.state_names(0)[now[0].active];
    }
    if (state != (states.empty() ? "" : states.back())) states.push_back(state);
  }
  const auto past = past_of(written);
  ReadPast asked;
  *asked.add_series() = speed;
  Series never = speed;
  never.set_id(6);
  never.set_robot(77);
  *asked.add_series() = never;
  asked.add_states_of(1);
  Past out;
  for (int i = 0; i < 100 && out.known_to() < past->history().last_time(); ++i) {
    out.Clear();
    EXPECT_EQ(past->read(asked, out).value_or(""), "");
  }
  ASSERT_EQ(out.samples_size(), 2);
  EXPECT_EQ(out.samples(0).id(), 5U);
  ASSERT_EQ(out.samples(0).samples().size(), expected.size() * sizeof(double));
  EXPECT_EQ(std::memcmp(out.samples(0).samples().data(), expected.data(), expected.size() * sizeof(double)),
            0);
  EXPECT_EQ(out.samples(1).error(), "there is no robot 77");
  ASSERT_EQ(out.states_size(), 1);
  ASSERT_GT(out.states(0).sequences_size(), 0);
  std::vector<std::string> told;
  for (const auto& span : out.states(0).sequences(0).spans()) told.push_back(span.state());
  EXPECT_EQ(told, states);
  EXPECT_GT(states.size(), 1U);
  for (int i = 0; i < 64; ++i) asked.add_states_of(1);
  Past nothing;
  EXPECT_EQ(past->read(asked, nothing).value_or(""),
            "2 quantities and states of 65 robots are asked for: at most 64 of each");
}

TEST(PastRun, FindsMomentsAheadAndBack) {
  WrittenRun written("demo_c/demo_c.mdl", 1, true);
  written.run().post(event::Execute{});
  auto condition = Condition::parse("any robot speed > 1.2");
  ASSERT_TRUE(condition);
  std::vector<std::uint64_t> expected;
  condition->look(written.run());
  for (int i = 0; i < 1600 && written.step(); ++i) {
    if (condition->look(written.run())) expected.push_back(written.run().cycle());
  }
  ASSERT_GT(expected.size(), 2U);
  const auto past = past_of(written);
  const auto all = [&](bool backwards, std::uint32_t most) {
    std::vector<std::uint64_t> out;
    FindMoments asked;
    asked.set_condition("any robot speed > 1.2");
    asked.set_backwards(backwards);
    asked.set_most(most);
    asked.set_from(backwards ? past->history().last_time() + 1.0 : 0.0);
    for (int i = 0; i < 1000; ++i) {
      Found found;
      EXPECT_EQ(past->find(asked, found).value_or(""), "");
      for (const Found::One& one : found.moments()) out.push_back(one.cycle());
      if (found.is_all()) break;
      asked.set_from(found.searched_to());
    }
    return out;
  };
  EXPECT_EQ(all(false, 0), expected);
  EXPECT_EQ(all(false, 1), expected);
  // The very last cycle is not before the end.
  if (expected.back() == written.run().cycle()) expected.pop_back();
  const std::vector<std::uint64_t> reversed(expected.rbegin(), expected.rend());
  EXPECT_EQ(all(true, 0), reversed);
  EXPECT_EQ(all(true, 1), reversed);
  FindMoments wrong;
  wrong.set_condition("robot 99 in contact");
  Found nothing;
  EXPECT_EQ(past->find(wrong, nothing).value_or(""), "there is no robot 99");
}

}  // namespace
}  // namespace mlab::console
