#include "mlab/console/session/look_backs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/core.h>

#include "mlab/console/published/overview.h"
#include "mlab/run/pace.h"

namespace mlab::console {
namespace {

constexpr double kPiece = 0.02;      // of the first pass: who asks meanwhile waits for so long [s]
constexpr double kLineEvery = 0.25;  // that the time line is told again, while it grows [s]
constexpr double kSettled =
    0.15;  // nobody has asked for another moment for so long: then trails are told [s]

std::string minutes(double time) {
  const auto tenths = static_cast<long>(std::floor(time * 10.0 + 1e-6));
  return fmt::format("{}:{:02}.{}", tenths / 600, tenths / 10 % 60, tenths % 10);
}

}  // namespace

LookBacks::LookBacks(const Parts& parts)
    : settings_(parts.settings),
      documents_(parts.documents),
      chronicle_(parts.chronicle),
      run_(parts.run),
      people_(parts.people),
      log_(parts.log),
      inbox_(parts.inbox) {}

LookBacks::~LookBacks() {
  end();
}

void LookBacks::end() {
  ends_.request_stop();
  workshop_.reset();
}

// ---- the run that can be looked back at

void LookBacks::open(std::shared_ptr<history::History> recording) {
  recording_ = std::move(recording);
  past().history = recording_;
  keep_on();
}

LookBacks::Past& LookBacks::past() {
  if (!past_) {
    past_ = std::make_shared<Past>();
    past_->history = std::make_shared<history::History>();
  }
  return *past_;
}

void LookBacks::make(Past& past, const history::ReplayTools& tools, PastRun::Settings settings) {
  text::Diagnostics problems;
  past.run = PastRun::make(past.history, tools, std::move(settings), problems);
  if (past.run) return;
  past.why_not = "the run can't be computed again";
  for (const text::Diagnostic& problem : problems.items()) {
    if (problem.severity == text::Severity::kError) {
      past.why_not = clean(problem.message);
      break;
    }
  }
}

// What the run has come to since is added first.
void LookBacks::work(std::function<void(Past& past)> job) {
  past();
  if (!workshop_) workshop_ = std::make_unique<Workshop>();
  PastRun::Settings settings;
  settings.ends = ends_.get_token();
  if (!recording_) {
    auto names = std::make_shared<std::map<std::string, std::string>>();
    for (const OpenDocument* document : documents_.documents())
      (*names)[document->text.source()->name()] = document->path;
    settings.documents = std::move(names);
    if (documents_.scene().has_picture()) settings.picture = documents_.scene().picture();
  }
  const std::uint64_t cycle = run_.live() != nullptr ? run_.live()->run().cycle() : 0;
  workshop_->start([this, past = past_, settings = std::move(settings), tools = tools(), job = std::move(job),
                    cycle, time = run_.sim_time(), is_recording = recording_ != nullptr,
                    entries = recording_ ? std::vector<wire::HistoryEntry>() : chronicle_.take_entries()] {
    if (!past->run && past->why_not.empty()) {
      for (const wire::HistoryEntry& entry : entries) static_cast<void>(past->history->add(entry));
      make(*past, tools, settings);
      if (past->run && !is_recording) past->run->add({}, cycle, time);
      if (!past->run && is_recording) past->recorded = std::make_unique<RecordedPast>(past->history, tools);
    } else if (past->run && !is_recording) {
      past->run->add(entries, cycle, time);
    }
    job(*past);
    if (past->run)
      past->known_to = past->run->known_to();
    else if (past->recorded)
      past->known_to = past->history->last_time();
    report(past);
  });
}

// On the workshop's thread.
void LookBacks::report(const PastPtr& past) {
  Log told;
  std::string slow;
  std::string parted;
  if (past->run) {
    past->run->log().encode_since(std::exchange(past->log_told, past->run->log().last()), told);
    slow = past->run->timeline().why_slow();
    if (const auto& divergence = past->run->timeline().divergence())
      parted = fmt::format("beyond cycle {}: {}", divergence->cycle, divergence->why);
  } else if (past->recorded) {
    past->recorded->log().encode_since(std::exchange(past->log_told, past->recorded->log().last()), told);
  }
  inbox_.post(
      [this, past, told, why_not = past->why_not, is_shown = past->recorded != nullptr, slow, parted] {
        if (past != past_) return;
        why_not_ = is_shown ? "" : why_not;
        only_recorded_ = is_shown ? why_not : "";
        why_slow_ = clean(slow);
        parted_ = clean(parted);
        if (recording_) take_log({told.entries().begin(), told.entries().end()});
      },
      Inbox::Kind::kDuringCycle);
}

// What happened in a recording is known once it was computed; of a run that goes on it is known already.
void LookBacks::take_log(const std::vector<Log::Entry>& entries) {
  for (const Log::Entry& entry : entries) {
    const auto place =
        entry.has_place() ? std::optional(geom::Point{entry.place().x(), entry.place().y()}) : std::nullopt;
    log_.add(entry.time(), {entry.kind(), entry.text(), entry.robot(), entry.unit(), place, false});
  }
}

// The first pass is made piece by piece, so that who asks for something need not wait for its end.
void LookBacks::keep_on() {
  if (std::exchange(keeps_on_, true)) return;
  work([this](Past& past) {
    const bool has_more = past.run && past.run->advance(kPiece);
    inbox_.post(
        [this, has_more, asked = &past] {
          keeps_on_ = false;
          if (has_more && asked == past_.get()) keep_on();
        },
        Inbox::Kind::kDuringCycle);
  });
}

void LookBacks::follow_run() {
  if (known_run_ == run_.run_number()) return;
  known_run_ = run_.run_number();
  if (recording_) return;
  past_.reset();
  why_not_.clear();
  only_recorded_.clear();
  why_slow_.clear();
  parted_.clear();
  while (!lookers_.empty()) return_to_now(lookers_.begin()->first, "");
}

// ---- what is asked

double LookBacks::run_end() const {
  return recording_ ? recording_->last_time() : run_.sim_time();
}

std::uint64_t LookBacks::last_cycle() const {
  if (recording_) return recording_->last_cycle();
  return run_.live() != nullptr ? run_.live()->run().cycle() : 0;
}

Answered LookBacks::why_not() const {
  if (!why_not_.empty()) return why_not_;
  if (recording_) return std::nullopt;
  if (run_.live() == nullptr || run_.live()->run().cycle() == 0) return "nothing has run yet";
  return std::nullopt;
}

Answered LookBacks::look_back(const Sender& sender, const LookBack& look) {
  const ConnectionId connection = sender.channel.connection();
  const bool is_known = lookers_.contains(connection);
  if (look.to_case() == LookBack::kNow && !recording_) {
    if (is_known) return_to_now(connection, "");
    return std::nullopt;
  }
  if (auto why = why_not()) return why;
  if (!std::isfinite(look.time()) || !std::isfinite(look.speed())) return "a moment and a speed are numbers";
  Looker& looker = lookers_[connection];
  if (!is_known) {
    sender.channel.looks_back = true;
    looker.time = run_end();
    looker.cycle = last_cycle();
  }
  PastWish wish;
  const std::uint64_t here = looker.wish && !looker.wish->time ? looker.wish->cycle : looker.cycle;
  switch (look.to_case()) {
    case LookBack::kTime:
      wish.time = std::clamp(look.time(), 0.0, run_end());
      break;
    case LookBack::kCycle:
      wish.cycle = std::min(look.cycle(), last_cycle());
      break;
    case LookBack::kCycles: {
      const auto most = static_cast<std::int64_t>(last_cycle());
      wish.cycle = static_cast<std::uint64_t>(std::clamp<std::int64_t>(
          static_cast<std::int64_t>(here) + std::clamp<std::int64_t>(look.cycles(), -most, most), 0, most));
      break;
    }
    case LookBack::kNow:
      wish.cycle = last_cycle();
      break;
    case LookBack::kHere:
    case LookBack::TO_NOT_SET:
      wish.cycle = here;
      if (looker.wish) wish = *looker.wish;
      break;
  }
  looker.speed = std::clamp(look.speed(), -run::Pace::kFastest, run::Pace::kFastest);
  looker.asked = looker.played = wall_time();
  looker.wants_trails = looker.is_sought = true;
  looker.wish = std::move(wish);
  tell_moment(connection, looker, "");
  keep_on();
  return std::nullopt;
}

void LookBacks::begin(const Sender& sender) {
  if (!recording_) return;
  LookBack look;
  look.set_cycle(0);
  static_cast<void>(look_back(sender, look));
}

Answered LookBacks::why_no_order(ConnectionId connection) const {
  const auto looker = lookers_.find(connection);
  if (recording_) return "this is a recording: it can't be told anything";
  if (looker == lookers_.end()) return std::nullopt;
  return fmt::format("you are looking at {} of the run: return to now first", minutes(looker->second.time));
}

void LookBacks::answer(ConnectionId to, std::uint32_t request,
                       std::function<Answered(PastRun& past, Reply& reply)> find) {
  work([this, to, request, find = std::move(find)](Past& past) {
    auto out = std::make_shared<ToBrowser>();
    Reply& reply = *out->mutable_reply();
    reply.set_request(request);
    const Answered error = past.run ? find(*past.run, reply) : Answered(past.why_not);
    reply.set_ok(!error);
    if (error) {
      reply.clear_result();  // a part of an answer is none
      reply.set_error(*error);
    }
    inbox_.post([this, to, out] { people_.send(to, *out); }, Inbox::Kind::kDuringCycle);
  });
}

Answered LookBacks::read_past(const Sender& sender, const ReadPast& asked, const Reply& reply) {
  if (auto why = why_not()) return why;
  answer(sender.channel.connection(), reply.request(),
         [asked](PastRun& past, Reply& out) { return past.read(asked, *out.mutable_past()); });
  return std::nullopt;
}

Answered LookBacks::find_moments(const Sender& sender, const FindMoments& asked, const Reply& reply) {
  if (auto why = why_not()) return why;
  answer(sender.channel.connection(), reply.request(),
         [asked](PastRun& past, Reply& out) { return past.find(asked, *out.mutable_found()); });
  return std::nullopt;
}

Answered LookBacks::ask_past(ConnectionId to, std::uint32_t request,
                             std::function<Answered(PastRun& past, Reply& reply)> find) {
  if (auto why = why_not()) return why;
  answer(to, request, std::move(find));
  return std::nullopt;
}

void LookBacks::with_past(std::function<void(PastRun* past)> job) {
  work([job = std::move(job)](Past& past) { job(past.run.get()); });
}

history::ReplayTools LookBacks::tools() const {
  return {settings_.permission, settings_.include_root, settings_.version, settings_.limits,
          settings_.run.threads};
}

// ---- what is told

// As much time as has passed on the clock.
// @return  false: it has caught up with now
bool LookBacks::play(Looker& looker, double wall) {
  const double time = looker.time + (wall - looker.played) * looker.speed;
  looker.played = wall;
  const bool has_ended = looker.speed < 0.0 ? time <= 0.0 : time >= run_end();
  PastWish wish;
  wish.time = std::clamp(time, 0.0, run_end());
  looker.time = *wish.time;
  looker.wish = std::move(wish);
  if (looker.speed < 0.0) looker.wants_trails = true;
  if (!has_ended) return true;
  const bool was_ahead = std::exchange(looker.speed, 0.0) > 0.0;
  return recording_ != nullptr || !was_ahead;
}

void LookBacks::publish() {
  const double wall = wall_time();
  std::vector<ConnectionId> caught_up;
  for (auto& [id, looker] : lookers_) {
    const auto channel = people_.channels().find(id);
    if (channel == people_.channels().end() || looker.is_under_way) continue;
    if (!looker.wish && looker.speed != 0.0 && channel->second.wants_frame(wall) && !play(looker, wall)) {
      caught_up.push_back(id);
      continue;
    }
    const bool sees_otherwise = looker.watch != channel->second.watch_number();
    const bool is_settled = looker.wants_trails && wall >= looker.asked + kSettled;
    if (!looker.wish && (sees_otherwise || is_settled)) looker.wish.emplace().cycle = looker.cycle;
    if (looker.wish && channel->second.has_room()) ask(id, looker, channel->second);
  }
  for (const ConnectionId id : caught_up) return_to_now(id, "");
}

double LookBacks::next() const {
  double out = std::numeric_limits<double>::infinity();
  for (const auto& [id, looker] : lookers_) {
    const auto channel = people_.channels().find(id);
    const bool is_free = channel != people_.channels().end() && channel->second.has_room();
    if (!is_free || looker.is_under_way) continue;
    if (looker.speed != 0.0) out = std::min(out, channel->second.next_frame());
    if (looker.wants_trails) out = std::min(out, looker.asked + kSettled);
  }
  return out;
}

void LookBacks::ask(ConnectionId connection, Looker& looker, const Channel& channel) {
  PastWish wish = std::move(*looker.wish);
  looker.wish.reset();
  looker.is_under_way = true;
  looker.was_sought = std::exchange(looker.is_sought, false);
  looker.watch = channel.watch_number();
  wish.watch = channel.watched();
  wish.told = looker.told;
  wish.with_trails = looker.is_new || (looker.wants_trails && wall_time() >= looker.asked + kSettled);
  if (wish.with_trails) looker.wants_trails = false;
  work([this, connection, wish = std::move(wish), asked_of = past_.get(), tools = tools()](Past& past) {
    const auto picture = std::make_shared<PastPicture>(LookBacks::picture(past, wish, tools));
    inbox_.post(
        [this, connection, picture, asked_of] {
          if (asked_of == past_.get()) take(connection, std::move(*picture));
        },
        Inbox::Kind::kDuringCycle);
  });
}

// On the workshop's thread. Where what is computed is no longer what was written, that is shown.
PastPicture LookBacks::picture(Past& past, const PastWish& wish, const history::ReplayTools& tools) {
  PastPicture out;
  if (past.run)
    out = past.run->picture(wish);
  else if (!past.recorded)
    out.problem = past.why_not;
  const bool has_parted =
      past.run && past.run->timeline().divergence() && !past.history->poses().empty() &&
      (!out.problem.empty() || (wish.time ? *wish.time > past.run->known_to() + kMoment
                                          : wish.cycle > past.run->timeline().known_to()));
  if (has_parted && !past.recorded) past.recorded = std::make_unique<RecordedPast>(past.history, tools);
  return past.recorded && (has_parted || !past.run) ? past.recorded->picture(wish) : out;
}

void LookBacks::take(ConnectionId connection, PastPicture picture) {
  const auto at = lookers_.find(connection);
  const auto channel = people_.channels().find(connection);
  if (at == lookers_.end() || channel == people_.channels().end()) return;
  Looker& looker = at->second;
  looker.is_under_way = false;
  if (!picture.problem.empty()) {
    looker.speed = 0.0;
    if (!recording_ && looker.is_new)
      return_to_now(connection, picture.problem);
    else
      tell_moment(connection, looker, picture.problem);
    return;
  }
  looker.is_new = false;
  looker.told = std::move(picture.told);
  looker.cycle = picture.cycle;
  if (looker.was_sought) {
    looker.time = picture.time;
    looker.played = wall_time();
  }
  for (ToBrowser& message : picture.messages) {
    // How fast the run goes on meanwhile, or would: the past knows nothing of that.
    if (message.has_status()) message.mutable_status()->set_speed(run_.pace().speed());
    people_.send(connection, message);
  }
  ToBrowser frame;
  *frame.mutable_frame() = std::move(picture.frame);
  frame.mutable_frame()->set_number(channel->second.begin_frame(wall_time()));
  people_.send(connection, frame);
  tell_moment(connection, looker, "");
}

void LookBacks::tell_moment(ConnectionId connection, const Looker& looker, const std::string& problem) const {
  ToBrowser out;
  Moment& moment = *out.mutable_moment();
  moment.set_time(looker.time);
  moment.set_cycle(looker.cycle);
  moment.set_speed(looker.speed);
  moment.set_problem(problem);
  moment.set_is_coming(looker.is_under_way || looker.wish.has_value());
  people_.send(connection, out);
}

void LookBacks::return_to_now(ConnectionId connection, const std::string& problem) {
  lookers_.erase(connection);
  const auto channel = people_.channels().find(connection);
  if (channel == people_.channels().end()) return;
  channel->second.looks_back = false;
  channel->second.seen = 0;
  channel->second.series_seen.clear();
  channel->second.failsafes_seen.clear();
  ToBrowser out;
  out.mutable_moment()->set_is_now(true);
  out.mutable_moment()->set_problem(problem);
  people_.send(connection, out);
  returned_.push_back(connection);
}

void LookBacks::encode(TimeLine& out) const {
  out.set_end(run_end());
  out.set_last_cycle(last_cycle());
  if (past_) out.set_known_to(past_->known_to);
  out.set_why_not(why_not().value_or(""));
  out.set_why_slow(why_slow_);
  out.set_parted(parted_);
  out.set_only_recorded(only_recorded_);
  if (!recording_) return;
  out.set_recording(clean(settings_.recording.name));
  out.set_outcome(recording_->end() ? clean(recording_->end()->outcome) : "cut off");
}

std::uint64_t LookBacks::line_revision() {
  const double wall = wall_time();
  if (wall < line_looked_ + kLineEvery) return line_revision_;
  line_looked_ = wall;
  TimeLine line;
  encode(line);
  std::string bytes = line.SerializeAsString();
  if (bytes != line_told_) ++line_revision_;
  line_told_ = std::move(bytes);
  return line_revision_;
}

}  // namespace mlab::console
