#include "mlab/agents/roster.h"

#include <algorithm>
#include <ctime>
#include <utility>

#include "mlab/agents/stop_state.h"
#include "mlab/agents/topics.h"
#include "mlab/text/member_name.h"
#include "mlab/text/shown.h"

namespace mlab::agents {
namespace {

constexpr std::size_t kMostMembers = 1000;  // names that anybody may make up
// Presence is said every two seconds, and may have to be sent again.
constexpr std::chrono::milliseconds kSilentAfter(3500);

// What an agent says of itself, fit for people; nothing where it is none.
std::optional<wire::AgentPresence> checked(const dds::Arrival& arrival) {
  wire::AgentPresence out;
  if (!out.ParseFromString(arrival.body) || out.name() != arrival.key || !is_agent_name(out.name()))
    return std::nullopt;
  out.set_host(text::shown(out.host(), 64));
  out.set_version(text::shown(out.version(), 32));
  out.set_not_kept(text::shown(out.not_kept(), 200));
  if (out.has_offered()) {
    if (out.offered().source() == 0) return std::nullopt;
    out.mutable_offered()->set_name(text::shown(out.offered().name(), 64));
  }
  if (out.has_vehicle()) out.mutable_vehicle()->set_kind(text::shown(out.vehicle().kind(), 64));
  if (!decode(out.stop())) return std::nullopt;
  return out;
}

}  // namespace

bool is_agent_name(std::string_view name) {
  static_assert(text::kMostInMemberName <= dds::kMaxKey);
  return text::is_member_name(name);
}

std::optional<Member::Rival> rival_of(const Member& member) {
  constexpr std::chrono::seconds kFresh(5);  // it says every two seconds that it is there
  return member.rival && Clock::now() - member.rival->heard < kFresh ? member.rival : std::nullopt;
}

std::expected<std::shared_ptr<Roster>, std::string> Roster::join(const dds::Network& network, Watch watch) {
  auto participant = dds::Participant::open(network);
  if (!participant) return std::unexpected(participant.error());
  auto waiter = dds::Waiter::make();
  if (!waiter) return std::unexpected(waiter.error());
  auto reader = participant->reader(kPresenceTopic, dds::ChannelKind::kPresence, *waiter);
  if (!reader) return std::unexpected(reader.error());
  std::optional<dds::Reader> life;
  if (watch == Watch::kClosely) {
    auto signs = participant->reader(kLifeTopic, dds::ChannelKind::kSignsOfLife, *waiter);
    if (!signs) return std::unexpected(signs.error());
    life = std::move(*signs);
  }
  return std::shared_ptr<Roster>(new Roster(network.fleet, std::move(*participant), std::move(*waiter),
                                            std::move(*reader), std::move(life)));
}

Roster::Roster(std::string fleet, dds::Participant participant, dds::Waiter waiter, dds::Reader reader,
               std::optional<dds::Reader> life)
    : fleet_(std::move(fleet)),
      participant_(std::move(participant)),
      waiter_(std::move(waiter)),
      reader_(std::move(reader)),
      life_(std::move(life)),
      thread_([this](const std::stop_token& stop) { listen(stop); }) {}

Roster::~Roster() {
  thread_.request_stop();
  waiter_.wake();
}

void Roster::listen(const std::stop_token& stop) {
  // Between two looks at who is silent. Signs of life wake nobody.
  const std::chrono::milliseconds glance(life_ ? 250 : 1000);
  while (!stop.stop_requested()) {
    waiter_.wait(glance);
    const std::vector<dds::Arrival> signs = life_ ? life_->take() : std::vector<dds::Arrival>();
    const std::vector<dds::Arrival> arrivals = reader_.take();
    const std::scoped_lock lock(mutex_);
    note_standstill();
    for (const dds::Arrival& arrival : arrivals) take(arrival);
    for (const dds::Arrival& sign : signs) take_sign_of_life(sign);
    give_up_the_silent();
    if (std::exchange(has_news_, false) || !arrivals.empty()) changed_.notify_all();
  }
}

Member* Roster::of(const dds::Guid& guid) {
  const auto at = std::ranges::find_if(members_, [&](const auto& one) { return one.second.guid == guid; });
  return at == members_.end() ? nullptr : &at->second;
}

void Roster::note_standstill() {
  constexpr double kLeast = 2.0;  // [s]
  timespec now{};
  ::clock_gettime(CLOCK_BOOTTIME, &now);
  const double seconds = static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
  const double passed = seconds - std::exchange(looked_, seconds);
  if (passed >= kLeast && passed < seconds) standstill_ = {passed, Clock::now()};
}

std::optional<Roster::Standstill> Roster::standstill() const {
  const std::scoped_lock lock(mutex_);
  return standstill_;
}

void Roster::forget_rival(const dds::Guid& guid) {
  for (auto& [name, member] : members_) {
    if (member.rival && member.rival->guid == guid) member.rival.reset();
  }
}

void Roster::set(Member& member, Member::State state) {
  if (member.state == state) return;
  member.state = state;
  member.since = Clock::now();
  has_news_ = true;
}

void Roster::take(const dds::Arrival& arrival) {
  using Kind = dds::Arrival::Kind;
  if (arrival.kind == Kind::kMessage) {
    auto said = checked(arrival);
    if (!said || (members_.size() >= kMostMembers && !members_.contains(arrival.key))) return;
    const auto [at, is_new] = members_.try_emplace(arrival.key);
    Member& member = at->second;
    // Who has the name keeps it until he has gone.
    if (!is_new && member.guid != arrival.sender && member.state == Member::State::kThere) {
      member.rival = Member::Rival{arrival.sender, said->host(), arrival.noticed, said->uptime()};
      return;
    }
    member.said = std::move(*said);
    member.heard = arrival.noticed;
    if (is_new || member.guid != arrival.sender) member.since = Clock::now();
    member.guid = arrival.sender;
    member.has_left = false;
    set(member, Member::State::kThere);
    return;
  }
  if (arrival.kind == Kind::kEnded || arrival.kind == Kind::kUnmatched) forget_rival(arrival.sender);
  Member* const member = of(arrival.sender);
  if (member == nullptr || (arrival.kind != Kind::kEnded && arrival.kind != Kind::kUnmatched)) return;
  member->has_left |= arrival.kind == Kind::kEnded;
  set(*member, Member::State::kGone);
}

void Roster::take_sign_of_life(const dds::Arrival& arrival) {
  using Kind = dds::Arrival::Kind;
  Member* const member = of(arrival.sender);
  if (member == nullptr || member->state == Member::State::kGone) return;
  if (arrival.kind == Kind::kSilent) set(*member, Member::State::kSilent);
  if (arrival.kind != Kind::kMessage && arrival.kind != Kind::kAlive) return;
  member->heard = arrival.noticed;
  set(*member, Member::State::kThere);
}

void Roster::give_up_the_silent() {
  for (auto& [name, member] : members_) {
    if (member.state == Member::State::kThere && Clock::now() - member.heard >= kSilentAfter)
      set(member, Member::State::kSilent);
    if (member.state == Member::State::kSilent && Clock::now() - member.since >= kSilencePatience)
      set(member, Member::State::kGone);
  }
}

std::vector<Member> Roster::members() const {
  const std::scoped_lock lock(mutex_);
  std::vector<Member> out;
  for (const auto& [name, member] : members_) out.push_back(member);
  return out;
}

std::optional<Member> Roster::find(std::string_view name) const {
  const std::scoped_lock lock(mutex_);
  const auto at = members_.find(name);
  return at == members_.end() ? std::nullopt : std::optional(at->second);
}

void Roster::hold(std::string_view name) {
  const std::scoped_lock lock(mutex_);
  if (const auto at = members_.find(name); at != members_.end()) at->second.is_held = true;
}

std::optional<Roster::Sighting> Roster::sight(std::string_view name) const {
  const std::scoped_lock lock(mutex_);
  const auto at = members_.find(name);
  if (at == members_.end()) return std::nullopt;
  return Sighting{at->second.guid, at->second.state, at->second.has_left, at->second.heard};
}

std::optional<Member::Rival> Roster::rival_of_mine(std::string_view name) const {
  const std::scoped_lock lock(mutex_);
  const auto at = members_.find(name);
  if (at == members_.end()) return std::nullopt;
  const Member& one = at->second;
  const dds::Guid own = participant_.guid();
  if (one.guid != own && one.state == Member::State::kThere)
    return Member::Rival{one.guid, one.said.host(), one.heard, one.said.uptime()};
  auto other = rival_of(one);
  return other && other->guid != own ? other : std::nullopt;
}

bool Roster::wait(const std::function<bool(const std::vector<Member>&)>& holds,
                  Clock::time_point deadline) const {
  while (!holds(members())) {
    std::unique_lock lock(mutex_);
    if (changed_.wait_until(lock, deadline) == std::cv_status::timeout) return false;
  }
  return true;
}

}  // namespace mlab::agents
