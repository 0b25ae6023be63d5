#pragma once

#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "mlab/base/random.h"
#include "mlab/mavlink/ardupilot.h"
#include "mlab/mavlink/frame.h"
#include "mlab/mavlink/rover_device.h"
#include "mlab/vehicle/stream.h"

namespace mlab::mavlink::testing {

using Time = vehicle::Clock::time_point;

/// What lies between a device and a rover: datagrams, some of which get lost, all later by the same delay.
struct ToyLink {
  struct Datagram {
    Time at;
    std::vector<std::byte> bytes;
  };
  std::deque<Datagram> to_rover;
  std::deque<Datagram> to_device;
  double loss = 0.0;
  vehicle::Clock::duration delay{0};
  bool is_cut = false;
  base::Random random{1};

  void put(std::deque<Datagram>& queue, std::span<const std::byte> bytes, Time now);
  static std::optional<std::vector<std::byte>> take(std::deque<Datagram>& queue, Time now);
};

/// The device's end. The link outlives it.
class ToyStream final : public vehicle::Stream {
 public:
  explicit ToyStream(ToyLink& link) : link_(link) {}
  const std::string& name() const override { return name_; }
  bool is_open() const override { return true; }
  const std::string& why() const override { return why_; }
  std::uint64_t openings() const override { return openings_; }
  std::span<const std::byte> read(Time now) override;
  bool write(std::span<const std::byte> bytes, Time now) override;
  void begin_anew(Time /*now*/) override { ++openings_; }

 private:
  ToyLink& link_;
  std::string name_ = "toy";
  std::string why_;
  std::uint64_t openings_ = 1;
  std::vector<std::byte> last_;
};

/// A rover that does what ArduPilot's does, as far as the device notices: modes, arming, set-points that
/// expire, acknowledgements, a failsafe. It has no inertia.
class ToyRover {
 public:
  explicit ToyRover(ToyLink& link, const std::optional<Key>& key = {});

  void work(Time now);
  /// Loses all that it was told, and its clock.
  void restart(Time now);
  void say(const std::string& text, Time now);
  template <class Message>
  void send(const Message& message, Time now) {
    link_.put(link_.to_device, writer_.write(message, signing_time), now);
  }

  Mode mode = Mode::kManual;
  bool is_armed = false;
  State state = State::kStandby;
  /// What it does where it is asked for the version of its firmware.
  enum class Version : std::uint8_t { kTold, kUnsupported, kMute };
  Version version = Version::kTold;
  bool passes_checks = true;
  bool refuses_modes = false;  ///< whatever mode it is told to take, it does not
  bool runs_away = false;      ///< goes on driving, whatever mode it is in, until it is disarmed
  std::map<std::string, float> parameters;
  double north = 0.0, east = 0.0, yaw = 0.0;
  double speed = 0.0, yaw_rate = 0.0;
  int forced_disarms = 0;
  std::optional<Time> heard_ground_station_at;
  std::optional<Time> set_point_at;
  std::vector<CommandLong> commands;
  SigningTime signing_time = 0;

 private:
  void take(const Frame& frame, Time now);
  void take_command(const CommandLong& message, Time now);
  void move(double dt, Time now);
  void stream(Time now);
  std::uint32_t boot_ms(Time now) const;

  ToyLink& link_;
  std::optional<Signatures> signatures_;
  FrameReader reader_;
  FrameWriter writer_;
  std::optional<Time> began_;
  Time moved_at_;
  std::map<std::uint32_t, vehicle::Clock::duration> intervals_;
  std::map<std::uint32_t, Time> sent_at_;
};

}  // namespace mlab::mavlink::testing
