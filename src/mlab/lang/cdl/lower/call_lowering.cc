#include "mlab/lang/cdl/lower/call_lowering.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "mlab/flow/value_types.h"
#include "mlab/lang/cdl/types/arithmetic.h"

namespace mlab::cdl {
namespace {

constexpr std::size_t kMaxNodes = 200'000;  // recursion makes much out of little

}  // namespace

Value CallLowering::call(const Call& call, Scope& scope, const Spot& spot, const text::Place& place) {
  const std::string& name = call.callee.text;
  if (const auto binding = parts_.configuration.bindings.find(name);
      binding != parts_.configuration.bindings.end())
    return this->binding(call, *binding->second, scope, spot, place);
  return instantiate(call.callee, given_by(call, scope), spot, place);
}

Value CallLowering::instantiate(const Word& callee, const std::vector<GivenArgument>& given, const Spot& spot,
                                const text::Place& place) {
  if (parts_.network.nodes.size() > kMaxNodes) {
    parts_.findings.error("too-many-nodes", place,
                          fmt::format("the robot has more than {} nodes", kMaxNodes));
    return {};
  }
  if (const Assemblage* assemblage = parts_.configuration.assemblage_named(callee))
    return instantiate_assemblage(callee, *assemblage, given, spot, place);
  const flow::Library::Entry entry = parts_.library.find(callee.text);
  if (entry.behavior != nullptr) return procedure(callee, entry, given, spot.path, place);
  return unknown_callee(callee);
}

Value CallLowering::unknown_callee(const Word& callee) {
  text::Diagnostic& d = parts_.findings.error(
      "unknown-call", callee.place, fmt::format("unknown assemblage or procedure `{}`", callee.text));
  std::vector<std::string> names = names_in(parts_.configuration.assemblages);
  for (const std::string& name : names_in(parts_.configuration.bindings)) names.push_back(name);
  for (const Function& function : functions()) names.emplace_back(function.name);
  for (const flow::Behavior* behavior : parts_.library.behaviors()) names.emplace_back(behavior->name);
  Findings::hint_nearest(d, callee.text, names);
  return {};
}

Value CallLowering::value_of(const GivenArgument& given) {
  return given.value ? *given.value : parts_.values.value_of(*given.expression, *given.scope);
}

void CallLowering::link_argument(const InputView& view, const GivenArgument& given, flow::Node& node) {
  const Value value = value_of(given);
  const text::Place link_place = given.name.text.empty() ? given.place : given.name.place;
  const auto link = [&](const Value& one, const text::Place& place) {
    if (auto source = parts_.binder.bind(one, view.type, view.input, view.name, place))
      node.links.push_back({view.name, std::move(*source), link_place});
  };
  if (!view.input->is_list || value.kind != Value::Kind::kList) {
    link(value, given.place);
    return;
  }
  // `[1, 2]` is one vector for a list of vectors, `[[1, 2]]` another way to say so.
  for (const Value& item : value.items) link(item, item.place);
}

Value CallLowering::procedure(const Word& callee, const flow::Library::Entry& entry,
                              const std::vector<GivenArgument>& given, const std::string& path,
                              const text::Place& place) {
  const std::vector<InputView> views = inputs_of(entry);
  std::vector<std::string> names;
  for (const InputView& view : views) names.push_back(view.name);
  const std::vector<int> matched = parts_.arguments.match(callee, given, names);
  const bool is_right = std::ranges::find(matched, -1) == matched.end();

  const std::size_t errors_before = parts_.findings.error_count();
  flow::Node node;
  node.name = path;
  node.behavior = callee.text;
  node.place = place;
  node.behavior_place = callee.place;
  std::vector<bool> is_given(views.size(), false);
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (matched[i] < 0) continue;
    const auto at = static_cast<std::size_t>(matched[i]);
    is_given[at] = true;
    link_argument(views[at], given[i], node);
  }
  for (std::size_t i = 0; is_right && i < views.size(); ++i) {
    const flow::Input& input = *views[i].input;
    if (!is_given[i] && !input.is_list && input.default_text.empty())
      parts_.arguments.say_missing(callee, views[i].name, views[i].type, std::string(input.help));
  }
  if (entry.behavior->output == nullptr) {
    Value sink;
    sink.kind = Value::Kind::kSink;
    sink.text = callee.text;
    sink.place = place;
    parts_.network.nodes.push_back(std::move(node));
    return sink;
  }
  // After an error the node is there all the same: who takes its value is not wrong for that.
  Value out = wire(node.name, parts_.elaboration.types().of_call(entry), place);
  if (parts_.findings.error_count() == errors_before) parts_.network.nodes.push_back(std::move(node));
  return out;
}

bool CallLowering::enter(const Assemblage& assemblage, const Word& callee) {
  const auto first = std::ranges::find(open_, &assemblage);
  if (first == open_.end()) {
    open_.push_back(&assemblage);
    return true;
  }
  std::string path;
  for (auto it = first; it != open_.end(); ++it) path += (*it)->name.text + " -> ";
  parts_.findings
      .error("recursive-assemblage", callee.place,
             fmt::format("assemblages contain each other: {}{}", path, assemblage.name.text))
      .hints = {"a `sequence` comes back to a state by a transition"};
  return false;
}

Value CallLowering::instantiate_assemblage(const Word& callee, const Assemblage& assemblage,
                                           const std::vector<GivenArgument>& given, const Spot& spot,
                                           const text::Place& place) {
  std::vector<std::string> names;
  for (const Parameter& parameter : assemblage.parameters) names.push_back(parameter.name.text);
  const std::vector<int> matched = parts_.arguments.match(callee, given, names, &assemblage);
  const bool is_right = std::ranges::find(matched, -1) == matched.end();
  Scope& scope = parts_.scopes.add();
  scope.path = spot.path;
  std::vector<bool> is_given(names.size(), false);
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (matched[i] < 0) continue;
    const auto at = static_cast<std::size_t>(matched[i]);
    is_given[at] = true;
    const Parameter& parameter = assemblage.parameters[at];
    const Value value = value_of(given[i]);
    scope.names[parameter.name.text].value =
        parts_.binder.pass(value, parameter, parts_.binder.type_of(parameter), given[i].place);
  }
  const auto known = purpose_ == Purpose::kCheck ? parts_.results.find(&assemblage) : parts_.results.end();
  const bool is_known = known != parts_.results.end();
  scope.nodes = is_known ? &kUnnamed : &parts_.elaboration.names(assemblage, is_given, *spot.taken);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Parameter& parameter = assemblage.parameters[i];
    if (is_given[i]) continue;
    if (!parameter.initial && is_right)
      parts_.arguments.say_missing(callee, names[i], parts_.binder.type_of(parameter), parameter.help);
    const Findings::Inside inside(parts_.findings, assemblage);
    scope.names[names[i]].value = default_of(parameter, scope);
  }
  if (!enter(assemblage, callee)) return {};
  Value out = is_known ? wire(spot.path, {known->second.first, known->second.second}, place)
                       : this->assemblage(assemblage, scope, place);
  open_.pop_back();
  return out;
}

// The value of a parameter that nobody gives; nothing where it has no default.
Value CallLowering::default_of(const Parameter& parameter, Scope& scope) {
  if (!parameter.initial) return {};
  // A default may use the parameters before it.
  const Value value = parts_.values.value_of(*parameter.initial, scope);
  return parts_.binder.pass(value, parameter, parts_.binder.type_of(parameter), parameter.initial->place);
}

// The value of an assemblage whose parameters have theirs.
Value CallLowering::assemblage(const Assemblage& assemblage, Scope& scope, const text::Place& place) {
  const Findings::Inside inside(parts_.findings, assemblage);
  scope.declare(assemblage.lets);
  const PortType result =
      assemblage.result_type.text.empty() ? PortType{} : parts_.binder.type_named(assemblage.result_type);
  Value out;
  if (assemblage.body) {
    out = parts_.values.value_of(*assemblage.body, scope);
    const bool has_type = result.type != nullptr && out.kind != Value::Kind::kNone;
    if (has_type && out.kind == Value::Kind::kWire) {
      if (!parts_.binder.fits(out.type, result, assemblage.name.text, assemblage.body->place)) out = {};
      Binder::declare_unit(out, result);
    }
    if (out.kind == Value::Kind::kNone && result.type != nullptr) out = wire(scope.path, result, place);
  } else {
    out = stand_still(assemblage, scope, result, place);
  }
  if (purpose_ == Purpose::kCheck) parts_.results[&assemblage] = {out.type.type, out.type.unit};
  return out;
}

Value CallLowering::check_value(const Assemblage& assemblage, Scope& scope) {
  open_.push_back(&assemblage);
  Value out = this->assemblage(assemblage, scope, assemblage.name.place);
  for (const Let& let : assemblage.lets) parts_.values.value_of(scope.names[let.name.text], scope);
  open_.pop_back();
  return out;
}

// An assemblage that is declared and empty.
Value CallLowering::stand_still(const Assemblage& assemblage, Scope& scope, const PortType& result,
                                const text::Place& place) {
  const std::string_view type = result.type == nullptr ? "Vector" : result.type->name;
  const flow::ValueTypeInfo* const known = flow::value_type_named(type);
  if (known == nullptr || parts_.library.find(known->neutral).behavior == nullptr) {
    parts_.findings.error("empty-assemblage", assemblage.name.place,
                          fmt::format("`{}` is empty, so it gives no {}", assemblage.name.text, type));
    return {};
  }
  parts_.findings
      .warning("empty-assemblage", assemblage.name.place, fmt::format("`{}` is empty", assemblage.name.text))
      .label = known->neutral_means;
  flow::Node node;
  node.name = scope.path;
  node.behavior = known->neutral;
  node.place = node.behavior_place = place;
  if (type == "bool") node.links.push_back({"value", {flow::Source::Kind::kConstant, "false", place}, place});
  parts_.network.nodes.push_back(node);
  return wire(node.name, {parts_.library.find_type(type), ""}, place);
}

// What a configuration asks for by the name of a binding point.
Value CallLowering::binding(const Call& call, const Binding& binding, Scope& scope, const Spot& spot,
                            const text::Place& place) {
  std::vector<std::string> names;
  for (const Parameter& parameter : binding.parameters) names.push_back(parameter.name.text);
  std::vector<GivenArgument> given = given_by(call, scope);
  const std::vector<int> matched = parts_.arguments.match(call.callee, given, names);
  std::vector<GivenArgument> asked;
  std::vector<bool> is_given(names.size(), false);
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (matched[i] < 0) continue;
    const Parameter& parameter = binding.parameters[static_cast<std::size_t>(matched[i])];
    is_given[static_cast<std::size_t>(matched[i])] = true;
    const Value value = value_of(given[i]);
    asked.push_back({{parameter.name.text, given[i].place},
                     nullptr,
                     nullptr,
                     parts_.binder.pass(value, parameter, parts_.binder.type_of(parameter), given[i].place),
                     given[i].place});
  }
  const PortType type =
      binding.result_type.text.empty() ? PortType{} : parts_.binder.type_named(binding.result_type);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Parameter& parameter = binding.parameters[i];
    if (is_given[i]) continue;
    if (parameter.initial) {
      asked.push_back({{parameter.name.text, place}, nullptr, nullptr, default_of(parameter, scope), place});
    } else if (asked.size() == given.size()) {
      parts_.arguments.say_missing(call.callee, names[i], parts_.binder.type_of(parameter), parameter.help);
    }
  }
  if (binding.result_type.text.empty()) {
    parts_.findings
        .error("sink-as-value", call.callee.place,
               fmt::format("`{}` is an actuator and gives no value", call.callee.text))
        .hints = {fmt::format("a robot drives it: `{} = ...;`", call.callee.text)};
    return {};
  }
  const DeviceUse* use = purpose_ == Purpose::kCheck ? nullptr : parts_.equipment.serving(call.callee);
  if (use == nullptr) return wire(spot.path, type, place);
  Value out = serve(*use, std::move(asked), spot, place);
  if (out.kind == Value::Kind::kWire &&
      !parts_.binder.fits(out.type, type, binding.name.text, use->device->by.callee.place))
    return {};
  Binder::declare_unit(out, type);
  return out;
}

// A device's own arguments hold: they say what it is. What is asked for is added to them.
Value CallLowering::serve(const DeviceUse& use, std::vector<GivenArgument> asked, const Spot& spot,
                          const text::Place& place) {
  const Device& device = *use.device;
  Scope& scope = parts_.equipment.scope_of(use, spot);
  std::vector<GivenArgument> given = given_by(device.by, scope);
  for (GivenArgument& one : asked) {
    const bool is_said =
        std::ranges::any_of(given, [&](const GivenArgument& own) { return own.name.text == one.name.text; });
    one.name.place = device.by.callee.place;  // what the device does not take is the device's mistake
    if (!is_said) given.push_back(std::move(one));
  }
  return instantiate(device.by.callee, given, {spot.path, &scope.nodes->top()}, place);
}

void CallLowering::drive(const DeviceUse& use, const Value& value, const std::string& path,
                         const text::Place& place) {
  const Device& device = *use.device;
  Scope& scope = parts_.equipment.scope_of(use, {path, &kNothingBelow});
  std::vector<GivenArgument> given = given_by(device.by, scope);
  const auto binding = parts_.configuration.bindings.find(device.binds.text);
  std::string input;
  if (binding != parts_.configuration.bindings.end() && !binding->second->parameters.empty()) {
    const Parameter& driven = binding->second->parameters.front();
    input = driven.name.text;
    if (value.kind == Value::Kind::kWire &&
        !parts_.binder.fits(value.type, parts_.binder.type_of(driven), device.binds.text, place))
      return;
  }
  given.push_back({{input, device.by.callee.place}, nullptr, nullptr, value, place});
  if (input.empty()) std::ranges::rotate(given, given.end() - 1);  // by position, the first
  const Value out = instantiate(device.by.callee, given, {path, &scope.nodes->top()}, device.name.place);
  if (out.kind == Value::Kind::kWire) {
    parts_.findings
        .error("not-an-actuator", device.by.callee.place,
               fmt::format("`{}` gives a value and moves nothing", device.by.callee.text))
        .hints = {"an actuator is a `procedure void`, such as Drive"};
  }
}

}  // namespace mlab::cdl
