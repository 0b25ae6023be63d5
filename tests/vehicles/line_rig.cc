#include "line_rig.h"

#include <stdexcept>
#include <utility>

namespace mlab::vehicle {
namespace {

constexpr auto kPeriod = std::chrono::milliseconds(20);

}  // namespace

LineRig::LineRig(std::uint64_t seed, const Facts& facts,
                 std::unique_ptr<model_vehicles::ModelVehicle> vehicle,
                 const std::function<Made(std::unique_ptr<Stream>)>& make_device, TestLine::Kind kind)
    : facts_(facts), line_(seed, kind), vehicle_(std::move(vehicle)) {
  Made made = make_device(line_.device_end());
  if (!made.has_value()) throw std::runtime_error(made.error());
  device_ = std::move(*made);
}

Clock::time_point LineRig::step() {
  now_ += kPeriod;
  vehicle_->receive(line_.read(now_));
  const std::string said = vehicle_->step(std::chrono::duration<double>(kPeriod).count());
  if (!is_off_) line_.write(said, now_);
  return now_;
}

Truth LineRig::truth() const {
  const auto truth = vehicle_->truth();
  return {truth.pose, truth.speed, truth.turn_rate};
}

void LineRig::cut(Cut how) {
  line_.cut(how);
  is_off_ = how == Cut::kPowerOff || how == Cut::kRestart;
  if (is_off_) vehicle_->restart();
}

void LineRig::mend() {
  if (is_off_) vehicle_->restart();
  is_off_ = false;
  line_.mend(now_);
}

}  // namespace mlab::vehicle
