#include "mlab/lang/cdl/types/quantities.h"

#include <algorithm>
#include <iterator>

namespace mlab::cdl {
namespace {

constexpr Quantity kQuantities[] = {
    {"gain", "double", ""},         {"number", "double", ""},
    {"length", "double", "m"},      {"speed", "double", "m/s"},
    {"angle", "double", "rad"},     {"duration", "double", "s"},
    {"turning", "double", "rad/s"}, {"flag", "bool", ""},
    {"count", "int", ""},           {"object_class", "ObjectClasses", ""},
    {"text", "Text", ""},
};

constexpr const char* kTypeNames[] = {
    "bool",   "int",     "double", "Vector", "Point",         "Pose",      "Obstacles",
    "Robots", "Objects", "Object", "Ranges", "ObjectClasses", "Formation", "FormationReference",
    "Task",   "Text"};

}  // namespace

std::span<const Quantity> quantities() {
  return kQuantities;
}

const Quantity* quantity_named(std::string_view name) {
  const auto* const found = std::ranges::find(kQuantities, name, &Quantity::name);
  return found == std::end(kQuantities) ? nullptr : found;
}

std::vector<std::string> type_names() {
  std::vector<std::string> names(std::begin(kTypeNames), std::end(kTypeNames));
  for (const Quantity& quantity : kQuantities) names.emplace_back(quantity.name);
  return names;
}

}  // namespace mlab::cdl
