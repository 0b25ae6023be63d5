#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "mlab/flow/program.h"
#include "mlab/robot.pb.h"
#include "mlab/robot/process/shared_cycles.h"

namespace mlab::robot_process {

/// The program's side of a conversation with a run. Says who it is and shares cycles; what else a program
/// answers to, it says itself.
class Speaker {
 public:
  /// @param name     of the program
  /// @param version  of the missionlab that it was made with
  Speaker(std::string name, std::string version) : name_(std::move(name)), version_(std::move(version)) {}
  Speaker(const Speaker&) = delete;
  Speaker& operator=(const Speaker&) = delete;
  virtual ~Speaker() = default;

  /// The answer to one message, valid until the next call. Bytes that are no message, and messages that make
  /// no sense, are answered by a Problem and change nothing.
  const wire::FromRobot& answer(std::string_view bytes);
  /// What the run shares, once it does; null before.
  SharedFiles* shared() { return shared_ ? &*shared_ : nullptr; }
  /// What computes the cycles that are shared then. Null: nothing was loaded yet.
  virtual const flow::Program* program() const = 0;

 protected:
  /// Fills `reply`, or refuses.
  virtual void answer_other(const wire::ToRobot& message) = 0;
  /// Whether it answers Reveal.
  virtual bool reveals() const { return false; }
  /// Hash of all that it was made from; 0: that is not known.
  virtual std::uint64_t source() const { return 0; }
  /// Cycles are shared from now on.
  virtual void begin_sharing(robot_wire::Control& /*control*/) {}

  wire::FromRobot& reply() { return answer_; }
  void refuse(std::string why) { answer_.mutable_problem()->set_text(std::move(why)); }

 private:
  void answer_hello(const wire::Hello& hello);
  void answer_share(const wire::Share& share);

  std::string name_;
  std::string version_;
  std::optional<SharedFiles> shared_;
  wire::ToRobot message_;
  wire::FromRobot answer_;
};

}  // namespace mlab::robot_process
