#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/robot/program/program_runner.h"
#include "mlab/robot/remote/link.h"

namespace mlab::robot_remote {

using robot::kActionPatience;
/// How long a side that has gone silent in real time is waited for [s]. Robots of a run that is lost go on
/// with what their failsafes say; afterwards nothing is left that they could be driven by.
inline constexpr double kLivePatience = 30.0;

/// Messages in real time between a run and one agent, beside their Link: only the newest of each key counts,
/// and any may be lost.
class LiveLine {
 public:
  struct Message {
    std::string key;
    std::string body;
    Clock::time_point arrived;
  };

  LiveLine() = default;
  LiveLine(const LiveLine&) = delete;
  LiveLine& operator=(const LiveLine&) = delete;
  virtual ~LiveLine() = default;

  /// Waits until each side hears the other: what is sent earlier is lost. False: it did not come to that.
  virtual bool meet(Clock::time_point deadline) = 0;
  /// By any thread.
  virtual void send(std::string_view key, std::string_view body) = 0;
  /// What has come; waits for something until then, or until `wake`. By one thread at a time.
  virtual std::vector<Message> receive(Clock::time_point deadline) = 0;
  /// Ends the wait under way, or else the next one. By any thread.
  virtual void wake() = 0;
};

/// The key of LiveBeat; robots' keys are their numbers.
inline constexpr std::string_view kBeatKey = "beat";

/// By a clock that nobody sets [ns].
inline std::int64_t nanoseconds_of(Clock::time_point time) {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(time.time_since_epoch()).count();
}
inline Clock::duration from_seconds(double seconds) {
  return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}
inline double in_seconds(Clock::duration duration) {
  return std::chrono::duration<double>(duration).count();
}

}  // namespace mlab::robot_remote
