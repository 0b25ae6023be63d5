#include "mlab/lang/cdl/lower/lowering.h"

#include <utility>

#include <fmt/core.h>

namespace mlab::cdl {

// What is unknown in several places is one slip, and so is what is wrong with one name.
std::string Lowering::key_of(const std::string& kind, const text::Place& place, const std::string& message,
                             const std::string& about) const {
  const void* const inside = inside_;
  if (kind == "unknown-call" || kind == "unknown-type") return fmt::format("{} {}", kind, message);
  if (kind == "unknown-name" || !about.empty())
    return fmt::format("{} {} {} {} {}", kind, inside,
                       inside == nullptr ? static_cast<const void*>(place.source.get()) : nullptr, message,
                       about);
  return fmt::format("{} {} {} {}", kind, static_cast<const void*>(place.source.get()), place.span.begin,
                     message);
}

text::Diagnostic& Lowering::report(text::Severity severity, std::string kind, const text::Place& place,
                                   std::string message, const std::string& about) {
  if (!said_.keys.insert(key_of(kind, place, message, about)).second) return muted_ = {};
  return severity == text::Severity::kError ? sink_.error(std::move(kind), place, std::move(message))
                                            : sink_.warning(std::move(kind), place, std::move(message));
}

text::Diagnostic& Lowering::error(std::string kind, const text::Place& place, std::string message) {
  return report(text::Severity::kError, std::move(kind), place, std::move(message));
}

text::Diagnostic& Lowering::warning(std::string kind, const text::Place& place, std::string message) {
  return report(text::Severity::kWarning, std::move(kind), place, std::move(message));
}

void Lowering::hint_nearest(text::Diagnostic& d, std::string_view name,
                            const std::vector<std::string>& candidates) const {
  const std::string nearest = text::nearest_name(name, candidates);
  if (!nearest.empty()) d.hints.push_back(fmt::format("did you mean `{}`?", nearest));
}

const NodeNames::Paths& Lowering::paths_of(const Expression& expression, Scope& scope) const {
  const bool is_repeated = scope.nodes->is_repeated(expression);
  return scope.nodes->of(expression, is_repeated ? scope.times[&expression]++ : 0);
}

const NodeNames::Paths& Lowering::last_paths_of(const Expression& expression, const Scope& scope) const {
  const auto times = scope.times.find(&expression);
  return scope.nodes->of(expression, times == scope.times.end() ? 0 : times->second - 1);
}

std::string Lowering::path_behind(const Expression& expression, const Scope& scope) const {
  return joined_path(scope.path, last_paths_of(expression, scope).behind);
}

std::string Lowering::angle_of(const Expression& expression, const Scope& scope) const {
  return joined_path(scope.path, last_paths_of(expression, scope).angle);
}

std::string Lowering::angle_of_operand(const Expression& expression, std::size_t operand,
                                       const Scope& scope) const {
  const std::vector<std::string>& angles = last_paths_of(expression, scope).operand_angles;
  return operand < angles.size() ? joined_path(scope.path, angles[operand]) : std::string();
}

Value Lowering::wire(const std::string& node, const PortType& type, const text::Place& place) const {
  Value out;
  out.kind = Value::Kind::kWire;
  out.text = node;
  out.type = type;
  out.counted_in = type.unit;
  out.place = place;
  return out;
}

Scope& Lowering::new_scope() {
  return scopes_.emplace_back();
}

}  // namespace mlab::cdl
