#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <thread>
#include <unordered_map>
#include <vector>

#include "mlab/agent.pb.h"
#include "mlab/robot/remote/remote_runner.h"

namespace mlab::robot_remote {

/// Says to agents, on a thread of its own, that the run is there, whatever its own thread is busy with, and
/// whether cycles go by.
class Beats {
 public:
  /// @param period  of a cycle [s]; without one for longer than two of them the run counts as resting
  explicit Beats(double period);
  void add(std::shared_ptr<LiveLine> line);
  void remove(const std::shared_ptr<LiveLine>& line);
  /// A cycle goes by.
  void note_cycle();

 private:
  void beat(const std::stop_token& stop);

  double period_;
  std::mutex mutex_;
  std::condition_variable_any ended_;
  std::vector<std::shared_ptr<LiveLine>> lines_;
  Clock::time_point last_cycle_;
  bool has_cycles_ = false;
  std::jthread thread_;
};

/// The way to an agent and back, by the four times that each action brings: the shortest of the last seconds,
/// which waited for nobody (the minimum filter of NTP, RFC 5905 section 10).
class RoundTrip {
 public:
  /// @param seconds  there and back, without what the agent took in between
  void note(double seconds, Clock::time_point now);
  /// [s]; 0: nothing is known yet.
  double shortest() const;

 private:
  static constexpr std::chrono::seconds kWindow{5};
  double current_ = 0.0;  // of this window; 0: none
  double before_ = 0.0;   // of the one before
  Clock::time_point began_;
};

/// Robots that agents carry in real time: the world does not wait for them. They act on the newest percepts
/// that reach them; a cycle takes the newest actions that have come. An action that is too old
/// (kActionPatience) makes its body stand. A body knows how far it has turned since what it is told was
/// decided, so that the delay does not make it steer past its way. What a robot asks for once (to pick
/// something up, to notify) is not lost with an action: it is repeated until it was taken.
class LiveRunner final : public RemoteRunner {
 public:
  /// @param period  of a cycle [s], > 0
  LiveRunner(Recruit recruit, double period);

  void open() override;
  void act(std::span<const Turn> turns) override;
  void ask() override;
  void wait(const robot::Meanwhile& meanwhile) override;
  double silence(Member member) const override;
  double percept_age(Member member) const override;
  const robot::Punctuality* punctuality() const override { return &punctuality_; }

 protected:
  bool waits_for_silent() const override { return false; }
  bool is_known_well(const Robot& robot) const override;

 private:
  /// What is known of a robot besides its values.
  struct Live {
    std::uint32_t number = 0;  // of the robot at its agent; another one: what is here is of before
    wire::LivePercepts percepts;
    std::uint64_t taken = 0;       // number of its newest action
    std::uint64_t answered = 0;    // the cycle that it was for
    percept::Action action;        // without what it asks for once
    std::vector<double> headings;  // of the last cycles, by their number [rad]
    Clock::time_point came;
    Clock::time_point answers;              // when the percepts were sent that `action` answers
    std::deque<percept::Request> requests;  // that have come and were not handed on
    bool has_ended = false;                 // with a failure or fault, which the turn holds
  };
  bool is_looked_at(const Robot& robot) const;
  void follow_lines();
  bool gather(Carrier& carrier, Clock::time_point last);
  void take(const LiveLine::Message& message, Carrier& carrier);
  std::optional<std::string> take(const wire::LiveAction& message, Robot& robot, Live& live);
  void finish(const Robot& robot, Live& live, Clock::time_point now);
  void note_asked(Clock::time_point now);
  const Live* find(Member member) const { return member < live_.size() ? live_[member].get() : nullptr; }

  double period_;
  std::vector<std::unique_ptr<Live>> live_;              // by member
  std::unordered_map<std::uint32_t, Member> by_number_;  // of this cycle's robots
  std::unordered_map<const LiveLine*, RoundTrip> trips_;
  std::vector<std::shared_ptr<LiveLine>> lines_;  // whose agents hear beats
  robot::Punctuality punctuality_;
  Clock::time_point asked_at_;
  std::vector<Clock::time_point> asked_;  // the last cycles, by their number
  Clock::time_point resumed_;             // since then cycles follow each other
  wire::LiveAction message_;
  std::string bytes_;
  Beats beats_;
};

}  // namespace mlab::robot_remote
