#include "served_rig.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mlab/vehicle/messages.h"

namespace mlab::vehicle {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds kProcessStep{20};  // of a vehicle's process
constexpr milliseconds kReporting{50};    // as it has it
constexpr milliseconds kCycle{100};       // of a run
constexpr const char* kSender = "run";
constexpr std::uint64_t kSession = 7;

}  // namespace

void MessageWay::put(std::string message, Clock::time_point now) {
  if (is_cut || random_.uniform() < impairment.loss) return;
  waiting_.push_back({now + impairment.delay, std::move(message)});
}

std::deque<std::string> MessageWay::take(Clock::time_point now) {
  std::deque<std::string> out;
  while (!is_held_back && !waiting_.empty() && waiting_.front().arrives <= now) {
    out.push_back(std::move(waiting_.front().text));
    waiting_.pop_front();
  }
  return out;
}

/// As a run has a vehicle: the newest report, and a command in each cycle.
class ServedRig::RunsEnd final : public Device {
 public:
  RunsEnd(ServedRig& rig, const Limits& limits) : rig_(rig), limits_(limits) {
    // What it is told lives so long, then it stops as it does when its own driver is gone.
    limits_.standstill += kCommandPatience;
  }
  ~RunsEnd() override {
    wire::VehicleCommand leave = next_command();
    leave.set_leaves(true);
    rig_.commands_.put(leave.SerializeAsString(), worked_at_);
  }

  const std::string& name() const override { return name_; }
  const Limits& limits() const override { return limits_; }
  void work(Clock::time_point now) override {
    worked_at_ = now;
    for (const std::string& one : rig_.reports_.take(now)) take(one, now);
    if (now - heard_ > milliseconds(1000)) is_driven_ = false;
    if (now - told_at_ < kCycle || heard_ == Clock::time_point{}) return;
    told_at_ = now;
    // A command is of a program that is computed in each cycle: nobody repeats it.
    const bool is_fresh = is_driven_ && now - driven_at_ < kCycle + kProcessStep;
    if (is_fresh || is_told_to_stand_) tell(is_fresh ? command_ : Command{}, is_fresh, now);
  }
  const Report& report(Clock::time_point now) override {
    if (heard_ == Clock::time_point{} || now - heard_ > milliseconds(1000)) {
      report_ = {};
      report_.readiness = Readiness::kSilent;
      report_.why = "has not been heard for 1 s";
    }
    return report_;
  }
  void drive(const Command& command, Clock::time_point now) override {
    if (!std::isfinite(command.speed) || !std::isfinite(command.turn_rate)) {
      stop(now);
      return;
    }
    is_driven_ = true;
    is_told_to_stand_ = false;
    command_ = command;
    driven_at_ = now;
  }
  void stop(Clock::time_point /*now*/) override {
    is_driven_ = false;
    is_told_to_stand_ = true;
  }

 private:
  wire::VehicleCommand next_command() {
    wire::VehicleCommand out;
    out.set_session(kSession);
    out.set_number(++told_);
    out.set_answers(number_);
    out.set_period(std::chrono::duration<double>(kCycle).count());
    return out;
  }
  void tell(const Command& command, bool drives, Clock::time_point now) {
    wire::VehicleCommand out = next_command();
    out.set_drives(drives);
    out.set_velocity_x(std::clamp(command.speed, -100.0, 100.0));
    out.set_spins(drives);
    out.set_spin(std::clamp(command.turn_rate, -100.0, 100.0));
    rig_.commands_.put(out.SerializeAsString(), now);
  }
  void take(const std::string& bytes, Clock::time_point now) {
    wire::VehicleReport message;
    if (!message.ParseFromString(bytes) || message.number() == number_) return;
    auto read = decode(message, now);
    if (!read) return;
    number_ = message.number();
    heard_ = now;
    report_ = std::move(*read);
  }

  ServedRig& rig_;
  const std::string name_ = "a vehicle of a fleet";
  Limits limits_;
  Report report_;
  std::uint64_t number_ = 0;  // of the newest report
  std::uint64_t told_ = 0;    // commands
  Command command_;
  bool is_driven_ = false;
  bool is_told_to_stand_ = false;
  Clock::time_point worked_at_;
  Clock::time_point heard_;
  Clock::time_point driven_at_;
  Clock::time_point told_at_;
};

ServedRig::ServedRig(std::uint64_t seed, const Facts& facts, MakeVehicle make_vehicle)
    : facts_(facts),
      make_vehicle_(std::move(make_vehicle)),
      commands_(base::combine_bits(seed, 1)),
      reports_(base::combine_bits(seed, 2)) {
  start_process();
  end_ = std::make_unique<RunsEnd>(*this, vehicle_->limits());
}

ServedRig::~ServedRig() = default;

Device& ServedRig::device() {
  return *end_;
}

void ServedRig::drop_device() {
  end_.reset();
}

void ServedRig::start_process() {
  vehicle_ = make_vehicle_(truth_.pose);
  server_ = std::make_unique<Server>(*vehicle_, [] { return false; });
}

// Its body is gone with it; another one begins where that was.
void ServedRig::end_process() {
  server_.reset();
  vehicle_.reset();
  truth_.speed = truth_.turn_rate = 0.0;
}

Clock::time_point ServedRig::step() {
  now_ += kProcessStep;
  if (!server_) return now_;
  for (const std::string& one : commands_.take(now_)) server_->hear(kSender, one, now_);
  server_->work(now_);
  if (now_ - reported_at_ >= kReporting) {
    reported_at_ = now_;
    reports_.put(server_->report(now_), now_);
  }
  const auto& motion = vehicle_->report(now_).motion;
  if (motion) truth_ = {motion->pose, motion->speed, motion->turn_rate};
  return now_;
}

void ServedRig::impair(const Impairment& impairment) {
  commands_.impairment = reports_.impairment = impairment;
}

void ServedRig::cut(Cut how) {
  for (MessageWay* const way : {&commands_, &reports_}) {
    way->is_cut = true;
    way->clear();
  }
  if (how == Cut::kHangUp) server_->lose(kSender);  // both are told
  if (how == Cut::kPowerOff || how == Cut::kRestart) end_process();
  if (how == Cut::kRestart) start_process();
}

void ServedRig::mend() {
  if (!server_) start_process();
  commands_.is_cut = reports_.is_cut = false;
}

void ServedRig::hold_back() {
  commands_.is_held_back = reports_.is_held_back = true;
}

void ServedRig::release() {
  commands_.is_held_back = reports_.is_held_back = false;
}

}  // namespace mlab::vehicle
