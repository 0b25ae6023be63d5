#pragma once

#include <expected>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "mlab/agents/missed.h"
#include "mlab/agents/roster.h"
#include "mlab/agents/stop_state.h"
#include "mlab/dds/reader.h"
#include "mlab/dds/writer.h"

namespace mlab::agents {

/// The emergency stop of a fleet, for who may pull and release it. What was pulled anywhere holds here, too.
/// Has a thread of its own, which says it every 4 ms for a tenth of a second, every 20 ms for a second, and
/// five times a second until all agents have acknowledged it. May be used by any thread.
class StopSwitch {
 public:
  /// @param by  who tells others whom he misses, for people: `run patrol on base`; empty: that isn't told
  /// @errors    a sentence: the network can't be used
  static std::expected<std::unique_ptr<StopSwitch>, std::string> open(std::shared_ptr<Roster> roster,
                                                                      std::string by = {});
  StopSwitch(const StopSwitch&) = delete;
  StopSwitch& operator=(const StopSwitch&) = delete;
  ~StopSwitch();

  /// Pulls it. It is under way when this comes back. Where it is engaged already it holds twice.
  void engage(const std::string& by);
  /// Releases all pulls that are known here by now; one that is heard of later holds.
  void release(const std::string& by);
  StopState state() const;
  /// Takes over at once what holds at the agents that have been heard.
  void hear_agents();

  /// An agent that has not acknowledged what holds.
  struct Unreached {
    std::string name;
    double silent = 0.0;  ///< since it was heard last [s]
    std::string by;       ///< who says so of one that was never heard here, for people; empty: it was
    std::string machine;  ///< its own name, for people
  };
  /// By name. Agents that have left the fleet in order are not among them. One that was never heard here is
  /// where somebody else in the fleet misses it.
  std::vector<Unreached> unreached() const;
  /// An agent that has confirmed the stop, and would forget it if it were started again.
  struct Forgetful {
    std::string name;
    std::string why;  ///< for people
  };
  /// By name; nobody where it is not engaged.
  std::vector<Forgetful> forgetful() const;
  /// With those that only others know of.
  std::size_t agent_count() const;

  /// Called whenever the state or who is unreached may have changed, on the switch's thread; it must not call
  /// this. Whoever was called before isn't any more when this comes back.
  void tell(std::function<void()> changed);

 private:
  StopSwitch(std::shared_ptr<Roster> roster, dds::Waiter waiter, dds::Reader reader, dds::Writer writer,
             std::unique_ptr<Hearsay> hearsay, std::string by);
  void spread();
  void serve(const std::stop_token& stop);
  bool listen();
  void say();
  bool is_fresh(Clock::duration age) const;
  void adopt(const StopState& state);
  std::vector<Hearsay::Entry> known_by_others() const;

  std::shared_ptr<Roster> roster_;
  dds::Waiter waiter_;
  dds::Reader reader_;
  dds::Writer writer_;
  std::unique_ptr<Hearsay> hearsay_;
  std::unique_ptr<MissedTeller> teller_;  // of the switch's thread; null: nobody is told
  mutable std::mutex mutex_;
  StopState state_;
  Clock::time_point since_;
  bool has_changed_ = false;  // since it was looked at
  std::mutex telling_;
  std::function<void()> changed_;  // under telling_
  std::jthread thread_;
};

}  // namespace mlab::agents
