#pragma once

#include <dds/dds.h>

#include <chrono>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "mlab/dds/counterparts.h"
#include "mlab/dds/participant_core.h"
#include "mlab/dds/prompter.h"
#include "mlab/dds/waiter_state.h"
#include "mlab/dds/writer.h"

namespace mlab::dds {

/// A writer as Cyclone's threads see it: they call its listener, which touches it only under its lock.
class Writer::State {
 public:
  using Clock = std::chrono::steady_clock;
  /// A reader that does not answer counts as one that hears in the end: another one that is gone, and was not
  /// given up yet, keeps what is written from being acknowledged by all.
  static constexpr std::chrono::seconds kLongestJoining{1};

  /// @param waiter  may be null
  State(std::shared_ptr<ParticipantCore> core, std::shared_ptr<WaiterState> waiter, std::string topic,
        ChannelKind kind);
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State();

  /// @errors  a sentence
  std::expected<void, std::string> begin(const std::string& topic, ChannelKind kind);

  Written write(std::string_view key, std::string_view body);
  Written end(std::string_view key);
  std::vector<Guid> readers() const;
  std::vector<std::string> mismatches() const;

 private:
  /// A reader that has matched and did not answer yet.
  struct Joining {
    dds_instance_handle_t reader = 0;
    std::uint64_t number = 0;  ///< counted from 1
    Clock::time_point until;
  };

  bool prompt();
  void note_those_before();
  void set_there(dds_instance_handle_t reader, bool is_there);
  bool note_those_that_answered();
  static void on_matched(dds_entity_t writer, dds_publication_matched_status_t status, void* state);
  static void on_incompatible(dds_entity_t writer, dds_offered_incompatible_qos_status_t status, void* state);

  std::shared_ptr<ParticipantCore> core_;
  std::shared_ptr<WaiterState> waiter_;
  mutable std::mutex mutex_;
  Counterparts readers_;
  std::vector<Joining> joining_;
  std::uint64_t joined_ = 0;    // so many have ever been in `joining_`
  std::uint64_t prompted_ = 0;  // so many of them were prompted; the prompter's thread alone uses it
  bool is_asked_after_;         // the channel
  bool can_prompt_ = false;     // `prompts_` is there
  Entity topic_;
  Entity writer_;
  std::optional<Prompter::Task> prompts_;  // of channels that are asked after
};

}  // namespace mlab::dds
