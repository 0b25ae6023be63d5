#include <algorithm>
#include <utility>

#include "mlab/console/overview.h"
#include "mlab/console/session_parts.h"
#include "mlab/console/status_encoder.h"

namespace mlab::console {
namespace {

constexpr double kStatusApart = 0.05;  // two that tell of something that happened [s]
constexpr double kStatusEvery = 0.25;  // while time passes [s]
constexpr double kBeatEvery = 0.2;     // a little more often than the loop looks around at least [s]

std::uint32_t count_of(std::size_t size) {
  return static_cast<std::uint32_t>(size);
}

std::shared_ptr<const std::string> bytes_of(const ToBrowser& message) {
  return std::make_shared<const std::string>(message.SerializeAsString());
}

}  // namespace

void Session::Parts::send(ConnectionId to, const ToBrowser& message) {
  send_(to, bytes_of(message));
}

void Session::Parts::broadcast(const ToBrowser& message) {
  if (channels_.empty()) return;
  const auto bytes = bytes_of(message);
  for (const auto& [id, channel] : channels_) send_(id, bytes);
}

void Session::Parts::fill_roster(ToBrowser& out) const {
  Roster& roster = *out.mutable_roster();
  roster.Clear();
  if (live_) encode_roster(live_->run(), roster);
}

void Session::Parts::fill_starts(ToBrowser& out) {
  Starts& starts = *out.mutable_starts();
  starts.Clear();
  if (live_) encode_starts(live_->run(), *starts.mutable_robots());
}

void Session::Parts::fill_plan(ToBrowser& out) const {
  Plan& plan = *out.mutable_plan();
  plan.Clear();
  plan.set_revision(plan_revision_);
  if (!live_) return;
  encode_plan(
      live_->run().mission(), plan_revision_,
      [this](const text::Place& place) { return documents_.place(place); }, plan);
}

void Session::Parts::fill_questions(ToBrowser& out) const {
  Questions& questions = *out.mutable_questions();
  questions.Clear();
  if (live_) encode_questions(live_->run().state(), live_->asked(), live_->question_texts(), questions);
}

Status Session::Parts::status_message() const {
  Status out;
  const double wall = now();
  if (live_) {
    encode_run(live_->run(), live_->estimates(), out);
    for (const std::string& option : options_on(live_->options())) out.add_options(option);
    out.set_zoom_percent(live_->options().zoom_percent);
  } else {
    out.set_seed(seed_);
  }
  teleoperations_.encode(out);
  if (is_stopped_) {
    out.set_mode(Status::STOPPED);
    out.mutable_stop()->set_robots(live_ ? count_of(live_->run().robots_in_world()) : 0);
    out.mutable_stop()->set_standing(live_ ? count_of(live_->run().robots_stopped()) : 0);
  }
  out.set_speed(pace_.speed());
  out.set_speed_reached(meter_.speed(wall));
  if (time_runs_) out.set_behind(pace_.behind(wall, sim_time()));
  return out;
}

void Session::Parts::publish() {
  if (live_ && live_->take_news()) changes_.status = changes_.questions = true;
  publish_state();
  publish_breakpoints();
  for (auto& [id, channel] : channels_) publish_log(channel);
  publish_frames();
  publish_beats();
}

void Session::Parts::publish_state() {
  const double wall = now();
  look_at_starts();
  ToBrowser out;
  if (std::exchange(changes_.project, false)) {
    *out.mutable_project() = documents_.project_message();
    broadcast(out);
  }
  if (std::exchange(changes_.documents, false)) {
    *out.mutable_documents() = documents_.documents_message();
    broadcast(out);
  }
  if (std::exchange(changes_.scene, false)) {
    fill_scene(out);
    broadcast(out);
  }
  if (std::exchange(changes_.roster, false)) {
    fill_roster(out);
    broadcast(out);
  }
  if (std::exchange(changes_.starts, false)) {
    fill_starts(out);
    broadcast(out);
  }
  if (std::exchange(changes_.plan, false)) {
    fill_plan(out);
    broadcast(out);
  }
  const bool is_due = (changes_.status && wall >= last_status_ + kStatusApart) ||
                      (time_runs_ && wall >= last_status_ + kStatusEvery);
  if (is_due) {
    changes_.status = false;
    last_status_ = wall;
    look_at_world();
    update_watches();
    if (!channels_.empty()) {
      *out.mutable_status() = status_message();
      broadcast(out);
    }
  }
  if (std::exchange(changes_.questions, false)) {
    fill_questions(out);
    broadcast(out);
  }
  if (std::exchange(changes_.clients, false)) {
    out.mutable_clients()->Clear();
    roles_.encode(*out.mutable_clients());
    broadcast(out);
  }
  if (std::exchange(changes_.edits, false)) {
    *out.mutable_edits() = documents_.edit_state();
    broadcast(out);
  }
  if (std::exchange(changes_.trails, false)) {
    out.mutable_trails()->Clear();
    if (live_) live_->trails().encode(*out.mutable_trails());
    broadcast(out);
  }
}

void Session::Parts::publish_log(Channel& channel) {
  const bool has_alerts = channel.alerts_seen == log_.alerts_after();
  if (channel.log_seen == log_.last() && has_alerts) return;
  channel.alerts_seen = log_.alerts_after();
  ToBrowser out;
  log_.encode_since(channel.log_seen, *out.mutable_log());
  channel.log_seen = log_.last();
  send(channel.connection(), out);
}

void Session::Parts::send_beat(const Channel& channel) {
  ToBrowser out;
  out.mutable_beat()->set_number(channel.beat);
  send(channel.connection(), out);
}

void Session::Parts::publish_beats() {
  const double wall = now();
  if (wall < last_beats_ + kBeatEvery) return;
  last_beats_ = wall;
  for (const auto& [id, channel] : channels_) send_beat(channel);
}

void Session::Parts::publish_frames() {
  const double wall = now();
  for (auto& [id, channel] : channels_) {
    if (channel.seen == version_ || !channel.wants_frame(wall)) continue;
    ToBrowser out;
    fill_frame(channel, *out.mutable_frame());
    out.mutable_frame()->set_number(channel.begin_frame(wall));
    channel.seen = version_;
    send(id, out);
  }
}

void Session::Parts::fill_frame(Channel& channel, Frame& out) {
  out.set_time(sim_time());
  if (!live_) return;
  const fleet::MissionRun& run = live_->run();
  if (rows_version_ != version_) {
    rows_.gather(run, live_->alarms().robots(), teleoperations_.robots());
    rows_version_ = version_;
  }
  const Watch& watch = channel.watched();
  const auto view = watch.has_view() ? std::optional<Box>(watch.view()) : std::nullopt;
  out.set_cycle(run.cycle());
  out.set_robots_elsewhere(rows_.encode(view, *out.mutable_robots()));
  if (watch.with_stations()) encode_stations(run, *out.mutable_stations());
  if (watch.with_vectors()) encode_vectors(run, *out.mutable_vectors());
  encode_objects(run, *out.mutable_objects());
  fill_details(watch, out);
  fill_series(channel, *out.mutable_series());
}

}  // namespace mlab::console
