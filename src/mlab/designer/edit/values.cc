#include "mlab/designer/edit/values.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/core.h>

#include "mlab/designer/drawing/graph.h"
#include "mlab/flow/value_types.h"
#include "mlab/lang/cdl/syntax/lexer.h"
#include "mlab/lang/cdl/syntax/parser.h"
#include "mlab/lang/cdl/syntax/walk.h"
#include "mlab/lang/cdl/types/units.h"

namespace mlab::designer {

cdl::ExpressionPtr named(const std::string& name) {
  auto out = std::make_shared<cdl::Expression>();
  out->what = cdl::Name{{name, {}}};
  return out;
}

cdl::ExpressionPtr called(const std::string& component) {
  auto out = std::make_shared<cdl::Expression>();
  out->what.emplace<cdl::Call>().callee.text = component;
  return out;
}

cdl::ExpressionPtr value_of(const std::string& words) {
  return cdl::parse_value(std::make_shared<const text::Source>("", words));
}

cdl::ExpressionPtr typed_value(const std::string& text) {
  return text.find(';') == std::string::npos ? value_of(text) : nullptr;
}

cdl::ExpressionPtr no_trigger() {
  return value_of("Constant(value = false)");
}

cdl::ExpressionPtr bare(const cdl::Expression& expression) {
  auto out = std::make_shared<cdl::Expression>(expression);
  out->whole = out->as.text.empty() ? out->place.span : text::Span{};
  out->as = {};
  return out;
}

cdl::ExpressionPtr bare_as(const cdl::Expression& expression, const std::string& name) {
  auto out = std::make_shared<cdl::Expression>(expression);
  out->whole = out->place.span;
  const std::string base = default_name(expression);
  if (base.empty() || !expression.as.text.empty() || is_own_name(name, base)) return out;
  out->as.text = name;
  out->whole = {};
  return out;
}

bool is_own_name(std::string_view name, std::string_view base) {
  if (!name.starts_with(base)) return false;
  name.remove_prefix(base.size());
  if (name.empty()) return true;
  if (!name.starts_with('_') || name.size() < 2) return false;
  return std::ranges::all_of(name.substr(1), [](char c) { return c >= '0' && c <= '9'; });
}

bool is_logic(const cdl::Expression& expression) {
  return std::holds_alternative<cdl::Logic>(expression.what);
}

bool is_block(const cdl::Expression& expression) {
  const auto& what = expression.what;
  return members_of(expression) != nullptr || std::holds_alternative<cdl::Sequence>(what) ||
         std::holds_alternative<cdl::Select>(what);
}

bool has_node(const cdl::Expression& expression) {
  bool out = false;
  cdl::for_each_expression(expression, [&](const cdl::Expression& one) {
    out |= std::holds_alternative<cdl::Call>(one.what) || std::holds_alternative<cdl::Delay>(one.what) ||
           is_block(one);
  });
  return out;
}

const cdl::Call* call_of(const cdl::Expression& expression) {
  if (const auto* call = std::get_if<cdl::Call>(&expression.what)) return call;
  if (const auto* by = std::get_if<cdl::Coordinate>(&expression.what)) return &by->by;
  if (const auto* by = std::get_if<cdl::Fuse>(&expression.what)) return &by->by;
  return nullptr;
}

const std::vector<cdl::Member>* members_of(const cdl::Expression& expression) {
  return std::visit(
      [](const auto& what) -> const std::vector<cdl::Member>* {
        if constexpr (requires { what.members; }) return &what.members;
        return nullptr;
      },
      expression.what);
}

std::vector<cdl::Item> items_of(const std::string& words) {
  text::Diagnostics sink;
  return cdl::parse(std::make_shared<const text::Source>("", words), sink).items;
}

std::string type_words(const cdl::PortType& type) {
  const std::string name = type.name();
  if (name == "double" && type.unit == "deg") return "angle [deg]";
  for (const flow::QuantityInfo& quantity : flow::kQuantities) {
    // That a number is a share, nobody can see.
    if (quantity.name != "gain" && flow::info(quantity.type).name == name && quantity.unit == type.unit)
      return std::string(quantity.name);
  }
  return type.unit.empty() ? name : fmt::format("{} [{}]", name, type.unit);
}

void set_type(cdl::Parameter& parameter, const cdl::PortType& type) {
  const std::string words = type_words(type);
  const std::size_t unit = words.find(" [");
  parameter.type = {words.substr(0, unit), {}};
  parameter.unit = {};
  if (unit != std::string::npos) parameter.unit.text = words.substr(unit + 2, words.size() - unit - 3);
}

cdl::ExpressionPtr neutral_for(const cdl::PortType& type) {
  const auto is = [&](flow::TypeKind kind) { return type.type != nullptr && type.type->kind == kind; };
  if (is(flow::TypeKind::kBool)) return named("false");
  if (is(flow::TypeKind::kVector)) return called(std::string(flow::info(flow::ValueType::kVector).neutral));
  return value_of(is(flow::TypeKind::kPoint) ? "[0, 0]" : "0");
}

namespace {

// 0 in a unit that only products have: no number is written in it.
std::string zero_in(std::string_view unit) {
  std::string out = "0";
  for (const char* sign = " * "; !unit.empty();) {
    const std::size_t end = std::min(unit.find_first_of("*/"), unit.size());
    const std::string_view word = unit.substr(0, end);
    if (word != "1") out += fmt::format("{}1 {}", sign, word);
    if (end == unit.size()) break;
    sign = unit[end] == '/' ? " / " : " * ";
    unit.remove_prefix(end + 1);
  }
  return out;
}

}  // namespace

cdl::ExpressionPtr zero_for(const cdl::PortType& type) {
  const bool is_number = type.type != nullptr && type.type->kind == flow::TypeKind::kReal;
  const bool is_vector = type.type != nullptr && type.type->kind == flow::TypeKind::kVector;
  if (is_vector) return value_of("[0, 0]");
  const auto unit = is_number && !type.unit.empty() ? cdl::unit_named(type.unit) : std::nullopt;
  const bool is_written = unit && std::ranges::find(cdl::unit_names(), type.unit) != cdl::unit_names().end();
  const auto value = is_written ? value_of("0 " + type.unit) : unit ? value_of(zero_in(type.unit)) : nullptr;
  return value ? value : neutral_for(type);
}

bool is_cdl_name(std::string_view text) {
  return cdl::is_name(text);
}

std::string unique(const std::string& wanted, const std::set<std::string>& taken) {
  std::string out = wanted;
  for (int number = 2; taken.contains(out); ++number) out = fmt::format("{}_{}", wanted, number);
  return out;
}

const Arrange::At* place_of(const Places& places, std::string_view node) {
  const auto found = std::ranges::find_if(places, [&](const Arrange::At& at) { return at.node() == node; });
  return found == places.end() ? nullptr : &*found;
}

std::string below(std::string_view path, std::string_view whole) {
  const bool is_below =
      !whole.empty() && path.size() > whole.size() && path.starts_with(whole) && path[whole.size()] == '.';
  return std::string(is_below ? path.substr(whole.size() + 1) : path);
}

}  // namespace mlab::designer
