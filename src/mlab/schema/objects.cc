#include "mlab/schema/objects.h"

#include <array>
#include <cstddef>

namespace mlab::schema {
namespace {

// In the order of percept::ObjectClass.
constexpr std::array<std::string_view, 11> kColors = {
    "orange", "red",   "purple",     "green",  "black", "dark sea green",
    "white",  "brown", "light blue", "yellow", "blue"};

bool is_same(std::string_view a, std::string_view b) {
  const auto small = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  return std::ranges::equal(a, b, {}, small, small);
}

}  // namespace

std::string_view color_of(percept::ObjectClass object_class) {
  const auto i = static_cast<std::size_t>(object_class);
  return i < kColors.size() ? kColors[i] : std::string_view{};
}

std::optional<percept::ObjectClass> object_class_of_color(std::string_view color) {
  for (std::size_t i = 0; i < kColors.size(); ++i) {
    if (is_same(kColors[i], color)) return static_cast<percept::ObjectClass>(i);
  }
  return std::nullopt;
}

bool sees(const percept::Percepts& percepts, flow::ObjectClasses classes, double range) {
  return std::ranges::any_of(percepts.objects, [&](const percept::ObjectReading& object) {
    return contains(classes, object.object_class) && edge_distance(object) <= range;
  });
}

}  // namespace mlab::schema
