#include "mlab/lang/cdl/lower/node_names.h"

#include <algorithm>
#include <variant>

#include "mlab/lang/cdl/syntax/signs.h"

namespace mlab::cdl {

const NodeNames::Paths& NodeNames::of(const Expression& expression, std::size_t time) const {
  static const Paths kNone;
  const auto first = paths_.find(&expression);
  if (first == paths_.end()) return kNone;
  const auto again = time == 0 ? again_.end() : again_.find(&expression);
  if (again == again_.end()) return first->second;
  return again->second[std::min(time, again->second.size()) - 1];
}

const NamesBelow& NodeNames::below(const Expression& call) const {
  static const NamesBelow kNone;
  const auto at = below_.find(&call);
  return at == below_.end() ? kNone : at->second;
}

bool NodeNames::stay_with(const NamesBelow& taken) const {
  if (taken.empty()) return true;
  return !hands_on_ &&
         std::ranges::none_of(taken, [&](const std::string& name) { return top_.contains(name); });
}

std::string joined_path(std::string_view path, std::string_view below) {
  std::string out;
  out.reserve(path.size() + below.size() + 1);
  out += path;
  if (!path.empty() && !below.empty()) out += '.';
  out += below;
  return out;
}

std::string default_name(const Expression& expression) {
  const auto& what = expression.what;
  if (const auto* call = std::get_if<Call>(&what)) return call->callee.text;
  if (std::holds_alternative<Cooperate>(what)) return "cooperate";
  if (std::holds_alternative<Compete>(what)) return "compete";
  if (const auto* coordinate = std::get_if<Coordinate>(&what)) return coordinate->by.callee.text;
  if (const auto* fuse = std::get_if<Fuse>(&what)) return fuse->by.callee.text;
  if (std::holds_alternative<Sequence>(what)) return "sequence";
  if (std::holds_alternative<Select>(what)) return "select";
  if (std::holds_alternative<Delay>(what)) return "delay";
  if (const auto* arithmetic = std::get_if<Arithmetic>(&what))
    return arithmetic->operations.empty() ? "" : std::string(sign(arithmetic->operations.back()).name);
  const auto* logic = std::get_if<Logic>(&what);
  if (logic == nullptr) return "";
  return logic->connective == Connective::kNot ? "Not" : logic->connective == Connective::kAnd ? "And" : "Or";
}

const Expression& condition_of(const Expression& trigger) {
  const auto* logic = std::get_if<Logic>(&trigger.what);
  const bool is_negated =
      logic != nullptr && logic->connective == Connective::kNot && trigger.as.text.empty() && !trigger.active;
  return is_negated ? *logic->operands.front() : trigger;
}

std::string case_name(const Case& one) {
  std::string out = one.values.empty() ? "otherwise" : "case_" + one.values.front().text;
  std::ranges::replace(out, '-', '_');
  return out;
}

}  // namespace mlab::cdl
