#include "mlab/agents/stop_switch.h"

#include <algorithm>
#include <utility>

#include "mlab/agents/topics.h"

namespace mlab::agents {
namespace {

// docs/network.md: best effort, so what is lost is made up for by what comes next.
constexpr std::chrono::milliseconds kFirst(4);
constexpr std::chrono::milliseconds kFirstFor(100);
constexpr std::chrono::milliseconds kUrgent(20);
constexpr std::chrono::seconds kUrgentFor(1);
constexpr std::chrono::milliseconds kRepeat(200);
constexpr std::chrono::milliseconds kTellMissed(500);

// Two that have heard the same from somebody differ by no more [s].
constexpr double kSameMoment = 2.0;

double seconds_between(Clock::time_point then, Clock::time_point now) {
  return std::chrono::duration<double>(now - then).count();
}

}  // namespace

std::expected<std::unique_ptr<StopSwitch>, std::string> StopSwitch::open(std::shared_ptr<Roster> roster,
                                                                         std::string by) {
  auto waiter = dds::Waiter::make();
  if (!waiter) return std::unexpected(waiter.error());
  dds::Participant& participant = roster->participant();
  auto reader = participant.reader(kStopTopic, dds::ChannelKind::kEmergencyStop, *waiter);
  if (!reader) return std::unexpected(reader.error());
  auto writer = participant.writer(kStopTopic, dds::ChannelKind::kEmergencyStop);
  if (!writer) return std::unexpected(writer.error());
  auto hearsay = Hearsay::open(participant, *waiter);
  if (!hearsay) return std::unexpected(hearsay.error());
  return std::unique_ptr<StopSwitch>(new StopSwitch(std::move(roster), std::move(*waiter), std::move(*reader),
                                                    std::move(*writer), std::move(*hearsay), std::move(by)));
}

StopSwitch::StopSwitch(std::shared_ptr<Roster> roster, dds::Waiter waiter, dds::Reader reader,
                       dds::Writer writer, std::unique_ptr<Hearsay> hearsay, std::string by)
    : roster_(std::move(roster)),
      waiter_(std::move(waiter)),
      reader_(std::move(reader)),
      writer_(std::move(writer)),
      hearsay_(std::move(hearsay)),
      teller_(by.empty() ? nullptr : std::make_unique<MissedTeller>(roster_->participant(), std::move(by))),
      thread_([this](const std::stop_token& stop) { serve(stop); }) {}

StopSwitch::~StopSwitch() {
  thread_.request_stop();
  waiter_.wake();
}

StopState StopSwitch::state() const {
  const std::scoped_lock lock(mutex_);
  return state_;
}

void StopSwitch::tell(std::function<void()> changed) {
  const std::scoped_lock lock(telling_);
  changed_ = std::move(changed);
}

void StopSwitch::engage(const std::string& by) {
  {
    const std::scoped_lock lock(mutex_);
    // Also where it is engaged: who releases that may not know of this.
    state_ = pulled(std::move(state_), by);
    since_ = Clock::now();
  }
  spread();
}

void StopSwitch::release(const std::string& by) {
  {
    const std::scoped_lock lock(mutex_);
    if (!state_.is_engaged()) return;
    state_ = released(std::move(state_), by);
    since_ = Clock::now();
  }
  spread();
}

void StopSwitch::spread() {
  say();
  waiter_.wake();
}

void StopSwitch::say() {
  wire::EmergencyStop message;
  encode(state(), message);
  // What is not written is as good as lost on the way: it is said again.
  static_cast<void>(writer_.write(kStopKey, message.SerializeAsString()));
}

void StopSwitch::adopt(const StopState& state) {
  if (state_.learn(state) == Learnt::kNothing) return;
  since_ = Clock::now();
  has_changed_ = true;
}

void StopSwitch::hear_agents() {
  const std::vector<Member> agents = roster_->members();
  const std::scoped_lock lock(mutex_);
  for (const Member& agent : agents) {
    const auto state = decode(agent.said.stop());
    if (state && agent.state != Member::State::kGone) adopt(*state);
  }
}

// What others have said, and what holds at agents. True: something else holds now.
bool StopSwitch::listen() {
  std::vector<StopState> heard;
  hearsay_->listen();
  for (const dds::Arrival& arrival : reader_.take()) {
    if (arrival.kind != dds::Arrival::Kind::kMessage) continue;
    if (auto state = decode(arrival.body)) heard.push_back(std::move(*state));
  }
  hear_agents();
  const std::scoped_lock lock(mutex_);
  for (const StopState& state : heard) adopt(state);
  return std::exchange(has_changed_, false);
}

void StopSwitch::serve(const std::stop_token& stop) {
  Clock::time_point said;
  Clock::time_point next_telling;
  std::vector<std::string> missing_before;
  while (!stop.stop_requested()) {
    const bool has_changed = listen();
    if (teller_ && (has_changed || Clock::now() >= next_telling)) {
      teller_->say(missed_among(roster_->members(), state(), Clock::now()));
      next_telling = Clock::now() + kTellMissed;
    }
    std::vector<std::string> missing;
    for (Unreached& one : unreached()) missing.push_back(std::move(one.name));
    if (has_changed || missing != missing_before) {
      const std::scoped_lock lock(telling_);
      if (changed_) changed_();
    }
    const bool is_urgent = is_fresh(kUrgentFor);
    const std::chrono::milliseconds every = !is_urgent ? kRepeat : is_fresh(kFirstFor) ? kFirst : kUrgent;
    const bool has_to_say = is_urgent || !missing.empty();
    // What it hears, its own words among it, does not make it speak more often.
    if (has_to_say && Clock::now() - said >= every) {
      say();
      said = Clock::now();
    }
    missing_before = std::move(missing);
    const Clock::duration left = has_to_say ? said + every - Clock::now() : Clock::duration(every);
    waiter_.wait(std::chrono::ceil<std::chrono::milliseconds>(std::max(left, Clock::duration::zero())));
  }
}

bool StopSwitch::is_fresh(Clock::duration age) const {
  const std::scoped_lock lock(mutex_);
  return state_.number > 0 && Clock::now() - since_ < age;
}

// Those of which nothing is known here; of others this knows better. One that has left may be there again
// since then.
std::vector<Hearsay::Entry> StopSwitch::known_by_others() const {
  const Clock::time_point now = Clock::now();
  std::vector<Hearsay::Entry> out = hearsay_->all(now);
  std::erase_if(out, [&](const Hearsay::Entry& entry) {
    const auto own = roster_->sight(entry.agent.name);
    return own && !(own->has_left && seconds_between(own->heard, now) > entry.agent.silent + kSameMoment);
  });
  return out;
}

std::vector<StopSwitch::Unreached> StopSwitch::unreached() const {
  const StopState wanted = state();
  std::vector<Unreached> out;
  if (wanted.number == 0) return out;
  const Clock::time_point now = Clock::now();
  for (const Member& agent : roster_->members()) {
    if (has_confirmed(agent.said.stop(), wanted) || agent.has_left) continue;
    out.push_back({agent.said.name(), seconds_between(agent.heard, now), "", agent.said.host()});
  }
  for (Hearsay::Entry& one : known_by_others())
    out.push_back(
        {std::move(one.agent.name), one.agent.silent, std::move(one.by), std::move(one.agent.machine)});
  std::ranges::sort(out, {}, &Unreached::name);
  return out;
}

std::vector<StopSwitch::Forgetful> StopSwitch::forgetful() const {
  const StopState wanted = state();
  std::vector<Forgetful> out;
  if (!wanted.is_engaged()) return out;
  for (const Member& agent : roster_->members()) {
    const bool is_there = agent.state != Member::State::kGone && !agent.said.not_kept().empty();
    if (is_there && has_confirmed(agent.said.stop(), wanted))
      out.push_back({agent.said.name(), agent.said.not_kept()});
  }
  return out;
}

std::size_t StopSwitch::agent_count() const {
  return static_cast<std::size_t>(std::ranges::count(roster_->members(), false, &Member::has_left)) +
         known_by_others().size();
}

}  // namespace mlab::agents
