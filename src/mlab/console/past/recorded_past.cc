#include "mlab/console/past/recorded_past.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string_view>

#include "mlab/console/published/colors.h"
#include "mlab/console/published/failsafe_encoder.h"
#include "mlab/console/published/frame_encoder.h"
#include "mlab/console/published/overview.h"
#include "mlab/console/published/wire.h"
#include "mlab/console/run/trail_recorder.h"
#include "mlab/lang/odl/odl.h"

namespace mlab::console {
namespace {

constexpr double kFarthest = 1e7;     // from the origin, that something is shown [m]
constexpr double kUsualRadius = 0.5;  // of a robot whose body isn't known: as the simulator's own has it [m]
constexpr std::uint32_t kNoRecordedProgram = 0xffffffff;
constexpr std::uint8_t kRuns = 1;  // of the flags of Frame.robots

bool is_shown(const wire::HistoryPoses& poses, int i) {
  const auto is_near = [](float value) {
    return std::isfinite(value) && std::abs(static_cast<double>(value)) < kFarthest;
  };
  return is_near(poses.x(i)) && is_near(poses.y(i)) && std::isfinite(poses.heading(i));
}

Status::Outcome recorded_outcome(const std::string& told) {
  return told == "done" ? Status::DONE : told == "failed" ? Status::FAILED : Status::ABORTED;
}

// What another version has written may name texts that are not there.
wire::HistoryMission with_known_texts(const history::History& history, const wire::HistoryMission& told) {
  wire::HistoryMission out = told;
  out.clear_texts();
  bool has_own = false;
  std::string other;
  for (const std::uint32_t id : told.texts()) {
    const text::SourcePtr source = history.text(id);
    if (!source) continue;
    out.add_texts(id);
    has_own = has_own || source->name() == told.path();
    if (other.empty() && source->name().ends_with(".mdl")) other = source->name();
  }
  if (!has_own) out.set_path(other);
  return out;
}

std::map<std::uint32_t, const Roster::Unit*> units_of(const Roster& roster) {
  std::map<std::uint32_t, const Roster::Unit*> out;
  for (const Roster::Unit& unit : roster.units()) {
    for (const std::uint32_t member : unit.members()) {
      const Roster::Unit*& smallest = out[member];
      if (smallest == nullptr || unit.members_size() < smallest->members_size()) smallest = &unit;
    }
  }
  return out;
}

}  // namespace

RecordedPast::RecordedPast(std::shared_ptr<const history::History> history, history::ReplayTools tools)
    : history_(std::move(history)), tools_(std::move(tools)) {
  std::set<std::uint32_t> robots;
  moments_.emplace_back(0, 0.0);
  const auto reach = [this](std::uint64_t cycle, double time) {
    if (cycle > moments_.back().first) moments_.emplace_back(cycle, std::max(time, moments_.back().second));
  };
  for (const history::PosesEntry& one : history_->poses()) {
    reach(one.cycle, one.time);
    for (int i = 0; i < one.poses.robots_size(); ++i) {
      if (is_shown(one.poses, i)) robots.insert(one.poses.robots(i));
      if (robots.size() > kMostRobots) robots.erase(std::prev(robots.end()));
    }
  }
  reach(history_->last_cycle(), history_->last_time());
  robots_.assign(robots.begin(), robots.end());
  for (const history::EventEntry& one : history_->events())
    log_.add(one.time, {one.is_warning ? Log::WARNING : Log::MESSAGE, clean(one.text), 0, "", {}, false});
  changes_.emplace_back(0, &history_->beginning().mission());
  for (const history::InputEntry& one : history_->inputs()) {
    if (one.input.has_exchanged()) changes_.emplace_back(one.moment.cycle, &one.input.exchanged().mission());
  }
}

// ---- moments

double RecordedPast::time_of(std::uint64_t cycle) const {
  const auto next = std::ranges::lower_bound(moments_, cycle, {}, &std::pair<std::uint64_t, double>::first);
  if (next == moments_.end()) return moments_.back().second;
  if (next->first == cycle || next == moments_.begin()) return next->second;
  const auto& [from, begin] = *std::prev(next);
  const double share = static_cast<double>(cycle - from) / static_cast<double>(next->first - from);
  return begin + share * (next->second - begin);
}

// As if all cycles between two entries took equally long.
std::uint64_t RecordedPast::cycle_at(double time) const {
  const auto next = std::ranges::upper_bound(moments_, time, {}, &std::pair<std::uint64_t, double>::second);
  if (next == moments_.end()) return moments_.back().first;
  if (next == moments_.begin()) return 0;
  const auto& [from, begin] = *std::prev(next);
  const double share = (time - begin) / (next->second - begin);
  return from +
         static_cast<std::uint64_t>(std::floor(share * static_cast<double>(next->first - from) + 1e-6));
}

const history::PosesEntry* RecordedPast::poses_at(std::uint64_t cycle) const {
  const std::vector<history::PosesEntry>& all = history_->poses();
  const auto next = std::ranges::upper_bound(all, cycle, {}, &history::PosesEntry::cycle);
  return next == all.begin() ? nullptr : &*std::prev(next);
}

PastPicture RecordedPast::picture(const PastWish& wish) {
  PastPicture out;
  out.cycle = std::min(wish.time ? cycle_at(*wish.time) : wish.cycle, history_->last_cycle());
  out.time = wish.time ? std::min(*wish.time, history_->last_time()) : time_of(out.cycle);
  out.told = wish.told;
  tell_version(version_at(out.cycle), out);
  Status& status = *out.messages.emplace_back().mutable_status();
  const bool is_over = history_->end() && out.cycle >= history_->last_cycle();
  status.set_mode(is_over ? Status::ENDED : Status::RUNNING);
  if (is_over) status.set_outcome(recorded_outcome(history_->end()->outcome));
  status.set_time(out.time);
  status.set_cycle(out.cycle);
  status.set_seed(history_->beginning().seed());
  if (wish.with_trails) tell_trails(out.cycle, *out.messages.emplace_back().mutable_trails());
  out.frame.set_time(out.time);
  out.frame.set_cycle(out.cycle);
  if (const history::PosesEntry* entry = poses_at(out.cycle)) {
    const wire::HistoryPoses& poses = entry->poses;
    for (int i = 0; i < poses.robots_size(); ++i) {
      if (!is_shown(poses, i) || !std::ranges::binary_search(robots_, poses.robots(i))) continue;
      append(*out.frame.mutable_robots(),
             RobotRows::Row{poses.robots(i), poses.x(i), poses.y(i),
                            packed_heading(static_cast<double>(poses.heading(i))), kRuns, 0});
    }
  }
  return out;
}

// ---- what the run was of

RecordedPast::Version RecordedPast::read(const wire::HistoryMission& told) const {
  Version out;
  const wire::HistoryMission known = with_known_texts(*history_, told);
  out.texts.emplace(*history_, known, 1);
  history::Remaker remaker(history_, tools_);
  text::Diagnostics problems;
  out.mission = remaker.read(known, problems);
  if (out.mission) {
    out.overlay = out.mission->overlay;
    return out;
  }
  // The map alone may be readable all the same.
  for (const std::uint32_t id : known.texts()) {
    const text::SourcePtr source = history_->text(id);
    if (source->name().ends_with(".odl"))
      odl::apply(odl::parse(source, problems), out.overlay, problems, odl::Companions::kIgnore);
  }
  return out;
}

const RecordedPast::Version& RecordedPast::version_at(std::uint64_t cycle) {
  // What comes in after a cycle is there from the next one on.
  std::size_t at = 0;
  while (at + 1 < changes_.size() && changes_[at + 1].first < cycle) ++at;
  if (!version_ || version_->number != at + 1) {
    version_ = read(*changes_[at].second);
    version_->number = at + 1;
  }
  return *version_;
}

void RecordedPast::tell_version(const Version& version, PastPicture& out) const {
  if (out.told.recorded == version.number) return;
  out.told = {};
  out.told.recorded = version.number;
  const PlaceOf place_of = [&version](const text::Place& place) { return version.texts->place(place); };
  Scene& scene = *out.messages.emplace_back().mutable_scene();
  scene = encode_scene(version.overlay, place_of);
  scene.clear_picture();
  *out.messages.emplace_back().mutable_documents() = version.texts->message();
  tell_roster(version, *out.messages.emplace_back().mutable_roster());
  out.messages.emplace_back().mutable_starts();
  Plan& plan = *out.messages.emplace_back().mutable_plan();
  plan.set_revision(version.number);
  Failsafes failsafes;
  if (version.mission) {
    encode_plan(*version.mission, version.number, place_of, plan);
    encode_failsafes(*version.mission, place_of, failsafes);
  }
  *out.messages.emplace_back().mutable_failsafes() = std::move(failsafes);
  out.messages.emplace_back().mutable_questions();
  out.messages.emplace_back().mutable_held_values();
}

void RecordedPast::tell_roster(const Version& version, Roster& out) const {
  if (version.mission) encode_units(*version.mission, out);
  const auto units = units_of(out);
  std::map<std::uint32_t, const mission::RobotType*> types;
  if (version.mission) {
    for (const mission::Robot& robot : version.mission->robots)
      types[robot.id.value] = &version.mission->types[robot.type];
  }
  for (const std::uint32_t id : robots_) {
    Roster::Robot& told = *out.add_robots();
    told.set_id(id);
    const auto type = types.find(id);
    told.set_type(type == types.end() ? "ROBOT" : clean(type->second->name));
    told.set_color(rgb_of(type == types.end() ? "" : type->second->color));
    told.set_radius(kUsualRadius);
    const double length = version.mission ? version.mission->options.robot_length : 0.0;
    told.set_length(length > 0.0 ? length : 2.0 * kUsualRadius);
    if (const auto unit = units.find(id); unit != units.end()) told.set_unit(unit->second->name());
    told.set_program(kNoRecordedProgram);
  }
}

void RecordedPast::tell_trails(std::uint64_t cycle, Trails& out) const {
  const std::vector<history::PosesEntry>& all = history_->poses();
  const auto count = static_cast<std::size_t>(
      std::ranges::upper_bound(all, cycle, {}, &history::PosesEntry::cycle) - all.begin());
  if (robots_.empty() || count == 0) return;
  const std::size_t most =
      std::clamp<std::size_t>(TrailRecorder::kMostPoints / robots_.size(), 2, TrailRecorder::kMostOfOne);
  const std::size_t stride = count / most + 1;
  std::map<std::uint32_t, std::string> points;
  for (std::size_t i = 0; i < count; ++i) {
    if (i % stride != 0 && i + 1 != count) continue;
    const wire::HistoryPoses& poses = all[i].poses;
    for (int k = 0; k < poses.robots_size(); ++k) {
      if (!is_shown(poses, k) || !std::ranges::binary_search(robots_, poses.robots(k))) continue;
      std::string& of = points[poses.robots(k)];
      append(of, poses.x(k));
      append(of, poses.y(k));
      append(of, static_cast<float>(all[i].time));
    }
  }
  for (auto& [id, bytes] : points) {
    Trails::Trail& told = *out.add_trails();
    told.set_robot(id);
    told.set_points(std::move(bytes));
  }
}

}  // namespace mlab::console
