#pragma once

#include <dds/dds.h>

#include <array>
#include <chrono>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "listener.h"

namespace mlab::ros2_robot {

/// Cyclone DDS in C, as little of it as the test needs: the other side of what the robot says. On the
/// loopback alone, without multicast, as ROS 2 sets it up where ROS_AUTOMATIC_DISCOVERY_RANGE is LOCALHOST.
class CycloneSide {
 public:
  explicit CycloneSide(int domain)
      : domain_(dds_create_domain(static_cast<dds_domainid_t>(domain), kConfiguration)),
        participant_(dds_create_participant(static_cast<dds_domainid_t>(domain), nullptr, nullptr)) {}
  ~CycloneSide() {
    dds_delete(participant_);
    dds_delete(domain_);
  }
  CycloneSide(const CycloneSide&) = delete;
  CycloneSide& operator=(const CycloneSide&) = delete;

  dds_entity_t participant() const { return participant_; }
  dds_entity_t reader(const dds_topic_descriptor_t& type, const std::string& topic,
                      bool is_kept = false) const {
    dds_qos_t* qos = dds_create_qos();
    dds_qset_reliability(qos, DDS_RELIABILITY_BEST_EFFORT, 0);
    if (is_kept) {
      dds_qset_reliability(qos, DDS_RELIABILITY_RELIABLE, DDS_SECS(1));
      dds_qset_durability(qos, DDS_DURABILITY_TRANSIENT_LOCAL);
    }
    return made(
        qos, [&](dds_entity_t t) { return dds_create_reader(participant_, t, qos, nullptr); }, type, topic);
  }
  /// Of what is to arrive each: questions, answers, commands.
  dds_entity_t reliable_reader(const dds_topic_descriptor_t& type, const std::string& topic) const {
    dds_qos_t* qos = reliable();
    return made(
        qos, [&](dds_entity_t t) { return dds_create_reader(participant_, t, qos, nullptr); }, type, topic);
  }
  dds_entity_t writer(const dds_topic_descriptor_t& type, const std::string& topic) const {
    dds_qos_t* qos = reliable();
    return made(
        qos, [&](dds_entity_t t) { return dds_create_writer(participant_, t, qos, nullptr); }, type, topic);
  }

 private:
  static constexpr const char* kConfiguration =
      "<CycloneDDS><Domain Id=\"any\"><General><Interfaces><NetworkInterface address=\"127.0.0.1\" "
      "multicast=\"false\"/></Interfaces><AllowMulticast>false</AllowMulticast></General><Discovery>"
      "<ParticipantIndex>auto</ParticipantIndex><MaxAutoParticipantIndex>32</MaxAutoParticipantIndex>"
      "<Peers><Peer address=\"127.0.0.1\"/></Peers></Discovery><Tracing><Verbosity>none</Verbosity></Tracing>"
      "</Domain></CycloneDDS>";

  static dds_qos_t* reliable() {
    dds_qos_t* qos = dds_create_qos();
    dds_qset_reliability(qos, DDS_RELIABILITY_RELIABLE, DDS_SECS(1));
    dds_qset_history(qos, DDS_HISTORY_KEEP_LAST, 10);
    return qos;
  }
  template <class Make>
  dds_entity_t made(dds_qos_t* qos, const Make& make, const dds_topic_descriptor_t& type,
                    const std::string& topic) const {
    const dds_entity_t of = dds_create_topic(participant_, &type, topic.c_str(), nullptr, nullptr);
    const dds_entity_t out = make(of);
    dds_delete_qos(qos);
    return out;
  }

  dds_entity_t domain_;
  dds_entity_t participant_;
};

/// Hands over what has come since.
/// @return  how many
template <class Message>
int take(dds_entity_t reader, const std::function<void(const Message&)>& use) {
  constexpr int kMost = 32;
  std::array<void*, kMost> samples{};
  std::array<dds_sample_info_t, kMost> infos{};
  const int count = dds_take(reader, samples.data(), infos.data(), kMost, kMost);
  int out = 0;
  for (int i = 0; i < count; ++i) {
    if (!infos.at(static_cast<std::size_t>(i)).valid_data) continue;
    use(*static_cast<const Message*>(samples.at(static_cast<std::size_t>(i))));
    ++out;
  }
  if (count > 0) dds_return_loan(reader, samples.data(), count);
  return out;
}

/// Whether it comes to be so, in ten seconds at most; meanwhile something is done every two milliseconds.
inline bool becomes(const std::function<bool()>& is_so, const std::function<void()>& meanwhile = {}) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  while (!is_so()) {
    if (std::chrono::steady_clock::now() > end) return false;
    if (meanwhile) meanwhile();
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return true;
}

inline bool has_partner(dds_entity_t endpoint) {
  dds_instance_handle_t one = 0;
  const bool is_writer = dds_get_matched_subscriptions(endpoint, &one, 1) > 0;
  return is_writer || dds_get_matched_publications(endpoint, &one, 1) > 0;
}

}  // namespace mlab::ros2_robot
