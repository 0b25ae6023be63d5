#pragma once

#include <cstdint>
#include <expected>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/flow/program.h"
#include "mlab/percept/action.h"
#include "mlab/percept/percepts.h"
#include "mlab/robot/native_program.h"
#include "mlab/robot_host/hosted_cycle.h"

namespace mlab::fleet {

/// The robots of a run whose programs run in processes of their own. All robots of one program share a few
/// processes, which compute a cycle side by side, and the run waits for all of them: results are the same for
/// any number.
///
/// There are two kinds: hosted programs, whose frames the run has (it hands them in each cycle, and gets them
/// back), and executables, which keep their robots' values to themselves.
///
/// Per cycle: `begin`; `join` for each robot that runs; `open`; `percepts` for each of them, on any thread;
/// `exchange`; `take` for each of them.
class LockStep {
 public:
  /// @param most  processes for each program, >= 1
  LockStep(int most, std::uint64_t seed) : most_(most), seed_(seed) {}

  /// A robot among those of the run.
  using Member = std::uint32_t;
  static constexpr Member kNone = 0xffffffffU;

  /// Brings a robot to life with the settings of its type and then its own; a process that has failed is
  /// started again.
  /// @param member  of the robot, where it lived before; else kNone
  /// @errors  what the process did instead
  std::expected<Member, std::string> start(Member member, std::uint32_t robot,
                                           const std::shared_ptr<const robot::NativeProgram>& program,
                                           const robot_host::Settings& own);
  /// Takes in a robot of a hosted program.
  Member host(Member member, std::uint32_t robot,
              const std::shared_ptr<const robot_host::HostedProgram>& program);
  /// What the robot's next cycle may read. Of an executable's robot; a hosted one's frame says it.
  const flow::Needs& needs(Member member) const { return members_[member].needs; }
  /// @errors  a sentence that says what is wrong
  std::optional<std::string> set(Member member, const std::string& port, const std::string& value);

  void begin();
  void join(Member member);
  /// All have joined.
  void open();
  /// Tells what the robot perceives in this cycle.
  /// @param frame  of a hosted robot: its values, which stay as they are until `exchange` comes back
  void percepts(Member member, const percept::Percepts& percepts, const flow::Frame& frame);
  /// @param meanwhile  asked again and again while a program is waited for, may be empty; true: it is
  /// to
  ///                   be ended
  void exchange(const robot_host::Meanwhile& meanwhile);

  struct Outcome {
    std::string fault;                 ///< path of the port that holds no number; empty: all is well
    std::string failure;               ///< what the process did instead of acting; empty: it acted
    std::span<const std::byte> frame;  ///< of a hosted robot that acted: its values now, until `begin`
  };
  /// @param action  what the robot's program wants; undefined where it did not act
  Outcome take(Member member, percept::Action& action);

 private:
  struct Process {
    std::string executable;
    std::shared_ptr<const robot_host::HostedProgram> hosted;  // in place of an executable
    std::unique_ptr<robot_host::HostedCycle> hosted_cycle;
    std::optional<robot_host::RobotProgramProcess> running;
    wire::ToRobot cycle;
    std::vector<Member> joined;
    bool is_asked = false;
  };
  struct MemberState {
    std::uint32_t robot = 0;
    std::size_t process = 0;
    std::size_t place = 0;  // in the cycle
    flow::Needs needs;
    percept::Action action;  // of an executable's robot, as the outcome
    Outcome outcome;
  };
  std::size_t process_for(const std::string& executable,
                          const std::shared_ptr<const robot_host::HostedProgram>& hosted);
  void exchange_messages(const robot_host::Meanwhile& meanwhile);
  void take_answer(Process& process, const wire::Actions& actions);

  int most_;
  std::uint64_t seed_;
  std::vector<Process> processes_;
  std::vector<MemberState> members_;
};

}  // namespace mlab::fleet
