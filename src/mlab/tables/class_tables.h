#pragma once

#include <string>

namespace mlab::tables {

/// The numbers of ObjectClass in robot.proto.
std::string object_class_enum();
/// Documentation: which colour marks which class.
std::string object_class_documentation();
/// What `mlab world` draws.
std::string world_kind_documentation();

}  // namespace mlab::tables
