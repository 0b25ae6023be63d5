#include "mlab/console/past/past_run.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "mlab/console/past/condition.h"
#include "mlab/console/published/failsafe_encoder.h"
#include "mlab/console/published/overview.h"
#include "mlab/console/published/robot_detail.h"
#include "mlab/console/published/status_encoder.h"
#include "mlab/console/published/watched.h"
#include "mlab/console/run/held_values.h"
#include "mlab/console/session/request.h"

namespace mlab::console {
namespace {

constexpr double kPiece = 0.5;  // that one answer may take, about [s]
constexpr std::size_t kMostSurveys = 8;
constexpr int kMostAsked = 64;  // series and robots of a request
// What nobody has asked for is computed up to this cycle, six days of ten cycles a second: who wrote a
// recording may claim what he likes.
constexpr std::uint64_t kMostAhead = 5'000'000;
constexpr std::size_t kUsualFound = 100;
constexpr std::size_t kMostFound = 10'000;
constexpr std::uint64_t kBackwards = 500;  // cycles that are searched ahead, to find the last one first

// Left out where the client knows it.
void add_small(ToBrowser message, PastPicture& out) {
  std::string bytes = message.SerializeAsString();
  std::string& known = out.told.bytes[message.body_case()];
  if (known == bytes) return;
  known = std::move(bytes);
  out.messages.push_back(std::move(message));
}

}  // namespace

// ---- the first pass

std::unique_ptr<PastRun> PastRun::make(std::shared_ptr<history::History> history, history::ReplayTools tools,
                                       Settings settings, text::Diagnostics& sink) {
  auto timeline = history::Timeline::make(history, std::move(tools), {}, sink);
  if (!timeline) return nullptr;
  return std::unique_ptr<PastRun>(new PastRun(std::move(history), std::move(settings), std::move(timeline)));
}

PastRun::PastRun(std::shared_ptr<history::History> history, Settings settings,
                 std::unique_ptr<history::Timeline> timeline)
    : settings_(std::move(settings)),
      history_(std::move(history)),
      timeline_(std::move(timeline)),
      notes_(timeline_->first_pass(), log_),
      times_{timeline_->first_pass().time()} {
  timeline_->set_observer([this](const mission::Effect& effect) { notes_.see(effect); });
  timeline_->set_watcher([this](const run::MissionRun& run) {
    notes_.look(true);
    alarms_.note(run.cycle(), notes_.alarms());
    times_.push_back(run.time());
  });
}

void PastRun::add(const std::vector<wire::HistoryEntry>& entries, std::uint64_t cycle, double time) {
  // They are our own, so nothing can be wrong with them.
  for (const wire::HistoryEntry& entry : entries) static_cast<void>(history_->add(entry));
  history_->reach(cycle, time);
}

bool PastRun::can_advance() const {
  return !timeline_->divergence() && timeline_->known_to() < history_->last_cycle() &&
         !settings_.ends.stop_requested();
}

bool PastRun::advance(double seconds) {
  return can_advance() && timeline_->known_to() < kMostAhead && timeline_->advance(seconds);
}

std::uint64_t PastRun::cycle_at(double time) {
  while (times_.back() < time && can_advance()) timeline_->advance(0.0);
  const auto next = std::ranges::upper_bound(times_, time + kMoment);
  return next == times_.begin() ? 0 : static_cast<std::uint64_t>(next - times_.begin() - 1);
}

double PastRun::time_of(std::uint64_t cycle) const {
  return cycle < times_.size() ? times_[cycle] : times_.back();
}

// ---- one moment

std::optional<std::string> PastRun::go_to(std::uint64_t cycle) {
  while (timeline_->known_to() < cycle && can_advance()) timeline_->advance(0.0);
  if (settings_.ends.stop_requested()) return "the session ends";
  const bool is_end = history_->end() && cycle >= history_->last_cycle();
  return is_end ? timeline_->go_to_end() : timeline_->go_to(cycle);
}

// The cycle before tells which transitions were made in this one.
std::optional<std::string> PastRun::go_to(std::uint64_t cycle, const Watch& watch,
                                          TransitionRecorder& transitions) {
  transitions.watch(std::vector<std::uint32_t>(watch.details().begin(), watch.details().end()));
  if (watch.details_size() > 0 && cycle > 0) {
    if (auto problem = go_to(cycle - 1)) return problem;
    transitions.look(timeline_->run());
  }
  if (auto problem = go_to(cycle)) return problem;
  transitions.change(timeline_->run());
  transitions.look(timeline_->run());
  return std::nullopt;
}

PastPicture PastRun::picture(const PastWish& wish) {
  PastPicture out;
  const std::uint64_t cycle = std::min(wish.time ? cycle_at(*wish.time) : wish.cycle, history_->last_cycle());
  TransitionRecorder transitions;
  if (auto problem = go_to(cycle, wish.watch, transitions)) {
    out.problem = std::move(*problem);
    return out;
  }
  const run::MissionRun& run = timeline_->run();
  if (wish.told.recorded == 0) out.told = wish.told;
  out.cycle = run.cycle();
  out.time = run.time();
  follow_version();
  tell_map(out);
  tell_mission(out);
  tell_state(out);
  if (wish.with_trails) tell_trails(out);
  fill(wish.watch, transitions, out.frame);
  return out;
}

DocumentPlace PastRun::place(const text::Place& place) const {
  if (texts_) return texts_->place(place);
  if (!place.source || !settings_.documents) return {};
  const auto found = settings_.documents->find(place.source->name());
  if (found == settings_.documents->end()) return {};
  return {found->second, place.source->line_column(place.span.begin).line};
}

// The texts of the mission that runs at the moment.
void PastRun::follow_version() {
  const run::MissionRun& run = timeline_->run();
  if (settings_.documents || version_ == run.crew()) return;
  version_ = run.crew();
  texts_.emplace(*history_, history_->version_at(run.cycle()), ++versions_);
}

void PastRun::tell_map(PastPicture& out) const {
  const run::MissionRun& run = timeline_->run();
  const std::uint64_t obstacles = obstacles_key(run.world());
  if (out.told.crew == run.crew() && out.told.obstacles == obstacles) return;
  out.told.obstacles = obstacles;
  ToBrowser message;
  Scene& scene = *message.mutable_scene();
  scene = encode_scene(run.mission().overlay, [this](const text::Place& where) { return place(where); });
  scene.clear_picture();
  if (settings_.picture) *scene.mutable_picture() = *settings_.picture;
  add_other_obstacles(run.world(), scene);
  out.messages.push_back(std::move(message));
}

void PastRun::tell_mission(PastPicture& out) const {
  const run::MissionRun& run = timeline_->run();
  const std::size_t not_started = count_not_started(run);
  const bool is_known = out.told.crew == run.crew();
  if (!is_known) {
    const PlaceOf place_of = [this](const text::Place& where) { return place(where); };
    if (texts_) *out.messages.emplace_back().mutable_documents() = texts_->message();
    encode_roster(run, *out.messages.emplace_back().mutable_roster());
    encode_plan(run.mission(), 1, place_of, *out.messages.emplace_back().mutable_plan());
    encode_failsafes(run.mission(), place_of, *out.messages.emplace_back().mutable_failsafes());
  }
  if (!is_known || out.told.not_started != not_started)
    encode_starts(run, *out.messages.emplace_back().mutable_starts()->mutable_robots());
  out.told.not_started = not_started;
  out.told.crew = run.crew();
}

void PastRun::tell_state(PastPicture& out) const {
  const run::MissionRun& run = timeline_->run();
  ToBrowser status;
  encode_run(run, Estimates(), *status.mutable_status());
  encode_options(notes_.options(), *status.mutable_status());
  add_small(std::move(status), out);
  ToBrowser questions;
  encode_questions(run.state(), notes_.asked(), notes_.question_texts(), *questions.mutable_questions());
  add_small(std::move(questions), out);
  ToBrowser held;
  encode_held(run, *held.mutable_held_values());
  add_small(std::move(held), out);
}

void PastRun::tell_trails(PastPicture& out) const {
  notes_.trails().encode(*out.messages.emplace_back().mutable_trails(), out.time);
}

void PastRun::fill(const Watch& watch, const TransitionRecorder& transitions, Frame& out) {
  const run::MissionRun& run = timeline_->run();
  out.set_time(run.time());
  rows_.gather(run, {}, {});
  const auto view = watch.has_view() ? std::optional<Box>(watch.view()) : std::nullopt;
  out.set_robots_elsewhere(rows_.encode(view, *out.mutable_robots()));
  encode_watched(run, watch, out);
  for (const std::uint32_t id : watch.details()) {
    const fleet::FleetRobot* const robot = run.fleet().find({id});
    if (robot == nullptr) continue;
    RobotDetail& told = *out.add_details();
    encode_watched(run, *robot, watch, Estimates(), transitions, told);
    for (std::string& line : waits_for(run, *robot)) told.add_waits_for(std::move(line));
    if (watch.with_failsafes() && !run.fleet().failsafes().empty())
      encode_standings(run, *robot, *out.add_failsafes());
  }
}

// ---- the whole run

// For what none has yet.
void PastRun::add_survey(const ReadPast& asked) {
  std::vector<Series> series;
  std::vector<std::uint32_t> robots;
  const auto is_known = [&](const auto& has) { return std::ranges::any_of(surveys_, has); };
  for (const Series& one : asked.series()) {
    if (!is_known([&](const auto& survey) { return survey->has(one); })) series.push_back(one);
  }
  for (const std::uint32_t robot : asked.states_of()) {
    if (!is_known([&](const auto& survey) { return survey->has_states_of(robot); })) robots.push_back(robot);
  }
  if (series.empty() && robots.empty()) return;
  if (surveys_.size() == kMostSurveys) surveys_.erase(surveys_.begin());
  surveys_.push_back(std::make_unique<Survey>(timeline_->again(), series, robots));
}

std::optional<std::string> PastRun::read(const ReadPast& asked, Past& out) {
  if (asked.series_size() > kMostAsked || asked.states_of_size() > kMostAsked)
    return fmt::format("{} quantities and states of {} robots are asked for: at most {} of each",
                       asked.series_size(), asked.states_of_size(), kMostAsked);
  add_survey(asked);
  const double deadline = wall_time() + kPiece;
  double known_to = history_->last_time();
  const auto bring = [&](Survey& survey) {
    const double left = deadline - wall_time();
    if (left > 0.0) survey.advance(left);
    known_to = std::min(known_to, survey.known_to());
  };
  const auto take = [&](const auto& has, const auto& encode) {
    const auto found = std::ranges::find_if(surveys_, has);
    if (found == surveys_.end()) return;
    bring(**found);
    encode(**found);
  };
  for (const Series& one : asked.series()) {
    take([&](const auto& survey) { return survey->has(one); },
         [&](const Survey& survey) { survey.encode(one, *out.add_samples()); });
  }
  for (const std::uint32_t robot : asked.states_of()) {
    take([&](const auto& survey) { return survey->has_states_of(robot); },
         [&](const Survey& survey) { survey.encode_states(robot, *out.add_states()); });
  }
  out.set_known_to(known_to);
  return std::nullopt;
}

std::optional<std::string> PastRun::find(const FindMoments& asked, Found& out) {
  auto condition = Condition::parse(asked.condition());
  if (!condition) return std::move(condition.error());
  const std::uint64_t from = cycle_at(std::max(0.0, asked.from()));
  const std::size_t most = asked.most() == 0 ? kUsualFound : std::min<std::size_t>(asked.most(), kMostFound);
  if (auto problem = go_to(from)) return problem;
  // What is missing at one moment may come with a typed order or an edit.
  const bool may_change = std::ranges::any_of(history_->inputs(), [](const history::InputEntry& one) {
    return one.input.has_exchanged() || one.input.posted().kind() == wire::HistoryPosted::TYPED;
  });
  if (auto why = condition->why_never(timeline_->run()); why && !may_change) return why;
  return asked.backwards() ? find_back(*condition, from, most, out) : find_ahead(*condition, from, most, out);
}

namespace {

void add_found(const run::MissionRun& run, Condition::Met met, Found& out) {
  Found::One& one = *out.add_moments();
  one.set_time(run.time());
  one.set_cycle(run.cycle());
  one.set_robot(met.robot);
  one.set_text(std::move(met.text));
}

}  // namespace

// What is true already does not become so; and which state a transition was from is seen in the cycle before.
std::optional<std::string> PastRun::begin_to_look(Condition& condition, std::uint64_t cycle) {
  condition.forget();
  if (cycle > 0) {
    if (auto problem = timeline_->go_to(cycle - 1)) return problem;
    condition.look(timeline_->run());
  }
  if (auto problem = timeline_->go_to(cycle)) return problem;
  condition.look(timeline_->run());
  return std::nullopt;
}

std::optional<std::string> PastRun::find_ahead(Condition& condition, std::uint64_t from, std::size_t most,
                                               Found& out) {
  const double deadline = wall_time() + kPiece;
  if (auto problem = begin_to_look(condition, from)) return problem;
  std::uint64_t cycle = from;
  while (cycle < history_->last_cycle() && static_cast<std::size_t>(out.moments_size()) < most &&
         wall_time() < deadline) {
    if (auto problem = timeline_->go_to(++cycle)) return problem;
    if (auto met = condition.look(timeline_->run())) add_found(timeline_->run(), std::move(*met), out);
  }
  out.set_searched_to(time_of(cycle));
  out.set_is_all(cycle >= history_->last_cycle());
  return std::nullopt;
}

// A stretch is searched ahead, since states are only known in that direction, and told in reverse.
std::optional<std::string> PastRun::find_back(Condition& condition, std::uint64_t from, std::size_t most,
                                              Found& out) {
  const double deadline = wall_time() + kPiece;
  std::uint64_t last = from > 0 ? from - 1 : 0;
  while (last > 0 && static_cast<std::size_t>(out.moments_size()) < most && wall_time() < deadline) {
    const std::uint64_t before = last > kBackwards ? last - kBackwards : 0;
    Found stretch;
    if (auto problem = begin_to_look(condition, before)) return problem;
    for (std::uint64_t cycle = before + 1; cycle <= last; ++cycle) {
      if (auto problem = timeline_->go_to(cycle)) return problem;
      if (auto met = condition.look(timeline_->run())) add_found(timeline_->run(), std::move(*met), stretch);
    }
    last = before;
    for (int i = stretch.moments_size(); i-- > 0;) {
      *out.add_moments() = stretch.moments(i);
      if (static_cast<std::size_t>(out.moments_size()) < most) continue;
      last = i > 0 ? stretch.moments(i).cycle() : before;  // the others of the stretch come next time
      break;
    }
  }
  out.set_searched_to(time_of(last));
  out.set_is_all(last == 0);
  return std::nullopt;
}

}  // namespace mlab::console
