#pragma once

#include <expected>
#include <string>
#include <string_view>

#include "mlab/flow/program.h"
#include "mlab/robot.pb.h"
#include "mlab/robot_process/shared_cycles.h"

namespace mlab::robot_process {

/// The program's side of a conversation with a run.
class Speaker {
 public:
  Speaker() = default;
  Speaker(const Speaker&) = delete;
  Speaker& operator=(const Speaker&) = delete;
  virtual ~Speaker() = default;

  /// The answer to one message, valid until the next call. Whatever arrives is answered.
  virtual const wire::FromRobot& answer(std::string_view bytes) = 0;
  /// What the run shares, once it does; null before.
  virtual SharedFiles* shared() = 0;
  /// What computes the cycles that are shared then.
  virtual const flow::Program& program() const = 0;
};

/// The files of a run that shares its cycles.
/// @errors  a sentence: it was built with other headers, there are no such files
std::expected<SharedFiles, std::string> accept_share(const wire::Share& share);

}  // namespace mlab::robot_process
