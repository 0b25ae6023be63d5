#include "mlab/tables/class_tables.h"

#include <string_view>

#include <fmt/core.h>

#include "mlab/lang/odl/drawn_worlds.h"
#include "mlab/percept/object_classes.h"

namespace mlab::tables {
namespace {

// `EnemyRobot` as `ENEMY_ROBOT`.
std::string in_capitals(std::string_view name) {
  std::string out;
  for (const char c : name) {
    const bool is_small = c >= 'a' && c <= 'z';
    if (!is_small && !out.empty()) out += '_';
    out += is_small ? static_cast<char>(c - 'a' + 'A') : c;
  }
  return out;
}

}  // namespace

std::string object_class_enum() {
  std::string out;
  for (const percept::ObjectClassInfo& one : percept::kObjectClasses)
    out += fmt::format("  {} = {};\n", in_capitals(one.name), static_cast<int>(one.object_class));
  return out;
}

std::string world_kind_documentation() {
  std::string out = "| `KIND` | |\n|---|---|\n";
  for (const odl::WorldKindInfo& one : odl::kWorldKinds)
    out += fmt::format("| `{}` | {} |\n", one.name, one.help);
  return out;
}

std::string object_class_documentation() {
  std::string out = "| class | colour |\n|---|---|\n";
  for (const percept::ObjectClassInfo& one : percept::kObjectClasses)
    out += fmt::format("| `{}` | {} |\n", one.name, one.color);
  return out;
}

}  // namespace mlab::tables
