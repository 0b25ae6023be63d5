#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "mlab/geom/pose.h"
#include "mlab/vehicle/device.h"

namespace mlab::vehicle {

/// What a vehicle really does, whatever is told of it.
struct Truth {
  geom::Pose pose;         ///< [m, world]
  double speed = 0.0;      ///< along its heading [m/s]
  double turn_rate = 0.0;  ///< counter-clockwise [rad/s]
};

/// What can become of what connects a device with its vehicle.
enum class Cut : std::uint8_t {
  kSilence,   ///< all that is said is lost, either way, and nobody is told
  kHangUp,    ///< the device can't be opened any more: its plug was pulled
  kPowerOff,  ///< the same, and the vehicle is switched off; with the line it is switched on again
  kRestart,   ///< it is switched off and on, but the device can be opened: an adapter has power of its own
};
inline constexpr Cut kLastCut = Cut::kRestart;

/// What a line does to what is said over it, either way.
struct Impairment {
  double loss = 0.0;  ///< chance that a message, or a piece of a stream of bytes, is lost, 0 .. 1
  std::chrono::milliseconds delay{0};  ///< of all that arrives
};

/// What the suite has to know of a kind of device to try it. The numbers are promises to its users: they
/// stand on its page.
struct Facts {
  double silent_after = 1.0;   ///< of what was said longer ago it reports nothing [s]
  double battery_lasts = 0.0;  ///< the same of its battery, where that is longer [s]
  double ready_within = 5.0;   ///< once its vehicle can be reached over a line without losses [s]
  double stops_within = 1.0;   ///< from full speed, once it is told over a line that works [s]
  double pose_error = 0.02;    ///< of a reported place against the true one; encoders of rigs don't drift [m]
  double heading_error = 0.02;  ///< [rad]
  double speed_error = 0.02;    ///< [m/s]
  double turn_error = 0.05;     ///< [rad/s]
  /// So much earlier than its stamp says a report may have been true, besides the line's delay [s].
  double stamp_error = 0.05;
  double standing_speed = 1e-3;      ///< what is not faster stands [m/s]
  double standing_turn_rate = 1e-3;  ///< [rad/s]
  /// Of the way that it is told to make it makes at least this share over a line that loses 20 % and delays
  /// the rest by 200 ms, each way.
  double bad_line_share = 0.5;
  bool has_ranges = false;  ///< it reports scans
  bool has_battery = false;
  /// Its vehicle refuses what it was told too long ago; else a line that holds commands back and lets them go
  /// later moves it once more.
  bool refuses_late_commands = false;
  /// Else it turns as it sees fit on the way to where a command leads: it is only told that.
  bool holds_turn_rates = true;
  bool has_checks = true;  ///< it says what of it is to be looked at before a mission, for it is real
};

/// A device and its vehicle with all that is between them. The vehicle is a model, or anything else that says
/// the truth about itself.
class Rig {
 public:
  Rig() = default;
  Rig(const Rig&) = delete;
  Rig& operator=(const Rig&) = delete;
  virtual ~Rig() = default;

  virtual const Facts& facts() const = 0;
  virtual Device& device() = 0;
  /// Destroys the device; `device` is not called any more.
  virtual void drop_device() = 0;
  /// Lets some time go by for the vehicle and the line, at most 50 ms: on a clock of its own where vehicle
  /// and line have none, so that hours take seconds.
  /// @return  the time after it
  virtual Clock::time_point step() = 0;
  /// As it is at the time that `step` returned last.
  virtual Truth truth() const = 0;
  virtual void impair(const Impairment& impairment) = 0;
  virtual void cut(Cut how) = 0;
  virtual void mend() = 0;
  /// What is said waits in the line, either way, until `release` lets all of it go, not faster than a line
  /// can.
  virtual void hold_back() = 0;
  virtual void release() = 0;
  /// Somebody else takes the vehicle, a pilot by remote control, say, and has it go on moving until an
  /// emergency stop.
  /// @return  false: nobody can
  virtual bool take() { return false; }
  /// Somebody else takes the vehicle to have it stand: puts it into another mode, presses its own emergency
  /// stop.
  /// @return  false: nobody can
  virtual bool take_to_stand() { return false; }
  /// Who took it to stand lets go of it.
  virtual void give_back() {}
};

/// A kind of device, as the suite is instantiated with.
struct RigKind {
  std::string name;  ///< of tests: letters and digits
  /// @param seed  of all that is random in it
  std::function<std::unique_ptr<Rig>(std::uint64_t seed)> make;
  /// How often its device goes away and comes back at random; what runs in real time does so less often.
  int outages = 100;
};

}  // namespace mlab::vehicle
