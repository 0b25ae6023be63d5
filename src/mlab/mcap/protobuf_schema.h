#pragma once

#include "mlab/mcap/records.h"

namespace google::protobuf {
class Descriptor;
}

namespace mlab::mcap {

/// What channels with the message encoding `protobuf` want to know of a type of messages: its full name, and
/// the definitions of it and of all that it is made of, as a serialized `FileDescriptorSet`. The same bytes
/// for the same definitions.
///
///     const auto schema = writer.add_schema(protobuf_schema(*wire::Pose::descriptor()));
Schema protobuf_schema(const google::protobuf::Descriptor& type);

}  // namespace mlab::mcap
