#include "mlab/cli/run_screen.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "mlab/base/angle.h"
#include "mlab/base/counted.h"
#include "mlab/cli/clock.h"
#include "mlab/cli/terminal.h"
#include "mlab/text/shown.h"

namespace mlab::cli {
namespace {

constexpr double kRedrawSeconds = 0.1;
constexpr int kBarWidth = 24;
constexpr std::size_t kMostRobots = 12;

using mission::effect::Tell;

constexpr std::size_t kMostCharacters = 600;  // of a line that a mission's author had a hand in

constexpr RepeatedWarnings::Limits kUsual{1000, 1000};
constexpr RepeatedWarnings::Limits kQuietly{3, 30};
constexpr std::size_t kMostLoadWarnings = 10;

// The text with each number as one `#`.
std::string kind_of(const std::string& text) {
  std::string out;
  for (const char c : text) {
    const bool is_digit = c >= '0' && c <= '9';
    if (!is_digit)
      out += c;
    else if (!out.ends_with('#'))
      out += '#';
  }
  return out;
}

}  // namespace

bool RepeatedWarnings::admit(const std::string& text) {
  const std::string kind = kind_of(text);
  const auto it = kinds_.find(kind);
  if (it == kinds_.end() && kinds_.size() >= limits_.kinds) {
    ++of_no_kind_;
    return false;
  }
  Kind& found = it == kinds_.end() ? kinds_[kind] : it->second;
  if (found.count++ == limits_.of_a_kind) found.first = text;
  return found.count <= limits_.of_a_kind;
}

std::vector<std::string> RepeatedWarnings::left_out() const {
  std::vector<std::string> out;
  for (const auto& [text, kind] : kinds_) {
    if (kind.count > limits_.of_a_kind)
      out.push_back(fmt::format("{} more like: {}", kind.count - limits_.of_a_kind, kind.first));
  }
  if (of_no_kind_ > 0) out.push_back(fmt::format("{} more of other kinds", of_no_kind_));
  return out;
}

RunScreen::RunScreen(bool quiet)
    : quiet_(quiet), is_terminal_(isatty(STDOUT_FILENO) == 1), warnings_(quiet ? kQuietly : kUsual) {}

void RunScreen::line(const std::string& text) {
  clear_progress();
  const std::string asked = std::exchange(prompt_, "");
  if (!asked.empty()) fmt::print("{}", is_terminal_ ? "\r\x1b[K" : "\n");
  fmt::print("{}\n", text);
  std::fflush(stdout);
  if (!asked.empty()) show_prompt(asked);
}

void RunScreen::show_prompt(const std::string& text) {
  if (prompt_ == text) return;
  clear_progress();
  prompt_ = text;
  fmt::print("{}", text);
  std::fflush(stdout);
}

void RunScreen::end_prompt(bool is_answered) {
  if (!std::exchange(prompt_, "").empty() && !is_answered) fmt::print("\n");
  std::fflush(stdout);
}

// The commands say which step they belong to, so a line for the step itself would only repeat them. Quietly:
// what is wrong, and why the mission has failed.
bool RunScreen::is_worth_a_line(const run::MissionRun& run, const Tell& told) {
  if (told.kind == Tell::Kind::kWarning) return warnings_.admit(told.text);
  if (quiet_)
    return told.kind == Tell::Kind::kCommandEnded &&
           run.state().commands[told.command].outcome == mission::Outcome::kFailed;
  return told.kind != Tell::Kind::kStepStarted && told.kind != Tell::Kind::kStepEnded;
}

void RunScreen::clear_progress() {
  if (!has_bar_) return;
  fmt::print("\r\x1b[K");
  std::fflush(stdout);
  has_bar_ = false;
}

void RunScreen::show_start(const run::MissionRun& run) {
  if (quiet_) return;
  const mission::Mission& mission = run.mission();
  line(fmt::format("{}: {}, {}, seed {}, cycle {} s",
                   mission.name.empty() ? "mission" : text::shown(mission.name),
                   base::counted(mission.robots.size(), "robot"), base::counted(mission.steps.size(), "step"),
                   run.seed(), run.cycle_duration()));
}

void RunScreen::show(const run::MissionRun& run, const mission::Effect& effect) {
  if (const auto* print = std::get_if<mission::effect::Print>(&effect))
    print->robot_info ? show_robots(run) : show_database(run);
  const auto* told = std::get_if<Tell>(&effect);
  if (told == nullptr) return;
  if (!is_worth_a_line(run, *told)) return;
  line(fmt::format("[{:9.1f} s] {}{}", run.time(),
                   told->kind == Tell::Kind::kWarning ? colored("warning: ", Color::kWarning) : "",
                   text::shown(told->text, kMostCharacters)));
}

void RunScreen::show_database(const run::MissionRun& run) {
  for (const overlay::ControlMeasure& measure : run.mission().overlay.measures) {
    const geom::Point at = measure.center();
    line(fmt::format("  {:<10} {:<20} at ({:.2f}, {:.2f})", keyword(measure.kind), text::shown(measure.name),
                     at.x, at.y));
  }
  for (const mission::Unit& unit : run.mission().units) {
    if (unit.name.empty()) continue;
    std::vector<std::uint32_t> ids;
    for (const base::RobotId id : unit.members) ids.push_back(id.value);
    line(fmt::format("  {:<10} {:<20} robots {}", "UNIT", text::shown(unit.name), fmt::join(ids, " ")));
  }
}

void RunScreen::show_robots(const run::MissionRun& run) {
  for (const fleet::FleetRobot& robot : run.fleet().robots()) {
    const geom::Pose pose = run.fleet().pose(robot);
    line(fmt::format("  robot {:<6} {:<16} {:<12} at ({:.2f}, {:.2f}) heading {:.1f} deg", robot.id.value,
                     text::shown(robot.type), name(robot.life), pose.position.x, pose.position.y,
                     base::degrees(pose.heading)));
  }
}

void RunScreen::show_progress(const run::MissionRun& run) {
  if (!is_terminal_ || quiet_ || !prompt_.empty()) return;
  const double now = steady_seconds();
  if (now - last_drawn_ < kRedrawSeconds) return;
  if (last_drawn_ > 0.0) {
    const double rate = (run.time() - last_cycles_) / (now - last_drawn_);
    rate_ = rate_ == 0.0 ? rate : 0.8 * rate_ + 0.2 * rate;
  }
  last_drawn_ = now;
  last_cycles_ = run.time();
  const std::size_t total = std::max<std::size_t>(run.mission().steps.size(), 1);
  const std::size_t done = std::min(run.steps_done(), total);
  const auto filled = static_cast<std::size_t>(kBarWidth) * done / total;
  fmt::print("\r\x1b[K[{}{}] step {} of {}   {:.0f} s simulated   {:.0f} x real time",
             std::string(filled, '#'), std::string(kBarWidth - filled, '.'), std::min(done + 1, total), total,
             run.time(), rate_);
  std::fflush(stdout);
  has_bar_ = true;
}

void RunScreen::show_summary(const run::MissionRun& run, const std::string& outcome, double wall_seconds) {
  clear_progress();
  fmt::print("\n{} after {:.1f} s simulated, {:.2f} s real ({:.0f} robot-cycles per second)\n",
             colored(outcome, outcome == "done" ? Color::kGood : Color::kBad), run.time(), wall_seconds,
             wall_seconds > 0.0 ? static_cast<double>(run.robot_cycles()) / wall_seconds : 0.0);
  if (outcome != "done" && run.state().outcome == mission::Outcome::kDone)
    fmt::print("  all steps were done, but not by all robots\n");
  if (const robot::Punctuality* const robots = run.fleet().punctuality()) {
    fmt::print(
        "  in real time: {} of {} robot-cycles came too late ({:.1f} %), robots stood for {} of them\n",
        robots->late, robots->asked,
        robots->asked > 0 ? 100.0 * static_cast<double>(robots->late) / static_cast<double>(robots->asked)
                          : 0.0,
        robots->stood);
  }
  std::size_t shown_robots = 0;
  std::uint64_t contacts = 0;
  for (const fleet::FleetRobot& robot : run.fleet().robots()) {
    const bool was_started = robot.life != fleet::RobotLife::kNotStarted;
    if (was_started) contacts += run.world().body(robot.body).contacts;
    if (shown_robots++ >= kMostRobots) continue;
    if (!was_started) {
      fmt::print("  robot {}: not started\n", robot.id.value);
      continue;
    }
    const geom::Point at = run.fleet().pose(robot).position;
    const binding::BodyState body = run.world().body(robot.body);
    const std::string failure = failure_of(robot);
    fmt::print("  robot {}: {:>8} at ({:.1f}, {:.1f}), drove {:.1f} m, {}{}{}\n", robot.id.value,
               name(robot.life), at.x, at.y, body.distance_driven, base::counted(body.contacts, "collision"),
               failure.empty() ? "" : "; it failed: ", failure);
  }
  if (shown_robots > kMostRobots)
    fmt::print("  ... and {} more; {} in all\n", shown_robots - kMostRobots,
               base::counted(contacts, "collision"));
  for (std::size_t i = 0; i < run.mission().units.size() && i < run.unit_metrics().size(); ++i) {
    const run::UnitMetrics& metrics = run.unit_metrics()[i];
    if (metrics.samples == 0) continue;
    fmt::print(
        "  unit {}: formation error {:.1f} m on average, {:.1f} m at most, out of formation {:.0f} % of the "
        "time\n",
        text::shown(run.mission().units[i].name), metrics.mean_error(), metrics.max_error,
        100.0 * metrics.out_share());
  }
  std::fflush(stdout);
}

void RunScreen::show_warnings(const text::Diagnostics& at_load) const {
  std::vector<std::string> lines;
  for (const text::Diagnostic& d : at_load.items()) {
    if (d.severity != text::Severity::kWarning || lines.size() >= kMostLoadWarnings) continue;
    lines.push_back(d.place.source
                        ? fmt::format("{}:{}: {}", d.place.source->name(),
                                      d.place.source->line_column(d.place.span.begin).line, d.message)
                        : d.message);
    if (!d.hints.empty()) lines.back() += fmt::format(" ({})", d.hints.front());
  }
  const std::size_t count = at_load.warning_count();
  if (count > lines.size()) lines.push_back(fmt::format("... and {} more", count - lines.size()));
  if (count > 0) fmt::print("{}:\n", base::counted(count, "warning"));
  for (const std::string& one : lines) fmt::print("  {}\n", one);
  const std::vector<std::string> left_out = warnings_.left_out();
  if (!left_out.empty()) fmt::print("warnings that were not shown:\n");
  for (const std::string& one : left_out) fmt::print("  {}\n", text::shown(one, kMostCharacters));
  std::fflush(stdout);
}

}  // namespace mlab::cli
