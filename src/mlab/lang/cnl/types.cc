#include "mlab/lang/cnl/types.h"

#include <algorithm>
#include <array>

namespace mlab::cnl {
namespace {

// Words of C++ that historic networks use for whole numbers.
constexpr std::array<std::string_view, 5> kWholeNumbers = {"short", "long", "char", "signed", "unsigned"};

constexpr std::array<std::string_view, 6> kLost = {"type_pry",        "Reinforcer", "gt_Unit_Members",
                                                   "raw_sonar_array", "gt_Command", "vector_array"};

}  // namespace

const flow::ValueTypeInfo* find_port_type(std::string_view name) {
  if (std::ranges::find(kWholeNumbers, name) != kWholeNumbers.end()) name = "int";
  for (const flow::ValueTypeInfo& type : flow::kValueTypes) {
    if (type.name == name || (!type.historic.empty() && type.historic == name)) return &type;
  }
  return nullptr;
}

bool is_reading(const flow::ValueTypeInfo& type) {
  return type.kind == flow::TypeKind::kList;
}

bool is_scalar(const flow::ValueTypeInfo& type) {
  switch (type.kind) {
    case flow::TypeKind::kBool:
    case flow::TypeKind::kInteger:
    case flow::TypeKind::kReal:
    case flow::TypeKind::kChoice:
      return true;
    case flow::TypeKind::kVector:
    case flow::TypeKind::kPoint:
    case flow::TypeKind::kPose:
    case flow::TypeKind::kText:
    case flow::TypeKind::kMask:
    case flow::TypeKind::kList:
    case flow::TypeKind::kOther:
      return false;
  }
  return false;
}

std::vector<std::string> port_type_names() {
  std::vector<std::string> out;
  for (const flow::ValueTypeInfo& type : flow::kValueTypes) {
    out.emplace_back(type.name);
    if (!type.historic.empty()) out.emplace_back(type.historic);
  }
  out.insert(out.end(), kWholeNumbers.begin(), kWholeNumbers.end());
  return out;
}

bool is_lost_historic_type(std::string_view name) {
  return std::ranges::find(kLost, name) != kLost.end();
}

}  // namespace mlab::cnl
