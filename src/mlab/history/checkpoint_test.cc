#include "mlab/run/checkpoint.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <numbers>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "mlab/base/testing/processor_time.h"
#include "mlab/base/testing/source_folder.h"
#include "mlab/history/testing/meddler.h"
#include "mlab/history/testing/written_run.h"
#include "mlab/robot/program/configuration_file.h"
#include "mlab/simulated/run.h"
#include "mlab/text/source.h"

namespace mlab::history {
namespace {

using testing::all_of;
using testing::Meddler;
using testing::WrittenRun;
namespace event = mission::event;

// A run to which things happen, which are noted, and moments of it that were saved.
class Script {
 public:
  explicit Script(WrittenRun& written) : run_(written.run()), crew_(run_.crew()) {
    run_.set_input_observer([this](const run::Moment&, const run::Input& input) { begin(input); });
    run_.set_observer([this](const mission::Effect& effect) {
      if (const auto* told = std::get_if<mission::effect::Tell>(&effect)) told_.push_back(told->text);
    });
  }
  ~Script() {
    run_.set_input_observer({});
    run_.set_observer({});
  }

  bool step() {
    begin({});
    return run_.step() == run::MissionRun::Progress::kStepped;
  }
  void save() {
    finish();
    const auto checkpoint = run_.save();
    ASSERT_TRUE(checkpoint) << checkpoint.error();
    saved_.push_back({*checkpoint, actions_.size()});
  }

  // Goes on from all that was saved, in any order, in the run itself and in another one of the same crew, and
  // always comes to the same.
  void check(std::size_t most_actions) {
    finish();
    run_.set_input_observer({});
    auto other = simulated::make_run(crew_, run_.settings());
    std::shuffle(saved_.begin(), saved_.end(), std::mt19937(1));
    for (std::size_t i = 0; i < saved_.size(); ++i) {
      SCOPED_TRACE("from action " + std::to_string(saved_[i].actions));
      check(i % 2 == 0 ? run_ : *other, saved_[i], most_actions);
      if (::testing::Test::HasFatalFailure()) return;
    }
    // What went on has changed none of them.
    for (const Saved& saved : saved_) {
      ASSERT_FALSE(run_.restore(saved.checkpoint));
      ASSERT_EQ(all_of(run_), after(saved.actions));
    }
  }

 private:
  struct Saved {
    run::Checkpoint checkpoint;
    std::size_t actions;
  };
  struct Action {
    std::optional<run::Input> input;  // nothing: a cycle
    std::uint64_t after = 0;          // how all stood then
    std::size_t told = 0;             // how much had been told
  };

  void begin(std::optional<run::Input> input) {
    finish();
    actions_.push_back({std::move(input)});
  }
  void finish() {
    if (actions_.empty()) {
      before_ = all_of(run_);
      return;
    }
    actions_.back().after = all_of(run_);
    actions_.back().told = told_.size();
  }
  std::uint64_t after(std::size_t actions) const {
    return actions == 0 ? before_ : actions_[actions - 1].after;
  }

  void check(run::MissionRun& run, const Saved& saved, std::size_t most) {
    std::vector<std::string> told;
    run.set_observer([&](const mission::Effect& effect) {
      if (const auto* one = std::get_if<mission::effect::Tell>(&effect)) told.push_back(one->text);
    });
    ASSERT_FALSE(run.restore(saved.checkpoint));
    ASSERT_EQ(all_of(run), after(saved.actions)) << "at once";
    const std::size_t told_before = saved.actions == 0 ? 0 : actions_[saved.actions - 1].told;
    for (std::size_t i = saved.actions; i < std::min(actions_.size(), saved.actions + most); ++i) {
      if (actions_[i].input)
        run.take(*actions_[i].input);
      else
        run.step();
      ASSERT_EQ(all_of(run), actions_[i].after) << "after action " << i << ", cycle " << run.cycle();
      ASSERT_EQ(told.size(), actions_[i].told - told_before) << "after action " << i;
      ASSERT_TRUE(std::equal(told.begin(), told.end(), told_.begin() + static_cast<long>(told_before)));
    }
    run.set_observer({});
  }

  run::MissionRun& run_;
  std::shared_ptr<const run::Crew> crew_;
  std::vector<Action> actions_;
  std::vector<std::string> told_;
  std::vector<Saved> saved_;
  std::uint64_t before_ = 0;
};

class OfMission : public ::testing::TestWithParam<std::string> {};

TEST_P(OfMission, GoesOnFromAnyMomentAsItDid) {
  WrittenRun written(GetParam() + "/" + GetParam() + ".mdl", 3, true);
  Script script(written);
  std::mt19937 random(7);
  script.save();
  written.run().post(event::Execute{});
  for (int cycle = 0; cycle < base::examples(2500) && script.step(); ++cycle) {
    if (random() % 200 == 0) script.save();
  }
  ASSERT_GT(written.run().cycle(), 300U);
  script.check(400);
}

std::vector<std::string> all_missions() {
  std::vector<std::string> out;
  for (const auto& entry : std::filesystem::directory_iterator(base::source_folder() + "/missions")) {
    if (entry.is_directory()) out.push_back(entry.path().filename().string());
  }
  std::ranges::sort(out);
  return out;
}

INSTANTIATE_TEST_SUITE_P(Checkpoint, OfMission, ::testing::ValuesIn(all_missions()),
                         [](const auto& test) { return test.param; });

TEST(Checkpoint, IsOfAnyMomentWhateverPeopleDo) {
  int stopped = 0;
  int paused = 0;
  int steered = 0;
  for (std::uint32_t seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    WrittenRun written("demo_c/demo_c.mdl", seed);
    const run::MissionRun& run = written.run();
    Script script(written);
    written.run().post(event::Execute{});
    Meddler meddler(written, seed);
    for (int i = 0; i < 100; ++i) {
      meddler.meddle();
      const int cycles = meddler.below(20);
      const int moment = meddler.below(40);
      for (int cycle = 0; cycle <= cycles; ++cycle) {
        if (cycle == moment) {
          script.save();
          stopped += run.is_stopped() ? 1 : 0;
          paused += run.state().paused ? 1 : 0;
          steered += run.fleet().find({3})->joystick.magnitude > 0.0 ? 1 : 0;
        }
        script.step();
      }
    }
    script.check(500);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(stopped, 0);
  EXPECT_GT(paused, 0);
  EXPECT_GT(steered, 0);
}

TEST(Checkpoint, IsOfAQuestionToo) {
  WrittenRun written("demo_c/demo_c.mdl", 2);
  run::MissionRun& run = written.run();
  Script script(written);
  run.post(event::Execute{});
  int asked = 0;
  for (int i = 0; i < 3000 && !run.is_over(); ++i) {
    if (script.step() || run.state().questions.empty()) continue;
    script.save();
    run.post(event::Answer{run.state().questions.front().id, true});
    script.save();
    ++asked;
  }
  ASSERT_GT(asked, 1);
  script.check(600);
}

TEST(Checkpoint, IsOfABrakingFleet) {
  WrittenRun written("patrol/patrol.mdl", 1, true);
  run::MissionRun& run = written.run();
  Script script(written);
  run.post(event::Execute{});
  for (int i = 0; i < 200; ++i) script.step();
  run.set_emergency_stop(true);
  script.save();
  while (script.step()) script.save();
  script.save();
  run.set_emergency_stop(false);
  script.save();
  for (int i = 0; i < 200; ++i) script.step();
  script.check(500);
}

TEST(Checkpoint, IsOfWhatPeopleMadeOfPrograms) {
  WrittenRun written("forage/forage.mdl", 3);
  run::MissionRun& run = written.run();
  Script script(written);
  run.post(event::Execute{});
  for (int i = 0; i < 100; ++i) script.step();
  const std::string sequence(run.fleet().find({2})->workings().program->sequence_name(0));
  const auto go_on = [&] {
    script.save();
    for (int i = 0; i < 30; ++i) script.step();
    script.save();
  };
  EXPECT_FALSE(run.force_state({2}, sequence, "Returning"));
  go_on();
  EXPECT_FALSE(run.hold_value({1}, "movement", "0.5, 0.5, 0"));
  go_on();
  EXPECT_FALSE(run.release_value({1}, ""));
  go_on();
  script.check(200);
}

TEST(Checkpoint, IsOfFailsafesThatAct) {
  WrittenRun written("demo_c/demo_c.mdl", 1, true);
  run::MissionRun& run = written.run();
  Script script(written);
  run.edit(written.edited("COMMAND LIST:", "FAILSAFE STUCK AFTER 1 RETURN\n\nCOMMAND LIST:"));
  run.post(event::Execute{});
  script.step();
  // They are to leave a place round which rocks stand now.
  for (int i = 0; i < 32; ++i) {
    const double angle = i * 2.0 * std::numbers::pi / 32.0;
    written.type(fmt::format("OBSTACLE {:.3f} {:.3f} 9", 140.0 + 75.0 * std::cos(angle),
                             170.0 + 75.0 * std::sin(angle)));
  }
  for (int i = 0; i < 600; ++i) {
    script.step();
    if (i % 37 == 0) script.save();
  }
  ASSERT_GT(run.failsafes().size(), 3U);
  script.check(200);
}

TEST(Checkpoint, IsOfParametersThatOutliveANewStart) {
  WrittenRun written("demo_c/demo_c.mdl", 1, true);
  run::MissionRun& run = written.run();
  Script script(written);
  run.post(event::Execute{});
  for (int i = 0; i < 20; ++i) script.step();
  script.save();
  EXPECT_FALSE(run.set_parameter({1}, "base_velocity", "3.5"));
  for (int i = 0; i < 20; ++i) {
    script.save();
    script.step();
  }
  run.post(event::Abort{});
  script.save();
  run.post(event::Jump{0});
  run.post(event::Execute{});
  for (int i = 0; i < 100; ++i) script.step();
  const robot::Workings workings = run.fleet().find({1})->workings();
  EXPECT_EQ(flow::Program::print(workings.frame, *workings.program->find("base_velocity")), "3.5");
  script.check(300);
}

TEST(Checkpoint, IsOfBodiesThatTouchSomething) {
  WrittenRun written("forage/forage.mdl", 1, true);
  run::MissionRun& run = written.run();
  Script script(written);
  run.post(event::Execute{});
  for (int i = 0; i < 20; ++i) script.step();
  // It drives into a rock, and slides along it.
  EXPECT_FALSE(run.hold_value({1}, "movement", "1, 0, 0"));
  const geom::Pose pose = run.fleet().pose(*run.fleet().find({1}));
  written.type(fmt::format("OBSTACLE {:.2f} {:.2f} 2", pose.position.x + 4.0 * std::cos(pose.heading + 0.2),
                           pose.position.y + 4.0 * std::sin(pose.heading + 0.2)));
  for (int i = 0; i < 150; ++i) {
    script.step();
    if (i % 4 == 0) script.save();
  }
  ASSERT_GT(run.world().body(run.fleet().find({1})->body).contacts, 0U);
  script.check(60);
}

TEST(Checkpoint, IsOfProceduresInACell) {
  WrittenRun written("../examples/14_behavior/pond.mdl", 3, true);
  run::MissionRun& run = written.run();
  ASSERT_NE(run.fleet().robots().front().program->hosted, nullptr);
  Script script(written);
  run.post(event::Execute{});
  script.save();
  for (int i = 0; i < 300; ++i) {
    if (i == 150) {
      EXPECT_FALSE(run.set_parameter({1}, "distance", "9"));
    }
    script.step();
    if (i % 60 == 7) script.save();
  }
  script.check(120);
}

// After two seconds of robots that tell each other a place as they start, two of which stand side by side.
std::size_t bytes_of_tellers(double radio_range) {
  WrittenRun written("out_of_reach/out_of_reach.mdl");
  run::Crew crew = *written.run().crew();
  const auto source = std::make_shared<const text::Source>(
      "teller.cdl", "robot Teller is Scout { movement = SharePlace(place = [12, 5]); }\n");
  text::Diagnostics sink;
  const auto made = robot::configure(source, "", "", {}, {}, sink);
  EXPECT_TRUE(made && !sink.has_errors()) << text::render(sink);
  for (robot::RobotProgram& program : crew.programs) {
    program.program = made->built.program;
    program.initial = program.program->make_frame();
  }
  for (binding::BodySpec& body : crew.bodies) body.radio.range = radio_range;
  const auto run = simulated::make_run(std::make_shared<const run::Crew>(std::move(crew)), {});
  run->post(event::Execute{});
  for (int i = 0; i < 20; ++i) run->step();
  std::size_t heard = 0;
  for (const fleet::FleetRobot& robot : run->fleet().robots()) heard += robot.places.size();
  EXPECT_EQ(heard, radio_range > 1.0 ? 5U : 3U) << "each hears itself";
  const auto checkpoint = run->save();
  EXPECT_TRUE(checkpoint) << checkpoint.error();
  return checkpoint->bytes();
}

TEST(Checkpoint, CountsPlacesThatRobotsHaveHeard) {
  EXPECT_EQ(bytes_of_tellers(8.0) - bytes_of_tellers(0.1), 2 * sizeof(percept::SharedPlace));
}

TEST(Checkpoint, IsNotForARunOfAnotherSeed) {
  WrittenRun one("demo_c/demo_c.mdl", 1);
  WrittenRun other("demo_c/demo_c.mdl", 2);
  const auto checkpoint = one.run().save();
  ASSERT_TRUE(checkpoint) << checkpoint.error();
  EXPECT_EQ(other.run().restore(*checkpoint), "it is of a run with another seed");
}

TEST(Checkpoint, KeepsAliveWhatItsRobotsAreMadeOf) {
  std::optional<run::Checkpoint> checkpoint;
  std::uint64_t then = 0;
  WrittenRun written("demo_c/demo_c.mdl", 1, true);
  run::MissionRun& run = written.run();
  run.post(event::Execute{});
  for (int i = 0; i < 100; ++i) written.step();
  checkpoint.emplace(*run.save());
  then = all_of(run);
  std::weak_ptr<const run::Crew> crew = run.crew();
  ASSERT_TRUE(run.take_over(written.edited("FORMATION Wedge", "FORMATION Line")));
  for (int i = 0; i < 100; ++i) written.step();
  ASSERT_FALSE(run.restore(*checkpoint));
  EXPECT_EQ(all_of(run), then);
  EXPECT_EQ(run.crew(), crew.lock());
}

}  // namespace
}  // namespace mlab::history
