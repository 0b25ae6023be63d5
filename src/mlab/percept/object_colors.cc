#include "mlab/percept/object_colors.h"

#include <cstddef>

#include "mlab/percept/object_classes.h"

namespace mlab::percept {
namespace {

bool is_blank(char c) {
  return c == ' ' || c == '-' || c == '_';
}

bool is_same_color(std::string_view a, std::string_view b) {
  const auto small = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  std::size_t i = 0;
  std::size_t k = 0;
  for (;;) {
    while (i < a.size() && is_blank(a[i])) ++i;
    while (k < b.size() && is_blank(b[k])) ++k;
    if (i == a.size() || k == b.size()) return i == a.size() && k == b.size();
    if (small(a[i++]) != small(b[k++])) return false;
  }
}

}  // namespace

std::string_view color_of(ObjectClass object_class) {
  const auto i = static_cast<std::size_t>(object_class);
  return i < kObjectClasses.size() ? kObjectClasses[i].color : std::string_view{};
}

std::optional<ObjectClass> object_class_of_color(std::string_view color) {
  for (const ObjectClassInfo& one : kObjectClasses) {
    if (is_same_color(one.color, color)) return one.object_class;
  }
  return std::nullopt;
}

std::string colors_of_classes() {
  std::string out;
  for (const ObjectClassInfo& one : kObjectClasses) {
    if (!out.empty()) out += ", ";
    out += one.color;
  }
  return out;
}

}  // namespace mlab::percept
