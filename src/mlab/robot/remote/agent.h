#pragma once

#include <cstdint>
#include <expected>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "mlab/agent.pb.h"
#include "mlab/robot/program/program_runner.h"
#include "mlab/robot/program/robot_program.h"
#include "mlab/robot/remote/link.h"

namespace mlab::robot_remote {

/// Version of proto/mlab/agent.proto; agents of another one are not understood.
inline constexpr std::uint32_t kAgentProtocol = 2;

/// How long an agent may take [s].
struct Patience {
  double answer = 10.0;    ///< for what concerns one robot
  double program = 300.0;  ///< to build a program, which may have C++ that is to be compiled
  double cycle = 60.0;     ///< its robots' processes have limits of their own: this ends only one that hangs
};

/// One agent, as a run talks to it. Whatever is asked of one whose link has failed is answered at once, with
/// that.
class Agent {
 public:
  /// @param name     of its machine, for people
  /// @param offered  the executable whose robots it carries, and no others; nothing: those that are built
  ///                 from text
  Agent(std::string name, std::unique_ptr<Link> link, Patience patience = {},
        std::optional<robot::ExecutableOrigin> offered = std::nullopt);
  Agent(const Agent&) = delete;
  Agent& operator=(const Agent&) = delete;
  /// In real time it is told, where it can be heard.
  ~Agent();

  const std::string& name() const { return name_; }
  /// May carry robots of that program.
  bool may_carry(const robot::RobotProgram& program) const;
  /// As Link::silence.
  double silence() const { return link_->silence(); }
  double patience_with_silence() const { return link_->patience_with_silence(); }
  /// What became of it, as a sentence about it. Empty: it stands.
  std::string failure() const;

  /// Says who asks, for which run. First of all.
  /// @param period  of a cycle in real time [s]; 0: in lock-step
  /// @errors  a sentence: it is of another version
  std::optional<std::string> open(std::uint64_t seed, const std::string& version, double period = 0.0);
  /// Sees to it that it has the program; what it has refused once it is not asked again.
  /// @return  how the agent calls it
  /// @errors  a sentence
  std::expected<std::uint32_t, std::string> bring(const robot::RobotProgram& program);

  static constexpr std::uint32_t kNoMember = 0;  ///< number of no robot
  /// Its log, and what the program of that robot wrote; also before `open`. An answer that takes longer is
  /// kept for the next call, and holds nothing else up.
  /// @param patience  so long it is waited for [s]
  /// @errors  a sentence
  std::expected<robot::Said, std::string> said(std::uint32_t member, double patience = 10.0);

  /// The answer to a message. Valid until the next call.
  /// @errors  why there is none, as a sentence
  std::expected<const wire::FromAgent*, std::string> ask(wire::ToAgent& message,
                                                         wire::FromAgent::BodyCase wanted);

  /// Sends a cycle without waiting for what the robots do.
  void send_cycle(wire::ToAgent& message);
  /// What they do; null where the agent has failed. Valid until the next call.
  const wire::AgentActed* receive_cycle(const robot::Meanwhile& meanwhile);
  /// What passes beside the conversation in real time; null: it is in lock-step.
  const std::shared_ptr<LiveLine>& live() const { return live_; }
  /// Gives it up because of something that its owner saw, as a sentence about it without its name.
  void fail(std::string why) { link_->fail(std::move(why)); }

 private:
  /// A question for what was said: the only one that others may overtake.
  struct LogQuestion {
    std::uint64_t number = 0;  // 0: none is under way
    std::uint32_t member = 0;
  };
  std::expected<const wire::FromAgent*, std::string> wait_for_log(double patience);
  void send(wire::ToAgent& message);
  const wire::FromAgent* receive(wire::FromAgent::BodyCase wanted, double patience,
                                 const robot::Meanwhile& meanwhile);
  std::expected<const wire::FromAgent*, std::string> ask(wire::ToAgent& message,
                                                         wire::FromAgent::BodyCase wanted, double patience);

  std::string name_;
  std::unique_ptr<Link> link_;
  std::shared_ptr<LiveLine> live_;
  Patience patience_;
  std::optional<robot::ExecutableOrigin> offered_;
  std::uint64_t number_ = 0;
  LogQuestion log_question_;
  std::uint64_t newest_log_ = 0;        // number of the last of them
  std::optional<wire::FromAgent> log_;  // that came to `log_question_` while something else was waited for
  // Kept alive by their keys, so that no other program comes to have the address of one of them.
  std::map<std::shared_ptr<const flow::Program>, std::expected<std::uint32_t, std::string>> brought_;
  std::string bytes_;
  wire::FromAgent answer_;
};

}  // namespace mlab::robot_remote
