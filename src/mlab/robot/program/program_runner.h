#pragma once

#include <cstddef>
#include <cstdint>
#include <expected>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/base/id.h"
#include "mlab/flow/carry_over.h"
#include "mlab/flow/frame.h"
#include "mlab/flow/interventions.h"
#include "mlab/flow/program.h"
#include "mlab/percept/action.h"
#include "mlab/percept/needs.h"
#include "mlab/percept/percepts.h"
#include "mlab/robot/program/robot_memory.h"
#include "mlab/robot/program/robot_program.h"
#include "mlab/robot/program/said.h"

namespace mlab::robot {

class RobotValues;

/// What a robot's program computes with, for who looks on; both null where it is kept elsewhere.
struct Workings {
  const flow::Program* program = nullptr;
  const std::byte* frame = nullptr;                    ///< until the runner's next call
  const flow::Interventions* interventions = nullptr;  ///< likewise; null: there are none

  explicit operator bool() const { return program != nullptr; }
};

/// How long a robot's action counts in real time [s]: without a newer one its body stands.
inline constexpr double kActionPatience = 0.5;

/// Asked again and again while a program is waited for; true: nobody has time for it any more, it is ended.
using Meanwhile = std::function<bool()>;

/// How well robots keep up with a world that does not wait for them.
struct Punctuality {
  std::uint64_t asked = 0;  ///< robot-cycles
  std::uint64_t late = 0;   ///< of these, those whose action was not there in time: an earlier one counted
  std::uint64_t stood =
      0;  ///< of the late ones, those in which the earlier one was too old, and the body stood
  double worst_age = 0.0;  ///< of percepts that were acted on [s]
};

/// A machine that carries robots, of which nothing is heard at present.
struct SilentMachine {
  std::string name;
  double silent = 0.0;                ///< since it was heard last [s]
  double patience = 0.0;              ///< after so long it is given up [s]
  bool is_waited_for = true;          ///< the run stands until it is back
  std::vector<base::RobotId> robots;  ///< that it carries
};

/// Runs the programs of robots, all at one kind of place: in this process, in cells beside it. They turn
/// percepts into actions; where percepts come from, and who carries actions out, it does not know.
///
/// Per cycle: `join` for each robot that acts; `open`; `needs` and `act` for all of them, in batches, on any
/// thread; `ask`; `wait`. With the same percepts the actions are the same for any number of threads. Once the
/// lists have grown, programs in this process take no heap.
class ProgramRunner {
 public:
  /// A robot among those of the runner.
  using Member = std::uint32_t;

  /// A robot's part of the cycle. What is pointed to is the caller's: percepts as long as `act` runs, the
  /// rest until `wait` comes back, which is when it is filled in.
  struct Turn {
    Member member = 0;
    const percept::Percepts* percepts = nullptr;
    percept::Action* action = nullptr;  ///< what the robot wants to do; nothing where there is a failure
    std::string* fault =
        nullptr;  ///< path of the port that holds no number, where the action does not either
    std::string* failure = nullptr;  ///< a sentence about what the program did instead of acting
  };

  ProgramRunner() = default;
  ProgramRunner(const ProgramRunner&) = delete;
  ProgramRunner& operator=(const ProgramRunner&) = delete;
  virtual ~ProgramRunner() = default;

  /// Takes a robot in: with the values before its first cycle, not started.
  /// @param program  outlives its being here
  virtual Member add(base::RobotId robot, const RobotProgram& program) = 0;
  virtual void remove(Member member) = 0;

  /// Brings the robot to life, or to life again: with the values before its first cycle, then those that a
  /// person set.
  /// @errors  what its program did instead
  virtual std::optional<std::string> start(Member member) = 0;
  /// Sets a parameter or constant, now and at every start.
  /// @param value  as a person writes it, in the port's edge_unit
  /// @errors  a sentence that says what is wrong
  virtual std::optional<std::string> set(Member member, std::string_view port, const std::string& value) = 0;
  /// What a person makes the program do, see flow::Interventions. Held values outlive a new start.
  /// @errors  a sentence that says why not: the robot's values may be kept elsewhere
  virtual std::optional<std::string> force(Member member, std::string_view sequence,
                                           std::string_view state) = 0;
  virtual std::optional<std::string> hold(Member member, std::string_view port, std::string_view value) = 0;
  /// @param port  empty: all
  virtual std::optional<std::string> release(Member member, std::string_view port) = 0;
  /// Gives the robot another version of its program, and so all values that this one sets differently; the
  /// rest is the robot's own. One that did not start yet gets all values of the new version.
  /// @param is_running  it takes part in cycles
  /// @return  false: that is not its program, and nothing has changed
  virtual bool take_over(Member member, const RobotProgram& after, bool is_running) = 0;

  /// The robot acts in the coming cycle.
  void join(Member member) { joined_.push_back(member); }
  /// All have joined.
  virtual void open() {}
  /// What the robots' next cycle may read. Fills as many of `out` as there are members.
  virtual void needs(std::span<const Member> members, std::span<percept::Needs> out) const = 0;
  virtual void act(std::span<const Turn> turns) = 0;
  /// All have their percepts; who computes elsewhere may begin.
  virtual void ask() {}
  /// Waits until all have acted.
  virtual void wait(const Meanwhile& /*meanwhile*/) { joined_.clear(); }

  virtual Workings workings(Member member) const = 0;
  /// All that is known of the robot; until the runner's next call. Null where its values are kept elsewhere.
  virtual RobotValues* values(Member /*member*/) { return nullptr; }
  /// Goes on as the robot's program before, with what of its values this one can go on with.
  /// @param before  what is known of the robot with that program
  /// @return  what begins anew
  virtual std::vector<flow::Restart> go_on_from(Member member, const RobotValues& before);
  /// All values of the robot: restored, it goes on exactly from there. Empty where they are kept elsewhere.
  virtual flow::Frame save(Member member) const = 0;
  /// @param frame  from `save`, of a robot of the same program
  /// @return  false: it is none of this program's
  virtual bool restore(Member member, const flow::Frame& frame) = 0;

  /// All that the robot goes on from, between two cycles.
  /// @errors  a sentence: its values are kept elsewhere
  virtual std::expected<RobotMemory, std::string> memory(Member /*member*/) const {
    return std::unexpected("its program keeps its values elsewhere");
  }
  /// Goes on from there.
  /// @param memory  of a robot of this id, from `memory` of a runner of this kind and seed
  virtual void remember(Member /*member*/, const RobotMemory& /*memory*/) {}

  /// The machine that carries the robot; empty: this one.
  virtual std::string machine(Member /*member*/) const { return ""; }
  /// That machine carries it no more: it has left, was started anew, or was silent for too long.
  virtual bool has_lost(Member /*member*/) const { return false; }
  /// What was said there, as far as it is kept. Between two cycles.
  /// @errors  a sentence: the machine can't be asked
  virtual std::expected<Said, std::string> said(Member /*member*/) { return Said{}; }
  /// By any call of the thread that the runner belongs to, also while it waits.
  virtual std::vector<SilentMachine> silent_machines() const { return {}; }
  /// So long nothing has been heard of the robot's program [s]; 0: it is waited for, or was heard in time.
  virtual double silence(Member /*member*/) const { return 0.0; }
  /// So old are the percepts that the robot's action answers [s]; 0: those of this cycle.
  virtual double percept_age(Member /*member*/) const { return 0.0; }
  /// Null: nothing here can be late, it is waited for.
  virtual const Punctuality* punctuality() const { return nullptr; }

 protected:
  std::vector<Member> joined_;  // of this cycle
};

/// False where it would drive a robot with something that is no number.
bool is_number(const percept::Action& action);

}  // namespace mlab::robot
