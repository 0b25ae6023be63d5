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
  /// Takes over what is known by now of other machines, without waiting until they are listened to again.
  virtual void hear() {}
  /// Before a run begins: waits, not for long, until it is known from some machine what holds.
  virtual void settle() {}
  /// Both come back at once, and hold from then on.
  virtual void engage() = 0;
  virtual void release() = 0;
  /// A machine whose robots are to stand, or to go again, and that has not said so.
  struct Unreached {
    std::string name;
    std::string by = {};  ///< who else in the fleet knows of it, for people; empty: it was heard here
    double silent = 0.0;  ///< since it was heard last [s]
  };
  virtual std::vector<Unreached> unreached() const = 0;
  /// What a person at the run has to know at once beside that, sentences that are told once. One thread at a
  /// time; may be asked in each cycle.
  virtual std::vector<std::string> take_alerts() { return {}; }
  /// Called whenever something of this may have changed, on a thread of the line's; it must not wait. Whoever
  /// was called before isn't any more when this comes back.
  virtual void tell(std::function<void()> changed) = 0;
};

}  // namespace mlab::run
