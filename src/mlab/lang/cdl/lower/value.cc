#include "mlab/lang/cdl/lower/value.h"

#include <fmt/core.h>

namespace mlab::cdl {

Value wire(const std::string& node, const PortType& type, const text::Place& place) {
  Value out;
  out.kind = Value::Kind::kWire;
  out.text = node;
  out.type = type;
  out.counted_in = type.unit;
  out.place = place;
  return out;
}

std::string quoted_number(const Value& value) {
  return value.unit.empty() ? fmt::format("{}", value.number)
                            : fmt::format("{} {}", value.number, value.unit);
}

std::string bracketed(const std::string& unit) {
  return unit.empty() ? "" : fmt::format(" [{}]", unit);
}

void Scope::declare(const std::vector<Let>& lets) {
  for (const Let& let : lets) {
    Named& named = names[let.name.text];
    named.let = &let;
    named.state = Named::State::kWaiting;
  }
}

const NodeNames::Paths& Scope::paths_of(const Expression& expression) {
  const bool is_repeated = nodes->is_repeated(expression);
  return nodes->of(expression, is_repeated ? times[&expression]++ : 0);
}

const NodeNames::Paths& Scope::last_paths_of(const Expression& expression) const {
  const auto known = times.find(&expression);
  return nodes->of(expression, known == times.end() ? 0 : known->second - 1);
}

std::string Scope::path_behind(const Expression& expression) const {
  return path_of(last_paths_of(expression).behind);
}

std::string Scope::angle_of(const Expression& expression) const {
  return path_of(last_paths_of(expression).angle);
}

std::string Scope::angle_of_operand(const Expression& expression, std::size_t operand) const {
  const std::vector<std::string>& angles = last_paths_of(expression).operand_angles;
  return operand < angles.size() ? path_of(angles[operand]) : std::string();
}

}  // namespace mlab::cdl
