#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <expected>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "mlab/dds/participant.h"
#include "mlab/presence.pb.h"

namespace mlab::agents {

using Clock = std::chrono::steady_clock;

/// What is known of an agent that was there once.
struct Member {
  enum class State : std::uint8_t {
    kThere,
    kSilent,  ///< nothing is heard of it: it is stopped, killed, or can't be reached
    kGone,    ///< it has left, or was silent for so long that it is not waited for any more
  };
  wire::AgentPresence said;  ///< last, checked: its name is one, text is fit for people
  dds::Guid guid;
  State state = State::kThere;
  bool has_left = false;    ///< in order: nobody there is commanded any more
  Clock::time_point since;  ///< of the state
  Clock::time_point heard;  ///< when it spoke last
  bool is_held = false;     ///< Roster::hold
  /// Somebody else who says that this is his name, too; heard last of all such.
  struct Rival {
    dds::Guid guid;
    std::string host;
    Clock::time_point heard;
    double uptime = 0.0;  ///< when it was heard, since it began [s]
  };
  std::optional<Rival> rival;  ///< may have gone since, see `rival_of`
};

/// How soon who goes is known to be silent.
enum class Watch : std::uint8_t {
  kClosely,  ///< within a second: for who has robots at agents, or people who look
  kLoosely,  ///< within four: agents watch each other so, since as many signs of life as there are pairs of
             ///< agents would take more of their machines than robots do
};

/// How long a silent agent is waited for.
inline constexpr std::chrono::seconds kSilencePatience(5);

/// What may be the name of an agent: 1 to 64 letters, digits, `-`, `_`, `.`
bool is_agent_name(std::string_view name);

/// Somebody else of the same name who is there now.
std::optional<Member::Rival> rival_of(const Member& member);

/// Who is in a fleet, as seen from here. Has a thread of its own; may be used by any.
class Roster {
 public:
  /// @errors  a sentence: the network can't be used
  static std::expected<std::shared_ptr<Roster>, std::string> join(const dds::Network& network,
                                                                  Watch watch = Watch::kClosely);
  Roster(const Roster&) = delete;
  Roster& operator=(const Roster&) = delete;
  ~Roster();

  const std::string& fleet() const { return fleet_; }
  dds::Participant& participant() { return participant_; }

  /// By name; those that have gone stand there as long as this does.
  std::vector<Member> members() const;
  std::optional<Member> find(std::string_view name) const;
  /// A run here works with it: it is missed for as long as this roster is there.
  void hold(std::string_view name);
  /// Of a member what changes all the time.
  struct Sighting {
    dds::Guid guid;
    Member::State state = Member::State::kThere;
    bool has_left = false;
    Clock::time_point heard;
  };
  std::optional<Sighting> sight(std::string_view name) const;
  /// This process did not run for a while: it was stopped, or its machine slept. Others gave it up meanwhile.
  struct Standstill {
    double seconds = 0.0;
    Clock::time_point ended;
  };
  /// The last one that was long enough to be told.
  std::optional<Standstill> standstill() const;
  /// Somebody else than this participant who is there under that name now.
  std::optional<Member::Rival> rival_of_mine(std::string_view name) const;
  /// Waits until something holds of those who are there, and asks again whenever somebody comes, goes or
  /// speaks.
  /// @return  whether it came to hold in time
  bool wait(const std::function<bool(const std::vector<Member>&)>& holds, Clock::time_point deadline) const;

 private:
  Roster(std::string fleet, dds::Participant participant, dds::Waiter waiter, dds::Reader reader,
         std::optional<dds::Reader> life);
  void listen(const std::stop_token& stop);
  void take(const dds::Arrival& arrival);
  void take_sign_of_life(const dds::Arrival& arrival);
  void give_up_the_silent();
  void note_standstill();
  Member* of(const dds::Guid& guid);
  void forget_rival(const dds::Guid& guid);
  void set(Member& member, Member::State state);

  std::string fleet_;
  dds::Participant participant_;
  dds::Waiter waiter_;
  dds::Reader reader_;
  std::optional<dds::Reader> life_;  // of who watches closely
  mutable std::mutex mutex_;
  mutable std::condition_variable changed_;
  std::map<std::string, Member, std::less<>> members_;
  std::optional<Standstill> standstill_;
  double looked_ = 0.0;    // [s], of a clock that goes on while the machine sleeps
  bool has_news_ = false;  // that those who wait are to look at
  std::jthread thread_;
};

}  // namespace mlab::agents
