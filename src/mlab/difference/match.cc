#include "mlab/difference/match.h"

#include <utility>

#include <fmt/core.h>

#include "mlab/lang/cdl/lower/node_names.h"

namespace mlab::difference {
namespace {

using cdl::ModelInput;
using cdl::ModelNode;
using cdl::ModelPage;
using Kind = ModelNode::Kind;
using Print = Fingerprints::Print;

const ModelNode& at(const ModelPage& page, std::size_t i) {
  return page.nodes[i];
}

class NodeMatcher {
 public:
  NodeMatcher(const ModelPage& before, const ModelPage& after, Prints& prints)
      : before_(before), after_(after), prints_(prints), pairs_(before.nodes.size(), after.nodes.size()) {}

  Pairs run() {
    // A name that an author gave may stand in several places of a page, each in a scope of its own.
    pair_by_unique(
        pairs_, [&](std::size_t i) { return name_key(at(before_, i), true); },
        [&](std::size_t i) { return name_key(at(after_, i), false); });
    take_new_ones();
    const auto says = [&](const ModelNode& node, bool is_before) { return print_of(node, is_before); };
    pair_by_unique(
        pairs_, [&](std::size_t i) { return says(at(before_, i), true); },
        [&](std::size_t i) { return says(at(after_, i), false); });
    take_new_ones();
    pair_results();
    follow();
    by_key([&](const ModelNode& node, bool is_before) {
      const Print print = says(node, is_before);
      return print == 0 ? std::string() : fmt::format("{} {}", print, node.name);
    });
    by_key(says);
    follow();
    replace();
    pair_by_unique(
        pairs_, [&](std::size_t i) { return free_component(at(before_, i)); },
        [&](std::size_t i) { return free_component(at(after_, i)); });
    take_new_ones();
    follow();
    return std::move(pairs_);
  }

 private:
  template <class Key>
  void by_key(const Key& key) {
    pair_by(
        pairs_, [&](std::size_t i) { return key(at(before_, i), true); },
        [&](std::size_t i) { return key(at(after_, i), false); });
    take_new_ones();
  }

  // Whose partner has been found since: its inputs are looked at next.
  void take_new_ones() {
    is_looked_at_.resize(pairs_.to_after.size());
    for (std::size_t i = 0; i < pairs_.to_after.size(); ++i) {
      if (pairs_.to_after[i] < 0 || is_looked_at_[i]) continue;
      is_looked_at_[i] = true;
      waiting_.push_back(i);
    }
  }

  std::string name_key(const ModelNode& node, bool is_before) const {
    const auto own = [&](const std::string& name) {
      return is_before ? Renames::in(prints_.renames.own, name) : name;
    };
    if (node.kind == Kind::kParameter) return "parameter " + own(node.parameter->name.text);
    if (node.kind == Kind::kOuter) return "outer " + own(node.let->name.text);
    if (node.kind == Kind::kActuator) return "actuator " + node.drive->binding.text;
    const std::string& name = given_name(node);
    return name.empty() ? "" : "node " + (node.let != nullptr ? own(name) : name);
  }

  Print print_of(const ModelNode& node, bool is_before) {
    if (!is_component(node)) return 0;
    return (is_before ? prints_.before : prints_.after).content(*node.expression);
  }

  static std::string free_component(const ModelNode& node) {
    return is_component(node) ? component_of(node) : "";
  }

  bool pair(int before, int after) {
    if (before < 0 || after < 0) return false;
    const auto i = static_cast<std::size_t>(before);
    const auto k = static_cast<std::size_t>(after);
    if (!pairs_.are_free(i, k)) return false;
    pairs_.put(i, k);
    is_looked_at_[i] = true;
    waiting_.push_back(i);
    return true;
  }

  bool are_alike(int before, int after) const {
    if (before < 0 || after < 0) return false;
    const ModelNode& one = at(before_, static_cast<std::size_t>(before));
    const ModelNode& other = at(after_, static_cast<std::size_t>(after));
    return is_component(one) && is_component(other) && component_here(one) == component_of(other);
  }
  std::string component_here(const ModelNode& node) const {
    return prints_.renames.declaration(component_of(node));
  }

  void pair_results() {
    if (are_alike(before_.result, after_.result)) pair(before_.result, after_.result);
  }

  // From what is the same to what drives it.
  void follow() {
    while (!waiting_.empty()) {
      const std::size_t i = waiting_.back();
      waiting_.pop_back();
      const InputGroups before = inputs_of(at(before_, i), &prints_.renames);
      const InputGroups after = inputs_of(at(after_, static_cast<std::size_t>(pairs_.to_after[i])), nullptr);
      for (const auto& [port, inputs] : before) {
        if (const auto found = after.find(port); found != after.end()) align(inputs, found->second);
      }
    }
  }

  // What drives the items of a list: that which says the same, then that which is of the same component.
  void align(const std::vector<const ModelInput*>& before, const std::vector<const ModelInput*>& after) {
    Pairs inputs(before.size(), after.size());
    for (std::size_t i = 0; i < before.size(); ++i) {
      const int from = before[i]->from;
      if (from >= 0 && pairs_.to_after[static_cast<std::size_t>(from)] >= 0) inputs.to_after[i] = 0;
    }
    for (std::size_t i = 0; i < after.size(); ++i) {
      const int from = after[i]->from;
      if (from >= 0 && pairs_.to_before[static_cast<std::size_t>(from)] >= 0) inputs.to_before[i] = 0;
    }
    const Pairs taken = inputs;
    const auto node = [](const ModelPage& page, const ModelInput* input) -> const ModelNode* {
      return input->from < 0 ? nullptr : &at(page, static_cast<std::size_t>(input->from));
    };
    const auto print = [&](const ModelNode* one, bool is_before) {
      return one == nullptr ? Print{0} : print_of(*one, is_before);
    };
    pair_by(
        inputs, [&](std::size_t i) { return print(node(before_, before[i]), true); },
        [&](std::size_t i) { return print(node(after_, after[i]), false); });
    const auto component = [](const ModelNode* one) { return one == nullptr ? "" : free_component(*one); };
    pair_by(
        inputs,
        [&](std::size_t i) { return prints_.renames.declaration(component(node(before_, before[i]))); },
        [&](std::size_t i) { return component(node(after_, after[i])); });
    for (std::size_t i = 0; i < before.size(); ++i) {
      if (taken.to_after[i] >= 0 || inputs.to_after[i] < 0) continue;
      pair(before[i]->from, after[static_cast<std::size_t>(inputs.to_after[i])]->from);
    }
  }

  // What all that stands in a node stands in afterwards; -1: nothing, -2: in several.
  static std::vector<int> now_in(const ModelPage& page, const ModelPage& other,
                                 const std::vector<int>& partners) {
    std::vector<int> out(page.nodes.size(), -1);
    for (std::size_t i = 0; i < page.nodes.size(); ++i) {
      const int reader = page.nodes[i].reader;
      if (reader < 0 || partners[i] < 0) continue;
      const int found = at(other, static_cast<std::size_t>(partners[i])).reader;
      int& told = out[static_cast<std::size_t>(reader)];
      if (found >= 0) told = told == -1 || told == found ? found : -2;
    }
    return out;
  }

  // An operator that became another one keeps its members.
  void replace() {
    const std::vector<int> there = now_in(before_, after_, pairs_.to_after);
    const std::vector<int> back = now_in(after_, before_, pairs_.to_before);
    for (std::size_t i = 0; i < before_.nodes.size(); ++i) {
      const int now = there[i];
      if (now < 0 || back[static_cast<std::size_t>(now)] != static_cast<int>(i)) continue;
      if (is_component(at(before_, i)) && is_component(at(after_, static_cast<std::size_t>(now))))
        pair(static_cast<int>(i), now);
    }
    follow();
  }

  const ModelPage& before_;
  const ModelPage& after_;
  Prints& prints_;
  Pairs pairs_;
  std::vector<std::size_t> waiting_;
  std::vector<bool> is_looked_at_;
};

// What a formula reads is called after who it is read from.
std::string renamed_term(const ModelInput& term, const Renames& renames) {
  const auto renamed = [&](const std::string& was, const std::string& is) {
    return term.port.starts_with(was) ? is + term.port.substr(was.size()) : term.port;
  };
  if (!term.written->as.text.empty()) return term.port;
  if (const auto* name = std::get_if<cdl::Name>(&term.written->what))
    return renamed(name->name.text, Renames::in(renames.own, name->name.text));
  if (const auto* call = std::get_if<cdl::Call>(&term.written->what))
    return renamed(call->callee.text, renames.declaration(call->callee.text));
  return term.port;
}

}  // namespace

bool is_component(const ModelNode& node) {
  return node.kind != Kind::kParameter && node.kind != Kind::kOuter && node.kind != Kind::kActuator;
}

std::string component_of(const ModelNode& node) {
  if (node.kind == Kind::kParameter) return "parameter";
  if (node.kind == Kind::kActuator) return "actuator";
  if (node.kind == Kind::kOuter || node.kind == Kind::kValue) return "value";
  if (const auto* compete = std::get_if<cdl::Compete>(&node.expression->what))
    return compete->rule == cdl::CompetitionRule::kPriority ? "compete by priority" : "compete by strength";
  if (const auto* coordinate = std::get_if<cdl::Coordinate>(&node.expression->what))
    return "coordinate by " + coordinate->by.callee.text;
  if (const auto* fuse = std::get_if<cdl::Fuse>(&node.expression->what))
    return "fuse by " + fuse->by.callee.text;
  return cdl::default_name(*node.expression);
}

const std::string& given_name(const ModelNode& node) {
  static const std::string kNone;
  if (node.let != nullptr) return node.let->name.text;
  return node.expression == nullptr ? kNone : node.expression->as.text;
}

std::string label_of(const ModelNode& node) {
  if (!given_name(node).empty()) return given_name(node);
  if (!is_component(node)) return node.name;
  const std::string component = component_of(node);
  const std::string last = node.name.substr(node.name.rfind('.') + 1);
  return last.starts_with(component) ? last : component;
}

std::string case_words(const cdl::Case& one) {
  std::string out;
  for (const cdl::Word& word : one.values) out += (out.empty() ? "" : ", ") + word.text;
  return out.empty() ? "otherwise" : "case " + out;
}

InputGroups inputs_of(const ModelNode& node, const Renames* renames) {
  InputGroups out;
  const auto* call = node.expression == nullptr ? nullptr : std::get_if<cdl::Call>(&node.expression->what);
  for (const ModelInput& input : node.inputs) {
    if (input.is_open || input.role == cdl::InputRole::kWeight) continue;
    std::string port = input.port;
    if (input.role == cdl::InputRole::kCase)
      port =
          case_words(std::get<cdl::Select>(node.expression->what).cases[static_cast<std::size_t>(input.at)]);
    else if (renames != nullptr && input.role == cdl::InputRole::kTerm)
      port = renamed_term(input, *renames);
    else if (renames != nullptr && call != nullptr)
      port = renames->parameter(call->callee.text, port);
    out[port].push_back(&input);
  }
  return out;
}

Pairs match_nodes(const ModelPage& before, const ModelPage& after, Prints& prints) {
  return NodeMatcher(before, after, prints).run();
}

Pairs match_states(const cdl::Sequence& before, const cdl::Sequence& after, Prints& prints) {
  Pairs out(before.states.size(), after.states.size());
  pair_by(
      out, [&](std::size_t i) { return before.states[i].name.text; },
      [&](std::size_t i) { return after.states[i].name.text; });
  const auto asks = [](const cdl::State& state, Fingerprints& prints_of) {
    Print print = prints_of.of(state.member);
    for (const cdl::Transition& transition : state.transitions)
      print = base::combine_bits(print, prints_of.of(transition.trigger));
    return print;
  };
  const auto does = [](const cdl::State& state, Fingerprints& prints_of) {
    return prints_of.of(state.member);
  };
  const auto by = [&](const auto& key) {
    pair_by(
        out, [&](std::size_t i) { return key(before.states[i], prints.before); },
        [&](std::size_t i) { return key(after.states[i], prints.after); });
  };
  by(asks);
  by(does);
  return out;
}

Pairs match_transitions(const cdl::State& before, const cdl::State& after, const Renames::Names& targets,
                        Prints& prints) {
  Pairs out(before.transitions.size(), after.transitions.size());
  const auto by = [&](bool by_trigger, bool by_target) {
    const auto key = [&](const cdl::Transition& transition, Fingerprints& prints_of,
                         const std::string& target) {
      Print print = 1;
      if (by_trigger) print = base::combine_bits(print, prints_of.of(transition.trigger));
      if (by_target) print = base::combine_bits(print, base::hash_text(target));
      return print;
    };
    pair_by(
        out,
        [&](std::size_t i) {
          const cdl::Transition& one = before.transitions[i];
          return key(one, prints.before, Renames::in(targets, one.target.text));
        },
        [&](std::size_t i) {
          const cdl::Transition& one = after.transitions[i];
          return key(one, prints.after, one.target.text);
        });
  };
  by(true, true);
  by(true, false);
  by(false, true);
  return out;
}

}  // namespace mlab::difference
