#include "mlab/run/report.h"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "mlab/base/angle.h"

namespace mlab::run {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kSchemaVersion = 2;

// Micrometres and microseconds are more than anybody reads; rounding keeps 0.1 from becoming
// 0.1000000000000001.
double rounded(double value) {
  return std::round(value * 1e6) / 1e6;
}

Json pose_json(geom::Pose pose) {
  return {{"x_m", rounded(pose.position.x)},
          {"y_m", rounded(pose.position.y)},
          {"heading_deg", rounded(base::degrees(base::wrap_angle(pose.heading)))}};
}

Json optional_text(const std::string& text) {
  return text.empty() ? Json(nullptr) : Json(text);
}

Json command_json(const mission::CommandRecord& record) {
  Json out;
  out["command"] = record.text;
  out["unit"] = optional_text(record.unit);
  out["task"] = record.task;
  out["place"] = optional_text(record.place);
  out["formation"] = optional_text(record.formation);
  out["start_s"] = rounded(record.start);
  out["end_s"] = record.outcome == mission::Outcome::kRunning ? Json(nullptr) : Json(rounded(record.end));
  out["outcome"] = mission::name(record.outcome);
  out["message"] = optional_text(record.message);
  return out;
}

Json steps_json(const mission::State& state) {
  Json steps = Json::array();
  for (const mission::StepRecord& record : state.steps) {
    Json step;
    step["label"] = optional_text(record.label);
    step["start_s"] = rounded(record.start);
    step["end_s"] = record.outcome == mission::Outcome::kRunning ? Json(nullptr) : Json(rounded(record.end));
    step["outcome"] = mission::name(record.outcome);
    step["commands"] = Json::array();
    for (std::uint32_t i = 0; i < record.command_count; ++i) {
      step["commands"].push_back(command_json(state.commands[record.first_command + i]));
    }
    steps.push_back(std::move(step));
  }
  return steps;
}

Json robots_json(const MissionRun& run) {
  Json robots = Json::array();
  for (const fleet::FleetRobot& robot : run.fleet().robots()) {
    Json out;
    out["id"] = robot.id.value;
    out["type"] = robot.type;
    out["state"] = name(robot.life);
    const bool was_started = robot.life != fleet::RobotLife::kNotStarted;
    out["start"] = was_started ? pose_json(robot.start) : Json(nullptr);
    out["end"] = was_started ? pose_json(run.fleet().pose(robot)) : Json(nullptr);
    const binding::BodyState body = was_started ? run.world().body(robot.body) : binding::BodyState{};
    out["distance_m"] = rounded(body.distance_driven);
    out["collisions"] = body.contacts;
    if (body.run_over > 0) out["run_over"] = body.run_over;
    out["fault"] = optional_text(robot.fault);
    out["failure"] = optional_text(robot.failure.empty() ? robot.ailment : robot.failure);
    robots.push_back(std::move(out));
  }
  return robots;
}

Json units_json(const MissionRun& run) {
  Json units = Json::array();
  for (std::size_t i = 0; i < run.mission().units.size(); ++i) {
    const mission::Unit& unit = run.mission().units[i];
    if (unit.name.empty()) continue;
    Json out;
    out["name"] = unit.name;
    out["robots"] = Json::array();
    for (const base::RobotId id : unit.members) out["robots"].push_back(id.value);
    const UnitMetrics metrics = i < run.unit_metrics().size() ? run.unit_metrics()[i] : UnitMetrics{};
    out["formation_error"] = {{"samples", metrics.samples},
                              {"mean_m", rounded(metrics.mean_error())},
                              {"max_m", rounded(metrics.max_error)},
                              {"out_of_formation_share", rounded(metrics.out_share())}};
    const double straight = metrics.straight();
    out["way_in_formation"] = {
        {"driven_m", rounded(metrics.driven)},
        {"straight_m", rounded(straight)},
        {"ratio", straight > 0.0 ? Json(rounded(metrics.driven / straight)) : Json(nullptr)}};
    units.push_back(std::move(out));
  }
  return units;
}

Json deliveries_json(const MissionRun& run) {
  Json out = Json::array();
  for (const Delivery& delivery : run.deliveries()) {
    out.push_back({{"time_s", rounded(delivery.time)},
                   {"robot", delivery.robot.value},
                   {"object", delivery.object.value},
                   {"basket", delivery.basket.value}});
  }
  return out;
}

Json failsafes_json(const MissionRun& run) {
  Json out = Json::array();
  for (const FailsafeRecord& record : run.failsafes()) {
    out.push_back({{"time_s", rounded(record.time)}, {"robot", record.robot.value}, {"what", record.what}});
  }
  return out;
}

Json interventions_json(const MissionRun& run) {
  Json out = Json::array();
  for (const InterventionRecord& record : run.interventions()) {
    out.push_back({{"cycle", record.cycle},
                   {"robot", record.robot.value},
                   {"kind", name(record.kind)},
                   {"path", optional_text(record.path)},
                   {"value", optional_text(record.value)}});
  }
  return out;
}

Json takeovers_json(const MissionRun& run) {
  const auto ids = [](const std::vector<base::RobotId>& robots) {
    Json out = Json::array();
    for (const base::RobotId robot : robots) out.push_back(robot.value);
    return out;
  };
  Json out = Json::array();
  for (const Takeover& one : run.takeovers()) {
    Json restarts = Json::array();
    for (const Takeover::Restart& restart : one.restarts)
      restarts.push_back({{"path", restart.path}, {"why", restart.why}, {"robots", ids(restart.robots)}});
    out.push_back({{"cycle", one.cycle}, {"robots", ids(one.robots)}, {"restarts", std::move(restarts)}});
  }
  return out;
}

Json performance_json(const MissionRun& run, const Performance& performance) {
  const auto cycles = static_cast<double>(run.robot_cycles());
  Json out;
  out["mlab_version"] = performance.program_version;
  out["started_at"] = performance.started_at;
  out["mission_clock_start"] = performance.mission_clock;
  out["wall_s"] = rounded(performance.wall_seconds);
  out["cpu_s"] = rounded(performance.cpu_seconds);
  out["robot_cycles"] = run.robot_cycles();
  out["robot_cycles_per_second"] =
      performance.wall_seconds > 0.0 ? std::round(cycles / performance.wall_seconds) : 0.0;
  if (const robot::Punctuality* const robots = run.fleet().punctuality()) {
    out["real_time"] = {{"robot_cycles", robots->asked},
                        {"late", robots->late},
                        {"stood", robots->stood},
                        {"worst_percept_age_s", rounded(robots->worst_age)}};
  }
  return out;
}

}  // namespace

std::string outcome_name(const MissionRun& run, RunEnd end) {
  // The others may have done all that there was to do; the mission was theirs and that robot's.
  const bool is_broken = std::ranges::any_of(
      run.fleet().robots(), [](const fleet::FleetRobot& robot) { return !failure_of(robot).empty(); });
  const bool is_over = run.is_over() || end == RunEnd::kByItself;
  if (is_broken && (is_over ? run.state().outcome == mission::Outcome::kDone : end == RunEnd::kTimeIsUp))
    return std::string(mission::name(mission::Outcome::kFailed));
  if (is_over) return std::string(mission::name(run.state().outcome));
  return end == RunEnd::kTimeIsUp ? "done" : "interrupted";
}

std::string report_json(const MissionRun& run, const Performance& performance, RunEnd end) {
  Json out;
  out["version"] = kSchemaVersion;
  out["mission"] = {{"name", run.mission().name},
                    {"file", run.mission().source ? run.mission().source->name() : ""},
                    {"cycle_duration_s", run.cycle_duration()},
                    {"cycles", run.cycle()},
                    {"simulated_s", rounded(run.time())}};
  out["mission"]["answers"] = Json::array();
  for (const AnswerRecord& answer : run.answers()) {
    out["mission"]["answers"].push_back(
        {{"cycle", answer.cycle}, {"question", answer.question}, {"proceed", answer.proceed}});
  }
  out["seed"] = run.seed();
  out["outcome"] = outcome_name(run, end);
  out["steps"] = steps_json(run.state());
  out["robots"] = robots_json(run);
  out["units"] = units_json(run);
  out["deliveries"] = deliveries_json(run);
  if (!run.failsafes().empty()) out["failsafes"] = failsafes_json(run);
  if (!run.interventions().empty()) out["interventions"] = interventions_json(run);
  if (!run.takeovers().empty()) out["takeovers"] = takeovers_json(run);
  out["performance"] = performance_json(run, performance);
  // What a mission's author wrote may be any bytes; a report is text all the same.
  return out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace mlab::run
