#include "mlab/percept/object_colors.h"

#include <array>
#include <cstddef>

namespace mlab::percept {
namespace {

/// In the order of ObjectClass.
/// @source  the historic table of object classes by colour
constexpr std::array<std::string_view, 11> kColors = {
    "orange", "red",   "purple",     "green",  "black", "dark sea green",
    "white",  "brown", "light blue", "yellow", "blue"};

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
  return i < kColors.size() ? kColors[i] : std::string_view{};
}

std::optional<ObjectClass> object_class_of_color(std::string_view color) {
  for (std::size_t i = 0; i < kColors.size(); ++i) {
    if (is_same_color(kColors[i], color)) return static_cast<ObjectClass>(i);
  }
  return std::nullopt;
}

std::string_view colors_of_classes() {
  return "orange, red, purple, green, black, dark sea green, white, brown, light blue, yellow, blue";
}

}  // namespace mlab::percept
