#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace mlab::mavlink {

// What ArduPilot's rovers mean by numbers of MAVLink.

/// `Heartbeat::custom_mode`.
enum class Mode : std::uint32_t {
  kManual = 0,
  kAcro = 1,
  kSteering = 3,
  kHold = 4,
  kLoiter = 5,
  kFollow = 6,
  kSimple = 7,
  kDock = 8,
  kCircle = 9,
  kAuto = 10,
  kRtl = 11,
  kSmartRtl = 12,
  kGuided = 15,
  kInitialising = 16,
};

struct ModeInfo {
  Mode mode = Mode::kManual;
  std::string_view name;
  bool is_pilots = false;  ///< somebody steers by remote control
};

inline constexpr std::array<ModeInfo, 14> kModes = {{
    {Mode::kManual, "MANUAL", true},
    {Mode::kAcro, "ACRO", true},
    {Mode::kSteering, "STEERING", true},
    {Mode::kHold, "HOLD", false},
    {Mode::kLoiter, "LOITER", false},
    {Mode::kFollow, "FOLLOW", false},
    {Mode::kSimple, "SIMPLE", true},
    {Mode::kDock, "DOCK", false},
    {Mode::kCircle, "CIRCLE", false},
    {Mode::kAuto, "AUTO", false},
    {Mode::kRtl, "RTL", false},
    {Mode::kSmartRtl, "SMART_RTL", false},
    {Mode::kGuided, "GUIDED", false},
    {Mode::kInitialising, "INITIALISING", false},
}};

/// As ArduPilot writes it; of one that is not known its number.
inline std::string name_of(Mode mode) {
  for (const ModeInfo& one : kModes) {
    if (one.mode == mode) return std::string(one.name);
  }
  return "number " + std::to_string(static_cast<std::uint32_t>(mode));
}
constexpr bool is_pilots(Mode mode) {
  for (const ModeInfo& one : kModes) {
    if (one.mode == mode) return one.is_pilots;
  }
  return false;
}

/// `Heartbeat::system_status`.
enum class State : std::uint8_t {
  kUninitialised = 0,
  kBoot = 1,
  kCalibrating = 2,
  kStandby = 3,
  kActive = 4,
  kCritical = 5,
  kEmergency = 6,
  kPowerOff = 7,
  kTermination = 8,
};

/// `CommandLong::command`.
inline constexpr std::uint16_t kDoSetMode = 176;
inline constexpr std::uint16_t kArmDisarm = 400;
inline constexpr std::uint16_t kSetMessageInterval = 511;
inline constexpr std::uint16_t kRequestMessage = 512;
/// Second parameter of `kArmDisarm`: also while it moves.
inline constexpr float kForced = 21196.0F;

/// `CommandAck::result`.
enum class Result : std::uint8_t {
  kAccepted = 0,
  kTemporarilyRejected = 1,
  kDenied = 2,
  kUnsupported = 3,
  kFailed = 4,
  kInProgress = 5,
};

inline constexpr std::uint8_t kTypeRover = 10;
inline constexpr std::uint8_t kTypeBoat = 11;
inline constexpr std::uint8_t kTypeGroundStation = 6;
inline constexpr std::uint8_t kAutopilotArdupilot = 3;
inline constexpr std::uint8_t kAutopilotNone = 8;
inline constexpr std::uint8_t kArmedBit = 128;
inline constexpr std::uint8_t kComponentAutopilot = 1;
inline constexpr std::uint8_t kComponentGroundStation = 190;
/// Of `SysStatus::sensors_*`: whether it may be armed.
inline constexpr std::uint32_t kPreArmBit = 0x10000000;

/// Velocity and turn rate count, nothing else does.
inline constexpr std::uint16_t kVelocityAndTurnRate = 0x05E7;
inline constexpr std::uint8_t kFrameBodyNed = 8;
inline constexpr std::uint8_t kFrameGlobal = 0;
inline constexpr std::uint8_t kFrameBodyFrd = 12;

}  // namespace mlab::mavlink
