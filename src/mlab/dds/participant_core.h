#pragma once

#include <dds/dds.h>

#include <chrono>
#include <cstdint>
#include <expected>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "mlab/dds/channel.h"
#include "mlab/dds/complaints.h"
#include "mlab/dds/domain_number.h"
#include "mlab/dds/entity.h"
#include "mlab/dds/message.h"
#include "mlab/dds/network.h"
#include "mlab/dds/prompter.h"

namespace mlab::dds {

/// What Cyclone knows of a participant. Its readers and writers share it.
class ParticipantCore {
 public:
  static std::expected<std::shared_ptr<ParticipantCore>, std::string> open(const Network& network);

  /// Every participant has a domain of its own, whose number means something to this process only: one
  /// configuration for each, and nothing shared with others of the process.
  explicit ParticipantCore(const Network& network);

  /// @errors  a sentence
  std::expected<Entity, std::string> topic(std::string_view name) const;

  /// As Participant::has_run_out.
  bool has_run_out() const { return end_ && std::chrono::steady_clock::now() >= *end_; }

  /// Made when it is asked for first.
  Prompter& prompter();

  DomainNumber number;
  /// First to come, last to go: what Cyclone says while all else ends is heard.
  Complaints complaints;
  Entity domain;
  Entity participant;
  Entity publisher;
  Entity subscriber;
  Guid guid;

 private:
  std::optional<std::chrono::steady_clock::time_point> end_;  // of the identity; nothing: it has none
  bool is_anything_lost_;                                     // on its way
  std::once_flag prompts_;
  std::optional<Prompter> prompter_;
};

/// Key of what only prompts readers to see what they miss; they are told nothing of it.
inline constexpr std::string_view kPromptKey = "\x01prompt";

/// The QoS of a reader or writer, in which the kind stands for the other side to see.
Qos qos_of(const ChannelInfo& channel);
/// As `qos_of` wrote it; empty where it did not.
std::string kind_in(const dds_qos_t* qos);

Guid guid_of(const dds_guid_t& guid);

}  // namespace mlab::dds
