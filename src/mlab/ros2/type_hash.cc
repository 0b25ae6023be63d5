#include "mlab/ros2/type_hash.h"

#include <openssl/evp.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include <fmt/format.h>

namespace mlab::ros2 {
namespace {

/// A type, and its definition with the names of members' types in full.
struct Definition {
  std::string_view type;
  std::string_view text;
};

constexpr std::array kDefinitions = {
    Definition{"action_msgs/msg/GoalInfo",
               "unique_identifier_msgs/UUID goal_id\nbuiltin_interfaces/Time stamp\n"},
    Definition{"action_msgs/msg/GoalStatus", "action_msgs/GoalInfo goal_info\nint8 status\n"},
    Definition{"action_msgs/msg/GoalStatusArray", "action_msgs/GoalStatus[] status_list\n"},
    Definition{"builtin_interfaces/msg/Time", "int32 sec\nuint32 nanosec\n"},
    Definition{"diagnostic_msgs/msg/DiagnosticArray",
               "std_msgs/Header header\ndiagnostic_msgs/DiagnosticStatus[] status\n"},
    Definition{"diagnostic_msgs/msg/DiagnosticStatus",
               "byte level\nstring name\nstring message\nstring hardware_id\n"
               "diagnostic_msgs/KeyValue[] values\n"},
    Definition{"diagnostic_msgs/msg/KeyValue", "string key\nstring value\n"},
    Definition{"geometry_msgs/msg/Point", "float64 x\nfloat64 y\nfloat64 z\n"},
    Definition{"geometry_msgs/msg/Pose",
               "geometry_msgs/Point position\ngeometry_msgs/Quaternion orientation\n"},
    Definition{"geometry_msgs/msg/PoseStamped", "std_msgs/Header header\ngeometry_msgs/Pose pose\n"},
    Definition{"geometry_msgs/msg/PoseWithCovariance", "geometry_msgs/Pose pose\nfloat64[36] covariance\n"},
    Definition{"geometry_msgs/msg/Quaternion", "float64 x\nfloat64 y\nfloat64 z\nfloat64 w\n"},
    Definition{"geometry_msgs/msg/Transform",
               "geometry_msgs/Vector3 translation\ngeometry_msgs/Quaternion rotation\n"},
    Definition{"geometry_msgs/msg/TransformStamped",
               "std_msgs/Header header\nstring child_frame_id\ngeometry_msgs/Transform transform\n"},
    Definition{"geometry_msgs/msg/Twist", "geometry_msgs/Vector3 linear\ngeometry_msgs/Vector3 angular\n"},
    Definition{"geometry_msgs/msg/TwistStamped", "std_msgs/Header header\ngeometry_msgs/Twist twist\n"},
    Definition{"geometry_msgs/msg/TwistWithCovariance",
               "geometry_msgs/Twist twist\nfloat64[36] covariance\n"},
    Definition{"geometry_msgs/msg/Vector3", "float64 x\nfloat64 y\nfloat64 z\n"},
    Definition{"nav_msgs/msg/Odometry",
               "std_msgs/Header header\nstring child_frame_id\n"
               "geometry_msgs/PoseWithCovariance pose\ngeometry_msgs/TwistWithCovariance twist\n"},
    Definition{"sensor_msgs/msg/BatteryState",
               "std_msgs/Header header\nfloat32 voltage\nfloat32 temperature\nfloat32 current\n"
               "float32 charge\nfloat32 capacity\nfloat32 design_capacity\nfloat32 percentage\n"
               "uint8 power_supply_status\nuint8 power_supply_health\nuint8 power_supply_technology\n"
               "bool present\nfloat32[] cell_voltage\nfloat32[] cell_temperature\nstring location\n"
               "string serial_number\n"},
    Definition{"sensor_msgs/msg/LaserScan",
               "std_msgs/Header header\nfloat32 angle_min\nfloat32 angle_max\nfloat32 angle_increment\n"
               "float32 time_increment\nfloat32 scan_time\nfloat32 range_min\nfloat32 range_max\n"
               "float32[] ranges\nfloat32[] intensities\n"},
    Definition{"std_msgs/msg/Header", "builtin_interfaces/Time stamp\nstring frame_id\n"},
    Definition{"std_msgs/msg/String", "string data\n"},
    Definition{"tf2_msgs/msg/TFMessage", "geometry_msgs/TransformStamped[] transforms\n"},
    Definition{"unique_identifier_msgs/msg/UUID", "uint8[16] uuid\n"},
};

/// A plain type, and rosidl's number for it.
struct Plain {
  std::string_view name;
  int number;
};
constexpr std::array kPlain = {
    Plain{"int8", 2},   Plain{"uint8", 3}, Plain{"int16", 4},   Plain{"uint16", 5},   Plain{"int32", 6},
    Plain{"uint32", 7}, Plain{"int64", 8}, Plain{"uint64", 9},  Plain{"float32", 10}, Plain{"float64", 11},
    Plain{"bool", 15},  Plain{"byte", 16}, Plain{"string", 17},
};
constexpr int kNested = 1;
constexpr int kFixedArray = 48;
constexpr int kSequence = 144;

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> out;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    out.push_back(text.substr(0, end));
    text.remove_prefix(end + 1);
  }
  return out;
}

/// A member's type, taken apart.
struct MemberType {
  int number = 0;  // rosidl's
  std::size_t capacity = 0;
  std::string nested;  // in full
};

MemberType member_type(std::string_view written) {
  MemberType out;
  const std::size_t bracket = written.find('[');
  int added = 0;
  if (bracket != std::string_view::npos) {
    const std::string_view count = written.substr(bracket + 1, written.size() - bracket - 2);
    std::from_chars(count.data(), count.data() + count.size(), out.capacity);
    added = count.empty() ? kSequence : kFixedArray;
    written = written.substr(0, bracket);
  }
  const auto* const plain = std::ranges::find(kPlain, written, &Plain::name);
  if (plain == kPlain.end()) {
    const std::size_t slash = written.find('/');
    out.nested = fmt::format("{}/msg/{}", written.substr(0, slash), written.substr(slash + 1));
  }
  out.number = added + (plain == kPlain.end() ? kNested : plain->number);
  return out;
}

/// Its description, and those of all that it refers to, by their names.
bool describe(std::string_view type, std::map<std::string, std::string>& out) {
  if (out.contains(std::string(type))) return true;
  const std::string_view text = definition_of(type);
  if (text.empty()) return false;
  std::string fields;
  std::vector<std::string> nested;
  for (const std::string_view line : lines_of(text)) {
    const std::size_t blank = line.find(' ');
    const MemberType is = member_type(line.substr(0, blank));
    fields +=
        fmt::format(R"({}{{"name": "{}", "type": {{"type_id": {}, "capacity": {}, "string_capacity": 0, )"
                    R"("nested_type_name": "{}"}}}})",
                    fields.empty() ? "" : ", ", line.substr(blank + 1), is.number, is.capacity, is.nested);
    if (!is.nested.empty()) nested.push_back(is.nested);
  }
  out[std::string(type)] = fmt::format(R"({{"type_name": "{}", "fields": [{}]}})", type, fields);
  return std::ranges::all_of(nested, [&](const std::string& one) { return describe(one, out); });
}

std::string sha256(std::string_view text) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int size = 0;
  EVP_Digest(text.data(), text.size(), digest.data(), &size, EVP_sha256(), nullptr);
  std::string out;
  for (unsigned int i = 0; i < size; ++i) out += fmt::format("{:02x}", digest[i]);
  return out;
}

}  // namespace

std::string_view definition_of(std::string_view type) {
  const auto* const found = std::ranges::find(kDefinitions, type, &Definition::type);
  return found == kDefinitions.end() ? std::string_view{} : found->text;
}

std::optional<std::string> type_hash(std::string_view type) {
  std::map<std::string, std::string> all;
  if (!describe(type, all)) return std::nullopt;
  const std::string own = all[std::string(type)];
  all.erase(std::string(type));
  std::string others;
  for (const auto& [name, description] : all) {
    if (!others.empty()) others += ", ";
    others += description;
  }
  return "RIHS01_" + sha256(fmt::format(R"({{"type_description": {}, "referenced_type_descriptions": [{}]}})",
                                        own, others));
}

std::string dds_name_of(std::string_view type) {
  const std::size_t first = type.find('/');
  const std::size_t last = type.rfind('/');
  if (first == std::string_view::npos || first == last) return {};
  return fmt::format("{}::{}::dds_::{}_", type.substr(0, first), type.substr(first + 1, last - first - 1),
                     type.substr(last + 1));
}

}  // namespace mlab::ros2
