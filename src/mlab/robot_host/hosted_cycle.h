#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mlab/percept/action.h"
#include "mlab/percept/percepts.h"
#include "mlab/robot_host/hosted_program.h"
#include "mlab/robot_host/robot_program_process.h"
#include "mlab/robot_host/shared_memory.h"

namespace mlab::robot_host {

/// Cycles of robots of one program, computed by one process. The process keeps nothing from cycle to cycle: a
/// robot's frame is handed in and comes back. Where the program of one robot ends the process, or never comes
/// back, that robot alone has failed: another process takes the place, and the others' cycle is computed as
/// if that robot had not been there.
///
/// Per cycle: `begin`; `join` for each robot; `set` for each, on any thread; `ask`; `wait`; `result`.
class HostedCycle {
 public:
  explicit HostedCycle(std::shared_ptr<const HostedProgram> program) : program_(std::move(program)) {}

  void begin();
  /// @return  the robot's place in this cycle
  std::size_t join(std::uint32_t robot, std::uint64_t seed);
  /// @param frame  lives, unchanged, until `wait` comes back
  void set(std::size_t place, const percept::Percepts& percepts, std::span<const std::byte> frame);

  /// Asked again and again while a program is waited for; true: whoever waits has no time any more, and it is
  /// to be ended.
  using Meanwhile = std::function<bool()>;
  void ask();
  void wait(const Meanwhile& meanwhile);

  struct Result {
    percept::Action action;
    std::span<const std::byte>
        frame;            ///< after the cycle, until `begin`; any bytes, as a program may leave them
    std::string failure;  ///< a sentence about what its program did instead; empty: all is well
  };
  const Result& result(std::size_t place) const { return joined_[place].result; }

 private:
  struct Joined {
    std::uint32_t robot = 0;
    std::uint64_t seed = 0;
    std::uint64_t percepts = 0;
    std::span<const std::byte> frame;
    Result result;
    bool takes_part = true;
  };
  /// How waiting ended.
  struct Failure {
    std::string what;
    std::uint32_t place = robot_wire::Control::kNobody;  ///< among the places that were asked
    std::uint32_t node = robot_wire::Control::kNobody;
  };
  std::optional<std::string> ensure_process();
  void fill();
  void fail_all(const std::string& why);
  void begin_cycle();
  std::optional<Failure> await(const Meanwhile& meanwhile);
  Failure failure_of(std::string what);
  void blame(const Failure& failure);
  void take_results();

  std::shared_ptr<const HostedProgram> program_;
  std::optional<SharedMemory> memory_;
  std::optional<RobotProgramProcess> process_;
  std::vector<Joined> joined_;
  std::vector<std::size_t> asked_;  // places that take part, in the order in which the program has them
  std::string unasked_;             // why nobody could be asked; empty: they were
  std::uint32_t cycle_ = 0;
};

}  // namespace mlab::robot_host
