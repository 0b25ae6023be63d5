#pragma once

#include <cstdint>
#include <expected>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mlab/cell/means.h"
#include "mlab/cell/policy.h"
#include "mlab/robot.pb.h"
#include "mlab/robot/host/child_process.h"
#include "mlab/robot/host/limits.h"
#include "mlab/robot/host/shared_memory.h"
#include "mlab/robot/wire/framing.h"

namespace mlab::robot_host {

/// An executable and the cell that it runs in.
struct Launch {
  std::string executable;
  cell::Policy policy;
  cell::Wall wall = cell::Wall::kLandlock;
};

/// What a robot program may do: be loaded, and compute in its memory. In a cell it writes no files, nor more
/// memory than the run shares with it. Sanitizers reserve more than there is, so with them memory has no
/// limit.
Launch launch_of(const std::string& executable, cell::Wall wall, const Limits& limits);

/// Something that a person wants of a program: path of the port, value as written.
using Settings = std::vector<std::pair<std::string, std::string>>;

/// Asked again and again while a program is waited for; true: whoever waits has no time any more, and it is
/// to be ended.
using Meanwhile = std::function<bool()>;
inline constexpr const char* kNotAwaited = "was ended, because nobody waits for it any more";

/// A robot program that runs. One that failed stays failed: nothing is sent to it any more.
class RobotProgramProcess {
 public:
  /// Starts the executable and has it say Welcome.
  /// @errors  a sentence that says what it did instead
  /// @param shared  what it shares with the run; null: nothing
  static std::expected<RobotProgramProcess, std::string> start(const Launch& launch, const Limits& limits,
                                                               const SharedMemory* shared = nullptr);

  /// Sends without waiting for the answer, which has to be received before anything else is sent.
  void send(const wire::ToRobot& message);
  /// The answer to what was sent last; null where the program failed. A Problem is a failure. Valid until the
  /// next call.
  /// @param meanwhile  asked again and again until it is there, may be empty; true: nobody waits any more,
  /// and
  ///                   the program is ended
  const wire::FromRobot* receive(wire::FromRobot::BodyCase wanted, const Meanwhile& meanwhile = {});
  /// Both.
  const wire::FromRobot* ask(const wire::ToRobot& message, wire::FromRobot::BodyCase wanted) {
    send(message);
    return receive(wanted);
  }

  /// Of the headers that it was made with, where it answers Reveal and Share; else 0.
  std::uint64_t layout() const { return layout_; }
  /// Hash of all that it was made from; 0: it does not say.
  std::uint64_t source() const { return source_; }

  /// The end of what it wrote to standard error, as it stands.
  const std::string& said() { return child_.said(); }
  /// Processor time of all its threads so far [s].
  double processor_time() const { return child_.processor_time(); }
  /// Looks whether it has ended by itself, and reads what it has to say. True: it has, and has failed with
  /// that.
  bool note_end();
  /// Somebody outside ended it. Of one of which note_end says so.
  bool was_killed() const { return child_.was_killed(); }

  /// Ends it because of something that its owner saw.
  void fail(std::string why);
  bool has_failed() const { return !failure_.empty(); }
  /// What it did: `ended with signal 11 (Segmentation fault)`, `gave no answer for 5 s`. Empty: nothing.
  const std::string& failure() const { return failure_; }

 private:
  RobotProgramProcess(ChildProcess child, Limits limits)
      : child_(std::move(child)), limits_(std::move(limits)) {}
  Clock::time_point deadline() const;
  void fail(ChildProcess::Io io);

  ChildProcess child_;
  Limits limits_;
  double patience_ = 0.0;  // for the answer that is awaited [s]
  Clock::time_point sent_;
  robot_wire::FrameReader reader_;
  std::uint64_t layout_ = 0;
  std::uint64_t source_ = 0;
  std::string bytes_;
  wire::FromRobot answer_;
  std::string failure_;
};

/// How an executable is made.
struct Revealed {
  wire::Revealed how;
  std::uint64_t source = 0;  ///< as RobotProgramProcess::source
};
/// Asks an executable that was made with the headers of this program.
/// @return  nothing where it was made otherwise
/// @errors  a sentence that says what it did instead
std::expected<std::optional<Revealed>, std::string> reveal(const Launch& launch, const Limits& limits);

/// What an executable says of itself, with these settings.
/// @errors  a sentence that says what it did instead
std::expected<wire::Description, std::string> describe(const Launch& launch, const Settings& settings,
                                                       const Limits& limits);

}  // namespace mlab::robot_host
