#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <string>

#include "mlab/base/random.h"
#include "mlab/vehicle/device.h"
#include "mlab/vehicle/server.h"
#include "mlab/vehicle/testing/rig.h"

namespace mlab::vehicle {

/// What lies between a run and a vehicle's process: messages, some of which are lost, all later by the same
/// delay, on the clock of a test.
class MessageWay {
 public:
  explicit MessageWay(std::uint64_t seed) : random_(seed) {}

  void put(std::string message, Clock::time_point now);
  /// What has arrived, the oldest first.
  std::deque<std::string> take(Clock::time_point now);
  void clear() { waiting_.clear(); }

  Impairment impairment;
  bool is_cut = false;
  bool is_held_back = false;

 private:
  struct Message {
    Clock::time_point arrives;
    std::string text;
  };
  base::Random random_;
  std::deque<Message> waiting_;
};

/// A vehicle that drives itself, as a run has it: its process with a `Server`, the way to it, and the run's
/// end of that way, which the suite drives as a device. What it is told is as live as what a run tells, and
/// no more.
class ServedRig final : public Rig {
 public:
  /// In a process that begins with the vehicle at a place.
  using MakeVehicle = std::function<std::unique_ptr<Device>(const geom::Pose& place)>;

  ServedRig(std::uint64_t seed, const Facts& facts, MakeVehicle make_vehicle);
  ~ServedRig() override;

  const Facts& facts() const override { return facts_; }
  Device& device() override;
  void drop_device() override;
  Clock::time_point step() override;
  Truth truth() const override { return truth_; }
  void impair(const Impairment& impairment) override;
  void cut(Cut how) override;
  void mend() override;
  void hold_back() override;
  void release() override;

 private:
  class RunsEnd;
  void start_process();
  void end_process();

  Facts facts_;
  MakeVehicle make_vehicle_;
  MessageWay commands_;
  MessageWay reports_;
  std::unique_ptr<Device> vehicle_;  // null: its process does not run
  std::unique_ptr<Server> server_;
  std::unique_ptr<RunsEnd> end_;
  Truth truth_;
  Clock::time_point now_{std::chrono::hours(1)};
  Clock::time_point reported_at_;
};

}  // namespace mlab::vehicle
