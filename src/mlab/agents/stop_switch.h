#pragma once

#include <expected>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "mlab/agents/roster.h"
#include "mlab/agents/stop_state.h"
#include "mlab/dds/reader.h"
#include "mlab/dds/writer.h"

namespace mlab::agents {

/// The emergency stop of a fleet, for who may pull and release it. What was pulled anywhere holds here, too.
/// Has a thread of its own, which says it every 20 ms for a second, and five times a second until all agents
/// have acknowledged it. May be used by any thread.
class StopSwitch {
 public:
  /// @errors  a sentence: the network can't be used
  static std::expected<std::unique_ptr<StopSwitch>, std::string> open(std::shared_ptr<Roster> roster);
  StopSwitch(const StopSwitch&) = delete;
  StopSwitch& operator=(const StopSwitch&) = delete;
  ~StopSwitch();

  /// Pulls it. It is under way when this comes back. Where it is engaged already it is said anew.
  void engage(const std::string& by);
  void release(const std::string& by);
  StopState state() const;

  /// An agent that has not acknowledged what holds.
  struct Unreached {
    std::string name;
    double silent = 0.0;  ///< since it was heard last [s]
  };
  /// By name. Agents that have left the fleet in order are not among them.
  std::vector<Unreached> unreached() const;
  std::size_t agent_count() const;

  /// Called whenever the state or who is unreached may have changed, on the switch's thread; it must not call
  /// this. Whoever was called before isn't any more when this comes back.
  void tell(std::function<void()> changed);

 private:
  StopSwitch(std::shared_ptr<Roster> roster, dds::Waiter waiter, dds::Reader reader, dds::Writer writer);
  void spread();
  void serve(const std::stop_token& stop);
  bool listen();
  void say();
  bool is_fresh() const;
  void adopt(const StopState& state);

  std::shared_ptr<Roster> roster_;
  dds::Waiter waiter_;
  dds::Reader reader_;
  dds::Writer writer_;
  mutable std::mutex mutex_;
  StopState state_;
  std::uint64_t own_pull_ = 0;  // the last that was pulled here; 0: none
  Clock::time_point since_;
  std::mutex telling_;
  std::function<void()> changed_;  // under telling_
  std::jthread thread_;
};

}  // namespace mlab::agents
