#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mlab/mavlink/control.h"
#include "mlab/mavlink/firmware.h"
#include "mlab/mavlink/line.h"
#include "mlab/mavlink/parameters.h"
#include "mlab/mavlink/readings.h"
#include "mlab/vehicle/device.h"

namespace mlab::mavlink {

/// A rover that has been heard is silent when nothing came of it for this long.
inline constexpr std::chrono::milliseconds kSilentAfter{2500};

/// Those of a rover of which nothing else is said.
inline vehicle::Limits rover_limits() {
  vehicle::Limits out;
  out.kinematics.drive = binding::Drive::kDifferential;
  out.standstill = 2.5;
  return out;
}

/// What is to be said of a rover that it does not say itself.
struct RoverSettings {
  /// Its own; `standstill` decides how long a set-point may last (its parameter GUID_TIMEOUT).
  vehicle::Limits limits = rover_limits();
  std::optional<Key> key;    ///< all is signed with it, and what is not is refused
  std::uint8_t vehicle = 0;  ///< its number (SYSID_THISMAV); 0: the first rover that is heard
  std::uint8_t self = 255;   ///< our number, as the rover's ground station
  /// Where the origin of its own frame is in the world's [m]; nothing: its poses begin anywhere.
  std::optional<geom::Point> origin;
  bool writes_parameters = false;  ///< needed parameters that are wrong are set, instead of only told
  Line::SigningClock signing_clock = &signing_time_now;
};

/// Something that happened, for people: what the vehicle said, or what was noticed of it.
struct Note {
  vehicle::Clock::time_point at;
  std::uint8_t severity = 6;  ///< 0 emergency .. 4 warning .. 7 debug
  std::string text;
};

/// A rover (or boat) under ArduPilot, in GUIDED mode, by MAVLink 2.
///
/// It is ready once it is armed and in GUIDED mode; `drive` brings it there where everything else is well:
/// its parameters, its own checks, a position. docs/mavlink.md says what stops it, and how soon.
class RoverDevice final : public vehicle::Device {
 public:
  using Time = vehicle::Clock::time_point;

  RoverDevice(std::unique_ptr<vehicle::Stream> stream, const RoverSettings& settings);
  ~RoverDevice() override;

  const std::string& name() const override { return name_; }
  const vehicle::Limits& limits() const override { return settings_.limits; }
  void work(Time now) override;
  const vehicle::Report& report(Time now) override;
  std::vector<vehicle::Check> checks(Time now) override;
  void drive(const vehicle::Command& command, Time now) override;
  void stop(Time now) override;
  void stop_in_emergency(Time now) override;
  void engage(Time now) override;

  /// Its parameters that matter, and what they have to be; for a check before a mission.
  std::vector<ParameterCheck> parameters() const { return parameters_.checks(); }
  /// Where it is on the earth; nothing: it has not said so lately.
  std::optional<Place> place(Time now) const { return readings_.place(now); }
  /// What happened since this was called last, the oldest first; at most 32.
  std::vector<Note> take_notes();
  std::vector<std::string> take_news() override;
  /// What came and was not taken for the rover's.
  const Refusals& refusals() const { return line_.refusals(); }

 private:
  struct Trouble {
    vehicle::Readiness readiness = vehicle::Readiness::kReady;
    std::string why;
  };

  void read(Time now);
  void take(const Frame& frame, Time now);
  void take_heartbeat(const Frame& frame, Time now);
  void take_answer(const CommandAck& message, Time now);
  void take_text(const StatusText& message, Time now);
  void say(Time now);
  void ask(Time now);
  void begin_anew(Time now);
  void lose(Time now);
  void notice(Time now, std::uint8_t severity, std::string text);
  bool is_silent(Time now) const;
  /// What is against driving it, apart from its mode and that it is not armed; nothing: `kReady`.
  Trouble trouble(Time now) const;
  Trouble silence(Time now) const;
  Trouble state_trouble(Time now) const;
  Trouble mode_trouble() const;

  RoverSettings settings_;
  std::string name_;
  Line line_;
  Parameters parameters_;
  Firmware firmware_;
  Readings readings_;
  Control control_;
  std::optional<Heard> heard_;
  std::optional<Time> frame_at_;  // of the last frame of the vehicle's
  bool was_silent_ = true;
  bool fails_checks_ = false;
  std::string check_text_;
  std::string stranger_;  // who is there instead of a rover
  double told_jump_ = 0.0;
  std::optional<Time> beat_at_;
  std::optional<Time> asked_at_;
  std::optional<Time> peer_since_;
  std::vector<std::optional<Time>> streams_seen_;
  std::vector<std::optional<Time>> streams_asked_;
  std::deque<Note> notes_;
  vehicle::Report report_;
  Time now_;
};

}  // namespace mlab::mavlink
