// Calls: of procedures, of assemblages, of binding points.

#include <algorithm>
#include <utility>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "mlab/lang/cdl/lower/lowering.h"

namespace mlab::cdl {
namespace {

constexpr std::size_t kMaxNodes = 200'000;  // recursion makes much out of little

}  // namespace

std::vector<Lowering::Given> Lowering::given_by(const Call& call, Scope& scope) const {
  std::vector<Given> out;
  for (const Argument& argument : call.arguments)
    out.push_back({argument.name, argument.value, &scope, {}, argument.value->place});
  return out;
}

Value Lowering::lower_call(const Call& call, Scope& scope, const Spot& spot, const text::Place& place) {
  const std::string& name = call.callee.text;
  if (const auto binding = configuration_.bindings.find(name); binding != configuration_.bindings.end())
    return call_binding(call, *binding->second, scope, spot, place);
  return instantiate(call.callee, given_by(call, scope), spot, place);
}

Value Lowering::instantiate(const Word& callee, const std::vector<Given>& given, const Spot& spot,
                            const text::Place& place) {
  if (network_.nodes.size() > kMaxNodes) {
    error("too-many-nodes", place, fmt::format("the robot has more than {} nodes", kMaxNodes));
    return {};
  }
  if (const Assemblage* assemblage = configuration_.assemblage_named(callee))
    return instantiate_assemblage(callee, *assemblage, given, spot, place);
  const flow::Library::Entry entry = library_.find(callee.text);
  if (entry.behavior != nullptr) return instantiate_procedure(callee, entry, given, spot.path, place);
  return unknown_callee(callee);
}

Value Lowering::unknown_callee(const Word& callee) {
  text::Diagnostic& d =
      error("unknown-call", callee.place, fmt::format("unknown assemblage or procedure `{}`", callee.text));
  std::vector<std::string> names = names_in(configuration_.assemblages);
  for (const std::string& name : names_in(configuration_.bindings)) names.push_back(name);
  for (const Function& function : functions()) names.emplace_back(function.name);
  for (const flow::Behavior* behavior : library_.behaviors()) names.emplace_back(behavior->name);
  hint_nearest(d, callee.text, names);
  return {};
}

std::vector<int> Lowering::match(const Word& callee, const std::vector<Given>& given,
                                 const std::vector<std::string>& names, const Assemblage* assemblage) {
  std::vector<int> out;
  std::vector<const Given*> taken(names.size(), nullptr);
  bool had_name = false;
  for (std::size_t i = 0; i < given.size(); ++i) {
    const Given& one = given[i];
    const text::Place& place = one.name.text.empty() ? one.place : one.name.place;
    int index = -1;
    if (!one.name.text.empty()) {
      had_name = true;
      const auto found = std::ranges::find(names, one.name.text);
      index = found == names.end() ? -1 : static_cast<int>(found - names.begin());
      // Where the assemblage misses that name itself, its parameter is misspelt.
      const Assemblage* outer = std::exchange(inside_, assemblage);
      const std::string missed =
          key_of("unknown-name", {}, fmt::format("unknown name `{}`", one.name.text), "");
      inside_ = outer;
      const bool was_said = assemblage != nullptr && said_.keys.contains(missed);
      if (index < 0 && !was_said) {
        text::Diagnostic& d = error("unknown-argument", place,
                                    fmt::format("`{}` has no input `{}`", callee.text, one.name.text));
        const std::string nearest = text::nearest_name(one.name.text, names);
        d.hints.push_back(!nearest.empty() ? fmt::format("did you mean `{}`?", nearest)
                          : names.empty()  ? "it takes no arguments"
                                           : fmt::format("its inputs are {}", fmt::join(names, ", ")));
      }
    } else if (had_name) {
      error("argument-without-name", place, "behind an argument with a name all have one").hints = {
          fmt::format("the inputs of `{}` are {}", callee.text, fmt::join(names, ", "))};
    } else if (i >= names.size()) {
      error("too-many-arguments", place,
            names.empty() ? fmt::format("`{}` takes no arguments", callee.text)
                          : fmt::format("`{}` takes no more than {} argument{}", callee.text, names.size(),
                                        names.size() == 1 ? "" : "s"));
    } else {
      index = static_cast<int>(i);
    }
    if (index >= 0 && taken[static_cast<std::size_t>(index)] != nullptr) {
      error("double-argument", place,
            fmt::format("`{}` is given twice", names[static_cast<std::size_t>(index)]))
          .notes.push_back({"first here", taken[static_cast<std::size_t>(index)]->place});
      index = -1;
    }
    if (index >= 0) taken[static_cast<std::size_t>(index)] = &one;
    out.push_back(index);
  }
  return out;
}

void Lowering::say_missing(const Word& callee, const std::string& name, const PortType& type,
                           const std::string& help) {
  error("missing-argument", callee.place, fmt::format("`{}` needs `{}`", callee.text, name))
      .hints.push_back(fmt::format("`{} = ...` takes {}{}{}{}", name,
                                   type.type == nullptr ? "a value" : std::string(type.type->name),
                                   bracketed(type.unit), help.empty() ? "" : ": ", help));
}

Value Lowering::value_of(const Given& given) {
  return given.ready ? *given.ready : lower(*given.value, *given.scope);
}

void Lowering::link_argument(const InputView& view, const Given& given, flow::Node& node) {
  const Value value = value_of(given);
  const text::Place link_place = given.name.text.empty() ? given.place : given.name.place;
  const auto link = [&](const Value& one, const text::Place& place) {
    if (auto source = bind(one, view.type, view.input, view.name, place))
      node.links.push_back({view.name, std::move(*source), link_place});
  };
  if (!view.input->is_list || value.kind != Value::Kind::kList) {
    link(value, given.place);
    return;
  }
  // `[1, 2]` is one vector for a list of vectors, `[[1, 2]]` another way to say so.
  for (const Value& item : value.items) link(item, item.place);
}

Value Lowering::instantiate_procedure(const Word& callee, const flow::Library::Entry& entry,
                                      const std::vector<Given>& given, const std::string& path,
                                      const text::Place& place) {
  const std::vector<InputView> views = inputs_of(entry);
  std::vector<std::string> names;
  for (const InputView& view : views) names.push_back(view.name);
  const std::vector<int> matched = match(callee, given, names);
  const bool is_right = std::ranges::find(matched, -1) == matched.end();

  const std::size_t errors_before = sink_.error_count();
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
      say_missing(callee, views[i].name, views[i].type, std::string(input.help));
  }
  if (entry.behavior->output == nullptr) {
    Value sink;
    sink.kind = Value::Kind::kSink;
    sink.text = callee.text;
    sink.place = place;
    network_.nodes.push_back(std::move(node));
    return sink;
  }
  // After an error the node is there all the same: who takes its value is not wrong for that.
  Value out = wire(node.name, types_.of_call(entry), place);
  if (sink_.error_count() == errors_before) network_.nodes.push_back(std::move(node));
  return out;
}

bool Lowering::enter_assemblage(const Assemblage& assemblage, const Word& callee) {
  const auto first = std::ranges::find(open_, &assemblage);
  if (first == open_.end()) {
    open_.push_back(&assemblage);
    return true;
  }
  std::string path;
  for (auto it = first; it != open_.end(); ++it) path += (*it)->name.text + " -> ";
  error("recursive-assemblage", callee.place,
        fmt::format("assemblages contain each other: {}{}", path, assemblage.name.text))
      .hints = {"a `sequence` comes back to a state by a transition"};
  return false;
}

Value Lowering::instantiate_assemblage(const Word& callee, const Assemblage& assemblage,
                                       const std::vector<Given>& given, const Spot& spot,
                                       const text::Place& place) {
  std::vector<std::string> names;
  for (const Parameter& parameter : assemblage.parameters) names.push_back(parameter.name.text);
  const std::vector<int> matched = match(callee, given, names, &assemblage);
  const bool is_right = std::ranges::find(matched, -1) == matched.end();
  Scope& scope = new_scope();
  scope.path = spot.path;
  std::vector<bool> is_given(names.size(), false);
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (matched[i] < 0) continue;
    const auto at = static_cast<std::size_t>(matched[i]);
    is_given[at] = true;
    const Parameter& parameter = assemblage.parameters[at];
    const Value value = value_of(given[i]);
    scope.names[parameter.name.text].value = pass(value, parameter, type_of(parameter), given[i].place);
  }
  const auto known = is_checking_ ? said_.results.find(&assemblage) : said_.results.end();
  const bool is_known = known != said_.results.end();
  scope.nodes = is_known ? &kUnnamed : &elaboration_.names(assemblage, is_given, *spot.taken);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Parameter& parameter = assemblage.parameters[i];
    if (is_given[i]) continue;
    if (!parameter.initial && is_right) say_missing(callee, names[i], type_of(parameter), parameter.help);
    const Assemblage* outer = std::exchange(inside_, &assemblage);
    scope.names[names[i]].value = default_of(parameter, scope);
    inside_ = outer;
  }
  if (!enter_assemblage(assemblage, callee)) return {};
  Value out = is_known ? wire(spot.path, {known->second.first, known->second.second}, place)
                       : lower_assemblage(assemblage, scope, place);
  open_.pop_back();
  return out;
}

// The value of a parameter that nobody gives; nothing where it has no default.
Value Lowering::default_of(const Parameter& parameter, Scope& scope) {
  if (!parameter.initial) return {};
  // A default may use the parameters before it.
  const Value value = lower(*parameter.initial, scope);
  return pass(value, parameter, type_of(parameter), parameter.initial->place);
}

// The value of an assemblage whose parameters have theirs.
Value Lowering::lower_assemblage(const Assemblage& assemblage, Scope& scope, const text::Place& place) {
  const Assemblage* outer = std::exchange(inside_, &assemblage);
  declare_lets(assemblage.lets, scope);
  const PortType result =
      assemblage.result_type.text.empty() ? PortType{} : type_named(assemblage.result_type);
  Value out;
  if (assemblage.body) {
    out = lower(*assemblage.body, scope);
    const bool has_type = result.type != nullptr && out.kind != Value::Kind::kNone;
    if (has_type && out.kind == Value::Kind::kWire) {
      if (!fits(out.type, result, assemblage.name.text, assemblage.body->place)) out = {};
      declare_unit(out, result);
    }
    if (out.kind == Value::Kind::kNone && result.type != nullptr) out = wire(scope.path, result, place);
  } else {
    out = stand_still(assemblage, scope, result, place);
  }
  inside_ = outer;
  if (is_checking_) said_.results[&assemblage] = {out.type.type, out.type.unit};
  return out;
}

// An assemblage that is declared and empty.
Value Lowering::stand_still(const Assemblage& assemblage, Scope& scope, const PortType& result,
                            const text::Place& place) {
  // What stands in the place of each type, and what that means.
  struct Nothing {
    std::string_view type, behavior, means;
  };
  static constexpr Nothing kNothing[] = {
      {"Vector", "Stand", "the robot stands still in its place"},
      {"bool", "Constant", "it is never true"},
      {"Objects", "NoObjects", "it sees none"},
      {"Obstacles", "NoObstacles", "it sees none"},
      {"Robots", "NoRobots", "it sees none"},
      {"Ranges", "NoRanges", "it measures nothing"},
      {"Object", "NoObject", "it gives no object"},
      {"ObjectClasses", "NoClasses", "it gives no class"},
      {"Formation", "NoFormation", "it gives none"},
      {"FormationReference", "NoFormationReference", "it gives the usual one"},
      {"Task", "NoTask", "it gives none"},
      {"Text", "NoText", "it gives the empty text"},
      {"double", "ZeroNumber", "it is always 0"},
      {"int", "ZeroCount", "it is always 0"},
      {"Point", "ZeroPoint", "it is always the origin"},
      {"Pose", "ZeroPose", "it is always the origin"}};
  const std::string_view type = result.type == nullptr ? "Vector" : result.type->name;
  const auto* nothing = std::ranges::find(kNothing, type, &Nothing::type);
  if (nothing == std::end(kNothing) || library_.find(nothing->behavior).behavior == nullptr) {
    error("empty-assemblage", assemblage.name.place,
          fmt::format("`{}` is empty, so it gives no {}", assemblage.name.text, type));
    return {};
  }
  warning("empty-assemblage", assemblage.name.place, fmt::format("`{}` is empty", assemblage.name.text))
      .label = nothing->means;
  flow::Node node;
  node.name = scope.path;
  node.behavior = nothing->behavior;
  node.place = node.behavior_place = place;
  if (type == "bool") node.links.push_back({"value", {flow::Source::Kind::kConstant, "false", place}, place});
  network_.nodes.push_back(node);
  return wire(node.name, {library_.find_type(type), ""}, place);
}

// What a configuration asks for by the name of a binding point.
Value Lowering::call_binding(const Call& call, const Binding& binding, Scope& scope, const Spot& spot,
                             const text::Place& place) {
  std::vector<std::string> names;
  for (const Parameter& parameter : binding.parameters) names.push_back(parameter.name.text);
  std::vector<Given> given = given_by(call, scope);
  const std::vector<int> matched = match(call.callee, given, names);
  std::vector<Given> asked;
  std::vector<bool> is_given(names.size(), false);
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (matched[i] < 0) continue;
    const Parameter& parameter = binding.parameters[static_cast<std::size_t>(matched[i])];
    is_given[static_cast<std::size_t>(matched[i])] = true;
    const Value value = value_of(given[i]);
    asked.push_back({{parameter.name.text, given[i].place},
                     nullptr,
                     nullptr,
                     pass(value, parameter, type_of(parameter), given[i].place),
                     given[i].place});
  }
  const PortType type = binding.result_type.text.empty() ? PortType{} : type_named(binding.result_type);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Parameter& parameter = binding.parameters[i];
    if (is_given[i]) continue;
    if (parameter.initial) {
      asked.push_back({{parameter.name.text, place}, nullptr, nullptr, default_of(parameter, scope), place});
    } else if (asked.size() == given.size()) {
      say_missing(call.callee, names[i], type_of(parameter), parameter.help);
    }
  }
  if (binding.result_type.text.empty()) {
    error("sink-as-value", call.callee.place,
          fmt::format("`{}` is an actuator and gives no value", call.callee.text))
        .hints = {fmt::format("a robot drives it: `{} = ...;`", call.callee.text)};
    return {};
  }
  const DeviceUse* use = is_checking_ ? nullptr : device_serving(call.callee);
  if (use == nullptr) return wire(spot.path, type, place);
  Value out = serve(*use, std::move(asked), spot, place);
  if (out.kind == Value::Kind::kWire &&
      !fits(out.type, type, binding.name.text, use->device->by.callee.place))
    return {};
  declare_unit(out, type);
  return out;
}

// A device's own arguments hold: they say what it is. What is asked for is added to them.
Value Lowering::serve(const DeviceUse& use, std::vector<Given> asked, const Spot& spot,
                      const text::Place& place) {
  const Device& device = *use.device;
  Scope& scope = device_scope(use, spot);
  std::vector<Given> given = given_by(device.by, scope);
  for (Given& one : asked) {
    const bool is_said =
        std::ranges::any_of(given, [&](const Given& own) { return own.name.text == one.name.text; });
    one.name.place = device.by.callee.place;  // what the device does not take is the device's mistake
    if (!is_said) given.push_back(std::move(one));
  }
  return instantiate(device.by.callee, given, {spot.path, &scope.nodes->top()}, place);
}

Scope& Lowering::device_scope(const DeviceUse& use, const Spot& spot) {
  Scope& out = new_scope();
  if (!use.overrides && class_scope_ != nullptr) out.names = class_scope_->names;
  out.path = spot.path;
  out.nodes = &elaboration_.names(*use.device, *spot.taken);
  return out;
}

const DeviceUse* Lowering::device_serving(const Word& binding) {
  const auto [found, fitting] = device_for(devices_, binding.text);
  const text::Place& place = class_name_.empty() ? robot_name_.place : class_place_;
  if (fitting.size() > 1) {
    error("several-devices", place,
          fmt::format("several devices of `{}` serve `{}`: {}", class_name_, binding.text,
                      fmt::join(fitting, ", ")))
        .hints = {fmt::format("choose one: `use {} for {};`", fitting.front(), binding.text)};
  }
  if (found == nullptr && !class_is_broken_) {
    const std::string who = class_name_.empty() ? fmt::format("robot `{}`", robot_name_.text)
                                                : fmt::format("class `{}`", class_name_);
    text::Diagnostic& d =
        error("device-not-offered", place, fmt::format("{} has nothing that serves `{}`", who, binding.text));
    d.hints.push_back(class_name_.empty()
                          ? fmt::format("say what it is: `robot {} is CLASS`", robot_name_.text)
                          : fmt::format("the class needs `sensor NAME: ... binds {};`", binding.text));
    d.notes.push_back({"asked for here", binding.place});
    class_is_broken_ = class_name_.empty();
  }
  return found;
}

}  // namespace mlab::cdl
