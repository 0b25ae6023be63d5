#include "mlab/ros2/participant.h"

#include <arpa/inet.h>

#include <algorithm>
#include <cstring>

#include <fmt/format.h>

#include "mlab/dds/loopback_only.h"
#include "mlab/ros2/type_hash.h"
#include "mlab/text/shown.h"

namespace mlab::ros2 {
namespace {

/// As many as have ports; a robot easily has thirty programs.
constexpr int kMostOnOneMachine = 119;
constexpr std::size_t kMostPeers = 100;
constexpr std::size_t kMostMatched = 64;  // others at the end of a topic that are looked at
/// What is larger than this is no message of a robot that we read.
constexpr int kLongestMessage = 4'000'000;
constexpr std::string_view kLoopback = "127.0.0.1";

bool is_address(const std::string& text) {
  in_addr address{};
  return inet_pton(AF_INET, text.c_str(), &address) == 1;
}

/// As Linux takes it, and nothing that would be something else in the configuration.
bool is_interface_name(const std::string& name) {
  return name.size() < 16 && std::ranges::all_of(
                                 name,
                                 [](char c) {
                                   return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                                          (c >= '0' && c <= '9') || c == '-' || c == '_' || c == '.' ||
                                          c == ':' || c == '@';
                                 });
}

bool is_loopback(const RosNetwork& network) {
  const std::string& name = network.interface_name;
  return name.empty() || name == "lo" || name.starts_with("127.");
}

std::expected<std::string, std::string> peers_of(const RosNetwork& network) {
  if (network.peers.size() > kMostPeers)
    return std::unexpected(
        fmt::format("{} machines are to be looked at: {} at most", network.peers.size(), kMostPeers));
  std::string out = is_loopback(network) ? fmt::format("<Peer address=\"{}\"/>", kLoopback) : "";
  for (const std::string& one : network.peers) {
    if (!is_address(one))
      return std::unexpected(
          fmt::format("`{}` is no IPv4 address such as 10.0.0.7: names are not looked up", text::shown(one)));
    if (is_loopback(network) && !one.starts_with("127."))
      return std::unexpected(
          fmt::format("`{}` can't be reached: without a network interface nothing leaves this machine", one));
    out += fmt::format("<Peer address=\"{}\"/>", one);
  }
  return out;
}

dds::Qos qos_of(const TopicQos& wanted, std::string_view type) {
  dds::Qos qos(dds_create_qos());
  dds_qset_reliability(qos.get(), wanted.is_reliable ? DDS_RELIABILITY_RELIABLE : DDS_RELIABILITY_BEST_EFFORT,
                       DDS_MSECS(1));
  dds_qset_durability(qos.get(),
                      wanted.is_for_latecomers ? DDS_DURABILITY_TRANSIENT_LOCAL : DDS_DURABILITY_VOLATILE);
  dds_qset_history(qos.get(), DDS_HISTORY_KEEP_LAST, wanted.depth);
  dds_qset_writer_data_lifecycle(qos.get(), false);
  const dds_data_representation_id_t representation = DDS_DATA_REPRESENTATION_XCDR1;
  dds_qset_data_representation(qos.get(), 1, &representation);
  const auto hash = type_hash(type);
  const std::string data = fmt::format("{}{}", hash ? fmt::format("typehash={};", *hash) : "", wanted.more);
  if (!data.empty()) dds_qset_userdata(qos.get(), data.data(), data.size());
  return qos;
}

dds::Qos participant_qos() {
  constexpr std::string_view kEnclave = "enclave=/;";
  dds::Qos qos(dds_create_qos());
  dds_qset_userdata(qos.get(), kEnclave.data(), kEnclave.size());
  return qos;
}

std::expected<dds::Entity, std::string> topic_in(dds_entity_t participant,
                                                 const dds_topic_descriptor_t& descriptor,
                                                 const std::string& name) {
  const dds_entity_t made = dds_create_topic(participant, &descriptor, name.c_str(), nullptr, nullptr);
  if (made < 0) return std::unexpected(fmt::format("no topic `{}`: {}", name, dds_strretcode(made)));
  return dds::Entity(made);
}

}  // namespace

std::expected<std::string, std::string> configuration_of(const RosNetwork& network) {
  if (network.domain < 0 || network.domain > kLastDomain)
    return std::unexpected(fmt::format("{} is no domain of ROS: 0 to {}", network.domain, kLastDomain));
  const std::string& name = network.interface_name;
  if (!is_interface_name(name))
    return std::unexpected(fmt::format("`{}` is no network interface such as eth0", text::shown(name)));
  const auto peers = peers_of(network);
  if (!peers) return std::unexpected(peers.error());
  const std::string interface = name.empty()       ? fmt::format("address=\"{}\"", kLoopback)
                                : is_address(name) ? fmt::format("address=\"{}\"", name)
                                                   : fmt::format("name=\"{}\"", name);
  return fmt::format(
      "<CycloneDDS><Domain Id=\"any\">"
      "<General><Interfaces><NetworkInterface {}/></Interfaces>"
      "<AllowMulticast>{}</AllowMulticast></General>"
      "<Discovery><ExternalDomainId>{}</ExternalDomainId>"
      "<ParticipantIndex>auto</ParticipantIndex><MaxAutoParticipantIndex>{}</MaxAutoParticipantIndex>"
      "<Peers>{}</Peers></Discovery>"
      "<Internal><MaxSampleSize>{} B</MaxSampleSize></Internal>"
      "<SharedMemory><Enable>false</Enable></SharedMemory>"
      "<Tracing><Verbosity>none</Verbosity></Tracing>"
      "</Domain></CycloneDDS>",
      interface, is_loopback(network) ? "false" : "spdp", network.domain, kMostOnOneMachine, *peers,
      kLongestMessage);
}

int Endpoint::writers() const {
  dds_subscription_matched_status_t status{};
  return dds_get_subscription_matched_status(handle(), &status) == 0 ? static_cast<int>(status.current_count)
                                                                     : 0;
}

int Endpoint::readers() const {
  dds_publication_matched_status_t status{};
  return dds_get_publication_matched_status(handle(), &status) == 0 ? static_cast<int>(status.current_count)
                                                                    : 0;
}

int Endpoint::readers_so_far() const {
  dds_publication_matched_status_t status{};
  return dds_get_publication_matched_status(handle(), &status) == 0 ? static_cast<int>(status.total_count)
                                                                    : 0;
}

std::string user_data_of(const dds_qos_t* qos) {
  void* bytes = nullptr;
  std::size_t size = 0;
  if (qos == nullptr || !dds_qget_userdata(qos, &bytes, &size) || bytes == nullptr) return {};
  std::string out(static_cast<const char*>(bytes), size);
  dds_free(bytes);
  return out;
}

std::vector<Reader> Endpoint::matched_readers() const {
  std::array<dds_instance_handle_t, kMostMatched> handles{};
  const dds_return_t count = dds_get_matched_subscriptions(handle(), handles.data(), handles.size());
  std::vector<Reader> out;
  for (std::size_t i = 0; i < std::min(handles.size(), static_cast<std::size_t>(std::max(count, 0))); ++i) {
    dds_builtintopic_endpoint_t* const one = dds_get_matched_subscription_data(handle(), handles[i]);
    if (one == nullptr) continue;  // it has gone again
    Reader& reader = out.emplace_back(user_data_of(one->qos));
    std::memcpy(reader.participant.data(), one->participant_key.v, reader.participant.size());
    dds_builtintopic_free_endpoint(one);
  }
  return out;
}

std::vector<dds_instance_handle_t> Endpoint::matched_writers() const {
  std::vector<dds_instance_handle_t> out(kMostMatched);
  const dds_return_t count = dds_get_matched_publications(handle(), out.data(), out.size());
  out.resize(std::min(out.size(), static_cast<std::size_t>(std::max(count, 0))));
  return out;
}

Gid gid_of(dds_entity_t entity) {
  Gid out{};
  dds_guid_t guid{};
  static_assert(sizeof guid.v == out.size());
  if (dds_get_guid(entity, &guid) == 0) std::memcpy(out.data(), guid.v, out.size());
  return out;
}

std::expected<std::unique_ptr<RosParticipant>, std::string> RosParticipant::open(const RosNetwork& network) {
  std::unique_ptr<RosParticipant> out(new RosParticipant);
  if (auto begun = out->begin(network); !begun) {
    std::string words = begun.error();
    for (const std::string& said : out->complaints()) words += fmt::format("; {}", said);
    return std::unexpected(std::move(words));
  }
  return out;
}

std::expected<void, std::string> RosParticipant::begin(const RosNetwork& network) {
  const auto configuration = configuration_of(network);
  if (!configuration) return std::unexpected(configuration.error());
  const dds_entity_t domain = dds_create_domain(number_.value(), configuration->c_str());
  if (domain < 0)
    return std::unexpected(
        fmt::format("no place in the domain {} of ROS: {}", network.domain, dds_strretcode(domain)));
  domain_ = dds::Entity(domain);
  if (is_loopback(network)) {
    if (const auto closed = dds::hear_loopback_only(network.domain); !closed)
      return std::unexpected(closed.error());
  }
  auto made = make_second();
  if (!made) return std::unexpected(made.error());
  participant_ = std::move(*made);
  complaints_.opened();
  return {};
}

std::expected<dds::Entity, std::string> RosParticipant::make_second() const {
  const dds::Qos qos = participant_qos();
  const dds_entity_t made = dds_create_participant(number_.value(), qos.get(), nullptr);
  if (made < 0) return std::unexpected(fmt::format("no participant: {}", dds_strretcode(made)));
  return dds::Entity(made);
}

std::expected<Endpoint, std::string> RosParticipant::reader(const std::string& name,
                                                            const dds_topic_descriptor_t& descriptor,
                                                            std::string_view type,
                                                            const TopicQos& wanted) const {
  auto topic = topic_in(handle(), descriptor, name);
  if (!topic) return std::unexpected(topic.error());
  const dds::Qos qos = qos_of(wanted, type);
  const dds_entity_t made = dds_create_reader(handle(), topic->handle(), qos.get(), nullptr);
  if (made < 0) return std::unexpected(fmt::format("`{}` can't be read: {}", name, dds_strretcode(made)));
  return Endpoint{std::move(*topic), dds::Entity(made), gid_of(made)};
}

std::expected<Endpoint, std::string> RosParticipant::writer(const std::string& name,
                                                            const dds_topic_descriptor_t& descriptor,
                                                            std::string_view type, const TopicQos& wanted,
                                                            dds_entity_t in) const {
  const dds_entity_t participant = in == 0 ? handle() : in;
  auto topic = topic_in(participant, descriptor, name);
  if (!topic) return std::unexpected(topic.error());
  const dds::Qos qos = qos_of(wanted, type);
  const dds_entity_t made = dds_create_writer(participant, topic->handle(), qos.get(), nullptr);
  if (made < 0) return std::unexpected(fmt::format("`{}` can't be written: {}", name, dds_strretcode(made)));
  return Endpoint{std::move(*topic), dds::Entity(made), gid_of(made)};
}

Gid RosParticipant::gid() const {
  return gid_of(handle());
}

}  // namespace mlab::ros2
