#pragma once

#include <chrono>
#include <cstddef>
#include <expected>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/agents/roster.h"
#include "mlab/agents/stop_state.h"
#include "mlab/dds/participant.h"

/// Whom the members of a fleet miss, each from where it is. They tell each other, so that one who has come
/// late, to pull the emergency stop say, can name agents that he has never heard himself.

namespace mlab::agents {

/// An agent that was heard once, and is out of reach; or one that is there and has not confirmed the
/// emergency stop.
struct Missed {
  std::string name;     ///< is_agent_name
  std::string machine;  ///< fit for people
  double silent = 0.0;  ///< since it was heard last [s], >= 0
};

/// Who misses whom.
struct MissedAgents {
  std::string by;  ///< for people: `agent north`
  std::vector<Missed> agents;
};

/// More are not told of, and not believed.
inline constexpr std::size_t kMostMissed = 64;
/// One that no run works with is forgotten when nothing has been heard of it for so long.
inline constexpr std::chrono::hours kMissedFor(1);

/// Of the members of a fleet those that are missed: not those that have left in order. Those that a run works
/// with first, then those that were heard last; kMostMissed at most.
/// @param holds  the emergency stop; where it is engaged, who is there has to have confirmed it
std::vector<Missed> missed_among(std::vector<Member> members, const StopState& holds, Clock::time_point now);

std::string encode(const MissedAgents& missed);
/// Nothing where it is nonsense; agents that can't be are left out, and text is fit for people.
std::optional<MissedAgents> decode_missed(std::string_view message);

/// Says whom somebody misses. One thread at a time. Who never misses anybody costs the fleet nothing.
class MissedTeller {
 public:
  /// @param participant  outlives this
  /// @param by           who says it, for people
  MissedTeller(dds::Participant& participant, std::string by);
  MissedTeller(const MissedTeller&) = delete;
  MissedTeller& operator=(const MissedTeller&) = delete;
  /// Whoever has left misses nobody.
  ~MissedTeller();

  /// To be called twice a second, and when something has changed.
  void say(std::vector<Missed> agents);

 private:
  dds::Participant& participant_;
  std::string by_;
  std::string key_;
  std::optional<dds::Writer> writer_;  // nothing: there was nobody to tell of yet, or it can't be made
  bool is_said_ = false;
};

/// What is known of missed agents by what others say. May be used by any thread.
class Hearsay {
 public:
  /// @param waiter  is woken when there is something new
  /// @errors        a sentence: the network can't be used
  static std::expected<std::unique_ptr<Hearsay>, std::string> open(dds::Participant& participant,
                                                                   dds::Waiter& waiter);

  void listen();

  struct Entry {
    Missed agent;  ///< silent: by now
    std::string by;
  };
  /// By name, each once: as told by who has heard it last. What somebody said who has not left in order holds
  /// for kMissedFor.
  std::vector<Entry> all(Clock::time_point now) const;

 private:
  explicit Hearsay(dds::Reader reader) : reader_(std::move(reader)) {}
  void take(const dds::Arrival& arrival);

  struct Told {
    MissedAgents missed;
    Clock::time_point when;
  };
  dds::Reader reader_;
  mutable std::mutex mutex_;
  std::map<dds::Guid, Told> told_;  // by participant: each has one such list
};

}  // namespace mlab::agents
