#include "mlab/tables/type_tables.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "mlab/flow/value_types.h"

namespace mlab::tables {
namespace {

using flow::kQuantities;
using flow::kValueTypes;
using flow::QuantityInfo;
using flow::TypeKind;
using flow::ValueTypeInfo;

std::vector<ValueTypeInfo> by_number() {
  std::vector<ValueTypeInfo> out(kValueTypes.begin(), kValueTypes.end());
  std::ranges::sort(out, {}, &ValueTypeInfo::type);
  return out;
}

// Longer ones first, so that a regular expression doesn't stop at `Object` of `Objects`.
std::string longest_first(std::vector<std::string_view> words) {
  std::ranges::stable_sort(words, std::greater(), &std::string_view::size);
  return fmt::format("{}", fmt::join(words, "|"));
}

std::string row(std::string_view name, const ValueTypeInfo& type, bool is_quantity) {
  std::string out = fmt::format(R"(  {{ name: "{}", flow: "{}")", name, type.look);
  if (is_quantity) out += ", isQuantity: true";
  if (type.kind == TypeKind::kInteger) out += ", isWhole: true";
  if (is_quantity || type.is_for_parameters) out += ", isForParameters: true";
  if (!is_quantity && type.is_sensed) out += ", isSensed: true";
  if (!type.format.empty()) out += fmt::format(", format: \"{}\"", type.format);
  return out + " },\n";
}

}  // namespace

std::string value_type_rows() {
  std::string out;
  for (const QuantityInfo& one : kQuantities) out += row(one.name, flow::info(one.type), true);
  for (const ValueTypeInfo& one : kValueTypes) out += row(one.name, one, false);
  return out;
}

std::string value_type_documentation() {
  std::string out = "| type | historic name | what it is |\n|---|---|---|\n";
  for (const ValueTypeInfo& one : by_number()) {
    const std::string historic = one.historic.empty() ? "" : fmt::format("`{}`", one.historic);
    out += fmt::format("| `{}` | {} | {} |\n", one.name, historic, one.help);
  }
  return out;
}

std::string quantity_documentation() {
  std::string out = "| name | type | |\n|---|---|---|\n";
  for (const QuantityInfo& one : kQuantities) {
    const std::string unit = one.unit.empty() ? "" : fmt::format(" in {}", one.unit);
    out += fmt::format("| `{}` | `{}`{} | {} |\n", one.name, flow::info(one.type).name, unit, one.help);
  }
  return out;
}

std::string value_type_words() {
  std::vector<std::string_view> words;
  for (const ValueTypeInfo& one : kValueTypes) words.push_back(one.name);
  return longest_first(words);
}

std::string historic_type_words() {
  std::vector<std::string_view> words;
  for (const ValueTypeInfo& one : kValueTypes) {
    if (!one.historic.empty()) words.push_back(one.historic);
  }
  return longest_first(words);
}

std::string quantity_words() {
  std::vector<std::string_view> words;
  for (const QuantityInfo& one : kQuantities) words.push_back(one.name);
  return longest_first(words);
}

std::string value_type_dictionary() {
  std::string out;
  for (const ValueTypeInfo& one : by_number()) out += fmt::format("\"{}\"\n", one.name);
  for (const QuantityInfo& one : kQuantities) out += fmt::format("\"{}\"\n", one.name);
  return out;
}

}  // namespace mlab::tables
