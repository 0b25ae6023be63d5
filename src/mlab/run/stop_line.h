#pragma once

#include <functional>
#include <string>
#include <vector>

namespace mlab::run {

/// An emergency stop that a run shares with others: with other consoles, and with the machines that carry its
/// robots. May be used by any thread.
class StopLine {
 public:
  struct State {
    bool is_engaged = false;
    std::string by;  ///< who pulled or released it last, for people
  };

  StopLine() = default;
  StopLine(const StopLine&) = delete;
  StopLine& operator=(const StopLine&) = delete;
  virtual ~StopLine() = default;

  virtual State state() const = 0;
  /// Both come back at once, and hold from then on.
  virtual void engage() = 0;
  virtual void release() = 0;
  /// Machines whose robots are to stand, or to go again, and that have not said so.
  virtual std::vector<std::string> unreached() const = 0;
  /// Called whenever something of this may have changed, on a thread of the line's; it must not wait. Whoever
  /// was called before isn't any more when this comes back.
  virtual void tell(std::function<void()> changed) = 0;
};

}  // namespace mlab::run
