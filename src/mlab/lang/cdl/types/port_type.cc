#include "mlab/lang/cdl/types/port_type.h"

#include <string_view>

namespace mlab::cdl {
namespace {

bool is_angle(std::string_view unit) {
  return unit == "rad" || unit == "deg";
}

}  // namespace

Misfit misfit(const PortType& have, const PortType& want) {
  using flow::TypeKind;
  if (have.type == nullptr || want.type == nullptr) return Misfit::kNone;
  const bool widens = have.type->kind == TypeKind::kInteger && want.type->kind == TypeKind::kReal;
  if (!widens && !flow::same_type(*have.type, *want.type)) return Misfit::kType;
  const bool have_units = want.type->kind == TypeKind::kReal && !have.unit.empty() && !want.unit.empty();
  if (!have_units || have.unit == want.unit) return Misfit::kNone;
  return is_angle(have.unit) && is_angle(want.unit) ? Misfit::kNone : Misfit::kUnit;
}

bool is_wired(const PortType& type) {
  if (type.type == nullptr) return false;
  switch (type.type->kind) {
    case flow::TypeKind::kVector:
    case flow::TypeKind::kPose:
    case flow::TypeKind::kList:
    case flow::TypeKind::kOther:
      return true;
    case flow::TypeKind::kBool:
    case flow::TypeKind::kInteger:
    case flow::TypeKind::kReal:
    case flow::TypeKind::kPoint:
    case flow::TypeKind::kText:
    case flow::TypeKind::kChoice:
    case flow::TypeKind::kMask:
      return type.type->parse == nullptr;
  }
  return false;
}

}  // namespace mlab::cdl
