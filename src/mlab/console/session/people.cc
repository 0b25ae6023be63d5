#include "mlab/console/session/people.h"

#include <utility>

#include <fmt/core.h>

namespace mlab::console {
namespace {

constexpr double kBeatEvery = 0.2;  // a little more often than the loop looks around at least [s]

std::shared_ptr<const std::string> bytes_of(const ToBrowser& message) {
  return std::make_shared<const std::string>(message.SerializeAsString());
}

}  // namespace

People::People(Welcome welcome, Session::Send send) : welcome_(std::move(welcome)), send_(std::move(send)) {}

Answered People::join(ConnectionId from, const Hello& hello) {
  if (hello.protocol() != welcome_.protocol())
    return fmt::format("this server speaks version {} of the protocol, not {}: load the page anew",
                       welcome_.protocol(), hello.protocol());
  if (channels_.contains(from)) return "Hello has been said";
  const Roles::Joined joined = roles_.join(from, hello.name(), hello.client_key(), wall_time());
  channels_.emplace(from, Channel(from));
  if (joined.displaced.value != 0 && channels_.contains(joined.displaced)) welcome(joined.displaced);
  return std::nullopt;
}

void People::leave(ConnectionId from) {
  channels_.erase(from);
  roles_.leave(from, wall_time());
}

void People::forget() {
  roles_.forget(wall_time());
}

std::optional<Sender> People::find(ConnectionId from) {
  const auto channel = channels_.find(from);
  const Roles::Client* client = roles_.of(from);
  if (channel == channels_.end() || client == nullptr) return std::nullopt;
  return Sender{channel->second, *client};
}

// ---- what they ask for

Answered People::why_no_operator(const Roles::Client& client) const {
  if (roles_.is_operator(client.id)) return std::nullopt;
  const Roles::Client* holder = roles_.find(roles_.operator_id());
  if (holder == nullptr) return "nobody is the operator: take the operator's place first";
  return fmt::format("only the operator may do this, and that is {}", holder->name);
}

void People::acknowledge(const Sender& sender, const Acknowledge& drawn) {
  sender.channel.acknowledge(drawn.frame());
}

void People::beat(const Sender& sender, const Beat& beat) {
  sender.channel.beat = beat.number();
  send_beat(sender.channel);
}

// ---- what they are told

void People::send(ConnectionId to, const ToBrowser& message) const {
  send_(to, bytes_of(message));
}

void People::broadcast(const ToBrowser& message, bool of_run) const {
  if (channels_.empty()) return;
  const auto bytes = bytes_of(message);
  for (const auto& [id, channel] : channels_) {
    if (!of_run || !channel.looks_back) send_(id, bytes);
  }
}

void People::welcome(ConnectionId to) const {
  ToBrowser out;
  *out.mutable_welcome() = welcome_;
  out.mutable_welcome()->set_client(roles_.of(to)->id);
  send(to, out);
}

void People::send_log(Channel& channel, const EventLog& log) const {
  const bool has_alerts = channel.alerts_seen == log.alerts_after();
  if (channel.log_seen == log.last() && has_alerts) return;
  channel.alerts_seen = log.alerts_after();
  ToBrowser out;
  log.encode_since(channel.log_seen, *out.mutable_log());
  channel.log_seen = log.last();
  send(channel.connection(), out);
}

void People::send_beat(const Channel& channel) const {
  ToBrowser out;
  out.mutable_beat()->set_number(channel.beat);
  send(channel.connection(), out);
}

void People::send_beats() {
  const double wall = wall_time();
  if (wall < last_beats_ + kBeatEvery) return;
  last_beats_ = wall;
  for (const auto& [id, channel] : channels_) send_beat(channel);
}

}  // namespace mlab::console
