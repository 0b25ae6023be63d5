#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace mlab::robot_remote {

using Clock = std::chrono::steady_clock;
class LiveLine;

/// Messages there and back between a run and one agent: whole, in order, none lost as long as it stands.
/// What carries them is behind it. Used by one thread at a time.
class Link {
 public:
  Link() = default;
  Link(const Link&) = delete;
  Link& operator=(const Link&) = delete;
  virtual ~Link() = default;

  /// Hands a message over; it does not wait for the other side to read it. Nothing happens where it has
  /// failed.
  virtual void send(std::string_view message) = 0;
  /// The next message, waited for until then; valid until the next call. Nothing: none came, or it has
  /// failed.
  virtual std::optional<std::string_view> receive(Clock::time_point deadline) = 0;

  /// Sees whether the other side still stands; `failure` says so.
  virtual void look() {}
  /// What became of the other side, as a sentence without its subject: `ended with exit status 3`, `has been
  /// silent for 5 s`. Empty: it stands. One that failed stays failed.
  virtual const std::string& failure() const = 0;
  /// For how long nothing has been heard of the other side [s], where that is longer than it should be; else
  /// 0.
  virtual double silence() const { return 0.0; }
  /// After so long a silence it is given up [s].
  virtual double patience_with_silence() const { return 0.0; }
  /// Nothing is heard of the other side at present, and yet it has not failed: it may come back, and what is
  /// sent now would be lost. In real time only.
  virtual bool is_cut() { return false; }
  /// Gives it up because of something that its owner saw.
  virtual void fail(std::string why) = 0;

  /// What passes beside it in real time; null: it was not made for that.
  virtual std::shared_ptr<LiveLine> live() { return nullptr; }
};

}  // namespace mlab::robot_remote
