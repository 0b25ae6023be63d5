#include "mlab/agents/stop_switch.h"

#include <algorithm>
#include <utility>

#include "mlab/agents/topics.h"

namespace mlab::agents {
namespace {

// docs/network.md: best effort, so what is lost is made up for by what comes next.
constexpr std::chrono::milliseconds kUrgent(20);
constexpr std::chrono::seconds kUrgentFor(1);
constexpr std::chrono::milliseconds kRepeat(200);

bool has_acknowledged(const Member& agent, const StopState& state) {
  const auto there = decode(agent.said.stop());
  return there && there->is_same(state);
}

}  // namespace

std::expected<std::unique_ptr<StopSwitch>, std::string> StopSwitch::open(std::shared_ptr<Roster> roster) {
  auto waiter = dds::Waiter::make();
  if (!waiter) return std::unexpected(waiter.error());
  dds::Participant& participant = roster->participant();
  auto reader = participant.reader(kStopTopic, dds::ChannelKind::kEmergencyStop, *waiter);
  if (!reader) return std::unexpected(reader.error());
  auto writer = participant.writer(kStopTopic, dds::ChannelKind::kEmergencyStop);
  if (!writer) return std::unexpected(writer.error());
  return std::unique_ptr<StopSwitch>(
      new StopSwitch(std::move(roster), std::move(*waiter), std::move(*reader), std::move(*writer)));
}

StopSwitch::StopSwitch(std::shared_ptr<Roster> roster, dds::Waiter waiter, dds::Reader reader,
                       dds::Writer writer)
    : roster_(std::move(roster)),
      waiter_(std::move(waiter)),
      reader_(std::move(reader)),
      writer_(std::move(writer)),
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
    if (!state_.is_engaged) {
      state_ = pulled(state_, by);
      own_pull_ = state_.pull;
    }
    since_ = Clock::now();
  }
  spread();
}

void StopSwitch::release(const std::string& by) {
  {
    const std::scoped_lock lock(mutex_);
    if (!state_.is_engaged) return;
    state_ = released(state_, by);
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
  if (!state.overrides(state_)) return;
  // Numbers were not known here yet when it was pulled: what was released is another pull.
  if (state_.is_engaged && state_.pull == own_pull_ && !state.is_engaged && state.pull != own_pull_)
    state_.number = state.number + 1;
  else
    state_ = state;
  since_ = Clock::now();
}

// What others have said, and what holds at agents. True: something else holds now.
bool StopSwitch::listen() {
  std::vector<StopState> heard;
  for (const dds::Arrival& arrival : reader_.take()) {
    if (arrival.kind != dds::Arrival::Kind::kMessage) continue;
    if (auto state = decode(arrival.body)) heard.push_back(std::move(*state));
  }
  for (const Member& agent : roster_->members()) {
    if (auto state = decode(agent.said.stop()); state && agent.state != Member::State::kGone)
      heard.push_back(std::move(*state));
  }
  const std::scoped_lock lock(mutex_);
  const StopState before = state_;
  for (const StopState& state : heard) adopt(state);
  return !before.is_same(state_);
}

void StopSwitch::serve(const std::stop_token& stop) {
  Clock::time_point next_repeat;
  std::size_t missing_before = 0;
  while (!stop.stop_requested()) {
    const bool has_changed = listen();
    const std::size_t missing = unreached().size();
    if (has_changed || missing != missing_before) {
      const std::scoped_lock lock(telling_);
      if (changed_) changed_();
    }
    missing_before = missing;
    const bool is_urgent = is_fresh();
    if (is_urgent || (missing > 0 && Clock::now() >= next_repeat)) {
      say();
      next_repeat = Clock::now() + kRepeat;
    }
    waiter_.wait(is_urgent ? kUrgent : kRepeat);
  }
}

bool StopSwitch::is_fresh() const {
  const std::scoped_lock lock(mutex_);
  return state_.number > 0 && Clock::now() - since_ < kUrgentFor;
}

std::vector<StopSwitch::Unreached> StopSwitch::unreached() const {
  const StopState wanted = state();
  std::vector<Unreached> out;
  if (wanted.number == 0) return out;
  for (const Member& agent : roster_->members()) {
    if (has_acknowledged(agent, wanted) || agent.has_left) continue;
    out.push_back({agent.said.name(), std::chrono::duration<double>(Clock::now() - agent.heard).count()});
  }
  return out;
}

std::size_t StopSwitch::agent_count() const {
  return static_cast<std::size_t>(std::ranges::count(roster_->members(), false, &Member::has_left));
}

}  // namespace mlab::agents
