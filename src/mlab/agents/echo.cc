#include "mlab/agents/echo.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include <fmt/core.h>

#include "mlab/agents/topics.h"
#include "mlab/presence.pb.h"

namespace mlab::agents {
namespace {

using WallClock = std::chrono::system_clock;

constexpr double kLongestRoundTrip = 60.0;  // [s]

std::int64_t nanoseconds_of(WallClock::time_point time) {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(time.time_since_epoch()).count();
}

double seconds(Clock::duration duration) {
  return std::chrono::duration<double>(duration).count();
}

}  // namespace

bool is_clock_known(const LinkQuality& link) {
  constexpr double kLeast = 0.0005;  // [s]
  return std::abs(link.clock_offset) > link.round_trip / 2.0 && std::abs(link.clock_offset) >= kLeast;
}

void LinkHistory::asked(std::uint64_t number, Clock::time_point now) {
  questions_.push_back({.number = number, .asked = now});
  if (questions_.size() > kKept) questions_.pop_front();
}

void LinkHistory::answered(std::uint64_t number, double round_trip, double clock_offset) {
  if (!(round_trip >= 0.0) || round_trip > kLongestRoundTrip) return;
  const auto at = std::ranges::find(questions_, number, &Question::number);
  if (at == questions_.end() || at->has_answer) return;
  at->has_answer = true;
  at->round_trip = round_trip;
  at->clock_offset = clock_offset;
  // What was asked before both had found each other was not lost on the way.
  if (!std::exchange(has_met_, true)) questions_.erase(questions_.begin(), at);
}

std::optional<LinkQuality> LinkHistory::quality(Clock::time_point now) const {
  LinkQuality out;
  std::size_t answers = 0;
  std::size_t due = 0;
  for (std::size_t i = 0; i < questions_.size(); ++i) {
    const Question& one = questions_[i];
    // Answers don't overtake each other: with the answer of a later one all before it are due.
    if (one.has_answer || now - one.asked >= kPatience) due = i + 1;
    if (!one.has_answer) continue;
    if (answers++ > 0 && one.round_trip >= out.round_trip) continue;
    out.round_trip = one.round_trip;
    out.clock_offset = one.clock_offset;
  }
  if (answers == 0) return std::nullopt;
  out.lost = 1.0 - static_cast<double>(answers) / static_cast<double>(due);
  return out;
}

std::expected<std::unique_ptr<EchoProbe>, std::string> EchoProbe::open(std::shared_ptr<Roster> roster) {
  auto waiter = dds::Waiter::make();
  if (!waiter) return std::unexpected(waiter.error());
  dds::Participant& participant = roster->participant();
  auto reader = participant.reader(kEchoTopic, dds::ChannelKind::kEchoes, *waiter);
  if (!reader) return std::unexpected(reader.error());
  auto writer = participant.writer(kEchoQuestionTopic, dds::ChannelKind::kEchoes);
  if (!writer) return std::unexpected(writer.error());
  return std::unique_ptr<EchoProbe>(
      new EchoProbe(std::move(roster), std::move(*waiter), std::move(*reader), std::move(*writer)));
}

EchoProbe::EchoProbe(std::shared_ptr<Roster> roster, dds::Waiter waiter, dds::Reader reader,
                     dds::Writer writer)
    : roster_(std::move(roster)),
      waiter_(std::move(waiter)),
      reader_(std::move(reader)),
      writer_(std::move(writer)) {
  // Askers are told apart by it, nothing else depends on it.
  std::random_device random;
  key_ = fmt::format("{:08x}{:08x}", random(), random());
}

void EchoProbe::ask() {
  const Clock::time_point now = Clock::now();
  for (const Member& agent : roster_->members()) {
    if (agent.state != Member::State::kGone) links_[agent.said.name()].asked(number_ + 1, now);
  }
  asked_[++number_] = {Clock::now(), WallClock::now()};
  if (asked_.size() > LinkHistory::kKept) asked_.erase(asked_.begin());
  wire::EchoQuestion question;
  question.set_number(number_);
  // What is not written is as good as lost on the way.
  static_cast<void>(writer_.write(key_, question.SerializeAsString()));
}

void EchoProbe::measure(std::chrono::milliseconds time) {
  ask();
  const Clock::time_point end = Clock::now() + time;
  for (Clock::time_point now = Clock::now(); now < end; now = Clock::now()) {
    waiter_.wait(std::chrono::ceil<std::chrono::milliseconds>(end - now));
    for (const dds::Arrival& arrival : reader_.take()) take(arrival);
  }
}

void EchoProbe::take(const dds::Arrival& arrival) {
  wire::Echo echo;
  if (arrival.kind != dds::Arrival::Kind::kMessage || !echo.ParseFromString(arrival.body) ||
      echo.asker() != key_)
    return;
  const auto agent = roster_->sight(arrival.key);
  const auto asked = asked_.find(echo.number());
  if (!agent || agent->guid != arrival.sender || asked == asked_.end()) return;
  // The four times of NTP: by steady clocks how long it took, by wall clocks how they differ.
  const double away = seconds(arrival.noticed - asked->second.steady);
  const double there = static_cast<double>(echo.sent() - echo.received()) * 1e-9;
  const double round_trip = away - there;
  const double to_there = static_cast<double>(echo.received() - nanoseconds_of(asked->second.wall)) * 1e-9;
  links_[arrival.key].answered(echo.number(), round_trip, to_there - round_trip / 2.0);
}

std::optional<LinkQuality> EchoProbe::quality(const std::string& agent) const {
  const auto at = links_.find(agent);
  return at == links_.end() ? std::nullopt : at->second.quality(Clock::now());
}

std::expected<EchoAnswerer, std::string> EchoAnswerer::open(dds::Participant& participant,
                                                            const dds::Waiter& waiter, std::string name) {
  auto reader = participant.reader(kEchoQuestionTopic, dds::ChannelKind::kEchoes, waiter);
  if (!reader) return std::unexpected(reader.error());
  auto writer = participant.writer(kEchoTopic, dds::ChannelKind::kEchoes);
  if (!writer) return std::unexpected(writer.error());
  return EchoAnswerer(std::move(*reader), std::move(*writer), std::move(name));
}

EchoAnswerer::EchoAnswerer(dds::Reader reader, dds::Writer writer, std::string name)
    : reader_(std::move(reader)), writer_(std::move(writer)), name_(std::move(name)) {}

void EchoAnswerer::answer() {
  for (const dds::Arrival& arrival : reader_.take()) {
    wire::EchoQuestion question;
    if (arrival.kind != dds::Arrival::Kind::kMessage || !question.ParseFromString(arrival.body)) continue;
    const WallClock::time_point now = WallClock::now();
    wire::Echo echo;
    echo.set_asker(arrival.key);
    echo.set_number(question.number());
    echo.set_sent(nanoseconds_of(now));
    // Between being noticed and now it waited for this thread.
    echo.set_received(nanoseconds_of(
        now - std::chrono::duration_cast<WallClock::duration>(Clock::now() - arrival.noticed)));
    static_cast<void>(writer_.write(name_, echo.SerializeAsString()));
  }
}

}  // namespace mlab::agents
