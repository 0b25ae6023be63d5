#pragma once

#include <dds/dds.h>

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "mlab/dds/counterparts.h"
#include "mlab/dds/participant_core.h"
#include "mlab/dds/reader.h"
#include "mlab/dds/waiter_state.h"

namespace mlab::dds {

/// What has arrived and was not taken yet. Its owner locks.
class Waiting {
 public:
  /// @param is_newest_only  of each key only the newest message is kept
  explicit Waiting(bool is_newest_only) : is_newest_only_(is_newest_only) {}

  void add(Arrival arrival);
  std::vector<Arrival> take();

 private:
  bool is_newest_only_;
  std::vector<Arrival> arrivals_;
  /// Where the message of a key stands.
  std::unordered_map<std::string, std::size_t> newest_;
  std::size_t bytes_ = 0;
  std::uint64_t lost_ = 0;
  std::chrono::steady_clock::time_point lost_at_;
};

/// Under the lock of its reader.
struct Reader::Branch::Queue {
  Guid sender;
  std::string key;
  std::shared_ptr<WaiterState> waiter;
  Waiting waiting;
};

/// A reader as Cyclone's threads see it: they call its listener, which touches it only under its lock.
class Reader::State {
 public:
  State(std::shared_ptr<ParticipantCore> core, std::shared_ptr<WaiterState> waiter, std::string topic,
        ChannelKind kind);
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State();

  /// @errors  a sentence
  std::expected<void, std::string> begin(const std::string& topic, ChannelKind kind);

  std::vector<Arrival> take();
  std::shared_ptr<Branch::Queue> add_branch(const Guid& sender, std::string_view key,
                                            std::shared_ptr<WaiterState> waiter);
  void end_branch(const std::shared_ptr<Branch::Queue>& branch);
  std::vector<Arrival> take(Branch::Queue& branch);
  std::vector<Guid> senders() const;
  std::vector<std::string> mismatches() const;

 private:
  static void on_data(dds_entity_t reader, void* state);
  static void on_matched(dds_entity_t reader, dds_subscription_matched_status_t status, void* state);
  static void on_liveliness(dds_entity_t reader, dds_liveliness_changed_status_t status, void* state);
  static void on_incompatible(dds_entity_t reader, dds_requested_incompatible_qos_status_t status,
                              void* state);

  Listener listener();
  bool fetch(dds_entity_t reader);
  /// Empty where its message doesn't count.
  std::optional<Guid> sender(dds_entity_t reader, dds_instance_handle_t writer);
  std::optional<Counterparts::Counterpart> look_up(dds_entity_t reader, dds_instance_handle_t writer);
  void tell(Arrival arrival);

  std::shared_ptr<ParticipantCore> core_;
  std::shared_ptr<WaiterState> waiter_;
  mutable std::mutex mutex_;
  Counterparts writers_;
  Waiting waiting_;
  std::vector<std::shared_ptr<Branch::Queue>> branches_;
  bool is_newest_only_;
  bool are_messages_quiet_;  // they say nothing but that who writes them is alive
  Entity topic_;
  Entity reader_;
};

}  // namespace mlab::dds
