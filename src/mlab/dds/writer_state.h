#pragma once

#include <dds/dds.h>

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
  void prompt();
  void note_those_before();
  static void on_matched(dds_entity_t writer, dds_publication_matched_status_t status, void* state);
  static void on_incompatible(dds_entity_t writer, dds_offered_incompatible_qos_status_t status, void* state);

  std::shared_ptr<ParticipantCore> core_;
  std::shared_ptr<WaiterState> waiter_;
  mutable std::mutex mutex_;
  Counterparts readers_;
  Entity topic_;
  Entity writer_;
  std::optional<Prompter::Task> prompts_;  // of channels that are asked after
};

}  // namespace mlab::dds
