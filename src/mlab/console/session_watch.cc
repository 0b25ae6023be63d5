#include <algorithm>
#include <cstring>
#include <limits>
#include <tuple>

#include "mlab/base/hash.h"
#include "mlab/console/measure_series.h"
#include "mlab/console/robot_detail.h"
#include "mlab/console/session_parts.h"

namespace mlab::console {
namespace {

std::uint64_t bits(double value) {
  std::uint64_t out = 0;
  std::memcpy(&out, &value, sizeof out);
  return out;
}

std::uint64_t key_of(std::span<const binding::Disc> discs) {
  std::uint64_t key = discs.size();
  for (const binding::Disc& disc : discs) {
    key = base::combine_bits(key, bits(disc.center.x));
    key = base::combine_bits(key, bits(disc.center.y) ^ bits(disc.radius));
  }
  return key;
}

// What people read need not be made for every frame [s].
constexpr double kSentencesEvery = 0.2;

using Round = std::tuple<double, double, double>;

}  // namespace

void Session::Parts::update_watches() {
  if (!live_) return;
  std::vector<std::uint32_t> details;
  std::vector<Series> series;
  for (const auto& [id, channel] : channels_) {
    const Watch& watch = channel.watched();
    details.insert(details.end(), watch.details().begin(), watch.details().end());
    series.insert(series.end(), watch.series().begin(), watch.series().end());
  }
  live_->transitions().watch(details);
  live_->alarms().watch_states(std::move(details));
  live_->series().watch(series, now());
}

void Session::Parts::look_at_world() {
  if (!live_) return;
  const std::uint64_t key = key_of(live_->run().world().discs());
  if (std::exchange(world_key_, key) == key) return;
  ++scene_extras_;
  changes_.scene = changes_.starts = true;
}

void Session::Parts::look_at_starts() {
  const auto count = live_ ? std::ranges::count(live_->run().fleet().robots(), fleet::RobotLife::kNotStarted,
                                                &fleet::FleetRobot::life)
                           : 0;
  const auto now = static_cast<std::size_t>(count);
  if (std::exchange(not_started_, now) != now) changes_.starts = true;
}

// What came into the world without standing in a text is shown after the rest.
void Session::Parts::fill_scene(ToBrowser& out) const {
  Scene& scene = *out.mutable_scene();
  scene = documents_.scene();
  constexpr std::uint64_t kRoom = 1U << 20U;
  scene.set_revision(scene.revision() * kRoom + scene_extras_ % kRoom);
  if (!live_) return;
  std::vector<Round> shown;
  for (const Obstacle& obstacle : scene.obstacles())
    shown.emplace_back(obstacle.x(), obstacle.y(), obstacle.radius());
  std::ranges::sort(shown);
  for (const binding::Disc& disc : live_->run().world().discs()) {
    if (std::ranges::binary_search(shown, Round{disc.center.x, disc.center.y, disc.radius})) continue;
    Obstacle& extra = *scene.add_obstacles();
    extra.set_x(disc.center.x);
    extra.set_y(disc.center.y);
    extra.set_radius(disc.radius);
  }
}

void Session::Parts::fill_details(const Watch& watch, Frame& out) {
  const fleet::MissionRun& run = live_->run();
  const std::vector<std::string> paths(watch.ports().begin(), watch.ports().end());
  for (const std::uint32_t id : watch.details()) {
    const fleet::FleetRobot* robot = run.fleet().find({id});
    if (robot == nullptr) continue;
    RobotDetail& told = *out.add_details();
    DetailWishes wishes = {watch.with_ports(), watch.with_readings(), live_->transitions().before(id)};
    if (watch.ports_size() > 0 && robot->workings().program)
      wishes.some_ports = port_indices(*robot->workings().program, paths);
    encode_detail(run, live_->estimates(), *robot, wishes, told);
    live_->transitions().encode(id, told);
    Sentences& sentences = sentences_[id];
    if (!time_runs_ || now() - sentences.wall > kSentencesEvery) sentences = {now(), waits_for(run, *robot)};
    for (const std::string& line : sentences.lines) out.mutable_details()->rbegin()->add_waits_for(line);
  }
}

void Session::Parts::fill_series(Channel& channel, SeriesData& out) {
  for (const Series& series : channel.watched().series()) {
    double& seen = channel.series_seen.try_emplace(series.id(), -1.0).first->second;
    SeriesData::Samples told;
    told.set_id(series.id());
    live_->series().encode_since(series, seen, *told.mutable_samples());
    if (told.samples().empty()) told.set_error(problem_of(live_->run(), series));
    if (told.samples().empty() && told.error().empty()) continue;
    seen = live_->series().last_time(series, seen);
    *out.add_samples() = std::move(told);
  }
}

void Session::Parts::read_series(const ReadSeries& read, Reply& reply) const {
  SeriesData& out = *reply.mutable_series();
  int count = 0;
  for (const Series& series : read.series()) {
    if (++count > static_cast<int>(Channel::kMostSeries)) return;
    SeriesData::Samples& told = *out.add_samples();
    told.set_id(series.id());
    if (!live_) {
      told.set_error("there is no run");
      continue;
    }
    live_->series().encode_since(series, -1.0, *told.mutable_samples());
    if (!told.samples().empty()) continue;
    told.set_error(problem_of(live_->run(), series));
    if (told.error().empty() && !live_->series().is_recorded(series))
      told.set_error("it has not been watched, so it was not recorded");
  }
}

}  // namespace mlab::console
