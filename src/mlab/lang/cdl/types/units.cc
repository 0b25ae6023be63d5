#include "mlab/lang/cdl/types/units.h"

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
  Unit out;
  bool divides = false;
  for (bool is_first = true; !name.empty(); is_first = false) {
    const std::size_t end = std::min(name.find_first_of("*/"), name.size());
    const std::string_view word = name.substr(0, end);
    const std::optional<Unit> one = is_first && word == "1" && end < name.size() ? Unit{} : base_unit(word);
    if (!one) return std::nullopt;
    const int sign = divides ? -1 : 1;
    out = {out.length + sign * one->length, out.time + sign * one->time, out.angle + sign * one->angle,
           out.numerator * (divides ? one->denominator : one->numerator),
           out.denominator * (divides ? one->numerator : one->denominator)};
    if (end == name.size()) return out;
    divides = name[end] == '/';
    name.remove_prefix(end + 1);
    if (name.empty()) return std::nullopt;
  }
  return out;
}

std::string si_unit(const Unit& unit) {
  std::string above;
  std::string below;
  const auto put = [&](int times, std::string_view name) {
    for (; times > 0; --times) above += (above.empty() ? "" : "*") + std::string(name);
    for (; times < 0; ++times) below += "/" + std::string(name);
  };
  put(unit.length, "m");
  put(unit.angle, "rad");
  put(unit.time, "s");
  return above.empty() && !below.empty() ? "1" + below : above + below;
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
