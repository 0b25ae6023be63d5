#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace mlab::ros2 {

/// The text of ROS 2's definition of a message, a member a line; empty: it is none of those that are spoken
/// here.
/// @param type  as ROS calls it: `geometry_msgs/msg/Twist`
std::string_view definition_of(std::string_view type);

/// What ROS 2 tells different definitions of one name apart by, since Iron: `RIHS01_` and 64 hexadecimal
/// digits.
/// @source  rosidl: SHA-256 of the type's description as JSON
/// @return  nothing: the type, or one of its members', is not known here
std::optional<std::string> type_hash(std::string_view type);

/// As a type of ROS is called over DDS: `geometry_msgs/msg/Twist` is `geometry_msgs::msg::dds_::Twist_`.
std::string dds_name_of(std::string_view type);

}  // namespace mlab::ros2
