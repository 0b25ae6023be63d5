#include "mlab/agents/dds_live_line.h"

#include <algorithm>
#include <thread>
#include <utility>

#include "mlab/agents/topics.h"

namespace mlab::agents {

std::expected<std::shared_ptr<DdsLiveLine>, std::string> DdsLiveLine::open(dds::Participant& participant,
                                                                           const End& out, const End& in,
                                                                           const dds::Guid& other) {
  auto waiter = dds::Waiter::make();
  if (!waiter) return std::unexpected(waiter.error());
  auto reader = participant.reader(in.topic, in.kind, *waiter);
  if (!reader) return std::unexpected(reader.error());
  auto writer = participant.writer(out.topic, out.kind);
  if (!writer) return std::unexpected(writer.error());
  return std::shared_ptr<DdsLiveLine>(
      new DdsLiveLine(std::move(*waiter), std::move(*reader), std::move(*writer), other));
}

DdsLiveLine::DdsLiveLine(dds::Waiter waiter, dds::Reader reader, dds::Writer writer, const dds::Guid& other)
    : waiter_(std::move(waiter)), reader_(std::move(reader)), writer_(std::move(writer)), other_(other) {}

bool DdsLiveLine::meet(robot_remote::Clock::time_point deadline) {
  constexpr std::chrono::milliseconds kGlance(2);
  const auto has_other = [this](const std::vector<dds::Guid>& all) {
    return std::ranges::find(all, other_) != all.end();
  };
  while (!has_other(writer_.readers()) || !has_other(reader_.senders())) {
    if (robot_remote::Clock::now() >= deadline) return false;
    std::this_thread::sleep_for(kGlance);
  }
  return true;
}

void DdsLiveLine::send(std::string_view key, std::string_view body) {
  // What is not written is as good as lost on the way: there will be newer ones.
  static_cast<void>(writer_.write(key, body));
}

std::vector<DdsLiveLine::Message> DdsLiveLine::receive(robot_remote::Clock::time_point deadline) {
  std::vector<Message> out;
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - robot_remote::Clock::now());
  waiter_.wait(std::max(left, std::chrono::milliseconds(0)));
  for (dds::Arrival& arrival : reader_.take()) {
    if (arrival.kind != dds::Arrival::Kind::kMessage || arrival.sender != other_) continue;
    out.push_back({std::move(arrival.key), std::move(arrival.body), arrival.noticed});
  }
  return out;
}

std::expected<std::shared_ptr<DdsLiveLine>, std::string> open_live_line_of_run(dds::Participant& participant,
                                                                               std::string_view agent,
                                                                               std::string_view conversation,
                                                                               const dds::Guid& other) {
  return DdsLiveLine::open(participant,
                           {percepts_topic(agent, conversation), dds::ChannelKind::kLivePercepts},
                           {actions_topic(agent, conversation), dds::ChannelKind::kActions}, other);
}

std::expected<std::shared_ptr<DdsLiveLine>, std::string> open_live_line_of_agent(
    dds::Participant& participant, std::string_view agent, std::string_view conversation,
    const dds::Guid& other) {
  return DdsLiveLine::open(participant, {actions_topic(agent, conversation), dds::ChannelKind::kActions},
                           {percepts_topic(agent, conversation), dds::ChannelKind::kLivePercepts}, other);
}

}  // namespace mlab::agents
