#include "mlab/recording/percepts_check.h"

#include <cmath>
#include <limits>
#include <vector>

#include <fmt/core.h>
#include <google/protobuf/descriptor.h>
#include <google/protobuf/io/coded_stream.h>
#include <google/protobuf/message.h>
#include <google/protobuf/wire_format_lite.h>

#include "mlab/binding/body.h"
#include "mlab/percept/action.h"
#include "mlab/robot/wire/action_wire.h"
#include "mlab/robot/wire/percepts_wire.h"

namespace mlab::recording {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using google::protobuf::internal::WireFormatLite;

/// Two bytes may stand for a message of a hundred: so many in one entry are the most.
constexpr int kMostMessages = 1 << 20;
constexpr double kLargest = 1e9;                   // of any number [m, s, rad]
constexpr std::uint32_t kMostObjects = 1U << 20U;  // ids count from 1

// The messages in the bytes of one of this type, itself counted. Stops where they are too many, or no
// messages.
int messages_in(google::protobuf::io::CodedInputStream& in, const Descriptor& type, int most) {
  int count = 1;
  for (std::uint32_t tag = in.ReadTag(); tag != 0 && count <= most; tag = in.ReadTag()) {
    const FieldDescriptor* field = type.FindFieldByNumber(WireFormatLite::GetTagFieldNumber(tag));
    int length = 0;
    if (field == nullptr || field->message_type() == nullptr ||
        WireFormatLite::GetTagWireType(tag) != WireFormatLite::WIRETYPE_LENGTH_DELIMITED) {
      if (!WireFormatLite::SkipField(&in, tag)) return count;
    } else if (in.ReadVarintSizeAsInt(&length)) {
      const auto outer = in.PushLimit(length);
      count += messages_in(in, *field->message_type(), most - count);
      in.PopLimit(outer);
    } else {
      return count;
    }
  }
  return count;
}

bool is_too_much(std::string_view bytes) {
  google::protobuf::io::CodedInputStream in(reinterpret_cast<const std::uint8_t*>(bytes.data()),
                                            static_cast<int>(bytes.size()));
  return messages_in(in, *wire::RecordedEntry::descriptor(), kMostMessages) > kMostMessages;
}

std::optional<std::string> problem_of_value(const Message& message, const FieldDescriptor& field, int i) {
  const google::protobuf::Reflection& values = *message.GetReflection();
  if (field.cpp_type() == FieldDescriptor::CPPTYPE_DOUBLE) {
    const double value = field.is_repeated() ? values.GetRepeatedDouble(message, &field, i)
                                             : values.GetDouble(message, &field);
    if (std::abs(value) <= kLargest) return std::nullopt;
    return fmt::format("{} is {}, where numbers from {} to {} can be", field.name(), value, -kLargest,
                       kLargest);
  }
  const int value = field.is_repeated() ? values.GetRepeatedEnumValue(message, &field, i)
                                        : values.GetEnumValue(message, &field);
  if (field.enum_type()->FindValueByNumber(value) != nullptr) return std::nullopt;
  return fmt::format("{} is {}, which no {} is", field.name(), value, field.enum_type()->name());
}

/// What is only compared with what robots do now may be anything.
bool is_only_compared(const Descriptor& type) {
  return &type == wire::Action::descriptor() || &type == wire::Needs::descriptor();
}

/// The first number or name anywhere in the message that stands for nothing, with the way there.
std::optional<std::string> problem_of_values(const Message& message) {
  const google::protobuf::Reflection& values = *message.GetReflection();
  std::vector<const FieldDescriptor*> fields;
  values.ListFields(message, &fields);
  for (const FieldDescriptor* field : fields) {
    const auto type = field->cpp_type();
    const bool is_message = type == FieldDescriptor::CPPTYPE_MESSAGE;
    if (is_message && is_only_compared(*field->message_type())) continue;
    if (!is_message && type != FieldDescriptor::CPPTYPE_DOUBLE && type != FieldDescriptor::CPPTYPE_ENUM)
      continue;
    const int count = field->is_repeated() ? values.FieldSize(message, field) : 1;
    for (int i = 0; i < count; ++i) {
      std::optional<std::string> problem;
      if (!is_message)
        problem = problem_of_value(message, *field, i);
      else
        problem = problem_of_values(field->is_repeated() ? values.GetRepeatedMessage(message, field, i)
                                                         : values.GetMessage(message, field));
      if (!problem) continue;
      const std::string index = field->is_repeated() ? fmt::format("[{}]", i) : "";
      return is_message ? fmt::format("{}{}.{}", field->name(), index, *problem)
                        : problem->insert(field->name().size(), index);
    }
  }
  return std::nullopt;
}

std::optional<std::string> problem_of(const wire::RecordedObject& object) {
  if (object.id() != 0 && object.id() <= kMostObjects) return std::nullopt;
  return fmt::format("an object with the id {}, where 1 to {} can be", object.id(), kMostObjects);
}

bool is_as_long(const wire::Points& points, int length) {
  return points.x_size() == length && points.y_size() == length;
}

std::optional<std::string> problem_of(const wire::RecordedWorld& world) {
  const int discs = world.disc_x_size();
  if (world.disc_y_size() != discs || world.disc_radius_size() != discs)
    return fmt::format("{} discs have {} y and {} radii", discs, world.disc_y_size(),
                       world.disc_radius_size());
  const int walls = world.wall_group_size();
  if (!is_as_long(world.wall_a(), walls) || !is_as_long(world.wall_b(), walls) ||
      world.wall_is_solid_size() != walls)
    return fmt::format("{} walls have {} and {} ends, and {} say whether they are solid", walls,
                       world.wall_a().x_size(), world.wall_b().x_size(), world.wall_is_solid_size());
  for (const double radius : world.disc_radius()) {
    if (radius < 0.0) return fmt::format("a disc has a radius of {} m", radius);
  }
  for (const wire::RecordedObject& object : world.objects()) {
    if (auto problem = problem_of(object)) return problem;
  }
  return std::nullopt;
}

std::optional<std::string> problem_of(const wire::RecordedBody& body) {
  if (body.radius() < 0.0) return fmt::format("robot {} has a radius of {} m", body.robot(), body.radius());
  constexpr auto kLastDrive = static_cast<std::uint32_t>(binding::kLastDrive);
  if (body.has_kinematics() && body.kinematics().drive() > kLastDrive)
    return fmt::format("robot {} has drive {}, where {} is the last", body.robot(), body.kinematics().drive(),
                       kLastDrive);
  if (body.has_kinematics() && !(body.kinematics().wheelbase() > 0.0))
    return fmt::format("robot {} has a wheelbase of {} m", body.robot(), body.kinematics().wheelbase());
  constexpr std::uint32_t kMostSensors = std::numeric_limits<std::uint16_t>::max();
  if (body.range_sensors() <= kMostSensors) return std::nullopt;
  return fmt::format("robot {} has {} range sensors, where {} are the most", body.robot(),
                     body.range_sensors(), kMostSensors);
}

std::optional<std::string> problem_of(const wire::RecordedRadio& radio) {
  if (radio.robot_size() != radio.net_size())
    return fmt::format("{} robots with radios are in {} nets", radio.robot_size(), radio.net_size());
  if (radio.lost_from_size() != radio.lost_to_size())
    return fmt::format("what {} robots told was lost to {}", radio.lost_from_size(), radio.lost_to_size());
  return std::nullopt;
}

std::optional<std::string> problem_of(const wire::RecordedCycle& cycle) {
  if (!(cycle.duration() > 0.0)) return fmt::format("a cycle lasts {} s", cycle.duration());
  robot_wire::DecodedPercepts percepts;
  percept::Action action;
  for (const wire::RecordedRobot& robot : cycle.robots()) {
    auto problem = percepts.decode(robot.percepts());
    if (!problem) problem = robot_wire::decode(robot.action(), action);
    if (problem) return fmt::format("of robot {}: {}", robot.robot(), *problem);
  }
  for (const wire::RecordedObject& object : cycle.objects()) {
    if (auto problem = problem_of(object)) return problem;
  }
  return problem_of(cycle.radio());
}

}  // namespace

std::optional<std::string> parse_entry(std::string_view bytes, wire::RecordedEntry& out) {
  if (is_too_much(bytes))
    return fmt::format("{} bytes with more than {} parts, which is more than an entry may have", bytes.size(),
                       kMostMessages);
  if (!out.ParseFromArray(bytes.data(), static_cast<int>(bytes.size())))
    return fmt::format("{} bytes that are no entry: this is no file of percepts, or broken", bytes.size());
  if (auto problem = problem_of_values(out)) return problem;
  switch (out.body_case()) {
    case wire::RecordedEntry::kWorld:
      return problem_of(out.world());
    case wire::RecordedEntry::kEmbodied:
      return problem_of(out.embodied());
    case wire::RecordedEntry::kCycle:
      return problem_of(out.cycle());
    case wire::RecordedEntry::kHead:
    case wire::RecordedEntry::kEnd:
      return std::nullopt;
    case wire::RecordedEntry::BODY_NOT_SET:
      break;
  }
  return "an entry of a kind that is not known";
}

}  // namespace mlab::recording
