#include "mlab/run/mission_run.h"

#include <algorithm>
#include <tuple>
#include <utility>
#include <variant>

#include <fmt/core.h>

#include "mlab/mission/command.h"
#include "mlab/mission/wording.h"
#include "mlab/run/places.h"

namespace mlab::run {

using mission::effect::Tell;

namespace {

constexpr std::size_t kMostMoved = 8;  // robots that are named, each with what happened to it

// The operator's yes to a robot that asked by itself, under the name that it has always had.
constexpr const char* kMayProceed = "CONSOLE->ROBOT PROCEED MISSION";

}  // namespace

MissionRun::MissionRun(std::shared_ptr<const Crew> crew, RunSettings settings,
                       std::unique_ptr<binding::Binding> binding)
    : settings_(std::move(settings)), binding_(std::move(binding)) {
  now_.executive = mission::initial_state(crew->mission, settings_.executive);
  now_.stands_still_for_operator = settings_.stands_still_for_operator;
  const mission::Mission& plan = *now_.executive.mission;
  now_.dt = plan.options.cycle_duration.value_or(now_.dt);
  now_.metrics.resize(plan.units.size());
  const auto cycle = [this] { return now_.cycle; };
  const auto recorded = [&] { return settings_.recorded.runner(cycle); };
  std::unique_ptr<robot::ProgramRunner> elsewhere;
  if (settings_.robots_elsewhere) elsewhere = settings_.robots_elsewhere(settings_.seed, now_.dt);
  if (settings_.recorded.runner && settings_.recorded.is_of_all) elsewhere = recorded();
  fleet_ =
      std::make_unique<fleet::Fleet>(plan, crew->programs, crew->bodies, *binding_, settings_.seed,
                                     std::move(elsewhere), settings_.recorded.runner ? recorded() : nullptr);
  if (settings_.recorded.failures) fleet_->set_known_failures(settings_.recorded.failures(cycle));
  now_.crews.push_back(std::move(crew));
}

void MissionRun::post(const mission::Event& event) {
  hear_bodies();
  note(input::Posted{event});
  carry_out(event);
}

void MissionRun::carry_out(const mission::Event& event) {
  if (const auto* answer = std::get_if<mission::event::Answer>(&event))
    now_.answers.push_back({now_.cycle, answer->question, answer->proceed});
  const std::vector<mission::Effect> effects = mission::advance_in_place(now_.executive, event);
  now_.moved_at_start = 0;
  for (const mission::Effect& effect : effects) apply(effect);
  if (now_.moved_at_start > kMostMoved) {
    tell(Tell::Kind::kWarning,
         fmt::format("{} more robots start at the nearest free place, since theirs is taken",
                     now_.moved_at_start - kMostMoved));
  }
}

void MissionRun::apply(const mission::Effect& effect) {
  if (const auto* start = std::get_if<mission::effect::Start>(&effect)) start_robot(*start);
  if (const auto* order = std::get_if<mission::effect::Order>(&effect)) fleet_->order(*order);
  if (const auto* stop = std::get_if<mission::effect::Stop>(&effect)) fleet_->stop(stop->robot);
  if (const auto* answered = std::get_if<mission::effect::LetProceed>(&effect))
    fleet_->notify(answered->robot, kMayProceed);
  if (const auto* set = std::get_if<mission::effect::Set>(&effect)) {
    const auto* number = std::get_if<mission::SetNumber>(&set->option);
    if (number != nullptr && number->option == mission::NumberOption::kCycleDuration) {
      now_.start_of_duration = time();
      now_.first_of_duration = now_.cycle;
      now_.dt = number->value;
    }
  }
  if (observer_) observer_(effect);
  const auto* told = std::get_if<Tell>(&effect);
  if (told != nullptr && told->kind == Tell::Kind::kCommandEnded) explain_failures(told->command);
}

void MissionRun::start_robot(const mission::effect::Start& start) {
  const std::expected<binding::Placement, std::string> placement = fleet_->start(start.robot, start.pose);
  if (!placement) {
    tell(Tell::Kind::kWarning, fmt::format("robot {} {}", start.robot.value, placement.error()));
  } else if (placement->moved && ++now_.moved_at_start <= kMostMoved) {
    const geom::Point to = placement->pose.position;
    const robot::RobotProgram& program = *fleet_->find(start.robot)->program;
    const std::string why = program.is_of_vehicle
                                ? fmt::format("its vehicle `{}` is there, and not at", program.host)
                                : std::string("its place");
    tell(Tell::Kind::kWarning, fmt::format("robot {} starts at ({:.2f}, {:.2f}): {} ({:.2f}, {:.2f}){}",
                                           start.robot.value, to.x, to.y, why, start.pose.position.x,
                                           start.pose.position.y, program.is_of_vehicle ? "" : " is taken"));
  }
}

std::vector<PlannedStart> MissionRun::planned_starts() const {
  std::vector<PlannedStart> starts;
  std::vector<binding::BodySetup> setups;
  std::vector<bool> is_planned(fleet_->robots().size());
  const auto plan = [&](const mission::UnitCommand& command) {
    std::size_t rank = 0;
    for (const base::RobotId id : mission::members_of(mission(), command)) {
      const fleet::FleetRobot* robot = fleet_->find(id);
      if (robot == nullptr) continue;
      const geom::Pose wanted = mission::start_pose(mission(), command, rank++);
      const auto place = static_cast<std::size_t>(robot - fleet_->robots().data());
      if (robot->life != fleet::RobotLife::kNotStarted || is_planned[place]) continue;
      is_planned[place] = true;
      setups.push_back({robot->body_spec, wanted, id, 0, robot->seen_as, robot->program->vehicle()});
    }
  };
  for (const mission::Step& step : mission().steps) {
    for (const mission::Command& one : step.commands) {
      const auto* command = std::get_if<mission::UnitCommand>(&one);
      if (command != nullptr && command->task == mission::Task::kStart) plan(*command);
    }
  }
  const std::vector<std::optional<geom::Pose>> places = binding_->places_for(setups);
  for (std::size_t i = 0; i < setups.size(); ++i) {
    if (places[i]) starts.push_back({setups[i].robot, *places[i]});
  }
  return starts;
}

void MissionRun::tell(Tell::Kind kind, std::string text) {
  Tell told;
  told.kind = kind;
  told.text = std::move(text);
  if (observer_) observer_(told);
}

bool MissionRun::is_over() const {
  return now_.executive.mode == mission::State::Mode::kQuit ||
         (now_.executive.mode == mission::State::Mode::kIdle &&
          now_.executive.outcome != mission::Outcome::kPending);
}

std::size_t MissionRun::steps_done() const {
  const std::size_t all = now_.executive.mission->steps.size();
  if (now_.executive.mode == mission::State::Mode::kRunning) return now_.executive.step;
  if (now_.executive.outcome == mission::Outcome::kDone) return all;
  std::vector<bool> is_done(all);
  for (const mission::StepRecord& step : now_.executive.steps) {
    if (step.step < all) is_done[step.step] = step.outcome == mission::Outcome::kDone;
  }
  return static_cast<std::size_t>(std::ranges::count(is_done, true));
}

void MissionRun::look() {
  if (now_.cycle != 0 && now_.executive.paused) return;
  // Robots on other machines may be lost while no time passes; all others stand as they stood.
  if (now_.has_looked && !settings_.robots_elsewhere) return;
  fleet_->report(seen_);
  auto& report = std::get<mission::event::Cycle>(report_);
  if (now_.has_looked && seen_ == report.robots) return;
  now_.has_looked = true;
  report.time = time();
  std::swap(report.robots, seen_);
  carry_out(report_);
}

MissionRun::Progress MissionRun::step() {
  hear_bodies();
  if (now_.is_stopped) return brake();
  look();
  if (is_over() && !(settings_.goes_on_when_done && now_.executive.outcome == mission::Outcome::kDone))
    return Progress::kOver;
  if (now_.executive.paused ||
      (now_.stands_still_for_operator && mission::awaits_only_operator(now_.executive)))
    return Progress::kWaits;
  ++now_.cycle;
  now_.has_looked = false;
  change_environment();
  note_teleoperated();
  fleet_->step(now_.dt);
  if (!now_.forced.empty()) tell_not_forced();
  tell_faults();
  answer_calls();
  measure();
  return Progress::kStepped;
}

void MissionRun::answer_calls() {
  bool is_to_end = false;
  for (const fleet::RobotCall& call : fleet_->take_calls()) {
    const std::uint32_t id = call.robot.value;
    switch (call.kind) {
      case fleet::RobotCall::Kind::kFailsafe:
        if (now_.failsafes.size() < kMostFailsafeRecords)
          now_.failsafes.push_back({time(), call.robot, call.text});
        [[fallthrough]];
      case fleet::RobotCall::Kind::kAlert:
        tell(Tell::Kind::kWarning, fmt::format("robot {}: {}", id, call.text));
        break;
      case fleet::RobotCall::Kind::kProceed:
        carry_out(mission::event::RobotAsks{call.robot});
        break;
      case fleet::RobotCall::Kind::kHalt:
        fleet_->stop(call.robot);
        tell(Tell::Kind::kMessage, fmt::format("the program of robot {} has ended", id));
        break;
      case fleet::RobotCall::Kind::kEndMission:
        if (!is_to_end) tell(Tell::Kind::kMessage, fmt::format("robot {} ends the mission", id));
        is_to_end = true;
        break;
    }
  }
  if (is_to_end) carry_out(mission::event::Abort{});
}

std::vector<base::RobotId> MissionRun::tell_faults() {
  std::vector<base::RobotId> faults = fleet_->take_new_faults();
  for (std::size_t i = 0; i < faults.size(); ++i) {
    const fleet::FleetRobot& robot = *fleet_->find(faults[i]);
    if (i == kMostMoved) {
      tell(Tell::Kind::kWarning, fmt::format("{} more robots stand, because of faults", faults.size() - i));
      break;
    }
    tell(Tell::Kind::kWarning, fmt::format("robot {} stands: {}", robot.id.value, failure_of(robot)));
  }
  return faults;
}

MissionRun::Progress MissionRun::brake() {
  if (now_.has_braked && fleet_->bodies().moving == 0) return Progress::kWaits;
  now_.has_braked = true;
  now_.has_looked = false;
  ++now_.cycle;
  fleet_->brake(now_.dt);
  mission::hold_until(now_.executive, time());
  return Progress::kStepped;
}

// Whom an operator is to steer now: his absence counts for nobody else.
void MissionRun::note_teleoperated() {
  if (!fleet_->failsafes().watches(mission::FailsafeWatch::kTeleoperated)) return;
  teleoperated_.clear();
  for (const mission::Run& command : now_.executive.runs) {
    if (command.phase == mission::Run::Phase::kTeleoperation)
      teleoperated_.insert(teleoperated_.end(), command.needed.begin(), command.needed.end());
  }
  std::ranges::sort(teleoperated_);
  fleet_->set_teleoperated(teleoperated_);
}

void MissionRun::change_environment() {
  for (const overlay::EnvironmentEvent& event : settings_.environment.events) {
    const std::uint64_t due = overlay::executions(event, time());
    for (std::uint64_t n = overlay::executions(event, time() - now_.dt); n < due; ++n) happen(event, n);
  }
}

void MissionRun::happen(const overlay::EnvironmentEvent& event, std::uint64_t execution) {
  std::vector<overlay::ObstacleDisc> before;
  for (const binding::Disc& disc : world().discs()) before.push_back({disc.center, disc.radius, 0.0, {}});
  std::vector<overlay::ObstacleDisc> after = before;
  std::vector<overlay::ObstacleDisc> bodies;
  for (const fleet::FleetRobot& robot : fleet_->robots()) {
    if (robot.life != fleet::RobotLife::kNotStarted)
      bodies.push_back({fleet_->pose(robot).position, robot.capabilities.radius, 0.0, {}});
  }
  if (!overlay::apply(event, execution, settings_.seed, bodies, after)) {
    if (!std::exchange(now_.is_full, true))
      tell(Tell::Kind::kWarning, "the environment has no room for as many obstacles as its file wants");
  }
  const auto less = [](const overlay::ObstacleDisc& a, const overlay::ObstacleDisc& b) {
    return std::tuple(a.center.x, a.center.y, a.radius) < std::tuple(b.center.x, b.center.y, b.radius);
  };
  std::sort(before.begin(), before.end(), less);
  std::sort(after.begin(), after.end(), less);
  const auto difference = [&](const auto& from, const auto& without) {
    std::vector<binding::Disc> out;
    for (const overlay::ObstacleDisc& disc : from) {
      if (!std::binary_search(without.begin(), without.end(), disc, less))
        out.push_back({disc.center, disc.radius});
    }
    return out;
  };
  tell_moved(binding_->change_obstacles(difference(before, after), difference(after, before)), "an obstacle");
}

void MissionRun::note_deliveries() {
  for (const binding::Object& object : world().objects()) {
    if (object.id.value >= now_.carriers.size()) now_.carriers.resize(object.id.value + 1);
    base::RobotId& carrier = now_.carriers[object.id.value];
    if (object.basket.value != 0 && carrier.value != 0)
      now_.deliveries.push_back({time(), carrier, object.id, object.basket});
    carrier = object.carrier;
  }
}

void MissionRun::measure_way(std::size_t robot, const fleet::Group& group, UnitMetrics& metrics) {
  const fleet::FleetRobot& one = fleet_->robots()[robot];
  if (one.rank == 0) {
    const auto leg = std::ranges::find(metrics.legs, group.order.sequence, &UnitMetrics::Leg::order);
    if (leg == metrics.legs.end())
      metrics.legs.push_back({group.order.sequence, group.members.size(), group.center, group.center});
    else
      leg->to = group.center;
  }
  now_.milestones.resize(fleet_->robots().size());
  Milestone& before = now_.milestones[robot];
  const double driven = binding_->view().body(one.body).distance_driven;
  if (before.cycle + 1 == now_.cycle) metrics.driven += driven - before.driven;
  before = {now_.cycle, driven};
}

void MissionRun::measure() {
  note_deliveries();
  for (std::size_t i = 0; i < fleet_->robots().size(); ++i) {
    const fleet::FleetRobot& robot = fleet_->robots()[i];
    if (robot.life != fleet::RobotLife::kRunning) continue;
    ++now_.robot_cycles;
    const fleet::Group* group = fleet_->group(robot);
    if (group == nullptr || !group->command || group->order.formation == percept::Formation::kNone ||
        group->members.size() < 2 || group->command->unit == mission::kNoUnit)
      continue;
    if (group->command->unit >= now_.metrics.size())
      now_.metrics.resize(now_.executive.mission->units.size());
    UnitMetrics& metrics = now_.metrics[group->command->unit];
    measure_way(i, *group, metrics);
    if (!fleet::has_station(*group, robot.rank)) continue;
    const double error = fleet_->station_error(robot);
    metrics.error_sum += error;
    metrics.max_error = std::max(metrics.max_error, error);
    ++metrics.samples;
    if (error > group->slop) ++metrics.out_of_formation;
  }
}

std::vector<base::RobotId> MissionRun::commanded(std::uint32_t command) const {
  const std::string& whom = now_.executive.commands[command].unit;
  const auto unit = std::ranges::find(now_.executive.mission->units, whom, &mission::Unit::name);
  if (!whom.empty() && unit != now_.executive.mission->units.end()) return unit->members;
  for (const fleet::FleetRobot& robot : fleet_->robots()) {
    const fleet::Group* group = fleet_->group(robot);
    if (group != nullptr && group->command && group->command->unit == mission::kNoUnit &&
        mission::robots_name(group->command->robots) == whom)
      return group->command->robots;
  }
  return {};
}

void MissionRun::explain_failures(std::uint32_t command) {
  if (command >= now_.executive.commands.size() ||
      now_.executive.commands[command].outcome != mission::Outcome::kFailed)
    return;
  // No cycle may follow that would tell them.
  const std::vector<base::RobotId> told = tell_faults();
  constexpr int kMostRobots = 8;
  int said = 0;
  for (const base::RobotId id : commanded(command)) {
    const fleet::FleetRobot* robot = fleet_->find(id);
    if (robot == nullptr || robot->action.status.done || said >= kMostRobots) continue;
    if (std::ranges::find(told, id) != told.end()) continue;
    ++said;
    for (std::string& line : explain(*robot)) tell(Tell::Kind::kMessage, std::move(line));
  }
}

}  // namespace mlab::run
