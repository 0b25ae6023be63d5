#include "mlab/comparison/comparer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/core.h>

#include "mlab/comparison/as_recorded.h"
#include "mlab/comparison/beginning.h"
#include "mlab/comparison/causes.h"
#include "mlab/comparison/in_world.h"
#include "mlab/comparison/inputs.h"
#include "mlab/comparison/rows.h"
#include "mlab/run/report.h"

namespace mlab::comparison {
namespace {

constexpr double kSameTime = 1e-9;                  // [s]
constexpr std::size_t kMostSamples = 1000;          // of a robot,
constexpr std::size_t kMostSamplesOfAll = 400'000;  // and of all of them
constexpr std::size_t kLeastSamples = 64;
constexpr float kNowhere = std::numeric_limits<float>::quiet_NaN();

std::string outcome_of(const history::History& history) {
  return history.end() ? history.end()->outcome : "";
}

// How far robots are from their stations, on average [m].
float formation_error(const run::MissionRun& run) {
  double sum = 0.0;
  std::size_t count = 0;
  for (const fleet::FleetRobot& robot : run.fleet().robots()) {
    if (robot.life != fleet::RobotLife::kRunning || !run.fleet().station_place(robot)) continue;
    sum += run.fleet().station_error(robot);
    ++count;
  }
  return count == 0 ? kNowhere : static_cast<float>(sum / static_cast<double>(count));
}

}  // namespace

Comparer::Comparer(Both<Recorded> runs) : runs_(std::move(runs)) {
  const Both<const history::History*> histories = {runs_[0].history.get(), runs_[1].history.get()};
  out_.is_recomputed = runs_[0].replay && runs_[1].replay;
  out_.beginning = compare_beginnings(histories);
  out_.input = first_difference(histories);
  if (!out_.is_recomputed) return;
  for (const Recorded& one : runs_) {
    for (const fleet::FleetRobot& robot : one.replay->run().fleet().robots()) row_of(robot.id);
  }
  most_samples_ =
      std::clamp(kMostSamplesOfAll / std::max<std::size_t>(1, robots_.size()), kLeastSamples, kMostSamples);
}

RobotRow* Comparer::row_of(base::RobotId id) {
  const auto found = robots_.find(id.value);
  if (found != robots_.end()) return &found->second;
  if (robots_.size() >= kMostRobots) return nullptr;
  RobotRow& row = robots_[id.value];
  row.id = id.value;
  // Of what was sampled before it came it had nothing.
  row.apart.assign(out_.times.size(), kNowhere);
  for (auto& way : row.ways) way.assign(out_.times.size(), {kNowhere, kNowhere});
  return &row;
}

double Comparer::share_done() const {
  double done = 0.0;
  double all = 0.0;
  for (const Recorded& one : runs_) {
    all += static_cast<double>(one.history->last_cycle());
    if (one.replay) done += static_cast<double>(one.replay->run().cycle());
  }
  return all > 0.0 ? std::min(1.0, done / all) : 1.0;
}

bool Comparer::advance(std::size_t side) {
  if (is_over_[side]) return false;
  if (runs_[side].replay->step()) return true;
  is_over_[side] = true;
  return false;
}

bool Comparer::step() {
  if (!out_.is_recomputed || is_done_) return false;
  const double ahead = runs_[0].replay->run().time() - runs_[1].replay->run().time();
  const bool first_waits = ahead > kSameTime && !is_over_[1];
  const bool second_waits = ahead < -kSameTime && !is_over_[0];
  if (!first_waits) advance(0);
  if (!second_waits) advance(1);
  is_done_ = is_over_[0] && is_over_[1];
  look();
  return !is_done_;
}

void Comparer::look() {
  note_robots();
  const Both<const run::MissionRun*> runs = {&runs_[0].replay->run(), &runs_[1].replay->run()};
  if (is_over_[0] != is_over_[1]) {
    if (out_.parting) return;
    const std::size_t ended = is_over_[0] ? 0 : 1;
    Parting parting;
    parting.what = Parting::What::kEnd;
    parting.cycle = runs[ended]->cycle();
    parting.time = runs[ended]->time();
    parting.value.path = "the run";
    parting.value.values[ended] =
        runs_[ended].replay->divergence() ? "can't be computed any further" : "ends here";
    parting.value.values[1 - ended] = "goes on";
    add_causes(runs, {}, out_, parting);
    out_.parting = std::move(parting);
    return;
  }
  if (is_done_ || std::abs(runs[0]->time() - runs[1]->time()) > kSameTime) return;
  if (!out_.parting) out_.parting = finder_.look(runs, out_);
  if (aligned_++ % stride_ == 0) note_sample();
}

void Comparer::note_robots() {
  for (const std::size_t side : kSides) {
    const run::MissionRun& run = runs_[side].replay->run();
    for (const fleet::FleetRobot& robot : run.fleet().robots()) {
      if (robot.life == fleet::RobotLife::kNotStarted) continue;
      RobotRow* const row = row_of(robot.id);
      if (row == nullptr) continue;
      row->is_there[side] = true;
      if (row->has_values && robot.life == fleet::RobotLife::kRunning && !robot.workings())
        row->has_values = false;
      if (!row->first_contact[side] && run.world().body(robot.body).contacts > 0)
        row->first_contact[side] = run.time();
    }
  }
  const run::MissionRun& a = runs_[0].replay->run();
  const run::MissionRun& b = runs_[1].replay->run();
  if (is_over_[0] != is_over_[1] || std::abs(a.time() - b.time()) > kSameTime) return;
  for (const fleet::FleetRobot& robot : a.fleet().robots()) {
    if (robot.life == fleet::RobotLife::kNotStarted) continue;
    const fleet::FleetRobot* const other = in_world(b, robot.id);
    RobotRow* const row = other == nullptr ? nullptr : row_of(robot.id);
    if (row == nullptr) continue;
    row->apart_at_end = geom::distance(a.fleet().pose(robot).position, b.fleet().pose(*other).position);
    if (!(row->apart_at_end > row->most_apart)) continue;
    row->most_apart = row->apart_at_end;
    row->most_apart_at = a.time();
  }
}

void Comparer::note_sample() {
  if (out_.times.size() >= most_samples_) thin();
  const Both<const run::MissionRun*> runs = {&runs_[0].replay->run(), &runs_[1].replay->run()};
  out_.times.push_back(runs[0]->time());
  for (const std::size_t side : kSides) out_.formation_errors[side].push_back(formation_error(*runs[side]));
  for (auto& [id, row] : robots_) {
    Both<geom::Point> at;
    for (const std::size_t side : kSides) {
      const fleet::FleetRobot* const robot = in_world(*runs[side], {id});
      at[side] =
          robot == nullptr ? geom::Point{kNowhere, kNowhere} : runs[side]->fleet().pose(*robot).position;
      row.ways[side].emplace_back(static_cast<float>(at[side].x), static_cast<float>(at[side].y));
    }
    row.apart.push_back(static_cast<float>(geom::distance(at[0], at[1])));
  }
}

// Every second sample goes, and from now on half as many come.
void Comparer::thin() {
  const auto halve = [](auto& list) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < list.size(); i += 2) list[kept++] = list[i];
    list.resize(kept);
  };
  halve(out_.times);
  for (auto& errors : out_.formation_errors) halve(errors);
  for (auto& [id, row] : robots_) {
    halve(row.apart);
    for (auto& way : row.ways) halve(way);
  }
  stride_ *= 2;
}

std::string Comparer::divergence_of(std::size_t side) const {
  const history::Replay* const replay = runs_[side].replay.get();
  if (replay == nullptr || !replay->divergence()) return "";
  return fmt::format("computed again it is not as recorded: by cycle {} {}", replay->divergence()->cycle,
                     replay->divergence()->why);
}

// One that is computed otherwise than it was recorded says nothing of what happened then.
void Comparer::give_up_computing() {
  out_.is_recomputed = false;
  out_.parting.reset();
  out_.times.clear();
  for (auto& errors : out_.formation_errors) errors.clear();
}

Side Comparer::side_of(std::size_t side) const {
  const Recorded& one = runs_[side];
  const wire::HistoryBeginning& beginning = one.history->beginning();
  Side out;
  out.name = one.name;
  out.mission = beginning.mission().path();
  out.version = beginning.version();
  out.seed = beginning.seed();
  out.cycles = one.history->last_cycle();
  out.length = one.history->last_time();
  out.outcome = outcome_of(*one.history);
  out.remarks = one.remarks;
  out.why_not_recomputed = one.why_not;
  if (const std::string why = divergence_of(side); !why.empty())
    (out_.is_recomputed ? out.remarks.emplace_back() : out.why_not_recomputed) = why;
  return out;
}

void Comparer::add_totals() {
  for (const std::size_t side : kSides) {
    const run::MissionRun& run = runs_[side].replay->run();
    for (auto& [id, row] : robots_) {
      const fleet::FleetRobot* const robot = in_world(run, {id});
      if (robot == nullptr) continue;
      const binding::BodyState body = run.world().body(robot->body);
      row.driven[side] = body.distance_driven;
      row.contacts[side] = body.contacts;
    }
  }
}

Comparison Comparer::finish() {
  out_.is_whole = is_done_ || !out_.is_recomputed;
  const bool has_diverged = !divergence_of(0).empty() || !divergence_of(1).empty();
  if (has_diverged && (!out_.parting || out_.parting->what == Parting::What::kEnd)) {
    give_up_computing();
    out_.is_whole = true;
  }
  for (const std::size_t side : kSides) out_.sides[side] = side_of(side);
  const Both<const history::History*> histories = {runs_[0].history.get(), runs_[1].history.get()};
  add_events(histories, out_);
  if (out_.is_recomputed) {
    add_totals();
    const Both<const run::MissionRun*> runs = {&runs_[0].replay->run(), &runs_[1].replay->run()};
    add_commands(runs, out_);
    add_units(runs, out_);
    for (auto& [id, row] : robots_) out_.robots.push_back(std::move(row));
  } else {
    compare_recorded(histories, out_);
  }
  return std::move(out_);
}

}  // namespace mlab::comparison
