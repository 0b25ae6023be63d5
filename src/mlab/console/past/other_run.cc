#include "mlab/console/past/other_run.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <system_error>

#include <fmt/core.h>

#include "mlab/console/published/overview.h"
#include "mlab/console/run/told_effects.h"
#include "mlab/console/session/request.h"
#include "mlab/history/digest.h"
#include "mlab/history/history_writer.h"
#include "mlab/history/recorded_names.h"
#include "mlab/history/recording_file.h"
#include "mlab/run/report.h"

namespace mlab::console {
namespace {

constexpr double kMostPlaces = 400'000.0;  // of all robots together: what a browser is told in one message
constexpr double kMostSamples = 600.0;     // of one robot
constexpr double kFewestSamples = 50.0;
constexpr std::size_t kOwn = 0;
constexpr std::size_t kOther = 1;
constexpr std::uint64_t kFarAhead = 5'000'000;  // cycles; `until` ends it before
constexpr float kNowhere = std::numeric_limits<float>::quiet_NaN();

const fleet::FleetRobot* in_world(const run::MissionRun& run, std::uint32_t id) {
  const fleet::FleetRobot* const robot = run.fleet().find({id});
  return robot != nullptr && robot->life != fleet::RobotLife::kNotStarted ? robot : nullptr;
}

// A folder that nobody else knows, and that goes with it.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path(error_) / "mlab-XXXXXX").string();
    if (!error_ && mkdtemp(name.data()) != nullptr) path_ = name;
  }
  ~ScratchFolder() {
    if (!path_.empty()) std::filesystem::remove_all(path_, error_);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::error_code error_;
  std::string path_;
};

// Why a run that is not over has come to a stand.
std::string why_it_stands(const run::MissionRun& run) {
  if (run.is_stopped()) return "stands: emergency stop";
  if (!run.state().questions.empty()) return "waits for an answer";
  return run.state().paused ? "is paused" : "waits for an operator";
}

}  // namespace

std::unique_ptr<OtherRun> OtherRun::compare(std::unique_ptr<history::Replay> own,
                                            std::shared_ptr<const history::History> other,
                                            const history::ReplayTools& tools, Settings settings,
                                            text::Diagnostics& sink) {
  auto replay = history::Replay::make(std::move(other), tools, sink);
  if (!replay) return nullptr;
  return std::unique_ptr<OtherRun>(new OtherRun(std::move(own), std::move(replay), std::move(settings)));
}

std::unique_ptr<OtherRun> OtherRun::depart(const history::Timeline& line,
                                           std::shared_ptr<history::History> other, Settings settings,
                                           text::Diagnostics& sink) {
  other->reach(other->last_cycle() + kFarAhead, settings.until);
  history::Timeline::Fork fork = line.fork(std::move(other), settings.known.cycle);
  // Whoever has written a text is told of its errors at once.
  if (auto why = fork.other->why_not_understood(settings.from_cycle)) {
    sink.error("not-understood", {}, std::move(*why));
    return nullptr;
  }
  return std::unique_ptr<OtherRun>(
      new OtherRun(std::move(fork.own), std::move(fork.other), std::move(settings)));
}

OtherRun::OtherRun(std::unique_ptr<history::Replay> own, std::unique_ptr<history::Replay> other,
                   Settings settings)
    : settings_(std::move(settings)), next_sample_(settings_.from) {
  sides_[kOwn].replay = std::move(own);
  sides_[kOther].replay = std::move(other);
  for (Side& side : sides_) side.alarms = settings_.known.alarms;
  const auto robots =
      static_cast<double>(std::max<std::size_t>(1, sides_[kOther].replay->run().fleet().robots().size()));
  const double most = std::clamp(kMostPlaces / robots, kFewestSamples, kMostSamples);
  spacing_ = std::max(0.0, (settings_.until - settings_.from) / most);
  begin_listening();
}

void OtherRun::begin_listening() {
  for (const std::size_t side : {kOwn, kOther}) {
    run::MissionRun& run = sides_[side].replay->run();
    run.set_observer(
        [this, side, &run](const mission::Effect& effect) { tell_effect(run, effect, sides_[side].log); });
  }
}

// ---- computing

bool OtherRun::advance(double seconds) {
  const double end = wall_time() + seconds;
  while (is_under_way_) {
    if (!has_departed_ && sides_[kOther].replay->run().cycle() == settings_.from_cycle && !depart()) break;
    if (!goes_on(kOwn) && !goes_on(kOther)) {
      finish();
      break;
    }
    step_behind();
    look_for_parting();
    note_most_apart();
    sample();
    if (wall_time() >= end) break;
  }
  return is_under_way_;
}

bool OtherRun::goes_on(std::size_t side) const {
  return !sides_[side].is_over && sides_[side].replay->run().time() < settings_.until - 1e-9;
}

// Both are at the moment.
bool OtherRun::depart() {
  if (goes_on(kOwn) && sides_[kOwn].replay->run().cycle() < settings_.from_cycle) return true;
  has_departed_ = true;
  for (Side& side : sides_) side.log = {};
  run::MissionRun& run = sides_[kOther].replay->run();
  takeovers_before_ = run.takeovers().size();
  awaits_takeover_ = settings_.takes_over;
  if (const auto error = set_parameters(run)) {
    fail(*error);
    return false;
  }
  note_before(kOwn);
  note_before(kOther);
  next_sample_ = settings_.from;
  sample();
  return true;
}

std::optional<std::string> OtherRun::set_parameters(run::MissionRun& run) const {
  for (const WhatIf::Parameter& one : settings_.parameters) {
    for (const std::uint32_t robot : one.robots()) {
      if (auto error = run.set_parameter({robot}, one.port(), one.value())) return error;
    }
  }
  return std::nullopt;
}

// What each has driven before it departs is none of its future.
void OtherRun::note_before(std::size_t side) {
  const run::MissionRun& run = sides_[side].replay->run();
  for (const fleet::FleetRobot& robot : run.fleet().robots()) {
    if (in_world(run, robot.id.value) == nullptr) continue;
    const binding::BodyState body = run.world().body(robot.body);
    Track& track = tracks_[robot.id.value];
    track.driven_before[side] = body.distance_driven;
    track.contacts_before[side] = body.contacts;
  }
}

// The one whose time is behind the other's.
void OtherRun::step_behind() {
  const double own = sides_[kOwn].replay->run().time();
  const double other = sides_[kOther].replay->run().time();
  const bool is_own = goes_on(kOwn) && (!goes_on(kOther) || own <= other);
  step(is_own ? kOwn : kOther);
}

void OtherRun::step(std::size_t side) {
  history::Replay& replay = *sides_[side].replay;
  if (!replay.step()) {
    end(side);
    return;
  }
  if (replay.run().cycle() > settings_.known.cycle) sides_[side].alarms.look(replay.run(), sides_[side].log);
  if (side != kOther) return;
  if (std::exchange(awaits_takeover_, false) && replay.run().takeovers().size() == takeovers_before_)
    fail("robots that run can't go on with these programs at that moment");
}

// It goes no further than it was recorded.
bool OtherRun::is_written(std::size_t side) const {
  return side == kOwn ? settings_.is_of_recording : settings_.is_recording;
}

void OtherRun::end(std::size_t side) {
  Side& one = sides_[side];
  one.is_over = true;
  one.replay->settle();
  const run::MissionRun& run = one.replay->run();
  const auto& divergence = one.replay->divergence();
  if (divergence && !divergence->stands && side == kOther) {
    fail(fmt::format("it can't be computed beyond cycle {}: {}", divergence->cycle, divergence->why));
    return;
  }
  const auto& recorded = one.replay->history().end();
  if (divergence && !divergence->stands)
    one.outcome = fmt::format("can't be computed any further: {}", divergence->why);
  else if (recorded)
    one.outcome = recorded->outcome;
  else if (run.is_over())
    one.outcome = run::outcome_name(run, run::RunEnd::kByItself);
  else if (is_written(side))
    one.outcome = "cut off";
  else
    one.outcome = side == kOther && !settings_.is_recording ? why_it_stands(run) : "goes on";
}

void OtherRun::fail(const std::string& problem) {
  problem_ = clean(problem);
  is_under_way_ = false;
  told_ = told_apart(sides_[kOwn].log, sides_[kOther].log);
}

// As far as it is wanted may be just where it ended.
void OtherRun::end_where_it_stopped(std::size_t side) {
  history::Replay& replay = *sides_[side].replay;
  if (sides_[side].is_over) return;
  if (is_written(side) && replay.run().cycle() >= replay.history().last_cycle()) {
    replay.step();  // what is written of its end
    end(side);
    return;
  }
  replay.settle();
  if (!is_written(side) && replay.run().is_over()) end(side);
}

void OtherRun::finish() {
  is_under_way_ = false;
  for (const std::size_t side : {kOwn, kOther}) {
    const run::MissionRun& run = sides_[side].replay->run();
    end_where_it_stopped(side);
    if (sides_[side].outcome.empty()) sides_[side].outcome = "goes on";
    for (auto& [id, track] : tracks_) {
      OtherFuture::Robot::Fate& fate = side == kOwn ? *track.told.mutable_own() : *track.told.mutable_other();
      const fleet::FleetRobot* const robot = in_world(run, id);
      fate.set_is_there(robot != nullptr);
      if (robot == nullptr) continue;
      const binding::BodyState body = run.world().body(robot->body);
      fate.set_driven(std::max(0.0, body.distance_driven - track.driven_before[side]));
      fate.set_contacts(body.contacts - std::min(body.contacts, track.contacts_before[side]));
      fate.set_state(std::string(fleet::name(robot->life)));
    }
  }
  told_ = told_apart(sides_[kOwn].log, sides_[kOther].log);
}

// ---- what is kept

void OtherRun::look_for_parting() {
  if (parting_ || sides_[kOwn].is_over || sides_[kOther].is_over) return;
  const run::MissionRun& own = sides_[kOwn].replay->run();
  const run::MissionRun& other = sides_[kOther].replay->run();
  if (own.cycle() != other.cycle() || history::digest_of(own) == history::digest_of(other)) return;
  parting_.emplace();
  parting_->set_cycle(other.cycle());
  parting_->set_time(other.time());
}

void OtherRun::sample() {
  if (!has_departed_) return;
  double now = std::numeric_limits<double>::infinity();
  for (const Side& side : sides_) {
    if (!side.is_over) now = std::min(now, side.replay->run().time());
  }
  if (!std::isfinite(now) || now < next_sample_ - 1e-9) return;
  if (!times_.empty() && static_cast<float>(now) <= times_.back()) return;
  next_sample_ = std::max(next_sample_ + spacing_, now);
  times_.push_back(static_cast<float>(now));
  for (const Side& side : sides_) {
    for (const fleet::FleetRobot& robot : side.replay->run().fleet().robots()) {
      if (robot.life != fleet::RobotLife::kNotStarted) tracks_[robot.id.value];
    }
  }
  for (auto& [id, track] : tracks_) sample(track, id);
}

void OtherRun::sample(Track& track, std::uint32_t id) {
  OtherFuture::Robot& out = track.told;
  const int before = static_cast<int>(times_.size()) - 1;
  for (auto* const values : {out.mutable_x(), out.mutable_y(), out.mutable_heading(), out.mutable_apart()}) {
    while (values->size() < before) values->Add(kNowhere);
  }
  std::optional<geom::Pose> poses[2];
  for (const std::size_t side : {kOwn, kOther}) {
    const run::MissionRun& run = sides_[side].replay->run();
    const fleet::FleetRobot* const robot = in_world(run, id);
    if (robot == nullptr) continue;
    if (!sides_[side].is_over) poses[side] = run.fleet().pose(*robot);
    const binding::BodyState body = run.world().body(robot->body);
    OtherFuture::Robot::Fate& fate = side == kOwn ? *out.mutable_own() : *out.mutable_other();
    if (body.contacts > track.contacts_before[side] && !fate.has_first_contact())
      fate.set_first_contact(run.time());
  }
  const auto& place = poses[kOther];
  out.add_x(place ? static_cast<float>(place->position.x) : kNowhere);
  out.add_y(place ? static_cast<float>(place->position.y) : kNowhere);
  out.add_heading(place ? static_cast<float>(place->heading) : kNowhere);
  double apart = std::numeric_limits<double>::quiet_NaN();
  if (place && poses[kOwn]) apart = geom::distance(place->position, poses[kOwn]->position);
  out.add_apart(static_cast<float>(apart));
}

// Of every cycle that both have, as `mlab compare` does, whatever is sampled.
void OtherRun::note_most_apart() {
  if (!has_departed_ || sides_[kOwn].is_over || sides_[kOther].is_over) return;
  const run::MissionRun& own = sides_[kOwn].replay->run();
  const run::MissionRun& other = sides_[kOther].replay->run();
  if (std::abs(own.time() - other.time()) > 1e-9) return;
  for (const fleet::FleetRobot& robot : own.fleet().robots()) {
    const fleet::FleetRobot* const there = in_world(other, robot.id.value);
    if (there == nullptr || in_world(own, robot.id.value) == nullptr) continue;
    OtherFuture::Robot& told = tracks_[robot.id.value].told;
    const double apart =
        geom::distance(own.fleet().pose(robot).position, other.fleet().pose(*there).position);
    if (!(apart > told.most_apart())) continue;
    told.set_most_apart(apart);
    told.set_most_apart_at(own.time());
  }
}

// ---- what is told

void OtherRun::encode(OtherFuture& out) const {
  out.set_name(clean(settings_.name));
  out.set_is_recording(settings_.is_recording);
  for (const std::string& one : settings_.changes) out.add_changes(clean(one));
  for (const std::string& one : settings_.remarks) out.add_remarks(clean(one));
  out.set_from_cycle(settings_.from_cycle);
  out.set_from(settings_.from);
  out.set_until(settings_.until);
  out.set_computed_to(sides_[kOther].replay->run().time());
  out.set_is_under_way(is_under_way_);
  out.set_problem(problem_);
  if (is_under_way_) return;
  out.mutable_told_own()->Assign(told_.alone[kOwn].begin(), told_.alone[kOwn].end());
  out.mutable_told_other()->Assign(told_.alone[kOther].begin(), told_.alone[kOther].end());
  out.set_told_left_out(told_.left_out);
  if (!problem_.empty()) return;
  if (parting_) *out.mutable_parting() = *parting_;
  for (const std::size_t side : {kOwn, kOther}) {
    const run::MissionRun& run = sides_[side].replay->run();
    OtherFuture::End& end = side == kOwn ? *out.mutable_own() : *out.mutable_other();
    end.set_outcome(clean(sides_[side].outcome));
    end.set_time(run.time());
    end.set_cycle(run.cycle());
    end.set_digest(history::digest_of(run));
  }
  out.mutable_times()->Assign(times_.begin(), times_.end());
  for (const auto& [id, track] : tracks_) {
    OtherFuture::Robot& told = *out.add_robots();
    told = track.told;
    told.set_robot(id);
  }
}

// As `advance` computes it, with all that is told on the way.
std::vector<wire::HistoryEntry> OtherRun::written() const {
  std::vector<wire::HistoryEntry> out;
  const std::unique_ptr<history::Replay> replay = sides_[kOther].replay->again();
  run::MissionRun& run = replay->run();
  history::HistoryWriter writer([&out](const wire::HistoryEntry& entry) { out.push_back(entry); });
  const wire::HistoryBeginning& then = replay->history().beginning();
  writer.begin(run, {settings_.version,
                     {then.overlay_folders().begin(), then.overlay_folders().end()},
                     then.obstacle_seed(),
                     then.started_at()});
  writer.note_cycle();
  run.set_observer([&writer](const mission::Effect& effect) { writer.see(effect); });
  bool has_stopped = false;
  for (bool has_departed = false; !has_stopped;) {
    if (!has_departed && run.cycle() == settings_.from_cycle) {
      has_departed = true;
      static_cast<void>(set_parameters(run));  // it was no error before
    }
    if (run.time() >= settings_.until - 1e-9) break;
    has_stopped = !replay->step();
    if (!has_stopped) writer.note_cycle();
  }
  if (!has_stopped) replay->settle();
  const std::string& outcome = sides_[kOther].outcome;
  writer.end(outcome == "goes on" ? "interrupted" : outcome);
  return out;
}

std::optional<std::string> OtherRun::save(FutureRecording& out) {
  if (settings_.is_recording) return "it is a recording already";
  if (is_under_way_) return "it is still being computed";
  if (!problem_.empty()) return "there is none: " + problem_;
  const ScratchFolder folder;
  if (folder.path().empty()) return "there is no room for it: no file can be made on this machine";
  const std::string path = folder.path() + "/what_if.mcap";
  const auto file =
      history::RecordingWriter::create(path, sides_[kOther].replay->history().beginning().started_at());
  if (!file) return clean(file.error().message);
  const history::RecordedNames names(sides_[kOther].replay->run().crew()->mission->folder);
  for (const wire::HistoryEntry& entry : written()) (*file)->put(names.in_recording(entry));
  (*file)->close();
  if (!(*file)->problem().empty()) return clean((*file)->problem());
  std::ifstream in(path, std::ios::binary);
  out.mutable_content()->assign(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  out.set_name(fmt::format("what_if_{:.1f}s.mcap", settings_.from));
  return std::nullopt;
}

}  // namespace mlab::console
