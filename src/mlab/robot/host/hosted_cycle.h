#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mlab/flow/interventions.h"
#include "mlab/percept/action.h"
#include "mlab/percept/percepts.h"
#include "mlab/robot/host/hosted_program.h"
#include "mlab/robot/host/robot_program_process.h"
#include "mlab/robot/host/shared_memory.h"

namespace mlab::robot_host {

/// Cycles of robots of one program, computed by one process. The process keeps nothing from cycle to cycle: a
/// robot's frame is handed in and comes back. Where the program of one robot ends the process, or never comes
/// back, that robot alone has failed: another process takes the place, and the others' cycle is computed as
/// if that robot had not been there. A process that somebody kills is nobody's failure, unless its successor
/// is killed as well.
///
/// Per cycle: `begin`; `join` for each robot; `open`; `set` for each, on any thread; `ask`; `wait`; `take`.
class HostedCycle {
 public:
  /// @param is_early  the process computes while robots are still being set; good where it has a processor of
  ///                  its own
  HostedCycle(std::shared_ptr<const HostedProgram> program, bool is_early)
      : program_(std::move(program)), is_early_(is_early) {}
  HostedCycle(const HostedCycle&) = delete;
  HostedCycle& operator=(const HostedCycle&) = delete;
  ~HostedCycle();

  void begin();
  /// @return  the robot's place in this cycle
  std::size_t join(std::uint32_t robot, std::uint64_t seed);
  /// All have joined.
  void open();
  /// @param frame, interventions  live, unchanged, until `wait` comes back; null: there are none
  void set(std::size_t place, const percept::Percepts& percepts, std::span<const std::byte> frame,
           const flow::Interventions* interventions = nullptr);

  void ask();
  void wait(const Meanwhile& meanwhile);

  /// The end of what its process wrote to standard error, and the one before it.
  std::string said();

  struct Outcome {
    /// After the cycle, until `begin`; any bytes, as a program may leave them.
    std::span<const std::byte> frame;
    std::string failure;  ///< a sentence about what its program did instead; empty: all is well
  };
  /// @param action  what the robot's program wants
  /// @param interventions  those that were set; take what the cycle made of them
  Outcome take(std::size_t place, percept::Action& action, flow::Interventions* interventions = nullptr);

 private:
  struct Joined {
    std::uint32_t robot = 0;
    std::uint64_t seed = 0;
    std::uint64_t percepts = 0;
    std::span<const std::byte> frame;
    const flow::Interventions* interventions = nullptr;
    std::atomic<bool> is_set = false;
    std::size_t slot = 0;  // its place among those that the program computes
    std::string failure;   // its program is not asked any more; empty: all is well
  };
  /// How waiting ended.
  struct Failure {
    std::string what;
    std::uint32_t place = robot_wire::Control::kNobody;  ///< among the places that were asked
    std::uint32_t node = robot_wire::Control::kNobody;
    bool was_killed = false;  ///< by somebody outside
  };
  std::optional<std::string> ensure_process();
  std::optional<std::string> prepare();
  void begin_asking();
  void hand_over(Joined& one);
  void hand_over_what_is_set();
  void ask_for_all();
  void ask_again();
  void fail_all(const std::string& why);
  std::optional<Failure> await(const Meanwhile& meanwhile);
  Failure failure_of(std::string what);
  void blame(const Failure& failure);

  std::shared_ptr<const HostedProgram> program_;
  bool is_early_;
  std::optional<SharedMemory> memory_;
  robot_wire::Looks looks_;
  std::optional<RobotProgramProcess> process_;
  std::string said_before_;    // by the process before this one
  std::deque<Joined> joined_;  // the first `count_` are of this cycle
  std::size_t count_ = 0;
  std::vector<Joined*> asked_;    // in the order in which the program has them
  std::uint32_t asked_ever_ = 0;  // handed over in all cycles, as the program counts them
  std::uint32_t asked_for_ = 0;   // of these, so many as the program knows of
  std::mutex handing_over_;
  std::size_t next_ = 0;  // of joined_ that is handed over
};

}  // namespace mlab::robot_host
