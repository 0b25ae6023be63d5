#include "mlab/flow/program_builder.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include <fmt/ranges.h>

#include "mlab/base/angle.h"
#include "mlab/flow/builder_hints.h"
#include "mlab/flow/conversions.h"
#include "mlab/flow/port_types.h"
#include "mlab/flow/type_words.h"

namespace mlab::flow {
namespace {

std::string unit_suffix(std::string_view unit) {
  return unit.empty() ? "" : fmt::format(" [{}]", unit);
}

// `a|b` names one thing in two ways.
bool has_word(std::string_view words, std::string_view word) {
  while (true) {
    const std::size_t bar = words.find('|');
    if (words.substr(0, bar) == word) return true;
    if (bar == std::string_view::npos) return false;
    words.remove_prefix(bar + 1);
  }
}

}  // namespace

template <class Visit>
void ProgramBuilder::for_each_source(const Op& op, Visit visit) {
  for (const auto& input : op.inputs) {
    for (const Ref& ref : input) visit(ref);
  }
  for (const StateRefs& state : op.states) {
    for (const Ref& trigger : state.triggers) visit(trigger);
    visit(state.member);
  }
  visit(op.selector);
  for (const Ref& member : op.cases) visit(member);
}

void ProgramBuilder::emit_wires() {
  for (const Op& op : ops_) {
    if (op.same_as != kNone || op.type == nullptr) continue;
    NodeWires wires{op.behavior, op.output, {}, op.kind == Program::Instruction::Kind::kDelay};
    const auto add = [&](const Ref& ref) {
      if (ref.kind != Ref::Kind::kNothing) wires.sources.push_back(offset_of(ref));
    };
    for_each_source(op, add);
    add(op.value);
    add(op.initial);
    program_->wires_.push_back(std::move(wires));
  }
}

std::shared_ptr<const Program> ProgramBuilder::build() {
  const std::size_t errors_before = sink_.error_count();
  program_->name_ = network_.name;
  declare_parameters();
  declare_nodes();
  for (std::uint32_t i = 0; i < network_.nodes.size(); ++i) link_node(i);
  if (sink_.error_count() > errors_before) return nullptr;
  refuse_loops();
  if (sink_.error_count() > errors_before) return nullptr;
  share_pure_calls();
  warn_about_unused();
  lay_out();
  emit_wires();
  return program_;
}

std::uint32_t ProgramBuilder::add_slot(Port port, std::vector<std::byte> value) {
  slots_.push_back({static_cast<std::uint32_t>(program_->ports_.size()), std::move(value), 0});
  program_->ports_.push_back(std::move(port));
  return static_cast<std::uint32_t>(slots_.size() - 1);
}

void ProgramBuilder::declare_name(const std::string& name, const text::Place& place, Ref ref) {
  const auto [it, is_new] = names_.try_emplace(name, Name{std::move(ref), place});
  if (is_new) return;
  text::Diagnostic& d = sink_.error("duplicate-name", place, fmt::format("`{}` is declared twice", name));
  d.notes.push_back({"the first is here", it->second.place});
}

void ProgramBuilder::declare_parameters() {
  for (const Parameter& parameter : network_.parameters) {
    const TypeInfo* type = library_.find_type(parameter.type);
    if (type == nullptr || type->parse == nullptr) {
      sink_.error("unknown-type", parameter.place,
                  fmt::format("a parameter can't have the type `{}`", parameter.type));
      continue;
    }
    // Angles are radians inside, whatever the author counts in.
    const std::string native = parameter.unit == "deg" ? "rad" : parameter.unit;
    Input range;
    range.name = parameter.name;
    range.min = parameter.min;
    range.max = parameter.max;
    const Ref ref = constant(parameter.initial, *type, native, parameter.unit, parameter.name, &range);
    if (ref.kind == Ref::Kind::kNothing) continue;
    Port& port = program_->ports_[slots_[ref.index].port];
    port.role = Port::Role::kParameter;
    port.help = parameter.help;
    declare_name(parameter.name, parameter.place, ref);
    for (const std::string& other : parameter.other_names) declare_name(other, parameter.place, ref);
  }
}

void ProgramBuilder::declare_behavior(const Node& node, Op& op) {
  const Library::Entry entry = library_.find(node.behavior);
  op.behavior = entry.behavior;
  op.alias = entry.alias;
  if (entry.behavior == nullptr) {
    text::Diagnostic& d = sink_.error("unknown-behavior", node.behavior_place,
                                      fmt::format("unknown behavior `{}`", node.behavior));
    hint(d, did_you_mean(node.behavior, library_.names()));
    return;
  }
  op.type = op.behavior->output;
  op.native_unit = op.behavior->output_unit;
  op.seen_unit = op.alias != nullptr && !op.alias->output_unit.empty() ? op.alias->output_unit
                                                                       : op.behavior->output_unit;
  if (op.behavior->latency_cycles > 0) op.kind = Program::Instruction::Kind::kStartAsync;
}

void ProgramBuilder::declare_nodes() {
  using Kind = Program::Instruction::Kind;
  for (const Node& node : network_.nodes) {
    Op op;
    op.node = &node;
    op.path = node.name;
    if (node.kind == Node::Kind::kBehavior) {
      declare_behavior(node, op);
    } else {
      op.kind = node.kind == Node::Kind::kSequence ? Kind::kSequence
                : node.kind == Node::Kind::kSelect ? Kind::kSelect
                                                   : Kind::kDelay;
      op.type = library_.find_type(node.behavior);
      if (op.type == nullptr) {
        sink_.error("unknown-type", node.behavior_place, fmt::format("unknown type `{}`", node.behavior));
      }
    }
    const auto index = static_cast<std::uint32_t>(ops_.size());
    std::uint32_t port = kNone;
    if (op.type != nullptr) {
      port = static_cast<std::uint32_t>(program_->ports_.size());
      program_->ports_.push_back({node.name, Port::Role::kOutput, op.type, op.native_unit, "", 0, -kNoLimit,
                                  kNoLimit, op.seen_unit});
    }
    op_ports_.push_back(port);
    declare_name(node.name, node.place, {Ref::Kind::kOp, index, op.type, op.native_unit, op.seen_unit});
    if (op.kind == Kind::kStartAsync) {
      declare_name(node.name + ".fresh", node.place, {Ref::Kind::kFresh, index, &type_info<bool>(), "", ""});
    }
    ops_.push_back(std::move(op));
  }
}

void ProgramBuilder::link_node(std::uint32_t op) {
  switch (ops_[op].node->kind) {
    case Node::Kind::kBehavior:
      if (ops_[op].behavior != nullptr) link_behavior(op);
      break;
    case Node::Kind::kSequence:
      link_sequence(op);
      break;
    case Node::Kind::kSelect:
      link_select(op);
      break;
    case Node::Kind::kDelay:
      link_delay(op);
      break;
  }
}

int ProgramBuilder::input_named(const Op& op, std::string_view name, std::string& unit) const {
  const auto& inputs = op.behavior->inputs;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const bool is_renamed = op.alias != nullptr && i < op.alias->inputs.size();
    const std::string_view visible = is_renamed ? op.alias->inputs[i].name : inputs[i].name;
    if (!has_word(visible, name)) continue;
    unit = is_renamed && !op.alias->inputs[i].unit.empty() ? op.alias->inputs[i].unit : inputs[i].unit;
    return static_cast<int>(i);
  }
  return -1;
}

bool ProgramBuilder::is_ignored_input(const Op& op, std::string_view name) const {
  return op.alias != nullptr &&
         std::ranges::find(op.alias->ignored_inputs, name) != op.alias->ignored_inputs.end();
}

std::vector<std::string> ProgramBuilder::input_names(const Op& op) const {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < op.behavior->inputs.size(); ++i) {
    const bool is_renamed = op.alias != nullptr && i < op.alias->inputs.size();
    const std::string_view visible = is_renamed ? op.alias->inputs[i].name : op.behavior->inputs[i].name;
    if (!visible.empty()) out.emplace_back(visible.substr(0, visible.find('|')));
  }
  return out;
}

void ProgramBuilder::link_behavior(std::uint32_t index) {
  const Node& node = *ops_[index].node;
  const Behavior& behavior = *ops_[index].behavior;
  const std::size_t count = behavior.inputs.size();
  InputLinks links = {std::vector<std::vector<Ref>>(count), std::vector<const Link*>(count, nullptr)};
  link_given(node, index, links);
  for (std::size_t i = 0; i < count; ++i) {
    const bool is_given = !links.refs[i].empty() || links.first[i] != nullptr;
    if (!is_given && !behavior.inputs[i].is_list) link_default(node, index, i, links);
  }
  ops_[index].inputs = std::move(links.refs);
  check_lists(ops_[index]);
  if (behavior.latency_cycles == 0) return;
  for (const Input& input : behavior.inputs) {
    if (!input.is_list && input.type->kind != TypeKind::kList) continue;
    sink_.error(
        "asynchronous-readings", node.place,
        fmt::format("`{}` is asynchronous, so its input `{}` can't be a list: readings last one cycle",
                    node.behavior, input.name));
  }
}

void ProgramBuilder::link_given(const Node& node, std::uint32_t index, InputLinks& links) {
  const Behavior& behavior = *ops_[index].behavior;
  for (const Link& link : node.links) {
    std::string seen_unit;
    const int i = input_named(ops_[index], link.input, seen_unit);
    if (i < 0) {
      if (is_ignored_input(ops_[index], link.input)) continue;
      text::Diagnostic& d = sink_.error("unknown-input", link.place,
                                        fmt::format("`{}` has no input `{}`", node.behavior, link.input));
      const std::vector<std::string> names = input_names(ops_[index]);
      const std::string nearest = did_you_mean(link.input, names);
      hint(d, nearest.empty() && !names.empty() ? fmt::format("its inputs are {}", fmt::join(names, ", "))
                                                : nearest);
      continue;
    }
    const auto at = static_cast<std::size_t>(i);
    const Input& input = behavior.inputs[at];
    const Link*& first = links.first[at];
    if (!input.is_list && first != nullptr) {
      text::Diagnostic& d =
          sink_.error("double-link", link.place, fmt::format("input `{}` is linked twice", link.input));
      d.notes.push_back({"the first link is here", first->place});
      continue;
    }
    if (first == nullptr) first = &link;
    std::vector<Ref>& refs = links.refs[at];
    std::string path = node.name + "." + link.input;
    if (input.is_list) path += fmt::format("[{}]", refs.size());
    refs.push_back(resolve(link.source, *input.type, std::string(input.unit), seen_unit, path, &input));
  }
}

void ProgramBuilder::link_default(const Node& node, std::uint32_t index, std::size_t which,
                                  InputLinks& links) {
  const Input& input = ops_[index].behavior->inputs[which];
  const Alias* alias = ops_[index].alias;
  const bool is_renamed = alias != nullptr && which < alias->inputs.size();
  const std::string_view renamed = is_renamed ? alias->inputs[which].name : input.name;
  const std::string visible(renamed.empty() ? input.name : renamed.substr(0, renamed.find('|')));
  if (input.default_text.empty()) {
    text::Diagnostic& d = sink_.error("missing-input", node.place,
                                      fmt::format("input `{}` of `{}` is not linked", visible, node.name));
    hint(d, fmt::format("`{}` takes {}{}{}", visible, value_of(*input.type, input.unit),
                        input.help.empty() ? "" : ": ", input.help));
    links.refs[which].push_back({});
    return;
  }
  const Source source{Source::Kind::kConstant, std::string(input.default_text), node.place};
  links.refs[which].push_back(constant(source, *input.type, std::string(input.unit), std::string(input.unit),
                                       node.name + "." + visible, &input));
}

void ProgramBuilder::check_lists(const Op& op) {
  const Input* first = nullptr;
  std::size_t length = 0;
  for (std::size_t i = 0; i < op.inputs.size(); ++i) {
    const Input& input = op.behavior->inputs[i];
    if (!input.is_list) continue;
    // A list behind another one pairs with it by position, and may be left out as a whole.
    if (op.inputs[i].empty() && first != nullptr) continue;
    if (op.inputs[i].empty()) {
      sink_.warning("empty-list", op.node->place,
                    fmt::format("list `{}` of `{}` has no members", input.name, op.path));
    } else if (first != nullptr && op.inputs[i].size() != length) {
      sink_.warning("list-lengths-differ", op.node->place,
                    fmt::format("lists of `{}` differ in length: {} of `{}`, {} of `{}`", op.path, length,
                                first->name, op.inputs[i].size(), input.name));
    }
    if (first == nullptr) {
      first = &input;
      length = op.inputs[i].size();
    }
  }
}

ProgramBuilder::Ref ProgramBuilder::resolve(const Source& source, const TypeInfo& type,
                                            const std::string& native_unit, const std::string& seen_unit,
                                            const std::string& constant_path, const Input* input) {
  if (source.kind == Source::Kind::kConstant)
    return constant(source, type, native_unit, seen_unit, constant_path, input);
  const auto named = names_.find(source.text);
  if (named == names_.end()) {
    // A bare word may be a constant of an enumerated type: `formation = Column`.
    alignas(Frame::kAlignment) std::byte scratch[512];
    if (type.parse != nullptr && type.size <= sizeof scratch && type.kind != TypeKind::kText &&
        type.parse(source.text, scratch)) {
      return constant(source, type, native_unit, seen_unit, constant_path, input);
    }
    text::Diagnostic& d = sink_.error("unknown-source", source.place,
                                      fmt::format("unknown node or parameter `{}`", source.text));
    std::vector<std::string> names;
    for (const auto& [name, entry] : names_) names.push_back(name);
    hint(d, did_you_mean(source.text, names));
    return {};
  }
  if (named->second.ref.type == nullptr) {
    const Op& op = ops_[named->second.ref.index];
    if (op.behavior != nullptr) {  // otherwise its own declaration is wrong, and said so
      sink_.error("sink-as-source", source.place,
                  fmt::format("`{}` has no output: {} is a sink", source.text, op.behavior->name));
    }
    return {};
  }
  return connect(named->second.ref, type, native_unit, seen_unit, source.place);
}

ProgramBuilder::Ref ProgramBuilder::constant(const Source& source, const TypeInfo& type,
                                             const std::string& native_unit, const std::string& seen_unit,
                                             const std::string& path, const Input* input) {
  std::vector<std::byte> value(std::max<std::size_t>(type.size, 1));
  if (type.parse == nullptr || !type.parse(source.text, value.data())) {
    text::Diagnostic& d =
        sink_.error("wrong-type", source.place, fmt::format("`{}` is no {}", source.text, noun_of(type)));
    d.label = fmt::format("`{}` takes {}{}", path, expected_of(type), unit_suffix(seen_unit));
    return {};
  }
  Port port{path,
            Port::Role::kConstant,
            &type,
            native_unit,
            input == nullptr ? "" : std::string(input->help),
            0,
            -kNoLimit,
            kNoLimit,
            seen_unit};
  if (input != nullptr) {
    // The range is said in the unit of the declaration; under an alias people write the other one.
    const bool differs = native_unit == "rad" && seen_unit == "deg" && input->unit == "rad";
    port.min = differs && is_limit(input->min) ? base::degrees(input->min) : input->min;
    port.max = differs && is_limit(input->max) ? base::degrees(input->max) : input->max;
  }
  if (type.kind == TypeKind::kReal || type.kind == TypeKind::kInteger) {
    double number = 0.0;
    int whole = 0;
    if (type.kind == TypeKind::kReal) {
      std::memcpy(&number, value.data(), sizeof number);
    } else {
      std::memcpy(&whole, value.data(), sizeof whole);
      number = whole;
    }
    if (number < port.min || number > port.max) {
      sink_.error("out-of-range", source.place, fmt::format("{} is out of range", source.text)).label =
          fmt::format("`{}` takes {} .. {}{}", path, port.min, port.max, unit_suffix(seen_unit));
      return {};
    }
    if (type.kind == TypeKind::kReal && seen_unit == "deg" && native_unit == "rad") {
      number = base::radians(number);
      std::memcpy(value.data(), &number, sizeof number);
    }
  }
  return {Ref::Kind::kSlot, add_slot(std::move(port), std::move(value)), &type, native_unit, seen_unit};
}

ProgramBuilder::Ref ProgramBuilder::connect(Ref from, const TypeInfo& type, const std::string& native_unit,
                                            const std::string& seen_unit, const text::Place& place) {
  if (!same_type(*from.type, type)) {
    if (from.type->kind == TypeKind::kInteger && type.kind == TypeKind::kReal) {
      from = convert(from, integer_to_real(), "");
    } else {
      text::Diagnostic& d =
          sink_.error("wrong-type", place,
                      fmt::format("{} is linked where {} is expected", value_of(*from.type), value_of(type)));
      d.label = "this is " + value_of(*from.type, from.seen_unit);
      return {};
    }
  }
  if (type.kind != TypeKind::kReal) return from;
  // Who says no unit takes the value as the other side thinks of it.
  const std::string have = from.seen_unit.empty() ? seen_unit : from.native_unit;
  const std::string want = seen_unit.empty() ? from.seen_unit : native_unit;
  if (have == want || have.empty() || want.empty()) return from;
  if (have == "rad" && want == "deg") return convert(from, radians_to_degrees(), "deg");
  if (have == "deg" && want == "rad") return convert(from, degrees_to_radians(), "rad");
  text::Diagnostic& d = sink_.error("wrong-unit", place,
                                    fmt::format("a value in {} is linked where {} is expected", have, want));
  d.label = fmt::format("this is in {}", have);
  return {};
}

ProgramBuilder::Ref ProgramBuilder::convert(Ref from, const Behavior& conversion, const std::string& unit) {
  Op op;
  op.path = fmt::format("{}({}.{})", conversion.name, static_cast<int>(from.kind), from.index);
  op.behavior = &conversion;
  op.type = conversion.output;
  op.native_unit = op.seen_unit = unit;
  op.inputs = {{std::move(from)}};
  const auto index = static_cast<std::uint32_t>(ops_.size());
  op_ports_.push_back(kNone);
  ops_.push_back(std::move(op));
  return {Ref::Kind::kOp, index, conversion.output, unit, unit};
}

void ProgramBuilder::share_pure_calls() {
  // In an order in which sources come before their consumers, so that sharing spreads from the sensors on.
  std::vector<std::uint32_t> all(ops_.size());
  for (std::uint32_t i = 0; i < ops_.size(); ++i) all[i] = i;
  std::map<std::pair<const Behavior*, std::vector<std::vector<Ref>>>, std::uint32_t> seen;
  for (const std::uint32_t i : order(all)) {
    Op& op = ops_[i];
    if (op.behavior == nullptr || !op.behavior->is_pure || op.type == nullptr) continue;
    bool has_constant = false;
    for (auto& input : op.inputs) {
      for (Ref& ref : input) {
        if (ref.kind == Ref::Kind::kOp) ref.index = canonical(ref.index);
        has_constant |= ref.kind == Ref::Kind::kSlot &&
                        program_->ports_[slots_[ref.index].port].role == Port::Role::kConstant;
      }
    }
    if (has_constant) continue;  // a slider of its own
    const auto [it, is_new] = seen.try_emplace({op.behavior, op.inputs}, i);
    if (!is_new) op.same_as = it->second;
  }
}

void ProgramBuilder::refuse_loops() {
  enum class Mark : std::uint8_t { kNew, kOpen, kDone };
  std::vector<Mark> marks(ops_.size(), Mark::kNew);
  struct Visit {
    std::uint32_t op;
    std::vector<std::uint32_t> sources;
    std::size_t next = 0;
  };
  const auto visit_of = [this](std::uint32_t op) {
    Visit visit{op, {}, 0};
    for_each_source(ops_[op], [&](const Ref& ref) {
      if (ref.kind == Ref::Kind::kOp || ref.kind == Ref::Kind::kFresh) visit.sources.push_back(ref.index);
    });
    return visit;
  };
  for (std::uint32_t root = 0; root < ops_.size(); ++root) {
    if (marks[root] != Mark::kNew) continue;
    std::vector<Visit> path = {visit_of(root)};
    marks[root] = Mark::kOpen;
    while (!path.empty()) {
      Visit& top = path.back();
      if (top.next == top.sources.size()) {
        marks[top.op] = Mark::kDone;
        path.pop_back();
        continue;
      }
      const std::uint32_t source = top.sources[top.next++];
      if (marks[source] == Mark::kNew) {
        marks[source] = Mark::kOpen;
        path.push_back(visit_of(source));
      } else if (marks[source] == Mark::kOpen) {
        std::string loop;
        const Node* at = nullptr;
        bool inside = false;
        for (const Visit& visit : path) {
          inside |= visit.op == source;
          if (!inside || ops_[visit.op].node == nullptr) continue;
          at = at == nullptr ? ops_[visit.op].node : at;
          loop = ops_[visit.op].path + (loop.empty() ? "" : " -> " + loop);
        }
        // Sources were followed upstream, so the path reads backwards: data flows from the last to the first.
        const std::size_t last = loop.find(" -> ");
        loop = fmt::format("{} -> {}", loop, loop.substr(0, last));
        text::Diagnostic& d = sink_.error("dataflow-loop", at == nullptr ? text::Place{} : at->place,
                                          fmt::format("values run in a loop: {}", loop));
        hint(d, "a `delay` on the way breaks it: what comes out is the value of the cycle before");
        return;
      }
    }
  }
}

void ProgramBuilder::warn_about_unused() {
  std::vector<std::uint32_t> waiting;
  for (std::uint32_t i = 0; i < ops_.size(); ++i) {
    const bool is_sink = ops_[i].behavior != nullptr && ops_[i].type == nullptr;
    if (is_sink || (ops_[i].node != nullptr && ops_[i].node->is_public)) waiting.push_back(i);
  }
  if (waiting.empty() && !network_.nodes.empty()) {
    sink_
        .warning("no-sink", network_.nodes.back().place,
                 "nothing of this network is ever evaluated: it has no sink")
        .hints = {"end it in an actuator, such as Drive, or mark a node `public`"};
  }
  while (!waiting.empty()) {
    const std::uint32_t i = waiting.back();
    waiting.pop_back();
    if (std::exchange(ops_[i].is_reached, true)) continue;
    const auto reach = [&](const Ref& ref) {
      if (ref.kind == Ref::Kind::kOp || ref.kind == Ref::Kind::kFresh) waiting.push_back(ref.index);
    };
    for_each_source(ops_[i], reach);
    reach(ops_[i].value);
    if (ops_[i].same_as != kNone) waiting.push_back(ops_[i].same_as);
  }
  for (const Op& op : ops_) {
    if (op.node != nullptr && !op.is_reached) {
      sink_.warning("unused-node", op.node->place,
                    fmt::format("node `{}` is never evaluated: nothing uses its output", op.path));
    }
  }
}

std::shared_ptr<const Program> build_program(const Network& network, const Library& library,
                                             text::Diagnostics& sink) {
  return ProgramBuilder(network, library, sink).build();
}

}  // namespace mlab::flow
