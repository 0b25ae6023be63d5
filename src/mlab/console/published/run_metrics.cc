#include "mlab/console/published/run_metrics.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "mlab/console/published/overview.h"
#include "mlab/text/shown.h"

namespace mlab::console {
namespace {

using fleet::RobotLife;
using metrics::Exposition;
using SeriesList = std::vector<Exposition::Series>;

constexpr std::size_t kMostCharacters = 100;  // of a name that others have chosen

// As values of a label are written.
constexpr std::array<std::pair<RobotLife, const char*>, 5> kLives = {{{RobotLife::kNotStarted, "not_started"},
                                                                      {RobotLife::kRunning, "running"},
                                                                      {RobotLife::kParked, "parked"},
                                                                      {RobotLife::kStopped, "stopped"},
                                                                      {RobotLife::kFaulted, "faulted"}}};

void tell_lives(const LiveRun& live, Exposition& out) {
  const std::vector<fleet::FleetRobot>& robots = live.run().fleet().robots();
  SeriesList series;
  for (const auto& [life, word] : kLives)
    series.push_back(
        {{{"state", word}}, static_cast<double>(std::ranges::count(robots, life, &fleet::FleetRobot::life))});
  out.gauge("mlab_robots", "Robots of the mission, by what has become of them.", series);
  const std::vector<Alarms::Robot>& alarms = live.notes().alarms().robots();
  out.gauge("mlab_robots_stuck", "Robots that have come no nearer to their goal for half a minute.",
            static_cast<double>(std::ranges::count(alarms, true, &Alarms::Robot::is_stuck)));
  out.gauge("mlab_robots_lost", "Robots of whose program nothing is heard.",
            static_cast<double>(std::ranges::count(alarms, true, &Alarms::Robot::is_lost)));
  const fleet::Fleet::Bodies bodies = live.run().fleet().bodies();
  out.gauge("mlab_bodies", "Robots' bodies that are in the world.", static_cast<double>(bodies.all));
  out.gauge("mlab_bodies_moving", "Bodies in the world that have not come to rest.",
            static_cast<double>(bodies.moving));
}

void tell_each(const LiveRun& live, Exposition& out) {
  const fleet::Fleet& fleet = live.run().fleet();
  SeriesList contacts;
  SeriesList ages;
  SeriesList silences;
  double all_contacts = 0.0;
  for (const fleet::FleetRobot& robot : fleet.robots()) {
    if (robot.body == binding::kNoBody) continue;
    const double count = live.run().world().body(robot.body).contacts;
    all_contacts += count;
    if (contacts.size() >= metrics::kMostSeries) continue;
    const Exposition::Labels labels = {{"robot", std::to_string(robot.id.value)}};
    const fleet::Situation situation = fleet.situation(robot);
    contacts.push_back({labels, count});
    ages.push_back({labels, situation.percept_age});
    silences.push_back({labels, situation.silence});
  }
  out.counter("mlab_contacts_total", "How often robots met something solid or each other.", all_contacts);
  out.counter("mlab_robot_contacts_total", "How often a robot met something solid or another one.", contacts);
  out.gauge("mlab_robot_percept_age_seconds", "Age of what a robot's action answers; 0 where it is in time.",
            ages);
  out.gauge("mlab_robot_silence_seconds", "For how long nothing has been heard of a robot's program.",
            silences);
}

void tell_machines(const fleet::Fleet& fleet, Exposition& out) {
  SeriesList silences;
  for (const robot::SilentMachine& one : fleet.silent_machines())
    silences.push_back({{{"machine", text::shown(one.name, kMostCharacters)}}, one.silent});
  out.gauge("mlab_machines_silent", "Machines that carry robots and of which nothing is heard.",
            static_cast<double>(silences.size()));
  out.gauge("mlab_machine_silence_seconds", "For how long nothing has been heard of a machine.", silences);
  // Where robots are waited for, all are in time.
  const robot::Punctuality* const known = fleet.punctuality();
  const robot::Punctuality robots = known != nullptr ? *known : robot::Punctuality{};
  out.counter("mlab_robot_cycles_total", "Cycles that robots elsewhere were asked for, in real time.",
              static_cast<double>(robots.asked));
  out.counter("mlab_robot_cycles_late_total", "Those of which an earlier action counted.",
              static_cast<double>(robots.late));
  out.counter("mlab_robot_cycles_stood_total",
              "Those in which the earlier action was too old, and the body stood.",
              static_cast<double>(robots.stood));
  out.gauge("mlab_percept_age_worst_seconds", "The oldest percepts that were acted on so far.",
            robots.worst_age);
}

void tell_recording(const history::Recorder* recorder, Exposition& out) {
  const bool has_file = recorder != nullptr && !recorder->path().empty();
  std::error_code error;
  const auto bytes = has_file ? std::filesystem::file_size(recorder->path(), error) : 0;
  out.gauge("mlab_recording_bytes", "Size of the recording of this run; 0 where there is none.",
            error ? 0.0 : static_cast<double>(bytes));
  out.gauge("mlab_recording_problem", "1 where the recording of this run does not go on.",
            recorder != nullptr && !recorder->problem().empty() ? 1.0 : 0.0);
}

}  // namespace

void tell_run(const LiveRun& live, Exposition& out) {
  const run::MissionRun& run = live.run();
  out.gauge(
      "mlab_run_info", "1; which mission this is.",
      {{{{"mission", text::shown(run.mission().name, kMostCharacters)}, {"seed", std::to_string(run.seed())}},
        1.0}});
  out.counter("mlab_simulated_seconds_total", "Time that has passed in this run.", run.time());
  out.counter("mlab_cycles_total", "Control cycles of this run.", static_cast<double>(run.cycle()));
  out.gauge("mlab_cycle_period_seconds", "Simulated time between two control cycles.", run.cycle_duration());
  out.gauge("mlab_steps", "Steps of the mission's plan.", static_cast<double>(run.mission().steps.size()));
  out.gauge("mlab_steps_done", "Steps that are done.", static_cast<double>(run.steps_done()));
  out.gauge("mlab_questions_open", "Questions that the operator has not answered.",
            static_cast<double>(run.state().questions.size()));
  tell_recording(live.recorder(), out);
}

void tell_robots(const LiveRun& live, Exposition& out) {
  tell_lives(live, out);
  tell_each(live, out);
  tell_machines(live.run().fleet(), out);
}

}  // namespace mlab::console
