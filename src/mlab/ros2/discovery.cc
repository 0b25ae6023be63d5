#include "mlab/ros2/discovery.h"

#include <algorithm>
#include <cstring>
#include <string_view>

#include <fmt/format.h>

#include "mlab/ros2/take_all.h"

namespace mlab::ros2 {
namespace {

/// Names of types that strangers make up are not kept without end.
constexpr std::size_t kMostTypes = 8;

}  // namespace

std::expected<Discovery, std::string> Discovery::begin(const RosParticipant& participant,
                                                       std::string velocity_topic) {
  Discovery out(std::move(velocity_topic));
  const dds_entity_t made =
      dds_create_reader(participant.handle(), DDS_BUILTIN_TOPIC_DCPSSUBSCRIPTION, nullptr, nullptr);
  if (made < 0) return std::unexpected(fmt::format("nobody can be found: {}", dds_strretcode(made)));
  out.subscriptions_ = dds::Entity(made);
  out.own_ = participant.gid();
  return out;
}

void Discovery::take(const dds_builtintopic_endpoint_t& endpoint) {
  Gid owner{};
  static_assert(sizeof endpoint.participant_key.v == owner.size());
  std::memcpy(owner.data(), endpoint.participant_key.v, owner.size());
  if (owner == own_) return;
  has_type_hashes_ = has_type_hashes_ || user_data_of(endpoint.qos).contains("typehash=RIHS01_");
  if (endpoint.topic_name == nullptr || endpoint.type_name == nullptr ||
      velocity_topic_ != endpoint.topic_name)
    return;
  if (velocity_types_.size() < kMostTypes && !has_listener_of(endpoint.type_name))
    velocity_types_.emplace_back(endpoint.type_name);
}

void Discovery::look() {
  take_all<dds_builtintopic_endpoint_t>(subscriptions_.handle(),
                                        [&](const auto& endpoint, const auto&) { take(endpoint); });
}

bool Discovery::has_listener_of(std::string_view type) const {
  return std::ranges::find(velocity_types_, type) != velocity_types_.end();
}

}  // namespace mlab::ros2
