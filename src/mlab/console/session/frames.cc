#include "mlab/console/session/frames.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "mlab/console/published/failsafe_encoder.h"
#include "mlab/console/published/robot_detail.h"
#include "mlab/console/published/watched.h"
#include "mlab/console/run/measure_series.h"

namespace mlab::console {
namespace {

// What people read need not be made for every frame [s].
constexpr double kSentencesEvery = 0.2;

}  // namespace

// ---- what is asked

void Frames::watch(const Sender& sender, const Watch& watch) {
  sender.channel.watch(watch);
  update_watches();
  const LiveRun* live = run_.live();
  for (const Series& series : sender.channel.watched().series()) {
    if (live != nullptr)
      sender.channel.series_seen.try_emplace(series.id(), live->notes().series().last_time(series, -1.0));
  }
}

Answered Frames::read_series(const ReadSeries& read, Reply& reply) {
  const LiveRun* live = run_.live();
  SeriesData& out = *reply.mutable_series();
  int count = 0;
  for (const Series& series : read.series()) {
    if (++count > static_cast<int>(Channel::kMostSeries)) break;
    SeriesData::Samples& told = *out.add_samples();
    told.set_id(series.id());
    if (live == nullptr) {
      told.set_error("there is no run");
      continue;
    }
    live->notes().series().encode_since(series, -1.0, *told.mutable_samples());
    if (!told.samples().empty()) continue;
    told.set_error(problem_of(live->run(), series));
    if (told.error().empty() && !live->notes().series().is_recorded(series))
      told.set_error("it has not been watched, so it was not recorded");
  }
  return std::nullopt;
}

// ---- what is recorded

void Frames::follow_run() {
  if (known_run_ == run_.run_number()) return;
  known_run_ = run_.run_number();
  rows_.clear();
  sentences_.clear();
  for (auto& [id, channel] : people_.channels()) {
    channel.series_seen.clear();
    channel.failsafes_seen.clear();
  }
  update_watches();
}

void Frames::update_watches() {
  LiveRun* live = run_.live();
  if (live == nullptr) return;
  std::vector<std::uint32_t> details;
  std::vector<Series> series;
  for (const auto& [id, channel] : people_.channels()) {
    const Watch& watch = channel.watched();
    details.insert(details.end(), watch.details().begin(), watch.details().end());
    series.insert(series.end(), watch.series().begin(), watch.series().end());
  }
  live->notes().transitions().watch(details);
  live->notes().alarms().watch_states(std::move(details));
  live->notes().series().watch(series, wall_time());
}

// ---- frames

double Frames::next_frame() const {
  double next = std::numeric_limits<double>::infinity();
  for (const auto& [id, channel] : people_.channels()) {
    if (!channel.looks_back && channel.seen != run_.world_version())
      next = std::min(next, channel.next_frame());
  }
  return next;
}

void Frames::publish() {
  const double wall = wall_time();
  for (auto& [id, channel] : people_.channels()) {
    if (channel.looks_back || channel.seen == run_.world_version() || !channel.wants_frame(wall)) continue;
    ToBrowser out;
    fill(channel, *out.mutable_frame());
    out.mutable_frame()->set_number(channel.begin_frame(wall));
    channel.seen = run_.world_version();
    people_.send(id, out);
  }
}

void Frames::fill(Channel& channel, Frame& out) {
  out.set_time(run_.sim_time());
  if (run_.live() == nullptr) return;
  const LiveRun& live = *run_.live();
  if (rows_version_ != run_.world_version()) {
    rows_.gather(live.run(), live.notes().alarms().robots(), run_.teleoperations().robots());
    rows_version_ = run_.world_version();
  }
  const Watch& watch = channel.watched();
  const auto view = watch.has_view() ? std::optional<Box>(watch.view()) : std::nullopt;
  out.set_robots_elsewhere(rows_.encode(view, *out.mutable_robots()));
  encode_watched(live.run(), watch, out);
  fill_details(watch, out);
  if (watch.with_failsafes()) fill_failsafes(channel, out);
  fill_series(channel, *out.mutable_series());
}

void Frames::fill_details(const Watch& watch, Frame& out) {
  const LiveRun& live = *run_.live();
  const run::MissionRun& run = live.run();
  for (const std::uint32_t id : watch.details()) {
    const fleet::FleetRobot* robot = run.fleet().find({id});
    if (robot == nullptr) continue;
    RobotDetail& told = *out.add_details();
    encode_watched(run, *robot, watch, live.notes().estimates(), live.notes().transitions(), told);
    Sentences& sentences = sentences_[id];
    if (!run_.time_runs() || wall_time() - sentences.wall > kSentencesEvery)
      sentences = {wall_time(), waits_for(run, *robot)};
    for (const std::string& line : sentences.lines) told.add_waits_for(line);
  }
}

void Frames::fill_failsafes(Channel& channel, Frame& out) {
  const run::MissionRun& run = run_.live()->run();
  if (run.fleet().failsafes().empty()) return;
  for (const std::uint32_t id : channel.watched().details()) {
    const fleet::FleetRobot* robot = run.fleet().find({id});
    if (robot == nullptr) continue;
    FailsafeStandings told;
    encode_standings(run, *robot, told);
    std::string bytes = told.SerializeAsString();
    std::string& seen = channel.failsafes_seen[id];
    if (seen == bytes) continue;
    seen = std::move(bytes);
    *out.add_failsafes() = std::move(told);
  }
}

void Frames::fill_series(Channel& channel, SeriesData& out) {
  const LiveRun& live = *run_.live();
  for (const Series& series : channel.watched().series()) {
    double& seen = channel.series_seen.try_emplace(series.id(), -1.0).first->second;
    SeriesData::Samples told;
    told.set_id(series.id());
    live.notes().series().encode_since(series, seen, *told.mutable_samples());
    if (told.samples().empty()) told.set_error(problem_of(live.run(), series));
    if (told.samples().empty() && told.error().empty()) continue;
    seen = live.notes().series().last_time(series, seen);
    *out.add_samples() = std::move(told);
  }
}

}  // namespace mlab::console
