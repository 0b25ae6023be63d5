#include "mlab/lang/cdl/lower/named_places.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include <fmt/core.h>

#include "mlab/flow/port_types.h"
#include "mlab/lang/cdl/types/arithmetic.h"

namespace mlab::cdl {

const std::string* NamedPlaces::name_in(const Expression& expression) const {
  const auto* call = std::get_if<Call>(&expression.what);
  const bool is_place = call != nullptr && call->callee.text == kPlaceFunction &&
                        call->arguments.size() == 1 && types_.function(call->callee) != nullptr;
  if (!is_place) return nullptr;
  const Argument& name = call->arguments.front();
  const auto* text = std::get_if<Text>(&name.value->what);
  const bool is_named = name.name.text.empty() || name.name.text == "name";
  return text == nullptr || text->value.empty() || !is_named ? nullptr : &text->value;
}

// Different names may become the same when only letters, digits and `_` are left of them.
std::string NamedPlaces::parameter_for(std::string_view place) {
  std::string stem = "place_";
  for (const char c : place) stem += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  int& count = stems_[stem];
  for (;;) {
    std::string out = ++count == 1 ? stem : fmt::format("{}_{}", stem, count);
    const bool is_taken = taken_ != nullptr && taken_->contains(out);
    if (!is_taken && names_.insert(out).second) return out;
  }
}

Value NamedPlaces::call(const Call& call, Scope& scope, const text::Place& place) {
  Expression whole;
  whole.what = call;
  const std::string* name = name_in(whole);
  if (name == nullptr) {
    const std::vector<int> matched = arguments_.match(call.callee, given_by(call, scope), {"name"});
    if (std::ranges::find(matched, -1) == matched.end())
      findings_
          .error("wrong-type", call.arguments.empty() ? place : call.arguments.front().value->place,
                 "a place is named by a text")
          .hints = {"`place(\"Gate\")` is where the mission's overlay has Gate"};
    return {};
  }
  const PortType type{&flow::type_info<geom::Point>(), "m"};
  const auto [known, is_new] = parameters_.try_emplace(*name);
  if (!is_new) return wire(known->second, type, place);
  const std::string path = known->second = parameter_for(*name);
  flow::Parameter parameter;
  parameter.name = path;
  parameter.type = std::string(type.type->name);
  parameter.unit = type.unit;
  parameter.help = fmt::format("where `{}` lies in the mission's overlay", *name);
  parameter.initial = {flow::Source::Kind::kConstant, "{0, 0}", place};
  parameter.place = place;
  parameter.place_name = {*name, place};
  network_.parameters.push_back(std::move(parameter));
  return wire(path, type, place);
}

}  // namespace mlab::cdl
