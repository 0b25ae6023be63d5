#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

namespace mlab::ros2_robot {

/// The robot in a process of its own, which ends with this object.
class RobotProcess {
 public:
  /// @param more  of its options
  explicit RobotProcess(const std::vector<std::string>& more);
  ~RobotProcess();
  RobotProcess(const RobotProcess&) = delete;
  RobotProcess& operator=(const RobotProcess&) = delete;

  /// What it has said so far.
  const std::string& said();
  bool has_said(const std::string& text) { return said().find(text) != std::string::npos; }
  /// The number behind the last `text` that it said, such as that of `stands at 3.250`.
  std::optional<double> last(const std::string& text);
  /// @return  its exit status; -1: a signal ended it
  int end(int signal);

 private:
  pid_t id_ = -1;
  int output_ = -1;
  std::string said_;
};

/// A domain of DDS whose first port nobody has on this machine.
int free_domain();

}  // namespace mlab::ros2_robot
