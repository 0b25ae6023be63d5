#include "mlab/dds/participant_core.h"

#include <algorithm>
#include <cstring>

#include <fmt/format.h>

#include "envelope.h"
#include "mlab/dds/loopback_only.h"
#include "mlab/dds/security_settings.h"
#include "mlab/text/shown.h"

namespace mlab::dds {
namespace {

constexpr std::size_t kMaxTopicName = 200;

bool is_topic_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' ||
         c == '.' || c == '/';
}

/// As Cyclone takes it: letters, digits, `_` and `/`, with no digit at the begin. No two names become one.
std::string topic_on_the_wire(std::string_view name) {
  std::string same = "mlab/";
  for (const char c : name) {
    if (c == '_')
      same += "__";
    else if (c == '-')
      same += "_m";
    else if (c == '.')
      same += "_d";
    else
      same += c;
  }
  return same;
}

/// What failed, and what Cyclone has to say of it.
std::string sentence(std::string_view failed, dds_return_t code, Complaints& complaints) {
  std::string words = fmt::format("{}: {}", failed, dds_strretcode(code));
  for (const std::string& said : complaints.take()) words += fmt::format("; {}", said);
  return words;
}

/// Takes a place among the participants of this machine: those that avoid their neighbours from the first on,
/// all others from the last on. Who has been told of a place goes on saying there that it is there, also when
/// somebody else has it; so neighbours would meet in places that somebody has left whom both have met.
/// @errors  a sentence of `configuration_of`; Cyclone's code is the domain's handle, then
std::expected<dds_entity_t, std::string> take_place(const Network& network, std::uint32_t number,
                                                    Complaints& complaints) {
  dds_entity_t domain = DDS_RETCODE_OUT_OF_RESOURCES;
  for (int place = kMaxParticipants - 1; place >= 0 && domain < 0; --place) {
    const auto configuration =
        network.avoids_neighbours ? configuration_of(network) : configuration_of(network, place);
    if (!configuration) return std::unexpected(configuration.error());
    static_cast<void>(complaints.take());  // of a place that is taken
    domain = dds_create_domain(number, configuration->c_str());
    if (network.avoids_neighbours) break;
  }
  return domain;
}

/// Publisher and subscriber: both in the fleet's partition.
Qos qos_in(const std::string& partition) {
  Qos qos(dds_create_qos());
  dds_qset_partition1(qos.get(), partition.c_str());
  return qos;
}

}  // namespace

ParticipantCore::ParticipantCore(const Network& network)
    : number(network.security.has_value()),
      complaints(number.value()),
      is_anything_lost_(network.lost_of_thousand > 0 || !is_loopback_only(network)) {
  if (network.security) end_ = std::chrono::steady_clock::now() + time_left(*network.security);
}

std::expected<std::shared_ptr<ParticipantCore>, std::string> ParticipantCore::open(const Network& network) {
  if (const auto checked = configuration_of(network); !checked) return std::unexpected(checked.error());
  const auto identity = identity_of(network);
  if (!identity) return std::unexpected(identity.error());
  auto core = std::make_shared<ParticipantCore>(network);
  const std::uint32_t number = core->number.value();
  if (number == 0) return std::unexpected("this process takes part in too many secured fleets");
  const auto failed = [&](std::string_view what, dds_entity_t code) {
    return std::unexpected(
        sentence(fmt::format("{} of the fleet `{}`", what, network.fleet), code, core->complaints));
  };
  const auto domain = take_place(network, number, core->complaints);
  if (!domain) return std::unexpected(domain.error());
  if (*domain < 0)
    return failed(fmt::format("no place (of {} on this machine) on the network", kMaxParticipants), *domain);
  core->domain = Entity(*domain);
  if (is_loopback_only(network)) {
    const auto closed = hear_loopback_only(domain_of(network.fleet));
    if (!closed) return std::unexpected(closed.error());
  }
  const dds_entity_t participant = dds_create_participant(number, identity->get(), nullptr);
  if (participant < 0) return failed("no participant", participant);
  core->participant = Entity(participant);
  const Qos qos = qos_in(partition_of(network.fleet));
  core->publisher = Entity(dds_create_publisher(participant, qos.get(), nullptr));
  core->subscriber = Entity(dds_create_subscriber(participant, qos.get(), nullptr));
  if (core->publisher.handle() < 0) return failed("no publisher", core->publisher.handle());
  if (core->subscriber.handle() < 0) return failed("no subscriber", core->subscriber.handle());
  dds_guid_t guid{};
  if (const dds_return_t code = dds_get_guid(participant, &guid); code < 0)
    return failed("no identity", code);
  core->guid = guid_of(guid);
  core->complaints.opened();
  return core;
}

Prompter& ParticipantCore::prompter() {
  std::call_once(prompts_, [this] {
    prompter_.emplace(is_anything_lost_ ? Prompter::Patience() : Prompter::kWhereNothingIsLost);
  });
  return *prompter_;
}

std::expected<Entity, std::string> ParticipantCore::topic(std::string_view name) const {
  if (has_run_out()) return std::unexpected("this machine's identity in the secured fleet has run out");
  if (name.empty()) return std::unexpected("the topic has no name");
  if (name.size() > kMaxTopicName)
    return std::unexpected(
        fmt::format("the topic's name has {} letters: {} at most", name.size(), kMaxTopicName));
  if (!std::ranges::all_of(name, is_topic_letter))
    return std::unexpected(fmt::format(
        "the topic's name `{}` has more than letters, digits, `_`, `-`, `.` and `/`", text::shown(name)));
  const dds_entity_t made = dds_create_topic(participant.handle(), &mlab_dds_Envelope_desc,
                                             topic_on_the_wire(name).c_str(), nullptr, nullptr);
  if (made < 0) return std::unexpected(fmt::format("no topic `{}`: {}", name, dds_strretcode(made)));
  return Entity(made);
}

Qos qos_of(const ChannelInfo& channel) {
  Qos qos(dds_create_qos());
  const auto wait = std::chrono::nanoseconds(channel.longest_wait).count();
  dds_qset_reliability(qos.get(),
                       channel.is_reliable ? DDS_RELIABILITY_RELIABLE : DDS_RELIABILITY_BEST_EFFORT, wait);
  dds_qset_durability(qos.get(),
                      channel.is_for_latecomers ? DDS_DURABILITY_TRANSIENT_LOCAL : DDS_DURABILITY_VOLATILE);
  dds_qset_durability_service(qos.get(), 0, DDS_HISTORY_KEEP_LAST, 1, DDS_LENGTH_UNLIMITED,
                              DDS_LENGTH_UNLIMITED, DDS_LENGTH_UNLIMITED);
  if (channel.is_newest_only)
    dds_qset_history(qos.get(), DDS_HISTORY_KEEP_LAST, 1);
  else
    dds_qset_history(qos.get(), DDS_HISTORY_KEEP_ALL, DDS_LENGTH_UNLIMITED);
  if (channel.lease.count() > 0)
    dds_qset_liveliness(qos.get(), DDS_LIVELINESS_MANUAL_BY_TOPIC,
                        std::chrono::nanoseconds(channel.lease).count());
  // A writer that goes ends its keys only if it says so: who is killed must not look like who has finished.
  dds_qset_writer_data_lifecycle(qos.get(), false);
  dds_qset_userdata(qos.get(), channel.name.data(), channel.name.size());
  return qos;
}

std::string kind_in(const dds_qos_t* qos) {
  void* bytes = nullptr;
  std::size_t size = 0;
  if (qos == nullptr || !dds_qget_userdata(qos, &bytes, &size) || bytes == nullptr) return {};
  std::string kind(static_cast<const char*>(bytes), size);
  dds_free(bytes);
  return kind;
}

Guid guid_of(const dds_guid_t& guid) {
  Guid same;
  static_assert(sizeof guid.v == sizeof same.bytes);
  std::memcpy(same.bytes.data(), guid.v, sizeof guid.v);
  return same;
}

}  // namespace mlab::dds
