#include "mlab/python/values.h"

#include <cstring>
#include <span>

#include <fmt/format.h>

namespace mlab::python {
namespace {

std::vector<double> parts_at(const std::byte* at, std::size_t count) {
  std::vector<double> out(count);
  std::memcpy(out.data(), at, count * sizeof(double));
  return out;
}

}  // namespace

Value value_of(const std::byte* frame, const flow::Port& port) {
  const std::byte* const at = frame + port.offset;
  switch (port.type->kind) {
    case flow::TypeKind::kBool:
      return flow::Program::number(frame, port) != 0.0;
    case flow::TypeKind::kInteger:
      return static_cast<std::int64_t>(flow::Program::number(frame, port).value_or(0.0));
    case flow::TypeKind::kReal:
      return flow::Program::number(frame, port).value_or(0.0);
    case flow::TypeKind::kVector:
    case flow::TypeKind::kPose:
      return parts_at(at, 3);
    case flow::TypeKind::kPoint:
      return parts_at(at, 2);
    default:
      return flow::Program::print(frame, port);
  }
}

const char* name_of(flow::Port::Role role) {
  switch (role) {
    case flow::Port::Role::kParameter:
      return "parameter";
    case flow::Port::Role::kConstant:
      return "constant";
    case flow::Port::Role::kOutput:
      return "output";
  }
  return "output";
}

std::string text_of(const std::vector<double>& parts) {
  return fmt::format("{{{}}}", fmt::join(parts, ", "));
}

}  // namespace mlab::python
