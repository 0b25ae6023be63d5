#include "mlab/lang/cdl/types/arithmetic.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

#include <fmt/core.h>

#include "mlab/flow/port_types.h"
#include "mlab/flow/type_words.h"
#include "mlab/lang/cdl/syntax/signs.h"
#include "mlab/lang/cdl/types/units.h"

namespace mlab::cdl {
namespace {

constexpr int kMaxPower = 9;  // of a unit in a product

enum class Sort { kUnknown, kNumber, kVector, kPoint, kOther };

Sort sort_of(const PortType& type) {
  if (type.type == nullptr) return Sort::kUnknown;
  switch (type.type->kind) {
    case flow::TypeKind::kReal:
    case flow::TypeKind::kInteger:
      return Sort::kNumber;
    case flow::TypeKind::kVector:
      return Sort::kVector;
    case flow::TypeKind::kPoint:
      return Sort::kPoint;
    case flow::TypeKind::kBool:
    case flow::TypeKind::kPose:
    case flow::TypeKind::kText:
    case flow::TypeKind::kChoice:
    case flow::TypeKind::kMask:
    case flow::TypeKind::kList:
    case flow::TypeKind::kOther:
      return Sort::kOther;
  }
  return Sort::kOther;
}

PortType number_in(const Unit& unit) {
  return {&flow::type_info<double>(), si_unit(unit)};
}
PortType vector_in(const Unit& unit) {
  return {&flow::type_info<geom::Vector>(), si_unit(unit)};
}
PortType truth() {
  return {&flow::type_info<bool>(), ""};
}

std::string with_article(const PortType& type) {
  return type.type == nullptr ? type.name() : flow::value_of(*type.type);
}

Computation refused(std::string message, std::string hint = {}) {
  Computation out;
  out.refusal = std::move(message);
  out.hint = std::move(hint);
  return out;
}

Computation refused_units(const PortType& a, const PortType& b, const char* what) {
  Computation out =
      refused(fmt::format("{} and {} can't be {}", unit_in_words(a.unit), unit_in_words(b.unit), what));
  out.is_about_units = true;
  const std::string& said = a.unit.empty() ? b.unit : a.unit;
  if (a.unit.empty() || b.unit.empty()) out.hint = fmt::format("a number with its unit: `1 {}`", said);
  return out;
}

// The operands of one computation, whose types are known.
class Operands {
 public:
  explicit Operands(std::span<const PortType> types) : types_(types) {
    for (const PortType& type : types) {
      sorts_.push_back(sort_of(type));
      units_.push_back(unit_named(type.unit));
    }
  }

  bool are_known() const { return std::ranges::find(sorts_, Sort::kUnknown) == sorts_.end(); }
  bool are_all(Sort sort) const {
    return std::ranges::all_of(sorts_, [&](Sort one) { return one == sort; });
  }
  bool are(Sort first, Sort second) const { return sorts_[0] == first && sorts_[1] == second; }
  const PortType& type(std::size_t i) const { return types_[i]; }
  std::size_t size() const { return types_.size(); }
  Unit unit(std::size_t i) const { return units_[i].value_or(Unit{}); }

  /// The first whose unit nobody knows: what is read from a procedure of somebody's own.
  std::optional<std::size_t> unknown_unit() const {
    const auto at = std::ranges::find_if(units_, [](const auto& unit) { return !unit.has_value(); });
    return at == units_.end() ? std::nullopt : std::optional(static_cast<std::size_t>(at - units_.begin()));
  }
  /// The first that is not in the unit of those before it. A vector that has none fits all.
  std::optional<std::size_t> other_unit(bool may_be_unsaid) const {
    for (std::size_t i = 1; i < size(); ++i) {
      const bool is_unsaid = may_be_unsaid && (types_[i].unit.empty() || types_[0].unit.empty());
      if (!is_unsaid && !unit(i).same_dimension(unit(0))) return i;
    }
    return std::nullopt;
  }
  /// Of vectors of which only some say it.
  Unit said_unit() const {
    for (std::size_t i = 0; i < size(); ++i) {
      if (!types_[i].unit.empty()) return unit(i);
    }
    return {};
  }

 private:
  std::span<const PortType> types_;
  std::vector<Sort> sorts_;
  std::vector<std::optional<Unit>> units_;
};

std::vector<std::size_t> in_order(std::size_t size) {
  std::vector<std::size_t> out(size);
  for (std::size_t i = 0; i < size; ++i) out[i] = i;
  return out;
}

// Numbers, or vectors, of one unit.
Computation of_one_unit(const Operands& operands, std::string_view behavior, bool gives_vector,
                        const char* what) {
  if (const auto at = operands.other_unit(gives_vector))
    return refused_units(operands.type(0), operands.type(*at), what);
  const Unit unit = operands.said_unit();
  return {behavior, gives_vector ? vector_in(unit) : number_in(unit), in_order(operands.size())};
}

Computation of_points(const Operands& operands, const char* what) {
  const bool are_points = operands.are(Sort::kPoint, Sort::kPoint);
  return refused(fmt::format("{} and {} can't be {}", with_article(operands.type(0)),
                             with_article(operands.type(1)), what),
                 are_points
                     ? "`distance(a, b)` is how far two places are from each other"
                     : "`DetectGoal(p)` is the way from the robot to a place of the world, as a Vector");
}

Computation mixed(const Operands& operands, const char* what) {
  const PortType& a = operands.type(0);
  const PortType& b = operands.type(operands.size() - 1);
  return refused(operands.size() == 1
                     ? fmt::format("{} can't be {}", with_article(a), what)
                     : fmt::format("{} and {} can't be {}", with_article(a), with_article(b), what));
}

Computation sum(const Operands& operands, bool adds) {
  const char* what = adds ? "added" : "subtracted";
  if (operands.are_all(Sort::kNumber))
    return of_one_unit(operands, adds ? "AddNumbers" : "SubtractNumbers", false, what);
  if (operands.are_all(Sort::kVector))
    return of_one_unit(operands, adds ? "AddVectors" : "SubtractVectors", true, what);
  const bool has_point = operands.are(Sort::kPoint, Sort::kVector) ||
                         operands.are(Sort::kPoint, Sort::kPoint) ||
                         operands.are(Sort::kVector, Sort::kPoint);
  return has_point ? of_points(operands, what) : mixed(operands, what);
}

Computation product(const Operands& operands, bool multiplies) {
  const Unit unit = operands.unit(0).times(operands.unit(1), multiplies ? 1 : -1);
  if (std::max({std::abs(unit.length), std::abs(unit.time), std::abs(unit.angle)}) > kMaxPower) {
    Computation out = refused(fmt::format("the unit of this has a power of more than {}", kMaxPower));
    out.is_about_units = true;
    return out;
  }
  if (operands.are_all(Sort::kNumber))
    return {multiplies ? "MultiplyNumbers" : "DivideNumbers", number_in(unit), {0, 1}};
  if (operands.are(Sort::kVector, Sort::kNumber))
    return {multiplies ? "ScaleVector" : "DivideVector", vector_in(unit), {0, 1}};
  if (multiplies && operands.are(Sort::kNumber, Sort::kVector))
    return {"ScaleVector", vector_in(unit), {1, 0}};
  return mixed(operands, multiplies ? "multiplied" : "divided");
}

Computation negation(const Operands& operands) {
  const Unit unit = operands.unit(0);
  if (operands.are_all(Sort::kNumber)) return {"NegateNumber", number_in(unit), {0}};
  if (operands.are_all(Sort::kVector)) return {"NegateVector", vector_in(unit), {0}};
  return mixed(operands, "negated");
}

Computation comparison(Operation operation, const Operands& operands) {
  Computation out = operands.are_all(Sort::kNumber) ? of_one_unit(operands, "", false, "compared")
                                                    : mixed(operands, "compared");
  if (!out.refusal.empty()) {
    const auto is_truth = [](const PortType& type) { return type.type->kind == flow::TypeKind::kBool; };
    const bool is_of_truths = is_truth(operands.type(0)) || is_truth(operands.type(1));
    if (!out.is_about_units && out.hint.empty())
      out.hint = is_of_truths ? "numbers are compared; a truth value is a condition by itself: `on`, `not on`"
                              : "numbers are compared";
    return out;
  }
  const bool is_turned = operation == Operation::kGreater || operation == Operation::kGreaterOrEqual;
  out.behavior = operation == Operation::kEqual                                      ? "AreEqual"
                 : operation == Operation::kUnequal                                  ? "AreUnequal"
                 : operation == Operation::kLess || operation == Operation::kGreater ? "IsLess"
                                                                                     : "IsLessOrEqual";
  if (is_turned) std::ranges::reverse(out.order);
  out.type = truth();
  return out;
}

Computation length_or_direction(const Function& function, const Operands& operands) {
  const bool is_vector = operands.are_all(Sort::kVector);
  if (!is_vector) {
    Computation out = refused(
        fmt::format("`{}` is of a Vector; this is {}", function.name, with_article(operands.type(0))));
    out.refused = 0;
    return out;
  }
  const std::vector<std::size_t> order = {0};
  if (function.name == "normalized") return {function.behavior, vector_in({}), order};
  if (function.name == "direction") return {function.behavior, number_in({0, 0, 1, 1.0, 1.0}), order};
  return {function.behavior, number_in(operands.unit(0)), order};
}

Computation distance(const Operands& operands) {
  if (operands.are_all(Sort::kPoint)) return {"DistanceOfPoints", number_in({1, 0, 0, 1.0, 1.0}), {0, 1}};
  if (!operands.are_all(Sort::kVector))
    return refused(fmt::format("`distance` is of two Points or of two Vectors; these are {} and {}",
                               with_article(operands.type(0)), with_article(operands.type(1))),
                   "`DetectGoal(p)` is the way from the robot to a place of the world, as a Vector");
  if (const auto at = operands.other_unit(true))
    return refused_units(operands.type(0), operands.type(*at), "compared");
  return {"DistanceOfVectors", number_in(operands.said_unit()), {0, 1}};
}

Computation of_numbers(const Function& function, const Operands& operands) {
  if (operands.are_all(Sort::kNumber)) return of_one_unit(operands, function.behavior, false, "compared");
  std::size_t at = 0;
  while (sort_of(operands.type(at)) == Sort::kNumber) ++at;
  Computation out =
      refused(fmt::format("`{}` is of numbers; this is {}", function.name, with_article(operands.type(at))));
  out.refused = at;
  return out;
}

const std::vector<Function>& all_functions() {
  static const std::vector<Function> kFunctions = {
      {"min", {"a", "b"}, "Minimum", "the lesser of two numbers"},
      {"max", {"a", "b"}, "Maximum", "the greater of two numbers"},
      {"abs", {"x"}, "Absolute", "a number without its sign"},
      {"clamp", {"x", "low", "high"}, "Clamp", "a number kept within a range"},
      {"length", {"v"}, "Length", "the length of a Vector in the plane"},
      {"direction", {"v"}, "DirectionOf", "where a Vector points, counter-clockwise from straight ahead"},
      {"normalized", {"v"}, "UnitVector", "the Vector of length 1 in the same direction"},
      {"distance", {"a", "b"}, "DistanceOfPoints", "how far two Points, or two Vectors, are from each other"},
      {kPlaceFunction, {"name"}, "", "where the place of that name lies in the mission's overlay"}};
  return kFunctions;
}

// What can't be computed whatever it is: nothing where all is known.
std::optional<Computation> unknown(const Operands& operands) {
  if (!operands.are_known()) return Computation{};
  const auto at = operands.unknown_unit();
  if (!at) return std::nullopt;
  Computation out = refused(fmt::format("nothing is known of the unit `{}`", operands.type(*at).unit));
  out.is_about_units = true;
  return out;
}

// As the procedures of the library: what is no number stays none.
double lesser(double a, double b) {
  return b < a || std::isnan(b) ? b : a;
}
double greater(double a, double b) {
  return a < b || std::isnan(b) ? b : a;
}
double quotient(double a, double b) {
  return b == 0.0 ? std::numeric_limits<double>::quiet_NaN() : a / b;
}

struct Fold {
  std::string_view behavior;
  double (*of)(std::span<const double>);
};

constexpr std::array kFolds = {
    Fold{"AddNumbers", [](std::span<const double> n) { return n[0] + n[1]; }},
    Fold{"SubtractNumbers", [](std::span<const double> n) { return n[0] - n[1]; }},
    Fold{"MultiplyNumbers", [](std::span<const double> n) { return n[0] * n[1]; }},
    Fold{"DivideNumbers", [](std::span<const double> n) { return quotient(n[0], n[1]); }},
    Fold{"NegateNumber", [](std::span<const double> n) { return -n[0]; }},
    Fold{"Minimum", [](std::span<const double> n) { return lesser(n[0], n[1]); }},
    Fold{"Maximum", [](std::span<const double> n) { return greater(n[0], n[1]); }},
    Fold{"Absolute", [](std::span<const double> n) { return std::abs(n[0]); }},
    Fold{"Clamp", [](std::span<const double> n) { return lesser(greater(n[0], n[1]), n[2]); }},
    Fold{"IsLess", [](std::span<const double> n) { return n[0] < n[1] ? 1.0 : 0.0; }},
    Fold{"IsLessOrEqual", [](std::span<const double> n) { return n[0] <= n[1] ? 1.0 : 0.0; }},
    Fold{"AreEqual", [](std::span<const double> n) { return n[0] == n[1] ? 1.0 : 0.0; }},
    Fold{"AreUnequal", [](std::span<const double> n) { return n[0] != n[1] ? 1.0 : 0.0; }}};

}  // namespace

std::span<const Function> functions() {
  return all_functions();
}

const Function* function_named(std::string_view name) {
  const auto found = std::ranges::find(all_functions(), name, &Function::name);
  return found == all_functions().end() ? nullptr : &*found;
}

Computation computation(Operation operation, std::span<const PortType> types) {
  const Operands operands(types);
  if (auto out = unknown(operands)) {
    if (is_comparison(operation)) out->type = truth();
    return *out;
  }
  switch (operation) {
    case Operation::kNegate:
      return negation(operands);
    case Operation::kAdd:
    case Operation::kSubtract:
      return sum(operands, operation == Operation::kAdd);
    case Operation::kMultiply:
    case Operation::kDivide:
      return product(operands, operation == Operation::kMultiply);
    default:
      return comparison(operation, operands);
  }
}

Computation computation(const Function& function, std::span<const PortType> types) {
  if (function.name == kPlaceFunction) return {"", {&flow::type_info<geom::Point>(), "m"}, {}};
  const Operands operands(types);
  if (types.size() != function.inputs.size()) return {};
  if (auto out = unknown(operands)) return *out;
  if (function.name == "distance") return distance(operands);
  if (function.inputs.front() == "v") return length_or_direction(function, operands);
  return of_numbers(function, operands);
}

std::optional<double> folded(std::string_view behavior, std::span<const double> numbers) {
  const auto* const found = std::ranges::find(kFolds, behavior, &Fold::behavior);
  return found == kFolds.end() ? std::nullopt : std::optional(found->of(numbers));
}

bool is_said_by_signs(std::string_view behavior) {
  constexpr std::string_view kOthers[] = {"InRadians",        "AddVectors",       "NegateVector",
                                          "DivideVector",     "UnitVector",       "DirectionOf",
                                          "DistanceOfPoints", "DistanceOfVectors"};
  return std::ranges::find(kFolds, behavior, &Fold::behavior) != kFolds.end() ||
         std::ranges::find(kOthers, behavior) != std::end(kOthers);
}

std::string unit_in_words(const std::string& unit) {
  return unit.empty() ? "a plain number" : fmt::format("a value in {}", unit);
}

}  // namespace mlab::cdl
