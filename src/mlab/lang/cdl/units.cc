#include "mlab/lang/cdl/units.h"

#include <algorithm>
#include <array>
#include <numbers>

namespace mlab::cdl {
namespace {

struct NamedUnit {
  std::string_view name;
  Unit unit;
};

constexpr std::array kUnits = {
    NamedUnit{"m", {1, 0, 0, 1, 1}},
    NamedUnit{"cm", {1, 0, 0, 1, 100}},
    NamedUnit{"mm", {1, 0, 0, 1, 1000}},
    NamedUnit{"km", {1, 0, 0, 1000, 1}},
    NamedUnit{"ft", {1, 0, 0, 3048, 1e4}},
    NamedUnit{"s", {0, 1, 0, 1, 1}},
    NamedUnit{"ms", {0, 1, 0, 1, 1000}},
    NamedUnit{"min", {0, 1, 0, 60, 1}},
    NamedUnit{"h", {0, 1, 0, 3600, 1}},
    NamedUnit{"rad", {0, 0, 1, 1, 1}},
    NamedUnit{"deg", {0, 0, 1, std::numbers::pi, 180.0}},
};

std::optional<Unit> base_unit(std::string_view name) {
  const auto* found = std::ranges::find(kUnits, name, &NamedUnit::name);
  return found == kUnits.end() ? std::nullopt : std::optional(found->unit);
}

}  // namespace

std::optional<Unit> unit_named(std::string_view name) {
  if (name.empty()) return Unit{};
  const std::size_t slash = name.find('/');
  std::optional<Unit> unit = name.starts_with("1/") ? Unit{} : base_unit(name.substr(0, slash));
  if (!unit || slash == std::string_view::npos) return unit;
  const std::optional<Unit> per = base_unit(name.substr(slash + 1));
  if (!per) return std::nullopt;
  return Unit{unit->length - per->length, unit->time - per->time, unit->angle - per->angle,
              unit->numerator * per->denominator, unit->denominator * per->numerator};
}

const std::vector<std::string>& unit_names() {
  static const std::vector<std::string> kNames = [] {
    std::vector<std::string> names;
    for (const NamedUnit& one : kUnits) names.emplace_back(one.name);
    for (const char* compound : {"m/s", "km/h", "rad/s", "deg/s"}) names.emplace_back(compound);
    return names;
  }();
  return kNames;
}

std::optional<double> converted(double value, const Unit& from, const Unit& to) {
  if (!from.same_dimension(to)) return std::nullopt;
  const double numerator = from.numerator * to.denominator;
  const double denominator = from.denominator * to.numerator;
  return numerator == denominator ? value : value * numerator / denominator;
}

}  // namespace mlab::cdl
