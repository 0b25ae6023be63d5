#include "mlab/history/testing/written_run.h"

#include <bit>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include <gtest/gtest.h>

#include "mlab/base/hash.h"
#include "mlab/base/testing/source_folder.h"
#include "mlab/cell/testing/permission.h"
#include "mlab/history/digest.h"
#include "mlab/lang/mdl/mdl.h"
#include "mlab/robot/program/configuration_file.h"
#include "mlab/simulated/run.h"
#include "mlab/simulated/testing/values.h"

namespace mlab::history::testing {
namespace {

robot::ProgramSources sources_of(const std::string& path) {
  return {cell::testing::code_permitted(), std::filesystem::path(path).parent_path().string(),
          base::source_folder() + "/src"};
}

mdl::LoadOptions options_of(const std::string& path) {
  mdl::LoadOptions out;
  out.seed = 5;
  out.societies = robot::society_reader(sources_of(path));
  return out;
}

std::shared_ptr<const run::Crew> crew_of(const std::shared_ptr<const mission::Mission>& mission,
                                         const std::string& path) {
  text::Diagnostics sink;
  auto out = mission ? run::make_crew(mission, sources_of(path), sink) : nullptr;
  EXPECT_NE(out, nullptr) << text::render(sink);
  return out;
}

}  // namespace

WrittenRun::WrittenRun(const std::string& file, std::uint64_t seed, bool proceeds, bool is_in_real_time,
                       std::unique_ptr<robot::ProgramRunner> elsewhere)
    : path_(base::source_folder() + "/missions/" + file), writer_([this](const wire::HistoryEntry& entry) {
        entries_.push_back(entry);
        const auto problem = history_->add(entry);
        EXPECT_FALSE(problem) << *problem;
      }) {
  text::Diagnostics sink;
  const auto crew = crew_of(mdl::load_mission(path_, sink, options_of(path_)), path_);
  if (!crew) throw std::runtime_error(text::render(sink));
  run::RunSettings settings;
  settings.seed = seed;
  settings.executive.proceed_all = proceeds;
  settings.is_in_real_time = is_in_real_time;
  if (elsewhere)
    settings.robots_elsewhere = [&elsewhere](std::uint64_t, double) { return std::move(elsewhere); };
  run_ = simulated::make_run(crew, settings);
  run_->set_observer([this](const mission::Effect& effect) { writer_.see(effect); });
  writer_.begin(*run_, {"test", {}, 5, 0.0});
  writer_.note_cycle();
}

bool WrittenRun::step() {
  if (run_->step() != run::MissionRun::Progress::kStepped) return false;
  writer_.note_cycle();
  values_.push_back(run_->is_in_real_time() ? all_outside_of_programs(*run_) : all_of(*run_));
  return true;
}

std::shared_ptr<const run::Crew> WrittenRun::edited(const std::string& from, const std::string& to) {
  std::string text(text::read_source(path_).value()->text());
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::runtime_error("nothing to edit");
  text.replace(at, from.size(), to);
  text::Diagnostics sink;
  const auto source = std::make_shared<const text::Source>(path_, text);
  const auto mission = mdl::check_mission(source, std::filesystem::path(path_).parent_path().string(), sink,
                                          options_of(path_));
  EXPECT_NE(mission, nullptr) << text::render(sink);
  return crew_of(mission, path_);
}

void WrittenRun::type(const std::string& line) {
  text::Diagnostics sink;
  const auto read = mdl::parse_immediate(line, run_->mission(), sink, options_of(path_));
  ASSERT_TRUE(read) << line << "\n" << text::render(sink);
  if (read->edited) {
    const auto crew = run::make_crew(read->edited, sources_of(path_), sink, run_->crew().get());
    ASSERT_NE(crew, nullptr) << text::render(sink);
    run_->edit(crew);
  }
  if (!read->commands.empty()) run_->post(mission::event::Typed{read->commands, line});
}

namespace {

// A number out of many.
class Sum {
 public:
  explicit Sum(std::uint64_t begin) : value_(begin) {}
  Sum& operator<<(double number) { return *this << std::bit_cast<std::uint64_t>(number); }
  Sum& operator<<(std::uint64_t number) {
    value_ = base::combine_bits(value_, number);
    return *this;
  }
  Sum& operator<<(const std::string& text) {
    value_ = base::hash_text(text, value_);
    return *this;
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_;
};

void add_robot(const run::MissionRun& run, const fleet::FleetRobot& robot, Sum& out) {
  const binding::BodyState body = run.world().body(robot.body);
  out << body.velocity.x << body.velocity.y << body.distance_driven << std::uint64_t{body.contacts}
      << std::uint64_t{body.in_contact} << std::uint64_t{body.carried.value};
  out << robot.joystick.x << robot.joystick.y << robot.joystick.magnitude;
  out << robot.action.velocity.x << robot.action.velocity.y << robot.action.status.remaining
      << std::uint64_t{robot.action.status.sequence} << std::uint64_t{robot.action.status.done};
  out << robot.fault << robot.failure << run.fleet().failsafe(robot);
  for (const std::uint64_t notification : robot.notifications) out << notification;
  if (const fleet::Group* const group = run.fleet().group(robot))
    out << group->center.x << group->center.y << group->formation_heading
        << std::uint64_t{group->order.sequence} << std::uint64_t{robot.rank};
  const percept::Percepts told =
      run.fleet().perceive_at(robot, run.fleet().pose(robot), {}, run.cycle_duration());
  for (const percept::SharedPlace& place : told.shared_places)
    out << std::uint64_t{place.from.value} << place.place.x << place.place.y << place.time;
  for (const percept::AskedPassage& passage : told.asked_passages)
    out << std::uint64_t{passage.from.value} << passage.to.x << passage.to.y << passage.cost << passage.time;
  for (const percept::Claim& claim : told.claims)
    out << std::uint64_t{claim.robot.value} << std::uint64_t{claim.object.value};
  for (const percept::Contract& contract : told.contracts)
    out << contract.task << std::uint64_t{contract.object.value} << contract.place.x << contract.place.y
        << static_cast<std::uint64_t>(contract.state) << std::uint64_t{contract.manager.value}
        << std::uint64_t{contract.contractor.value} << std::uint64_t{contract.reneged.value} << contract.time;
}

void add_program(const fleet::FleetRobot& robot, Sum& out) {
  const robot::Workings workings = robot.workings();
  if (!workings) return;
  simulated::testing::visit_values(robot, [&out](std::uint64_t word) { out << word; });
  if (workings.interventions == nullptr) return;
  for (const flow::Interventions::Held& held : workings.interventions->held())
    out << std::uint64_t{held.port};
}

void add_world(const run::MissionRun& run, Sum& out) {
  for (const binding::Object& object : run.world().objects())
    out << object.center.x << object.center.y << std::uint64_t{object.carrier.value}
        << std::uint64_t{object.basket.value};
  for (const binding::Disc& disc : run.world().discs()) out << disc.center.x << disc.center.y << disc.radius;
  for (const binding::MovingDisc& disc : run.world().moving_discs()) out << disc.center.x << disc.center.y;
}

void add_records(const run::MissionRun& run, Sum& out) {
  out << std::uint64_t{run.is_stopped()} << std::uint64_t{run.robots_stopped()} << run.robot_cycles();
  out << std::uint64_t{run.stands_still_for_operator()} << std::uint64_t{run.moment().has_looked};
  out << std::uint64_t{run.answers().size()} << std::uint64_t{run.interventions().size()};
  out << std::uint64_t{run.deliveries().size()} << std::uint64_t{run.failsafes().size()};
  for (const run::UnitMetrics& metrics : run.unit_metrics())
    out << metrics.error_sum << metrics.samples << metrics.driven << metrics.straight();
  const mission::State& state = run.state();
  out << std::uint64_t{state.paused} << std::uint64_t{state.questions.size()};
  for (const mission::RobotState& robot : state.robots)
    out << robot.pose.position.x << robot.remaining << robot.best << std::uint64_t{robot.done} << robot.seen;
  for (const mission::Run& each : state.runs) out << each.stalled << std::uint64_t{each.missing};
  for (const mission::CommandRecord& command : state.commands)
    out << command.text << std::uint64_t(command.outcome) << command.end;
}

}  // namespace

std::uint64_t all_outside_of_programs(const run::MissionRun& run) {
  Sum out(digest_of(run));
  for (const fleet::FleetRobot& robot : run.fleet().robots()) {
    if (robot.life != fleet::RobotLife::kNotStarted) add_robot(run, robot, out);
  }
  add_world(run, out);
  add_records(run, out);
  return out.value();
}

std::uint64_t all_of(const run::MissionRun& run) {
  Sum out(all_outside_of_programs(run));
  for (const fleet::FleetRobot& robot : run.fleet().robots()) {
    if (robot.life != fleet::RobotLife::kNotStarted) add_program(robot, out);
  }
  return out.value();
}

}  // namespace mlab::history::testing
