#include "mlab/lang/cdl/lower/binder.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include <fmt/core.h>

#include "mlab/flow/frame.h"
#include "mlab/flow/type_words.h"
#include "mlab/lang/cdl/types/types.h"
#include "mlab/lang/cdl/types/units.h"

namespace mlab::cdl {
namespace {

using flow::TypeKind;

std::string described(const PortType& type) {
  return flow::value_of(*type.type, type.unit);
}

// Of a value that is written down; vectors and points are no single words here.
std::string expected(const PortType& type) {
  const TypeKind kind = type.type->kind;
  const bool is_list = kind == TypeKind::kVector || kind == TypeKind::kPoint;
  return is_list || kind == TypeKind::kReal ? described(type)
                                            : flow::expected_of(*type.type) + bracketed(type.unit);
}

bool parses(const flow::TypeInfo& type, const std::string& text) {
  alignas(flow::Frame::kAlignment) std::byte scratch[512];
  return type.parse != nullptr && type.size <= sizeof scratch && type.parse(text, scratch);
}

bool is_number(TypeKind kind) {
  return kind == TypeKind::kReal || kind == TypeKind::kInteger;
}

flow::Source constant(std::string text, const text::Place& place) {
  return {flow::Source::Kind::kConstant, std::move(text), place};
}

}  // namespace

PortType Binder::type_named(const Word& name) {
  PortType known = types_.named(name.text);
  if (known.type != nullptr) return known;
  text::Diagnostic& d =
      findings_.error("unknown-type", name.place, fmt::format("unknown type `{}`", name.text));
  Findings::hint_nearest(d, name.text, type_names());
  return {};
}

PortType Binder::type_of(const Parameter& parameter) {
  PortType out = type_named(parameter.type);
  if (out.type == nullptr || parameter.unit.text.empty()) return out;
  const std::optional<Unit> unit = unit_named(parameter.unit.text);
  if (!unit) {
    text::Diagnostic& d = findings_.error("unknown-unit", parameter.unit.place,
                                          fmt::format("unknown unit `{}`", parameter.unit.text));
    Findings::hint_nearest(d, parameter.unit.text, unit_names());
    return {};
  }
  const std::optional<Unit> quantity = unit_named(out.unit);
  if (!out.unit.empty() && !unit->same_dimension(*quantity)) {
    findings_.error(
        "wrong-unit", parameter.unit.place,
        fmt::format("`{}` is no unit of the type `{}`", parameter.unit.text, parameter.type.text));
    return {};
  }
  // Values flow in SI units; only angles may be thought of in degrees.
  const bool is_si = unit->numerator == unit->denominator;
  if (!is_si && parameter.unit.text != "deg") {
    findings_
        .error("wrong-unit", parameter.unit.place,
               fmt::format("a parameter is in SI units or in `deg`, not in `{}`", parameter.unit.text))
        .hints = {"its values may be given in any unit: `50 cm`"};
    return {};
  }
  out.unit = parameter.unit.text;
  return out;
}

bool Binder::fits(const PortType& have, const PortType& want, const std::string& name,
                  const text::Place& place, const Value* about) {
  if (have.type == nullptr || want.type == nullptr) return true;  // what is unknown was told of before
  const Misfit misfit = cdl::misfit(have, want);
  if (misfit == Misfit::kType) {
    text::Diagnostic& d =
        findings_.error_about(about == nullptr ? "" : about->named, "wrong-type", place,
                              fmt::format("{} stands where {} is expected", flow::value_of(*have.type),
                                          flow::value_of(*want.type)));
    d.label = fmt::format("`{}` takes {}", name, described(want));
    const bool is_elsewhere = about != nullptr && !about->named.empty() && about->declared.source;
    if (is_elsewhere) d.notes.push_back({fmt::format("`{}` comes from here", about->named), about->declared});
    return false;
  }
  if (misfit == Misfit::kNone) return true;
  findings_
      .error("wrong-unit", place,
             fmt::format("{} stands where {} is expected", described(have), described(want)))
      .label = fmt::format("`{}` takes {}", name, described(want));
  return false;
}

void Binder::declare_unit(Value& value, const PortType& declared) {
  if (value.kind != Value::Kind::kWire || value.type.type == nullptr || declared.unit.empty()) return;
  // Vectors of whatever unit fit each other: one that has its own keeps it.
  const bool is_own = !is_number(value.type.type->kind) && !value.type.unit.empty();
  if (!is_own) value.type.unit = declared.unit;
}

bool Binder::is_convertible(const Value& value, const PortType& want, const std::string& name,
                            const text::Place& place) {
  const std::string& have = value.type.unit;
  const bool is_angle = have == "deg" || have == "rad";
  if (!value.counted_in.empty() || !is_angle || want.unit.empty() || want.unit == have) return true;
  text::Diagnostic& d = findings_.error(
      "wrong-unit", place, fmt::format("a plain number that is declared in {} can't be converted", have));
  d.label = fmt::format("`{}` takes {}", name, described(want));
  d.hints = {fmt::format("give it its unit where it comes from: `* 1 {}`", have)};
  return false;
}

std::optional<flow::Source> Binder::bind(const Value& value, const PortType& type, const flow::Input* input,
                                         const std::string& name, const text::Place& place) {
  switch (value.kind) {
    case Value::Kind::kNone:
      return std::nullopt;
    case Value::Kind::kSink:
      findings_.error("sink-as-value", place, fmt::format("`{}` gives no value", value.text)).label =
          fmt::format("`{}` takes {}", name, type.type == nullptr ? "a value" : described(type));
      return std::nullopt;
    case Value::Kind::kWire:
      if (!fits(value.type, type, name, place, &value)) return std::nullopt;
      if (!is_convertible(value, type, name, place)) return std::nullopt;
      return flow::Source{flow::Source::Kind::kName, value.text, place};
    default:
      break;
  }
  if (type.type == nullptr) return std::nullopt;
  // What came through a parameter has its type, whatever the words are.
  if (value.type.type != nullptr && !fits(value.type, type, name, place, &value)) return std::nullopt;
  if (value.kind == Value::Kind::kNumber) return bind_number(value, type, input, name, place);
  if (value.kind == Value::Kind::kList) return bind_coordinates(value, type, name, place);
  return bind_word(value, type, name, place);
}

std::optional<flow::Source> Binder::bind_number(const Value& value, const PortType& type,
                                                const flow::Input* input, const std::string& name,
                                                const text::Place& place) {
  const TypeKind kind = type.type->kind;
  if (!is_number(kind)) {
    const std::string text = fmt::format("{}", value.number);
    const bool takes_numbers = kind == TypeKind::kMask || kind == TypeKind::kChoice;
    if (takes_numbers && value.unit.empty() && parses(*type.type, text)) return constant(text, value.place);
    findings_
        .error("wrong-type", place,
               fmt::format("`{}` is no {}", quoted_number(value), flow::noun_of(*type.type)))
        .label = fmt::format("`{}` takes {}", name, expected(type));
    return std::nullopt;
  }
  double number = value.number;
  if (!value.unit.empty()) {
    const std::optional<Unit> from = unit_named(value.unit);
    const std::optional<Unit> to = unit_named(type.unit);
    const std::optional<double> in_unit = from && to ? converted(number, *from, *to) : std::nullopt;
    if (!in_unit && !(value.type.type != nullptr && type.unit.empty())) {
      findings_
          .error("wrong-unit", place,
                 type.unit.empty()
                     ? fmt::format("`{}` stands where a plain number is expected", quoted_number(value))
                     : fmt::format("`{}` stands where {} is expected", quoted_number(value), described(type)))
          .label = fmt::format("`{}` takes {}", name, described(type));
      return std::nullopt;
    }
    number = in_unit.value_or(number);
  }
  if (kind == TypeKind::kInteger &&
      (number != std::floor(number) || std::abs(number) > std::numeric_limits<int>::max())) {
    findings_.error("wrong-type", place, fmt::format("`{}` is no whole number", quoted_number(value))).label =
        fmt::format("`{}` takes {}", name, expected(type));
    return std::nullopt;
  }
  if (input != nullptr && (number < input->min || number > input->max)) {
    findings_.error("out-of-range", value.place, fmt::format("{} is out of range", quoted_number(value)))
        .label = fmt::format("`{}` takes {} .. {}{}", name, input->min, input->max, bracketed(type.unit));
    return std::nullopt;
  }
  return constant(fmt::format("{}", number), value.place);
}

std::optional<flow::Source> Binder::bind_word(const Value& value, const PortType& type,
                                              const std::string& name, const text::Place& place) {
  const TypeKind kind = type.type->kind;
  const bool is_word = value.kind == Value::Kind::kWord;
  if (!(is_word ? kind == TypeKind::kText : is_number(kind)) && parses(*type.type, value.text))
    return constant(value.text, value.place);
  const std::string label = fmt::format("`{}` takes {}", name, expected(type));
  if (!is_word) {
    findings_
        .error("wrong-type", place, fmt::format("\"{}\" is no {}", value.text, flow::noun_of(*type.type)))
        .label = label;
    return std::nullopt;
  }
  text::Diagnostic& d =
      findings_.error("unknown-name", value.place, fmt::format("unknown name `{}`", value.text));
  d.label = label;
  std::vector<std::string> names;
  if (value.scope != nullptr) {
    for (const auto& [known, what] : value.scope->names) names.push_back(known);
  }
  if (configuration_.assemblages.contains(value.text) || configuration_.bindings.contains(value.text) ||
      library_.find(value.text).behavior != nullptr) {
    d.hints.push_back(fmt::format("`{}()` makes one", value.text));
  } else {
    Findings::hint_nearest(d, value.text, names);
  }
  return std::nullopt;
}

// `[1 m, 2 m]` for a vector or a point.
std::optional<flow::Source> Binder::bind_coordinates(const Value& value, const PortType& type,
                                                     const std::string& name, const text::Place& place) {
  const TypeKind kind = type.type->kind;
  if (kind == TypeKind::kVector || kind == TypeKind::kPoint) {
    std::string text;
    bool is_right = value.items.size() == 2 || (value.items.size() == 3 && kind == TypeKind::kVector);
    for (const Value& item : value.items) {
      if (item.kind == Value::Kind::kNone) return std::nullopt;
      const std::optional<Unit> unit = unit_named(item.unit);
      const std::optional<double> metres =
          unit ? converted(item.number, *unit, unit->length != 0 ? Unit{1} : Unit{}) : std::nullopt;
      is_right = is_right && item.kind == Value::Kind::kNumber && metres;
      text += fmt::format("{}{}", text.empty() ? "{" : ", ", metres.value_or(0.0));
    }
    if (is_right) return constant(text + "}", value.place);
  }
  findings_
      .error("wrong-type", place,
             fmt::format("a list stands where {} is expected", is_number(kind) || kind == TypeKind::kBool
                                                                   ? flow::expected_of(*type.type)
                                                                   : flow::value_of(*type.type)))
      .label = fmt::format("`{}` takes {}", name, expected(type));
  return std::nullopt;
}

bool Binder::check_range(const Value& value, const Parameter& parameter, const PortType& type) {
  if (value.kind != Value::Kind::kNumber || !parameter.low || !parameter.high || type.type == nullptr)
    return true;
  const std::optional<Unit> to = unit_named(type.unit);
  const auto in_unit = [&](double number, const std::string& unit) {
    const std::optional<Unit> from = unit.empty() ? to : unit_named(unit);
    const std::optional<double> out = from ? converted(number, *from, *to) : std::nullopt;
    return out.value_or(number);
  };
  const double low = in_unit(parameter.low->value, parameter.low->unit.text);
  const double high = in_unit(parameter.high->value, parameter.high->unit.text);
  const double number = in_unit(value.number, value.unit);
  if (number >= low && number <= high) return true;
  findings_.error("out-of-range", value.place, fmt::format("{} is out of range", quoted_number(value)))
      .label = fmt::format("`{}` takes {} .. {}{}", parameter.name.text, low, high, bracketed(type.unit));
  return false;
}

Value Binder::pass(const Value& value, const Parameter& parameter, const PortType& type,
                   const text::Place& place) {
  if (value.kind == Value::Kind::kNone || type.type == nullptr) return {};
  // Members of a list are checked by the input that takes the list.
  const bool is_list = value.kind == Value::Kind::kList && type.type->kind != TypeKind::kVector &&
                       type.type->kind != TypeKind::kPoint;
  if (is_list) {
    Value out = value;
    for (Value& item : out.items) item = pass(item, parameter, type, item.place);
    return out;
  }
  const std::optional<flow::Source> bound = bind(value, type, nullptr, parameter.name.text, place);
  if (!bound || !check_range(value, parameter, type)) return {};
  Value out = value;
  if (value.kind == Value::Kind::kNumber) {
    double number = value.number;
    if (!value.unit.empty())
      number = converted(number, *unit_named(value.unit), *unit_named(type.unit)).value_or(number);
    out.number = number;
    out.unit = type.unit;
  }
  if (value.kind == Value::Kind::kWire) {
    declare_unit(out, type);
    return out;
  }
  out.type = type;
  return out;
}

}  // namespace mlab::cdl
