#pragma once

#include <cstdint>
#include <expected>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <google/protobuf/arena.h>

#include "mlab/agent.pb.h"
#include "mlab/robot/program/program_runners.h"
#include "mlab/robot/program/robot_program.h"
#include "mlab/robot/program/said.h"
#include "mlab/robot/remote/live_line.h"
#include "mlab/robot/remote/live_robot.h"
#include "mlab/robot/wire/percepts_wire.h"

namespace mlab::robot_remote {

/// What an agent lets runs do.
struct AgentTerms {
  robot::ProgramSources sources;  ///< what of code that a run brings may be compiled and run, by what means
  std::string offered = {};       ///< path of the executable whose robots it carries, and no others; empty:
                                  ///< those that are built from what the run brings
  bool is_a_vehicles = false;     ///< it carries no programs: who opens a conversation is refused
  /// An emergency stop holds: no robot drives, whatever its program says; by any thread. Empty: none ever
  /// does.
  std::function<bool()> is_stopped = {};
  /// What the agent told last, oldest first; by any thread. Empty: nothing is kept.
  std::function<std::vector<robot::LogLine>()> log = {};
};

/// The agent's side of the conversation with one run: builds the programs that the run brings, and has its
/// robots computed, each in a process of its own. All of them end with this object.
class RunnerServer {
 public:
  explicit RunnerServer(AgentTerms terms);

  /// Does what a message asks for. Anything may arrive.
  /// @param meanwhile  asked again and again while robots are waited for, may be empty; true: nobody waits
  /// for
  ///                   them
  /// @return  the answer, valid until the next call
  std::string_view answer(std::string_view message, const robot::Meanwhile& meanwhile = {});

  /// A run has said who it is.
  bool is_open() const { return runners_ != nullptr; }
  /// It has said that it ends.
  bool has_left() const { return has_left_; }
  std::size_t robot_count() const { return robots_.size(); }

  // ---- in real time, which the run asked for when it opened

  /// Of a robot's cycle [s]; 0: in lock-step, and the rest of this part is not for it.
  double period() const { return period_; }
  /// Takes what has come beside the conversation. Anything may.
  void hear(const LiveLine::Message& message);
  /// When robots act next, as far as is known; what comes until then may bring that forward.
  Clock::time_point due() const;
  /// Writes the action of a robot.
  using Publish = std::function<void(std::string_view key, std::string_view body)>;
  /// Lets those act for whom it is time: they have new percepts, or had none for longer than a cycle.
  void act_live(Clock::time_point now, const Publish& publish, const robot::Meanwhile& meanwhile);
  /// Says for all robots at once that they stand, without asking their programs.
  void stand(Clock::time_point now, const Publish& publish);

 private:
  struct Robot {
    robot::ProgramRunner* runner = nullptr;
    robot::ProgramRunner::Member member = 0;
    const robot::RobotProgram* program = nullptr;
    bool has_begun = false;
    LiveRobot live;
  };
  /// Its part of a cycle.
  struct Part {
    Robot* robot = nullptr;
    std::uint32_t number = 0;
    robot_wire::DecodedPercepts decoded;
    percept::Percepts percepts;
    bool wants_state = false;
    percept::Action action;
    std::string fault;
    std::string failure;
  };
  void answer_body(const wire::ToAgent& message, const robot::Meanwhile& meanwhile);
  void open(const wire::Open& message);
  void bring(const wire::Bring& message);
  std::optional<robot::RobotProgram> build(const wire::Bring& message);
  void enlist(const wire::Enlist& message);
  void dismiss(const wire::Dismiss& message);
  void put(const wire::Put& message);
  void change(const wire::Change& message);
  void look(const wire::Look& message);
  void act(const wire::AgentCycle& cycle, const robot::Meanwhile& meanwhile);
  std::optional<std::string> read(const wire::AgentCycle& cycle);
  Part& part(std::size_t place);
  std::span<const std::unique_ptr<Part>> run_parts(std::size_t count, const robot::Meanwhile& meanwhile);
  void put_action(const Part& part, wire::AgentAction& out) const;
  void read_log(const wire::ReadLog& message);
  bool is_stopped() const { return terms_.is_stopped && terms_.is_stopped(); }
  void let_stand(std::uint32_t number, Robot& robot, Clock::time_point now, const Publish& publish);
  void publish_live(const Part& part, Clock::time_point now, const Publish& publish);
  void refuse(std::string why);
  Robot* known(std::uint32_t number);
  void put_needs(const Robot& robot, wire::Needs& out) const;
  static void put_state(const Robot& robot, wire::RobotState& out);

  AgentTerms terms_;
  std::unique_ptr<robot::ProgramRunners> runners_;  // null: no run has opened
  std::map<std::uint32_t, std::unique_ptr<const robot::RobotProgram>> programs_;
  std::map<std::uint32_t, Robot> robots_;
  std::vector<std::unique_ptr<Part>> parts_;  // the first of them are of this cycle
  google::protobuf::ArenaOptions memory();
  // Of what is asked and answered; it is used again for the next.
  static constexpr std::size_t kBlock = 16'384;
  std::vector<char> block_ = std::vector<char>(kBlock);
  google::protobuf::Arena arena_{memory()};
  wire::ToAgent* message_ = nullptr;
  wire::FromAgent* answer_ = nullptr;
  wire::LiveAction live_;
  std::string bytes_;
  double period_ = 0.0;  // [s]
  bool has_left_ = false;
  bool rests_ = true;                             // no cycle goes by at the run
  std::optional<Clock::time_point> first_fresh_;  // when the first percepts came that nobody acted on
};

}  // namespace mlab::robot_remote
