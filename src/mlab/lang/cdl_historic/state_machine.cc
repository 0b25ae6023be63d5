// FSA: states, rules, and the assemblage that holds them.

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "mlab/lang/cdl_historic/converter.h"
#include "mlab/text/shown.h"

namespace mlab::cdl_historic {
namespace {

bool says_start(std::string_view index) {
  constexpr std::string_view kStart = "start";
  return index.size() == kStart.size() && std::ranges::equal(index, kStart, {}, [](char c) {
           return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
         });
}

// `State3`, `Trans12`: the editor's own names, which say nothing.
bool is_numbered(std::string_view label, std::string_view word) {
  return label.starts_with(word) &&
         std::ranges::all_of(label.substr(word.size()), [](char c) { return c >= '0' && c <= '9'; });
}

}  // namespace

/// Reads one `FSA( ... )`.
class StateMachine {
 public:
  StateMachine(Converter& converter, const Expr& expr, const Level* own)
      : converter_(converter), expr_(expr), own_(own) {}

  cdl::Sequence read(std::string_view wanted, const std::string& owner);
  const std::vector<Node>& nodes() const { return nodes_; }
  const std::string& type() const { return type_; }

 private:
  struct Planned {
    const Setting* setting = nullptr;
    cdl::State state;
  };

  void plan_states();
  std::string state_name(const Setting& setting);
  void mark_start();
  void read_rule(const Setting& setting);
  void read_member(Planned& planned, std::string_view wanted, const std::string& owner);
  std::string label_of(const Setting& setting) const;

  Converter& converter_;
  const Expr& expr_;
  const Level* own_;
  std::vector<Planned> states_;
  std::map<std::string, std::size_t> by_index_;
  std::map<std::string, std::string> labels_;  ///< by index: the first that is said
  std::map<std::string, const Setting*> spots_;
  std::map<std::string, int> names_;
  std::vector<Node> nodes_;
  std::string type_;
};

cdl::Sequence StateMachine::read(std::string_view wanted, const std::string& owner) {
  plan_states();
  mark_start();
  for (Planned& planned : states_) read_member(planned, wanted, owner);
  for (const Setting& setting : expr_.settings) {
    if (!setting.is_pushed && setting.value.kind == Value::Kind::kRule) read_rule(setting);
  }
  cdl::Sequence sequence;
  for (Planned& planned : states_) {
    planned.state.is_final = planned.state.transitions.empty();
    sequence.states.push_back(std::move(planned.state));
  }
  return sequence;
}

void StateMachine::plan_states() {
  for (const Setting& setting : expr_.settings) {
    if (setting.is_pushed || setting.index.text.empty()) continue;
    const std::string& index = setting.index.text;
    if (!setting.spot.label.text.empty()) labels_.emplace(index, setting.spot.label.text);
    if (setting.spot.has_position) spots_.emplace(index, &setting);
  }
  for (const Setting& setting : expr_.settings) {
    if (setting.is_pushed || setting.name.text != "society") continue;
    const std::string& index = setting.index.text;
    if (!by_index_.emplace(index, states_.size()).second) {
      converter_.sink().warning(
          "two-states", setting.index.place,
          fmt::format("there is a state `{}` already; rules mean the first one", text::shown(index)));
    }
    Planned planned;
    planned.setting = &setting;
    planned.state.name = {state_name(setting), setting.index.place};
    planned.state.place = setting.name.place;
    if (spots_.contains(index)) {
      const Spot& spot = spots_[index]->spot;
      nodes_.push_back({planned.state.name.text, spot.x, spot.y});
    }
    states_.push_back(std::move(planned));
  }
}

std::string StateMachine::label_of(const Setting& setting) const {
  const auto it = labels_.find(setting.index.text);
  return it == labels_.end() ? std::string{} : it->second;
}

// As the historic screen called it, else by its index; the second of two gets a number.
std::string StateMachine::state_name(const Setting& setting) {
  const std::string label = label_of(setting);
  const std::string base = legal_name(!label.empty()                        ? label
                                      : setting.index.text.starts_with("$") ? "State"
                                                                            : setting.index.text);
  std::string name = base;
  while (names_.contains(name)) name = fmt::format("{}_{}", base, ++names_[base]);
  names_[name] = 1;
  return name;
}

void StateMachine::mark_start() {
  if (states_.empty()) return;
  std::optional<std::size_t> start;
  for (std::size_t i = 0; i < states_.size(); ++i) {
    const Setting& setting = *states_[i].setting;
    if (!says_start(setting.index.text)) continue;
    if (!start) {
      start = i;
    } else {
      converter_.sink().warning("two-starts", setting.index.place,
                                "there is a start already; the first one counts");
    }
  }
  if (!start) {
    converter_.sink().warning("no-start", expr_.name.place,
                              "no state is called `start`; the first one is taken");
  }
  states_[start.value_or(0)].state.is_start = true;
}

void StateMachine::read_member(Planned& planned, std::string_view wanted, const std::string& owner) {
  Port port;
  port.type = wanted;
  converter_.suggest(owner + "_" + planned.state.name.text);
  TypedDraft member = converter_.make_value(*planned.setting, own_, port, "");
  if (member.expr == nullptr) member = converter_.nothing(wanted, planned.state.place);
  if (type_.empty()) type_ = member.type;
  planned.state.member = member.expr;
  const std::string label = label_of(*planned.setting);
  if (!label.empty() && label != planned.state.name.text && !is_numbered(label, "State"))
    planned.state.help = help_text(label);
}

void StateMachine::read_rule(const Setting& setting) {
  text::Diagnostics& sink = converter_.sink();
  const Rule& rule = *setting.value.rule;
  const auto from = by_index_.find(setting.index.text);
  const auto to = by_index_.find(rule.target.text);
  if (from == by_index_.end() || to == by_index_.end()) {
    const Word& missing = from == by_index_.end() ? setting.index : rule.target;
    sink.warning("no-such-state", missing.place,
                 fmt::format("no state is called `{}`; the rule is left out", text::shown(missing.text)));
    return;
  }
  if (rule.members.empty()) {
    sink.warning("empty-trigger", setting.name.place,
                 "this rule has no trigger, so it never fires; it is left out");
    return;
  }
  const TypedDraft trigger = converter_.make_members(rule.members, own_, "bool", rule.target.place);
  cdl::Transition transition;
  transition.trigger = converter_.fitting(trigger, "bool", setting.name.place).expr;
  transition.target = {states_[to->second].state.name.text, rule.target.place};
  transition.place = setting.name.place;
  const std::string& label = rule.spot.label.text;
  if (!is_numbered(label, "Trans")) transition.help = help_text(label);
  states_[from->second].state.transitions.push_back(std::move(transition));
}

TypedDraft Converter::make_state_machine(const Expr& expr, const Level* own, std::string_view wanted) {
  if (std::ranges::none_of(expr.settings,
                           [](const Setting& s) { return !s.is_pushed && s.name.text == "society"; })) {
    warn_once("no-states", expr.name.text, expr.name.place, "a state machine without states stands still");
    return nothing(wanted, expr.place);
  }
  const bool is_named = !expr.inline_names.empty() && !expr.inline_names[0].text.starts_with('$');
  std::string base = is_named ? expr.inline_names[0].text : suggested_;
  if (base.empty()) base = "Sequence";
  cdl::Assemblage assemblage;
  assemblage.name = {free_name(base), expr.place};
  Unit unit;
  unit.name = assemblage.name.text;
  start(unit);
  StateMachine machine(*this, expr, own);
  cdl::Sequence sequence = machine.read(wanted.empty() ? "Vector" : wanted, unit.name);
  finish(unit);
  assemblage.lets = std::move(unit.lets);
  assemblage.body = draft(std::move(sequence), expr.place);
  const std::string& label = expr.spot.label.text;
  if (label != "The State Machine") assemblage.help = help_text(label);
  return {call(add_assemblage(std::move(assemblage), machine.nodes()), expr.place), machine.type()};
}

}  // namespace mlab::cdl_historic
