#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>

#include "mlab/cli/run_screen.h"
#include "mlab/run/mission_run.h"

namespace mlab::cli {

/// One line of standard input, without blocking for longer than one wants to.
class Answers {
 public:
  enum class Kind { kNone, kLine, kEnd };
  Kind poll_line(int wait_ms, std::string& line);

 private:
  std::string pending_;
  bool is_over_ = false;
};

/// The operator of a headless run: shows what is asked and takes the answers from standard input.
class TerminalOperator {
 public:
  TerminalOperator(run::MissionRun& run, RunScreen& screen);

  void see(const mission::Effect& effect);
  bool is_needed() const { return !asked_.empty() || !teleoperated_.empty(); }
  /// A unit is under the stick, and nothing but a person ends that: no UNTIL does.
  bool is_steering() const;
  /// A person who is asked what answers itself after some time has that time by the clock on the wall,
  /// however fast the run is otherwise.
  /// @return how far the run is ahead of that clock [s]; 0: it may go on
  double ahead() const;

  /// Asks and waits for at most `wait_ms`. False where nobody is left to answer.
  bool attend(int wait_ms);

 private:
  struct Question {
    std::string text;
    bool expires = false;
    double asked_at = 0.0;    ///< simulated [s]
    double asked_when = 0.0;  ///< by the clock on the wall [s]
  };
  void withdraw(std::uint32_t question);
  void take(std::string line);

  run::MissionRun& run_;
  RunScreen& screen_;
  Answers answers_;
  std::map<std::uint32_t, Question> asked_;
  std::set<std::uint32_t> teleoperated_;  // commands
  bool is_person_;                        // at a terminal
  bool is_over_ = false;                  // nobody will answer any more
};

}  // namespace mlab::cli
