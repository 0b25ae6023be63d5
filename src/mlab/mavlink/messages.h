#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <tuple>
#include <type_traits>

namespace mlab::mavlink {

/// What tells a message from others on the wire.
struct MessageInfo {
  std::uint32_t id = 0;
  std::uint8_t extra =
      0;  ///< CRC_EXTRA: goes into the checksum, so that who has other fields sees no message
  std::string_view name;
};

// The messages that a rover and we speak by. A struct is its own description: its fields stand in the order
// of the wire (the larger first, extensions last), and `base::fields_of` reads and writes them. Units and
// frames are MAVLink's, as its dictionary `common.xml` has them: north, east, down; yaw clockwise.

struct Heartbeat {
  static constexpr MessageInfo kInfo{0, 50, "HEARTBEAT"};
  std::uint32_t custom_mode = 0;  ///< of a rover: `Mode`
  std::uint8_t type = 0;          ///< MAV_TYPE
  std::uint8_t autopilot = 0;     ///< MAV_AUTOPILOT
  std::uint8_t base_mode = 0;     ///< bits; 128: armed
  std::uint8_t system_status = 0;
  std::uint8_t mavlink_version = 3;
};

struct SysStatus {
  static constexpr MessageInfo kInfo{1, 124, "SYS_STATUS"};
  std::uint32_t sensors_present = 0;
  std::uint32_t sensors_enabled = 0;
  std::uint32_t sensors_health = 0;
  std::uint16_t load = 0;             ///< [0.1 %]
  std::uint16_t voltage_battery = 0;  ///< [mV]; 65535: not known
  std::int16_t current_battery = 0;   ///< [cA]
  std::uint16_t drop_rate_comm = 0;
  std::uint16_t errors_comm = 0;
  std::array<std::uint16_t, 4> errors_count{};
  std::int8_t battery_remaining = 0;  ///< [%]; -1: not known
};

struct ParamRequestRead {
  static constexpr MessageInfo kInfo{20, 214, "PARAM_REQUEST_READ"};
  std::int16_t param_index = -1;  ///< -1: by its name
  std::uint8_t target_system = 0;
  std::uint8_t target_component = 0;
  std::array<char, 16> param_id{};  ///< ends with a zero where it is shorter
};

struct ParamValue {
  static constexpr MessageInfo kInfo{22, 220, "PARAM_VALUE"};
  float param_value = 0.0F;  ///< ArduPilot tells whole numbers as such, too
  std::uint16_t param_count = 0;
  std::uint16_t param_index = 0;
  std::array<char, 16> param_id{};
  std::uint8_t param_type = 0;
};

struct ParamSet {
  static constexpr MessageInfo kInfo{23, 168, "PARAM_SET"};
  float param_value = 0.0F;
  std::uint8_t target_system = 0;
  std::uint8_t target_component = 0;
  std::array<char, 16> param_id{};
  std::uint8_t param_type = 9;  ///< MAV_PARAM_TYPE_REAL32
};

struct Attitude {
  static constexpr MessageInfo kInfo{30, 39, "ATTITUDE"};
  std::uint32_t time_boot_ms = 0;
  float roll = 0.0F;        ///< [rad]
  float pitch = 0.0F;       ///< [rad]
  float yaw = 0.0F;         ///< clockwise from north [rad]
  float rollspeed = 0.0F;   ///< [rad/s]
  float pitchspeed = 0.0F;  ///< [rad/s]
  float yawspeed = 0.0F;    ///< clockwise [rad/s]
};

struct LocalPositionNed {
  static constexpr MessageInfo kInfo{32, 185, "LOCAL_POSITION_NED"};
  std::uint32_t time_boot_ms = 0;
  float x = 0.0F;   ///< north of the filter's origin [m]
  float y = 0.0F;   ///< east of it [m]
  float z = 0.0F;   ///< below it [m]
  float vx = 0.0F;  ///< [m/s]
  float vy = 0.0F;
  float vz = 0.0F;
};

struct GlobalPositionInt {
  static constexpr MessageInfo kInfo{33, 104, "GLOBAL_POSITION_INT"};
  std::uint32_t time_boot_ms = 0;
  std::int32_t lat = 0;           ///< [1e-7 deg]
  std::int32_t lon = 0;           ///< [1e-7 deg]
  std::int32_t alt = 0;           ///< [mm]
  std::int32_t relative_alt = 0;  ///< [mm]
  std::int16_t vx = 0;            ///< north [cm/s]
  std::int16_t vy = 0;
  std::int16_t vz = 0;
  std::uint16_t hdg = 0;  ///< [0.01 deg]; 65535: not known
};

struct CommandLong {
  static constexpr MessageInfo kInfo{76, 152, "COMMAND_LONG"};
  std::array<float, 7> params{};
  std::uint16_t command = 0;  ///< MAV_CMD
  std::uint8_t target_system = 0;
  std::uint8_t target_component = 0;
  std::uint8_t confirmation = 0;  ///< how often it was sent before
};

struct CommandAck {
  static constexpr MessageInfo kInfo{77, 143, "COMMAND_ACK"};
  std::uint16_t command = 0;
  std::uint8_t result = 0;  ///< MAV_RESULT
  std::uint8_t progress = 0;
  std::int32_t result_param2 = 0;
  std::uint8_t target_system = 0;  ///< 0: for everybody
  std::uint8_t target_component = 0;
};

struct SetPositionTargetLocalNed {
  static constexpr MessageInfo kInfo{84, 143, "SET_POSITION_TARGET_LOCAL_NED"};
  std::uint32_t time_boot_ms = 0;  ///< of the sender
  float x = 0.0F;
  float y = 0.0F;
  float z = 0.0F;
  float vx = 0.0F;  ///< [m/s]
  float vy = 0.0F;
  float vz = 0.0F;
  float afx = 0.0F;
  float afy = 0.0F;
  float afz = 0.0F;
  float yaw = 0.0F;
  float yaw_rate = 0.0F;  ///< clockwise [rad/s]
  std::uint16_t type_mask = 0;
  std::uint8_t target_system = 0;
  std::uint8_t target_component = 0;
  std::uint8_t coordinate_frame = 0;
};

struct DistanceSensor {
  static constexpr MessageInfo kInfo{132, 85, "DISTANCE_SENSOR"};
  std::uint32_t time_boot_ms = 0;
  std::uint16_t min_distance = 0;      ///< [cm]
  std::uint16_t max_distance = 0;      ///< [cm]
  std::uint16_t current_distance = 0;  ///< [cm]
  std::uint8_t type = 0;
  std::uint8_t id = 0;
  std::uint8_t orientation = 0;  ///< 0 .. 7: looks 45 degrees more to the right each
  std::uint8_t covariance = 0;
  float horizontal_fov = 0.0F;  ///< [rad]; 0: not known
  float vertical_fov = 0.0F;
  std::array<float, 4> quaternion{};
  std::uint8_t signal_quality = 0;  ///< [%]; 0: not known, 1: of no use
};

struct BatteryStatus {
  static constexpr MessageInfo kInfo{147, 154, "BATTERY_STATUS"};
  std::int32_t current_consumed = 0;
  std::int32_t energy_consumed = 0;
  std::int16_t temperature = 0;
  std::array<std::uint16_t, 10> voltages{};  ///< of cells, or of all in the first ones [mV]; 65535: not known
  std::int16_t current_battery = 0;
  std::uint8_t id = 0;
  std::uint8_t battery_function = 0;
  std::uint8_t type = 0;
  std::int8_t battery_remaining = 0;  ///< [%]; -1: not known
};

struct AutopilotVersion {
  static constexpr MessageInfo kInfo{148, 178, "AUTOPILOT_VERSION"};
  std::uint64_t capabilities = 0;
  std::uint64_t uid = 0;
  std::uint32_t flight_sw_version = 0;  ///< major, minor, patch and kind, a byte each, the highest first
  std::uint32_t middleware_sw_version = 0;
  std::uint32_t os_sw_version = 0;
  std::uint32_t board_version = 0;
  std::uint16_t vendor_id = 0;
  std::uint16_t product_id = 0;
  std::array<char, 8> flight_custom_version{};  ///< of ArduPilot: the begin of the revision's number
  std::array<std::uint8_t, 8> middleware_custom_version{};
  std::array<std::uint8_t, 8> os_custom_version{};
  std::array<std::uint8_t, 18> uid2{};
};

struct StatusText {
  static constexpr MessageInfo kInfo{253, 83, "STATUSTEXT"};
  std::uint8_t severity = 0;  ///< 0 emergency .. 7 debug
  std::array<char, 50> text{};
  std::uint16_t id = 0;
  std::uint8_t chunk_seq = 0;
};

struct ObstacleDistance {
  static constexpr MessageInfo kInfo{330, 23, "OBSTACLE_DISTANCE"};
  std::uint64_t time_usec = 0;  ///< since the vehicle began, or since 1970
  std::array<std::uint16_t, 72>
      distances{};                 ///< clockwise [cm]; 65535: not known; more than max: nothing is there
  std::uint16_t min_distance = 0;  ///< [cm]
  std::uint16_t max_distance = 0;  ///< [cm]
  std::uint8_t sensor_type = 0;
  std::uint8_t increment = 0;  ///< [deg]
  float increment_f = 0.0F;    ///< [deg]; not 0: instead of `increment`
  float angle_offset = 0.0F;   ///< of the first distance, clockwise [deg]
  std::uint8_t frame = 0;      ///< MAV_FRAME; 0: from north, 12: from the vehicle's nose
};

/// All of them.
using Messages =
    std::tuple<Heartbeat, SysStatus, ParamRequestRead, ParamValue, ParamSet, Attitude, LocalPositionNed,
               GlobalPositionInt, CommandLong, CommandAck, SetPositionTargetLocalNed, DistanceSensor,
               BatteryStatus, AutopilotVersion, StatusText, ObstacleDistance>;

/// What tells each of them apart.
inline constexpr auto kInfos = []<class... One>(std::type_identity<std::tuple<One...>>) {
  return std::array{One::kInfo...};
}(std::type_identity<Messages>{});

/// CRC_EXTRA of a message of ours; nothing: it is none.
constexpr std::optional<std::uint8_t> extra_of(std::uint32_t id) {
  for (const MessageInfo& one : kInfos) {
    if (one.id == id) return one.extra;
  }
  return std::nullopt;
}

/// A name in a field of fixed length, cut to it.
template <std::size_t kSize>
std::array<char, kSize> field_of(std::string_view text) {
  std::array<char, kSize> out{};
  std::copy_n(text.begin(), std::min(text.size(), kSize), out.begin());
  return out;
}
/// What stands in such a field.
template <std::size_t kSize>
std::string_view text_of(const std::array<char, kSize>& field) {
  return {field.data(), static_cast<std::size_t>(std::ranges::find(field, '\0') - field.begin())};
}

}  // namespace mlab::mavlink
