#include "mlab/export/btcpp.h"

#include <algorithm>
#include <map>
#include <set>
#include <string_view>
#include <vector>

#include <fmt/core.h>

#include "mlab/export/btcpp_names.h"
#include "mlab/export/plan.h"
#include "mlab/export/xml.h"

namespace mlab::exports {
namespace {

std::string text_of(const Value& value) {
  switch (value.kind) {
    case Value::Kind::kNumber:
      return fmt::format("{}", value.number);
    case Value::Kind::kText:
    case Value::Kind::kWord:
      return value.text;
    case Value::Kind::kList: {
      // Lists are separated by `;`, as the library's own conversions read them.
      std::string out;
      for (const Value& item : value.items) out += (out.empty() ? "" : ";") + text_of(item);
      return out;
    }
    case Value::Kind::kCall: {
      std::string out = value.text + "(";
      for (const Argument& one : value.arguments)
        out += fmt::format("{}{}={}", out.ends_with('(') ? "" : ", ", one.name, text_of(one.value));
      return out + ")";
    }
  }
  return "";
}

class TreeWriter {
 public:
  explicit TreeWriter(text::Diagnostics& sink) : sink_(sink) {}

  std::string run(const Plan& plan) {
    root_ = &plan;
    name_plan(plan, btcpp_key(plan.name));
    name_texts(plan);
    put(plan, plan.name, "    ");
    const std::string id = tree_id(plan.name);
    std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
    out += fmt::format("<root BTCPP_format=\"4\" main_tree_to_execute=\"{}\">\n  <BehaviorTree ID=\"{}\">\n",
                       escaped(id), escaped(id));
    out += tree_ + "  </BehaviorTree>\n  <TreeNodesModel>\n";
    for (const auto& [key, ports] : models_) {
      out += fmt::format("    <{} ID=\"{}\"{}>\n", key.first, escaped(key.second), ports.empty() ? "/" : "");
      for (const std::string& port : ports)
        out += fmt::format("      <input_port name=\"{}\"/>\n", escaped(port));
      if (!ports.empty()) out += fmt::format("    </{}>\n", key.first);
    }
    return out + "  </TreeNodesModel>\n</root>\n";
  }

 private:
  // A tree must not be called as a node is.
  std::string tree_id(const std::string& wanted) const {
    std::string out = btcpp_skill(wanted);
    const auto is_node = [&](const auto& model) { return model.first.second == out; };
    while (std::ranges::any_of(models_, is_node)) out += '_';
    return out;
  }

  std::string unused(const std::string& wanted) {
    std::string out = wanted;
    for (int n = 2; !taken_.insert(out).second; ++n) out = fmt::format("{}_{}", wanted, n);
    return out;
  }

  // The names on the blackboard under which it stands in which state a plan is, and those inside.
  void name_plan(const Plan& plan, const std::string& wanted) {
    const std::string key = unused(wanted);
    keys_[&plan] = key;
    for (std::size_t i = 0; i < plan.steps.size(); ++i) {
      const Step& step = plan.steps[i];
      if (step.plan) name_plan(*step.plan, key + "_" + step.name);
      if (takes_turns(plan, i)) turns_[&step] = unused(key + "_" + step.name + "_turn");
    }
  }

  // Text in braces would be read as a name on the blackboard. So it is put there, under a name of its own.
  void name_texts(const Plan& plan) {
    for (const Step& step : plan.steps) {
      if (step.plan && !step.plan->steps.empty())
        name_texts(*step.plan);
      else
        name_texts(step.skill, step.place);
      for (const Step::Exit& exit : step.exits) name_texts(exit.condition, exit.place);
    }
  }
  void name_texts(const Condition& condition, const text::Place& place) {
    if (condition.kind == Condition::Kind::kValue) name_texts(condition.value, place);
    for (const Condition& operand : condition.operands) name_texts(operand, place);
  }
  void name_texts(const Value& call, const text::Place& place) {
    for (const Argument& one : call.arguments) {
      const std::string text = text_of(one.value);
      if (!btcpp_is_pointer(text) || texts_.contains(text)) continue;
      if (!btcpp_fits_script(text)) {
        sink_
            .error("text-in-braces", place,
                   fmt::format("`{}` of `{}` is text in braces", one.name, call.text))
            .hints = {
            "BehaviorTree.CPP reads text in braces as a name on its blackboard; this one can't be put "
            "there, for its scripts know neither `'` nor letters beyond ASCII in a text"};
      }
      texts_[text] = unused(keys_.at(root_) + "_text");
    }
  }

  // A skill that may be begun anew while it runs stands in the tree twice, and the two take turns.
  static bool takes_turns(const Plan& plan, std::size_t index) {
    const Step& step = plan.steps[index];
    return !step.plan && std::ranges::any_of(step.exits, [index](const Step::Exit& exit) {
      return exit.restarts && exit.target == index;
    });
  }

  // Scripts: to a state; a plan and all plans inside to their starts; what a plan that is entered begins
  // with.
  std::string moves_to(const Plan& plan, std::size_t step) const {
    return fmt::format("{}:='{}'", keys_.at(&plan), plan.steps[step].name);
  }
  std::string restarts(const Plan& plan) const {
    std::string out = moves_to(plan, plan.start);
    for (const Step& step : plan.steps) {
      if (step.plan && !step.plan->steps.empty()) out += "; " + restarts(*step.plan);
    }
    return out;
  }
  std::string begins(const Plan& plan) const {
    std::string out = moves_to(plan, plan.start);
    for (std::size_t i = 0; i < plan.steps.size(); ++i) {
      if (takes_turns(plan, i)) out += fmt::format("; {}:=0", turns_.at(&plan.steps[i]));
    }
    if (&plan != root_) return out;
    for (const auto& [text, key] : texts_) out += fmt::format("; {}:='{}'", key, text);
    return out;
  }
  std::string enters(const Plan& plan, std::size_t from, const Step::Exit& exit) const {
    const Step& target = plan.steps[exit.target];
    std::string out = moves_to(plan, exit.target);
    if (exit.target == from && exit.restarts) {
      if (target.plan && !target.plan->steps.empty()) {
        out += "; " + restarts(*target.plan);
      } else if (!target.plan) {
        const std::string& turn = turns_.at(&target);
        out += fmt::format("; {}:=1-{}", turn, turn);
      }
    }
    return out;
  }

  // In each cycle first the ways out of the state in which it is, of which the first that is open is taken,
  // then what that state does.
  void put(const Plan& plan, const std::string& name, const std::string& indent) {
    const std::string one = indent + "  ";
    const std::string two = one + "  ";
    tree_ += fmt::format("{}<Sequence name=\"{}\">\n", indent, escaped(name));
    tree_ += fmt::format("{}<Script code=\"{}\"/>\n", one, escaped(begins(plan)));
    tree_ += one + "<ReactiveSequence>\n";
    put_ways(plan, two);
    tree_ += two + "<ReactiveFallback>\n";
    for (std::size_t i = 0; i < plan.steps.size(); ++i) put_step(plan, i, two + "  ");
    tree_ += fmt::format("{}</ReactiveFallback>\n{}</ReactiveSequence>\n{}</Sequence>\n", two, one, indent);
  }

  void put_ways(const Plan& plan, const std::string& indent) {
    if (std::ranges::all_of(plan.steps, [](const Step& step) { return step.exits.empty(); })) return;
    const std::string one = indent + "  ";
    const std::string two = one + "  ";
    tree_ += indent + "<Fallback>\n";
    for (std::size_t i = 0; i < plan.steps.size(); ++i) {
      for (const Step::Exit& exit : plan.steps[i].exits) {
        tree_ += one + "<Sequence>\n" + two + is_in(plan, i, "");
        put(exit.condition, two);
        tree_ +=
            fmt::format("{}<Script code=\"{}\"/>\n{}</Sequence>\n", two, escaped(enters(plan, i, exit)), one);
      }
    }
    tree_ += one + "<AlwaysSuccess/>\n" + indent + "</Fallback>\n";
  }

  std::string is_in(const Plan& plan, std::size_t step, const std::string& more) {
    const std::string code = fmt::format("{}=='{}'{}", keys_.at(&plan), plan.steps[step].name, more);
    return fmt::format("<ScriptCondition code=\"{}\"/>\n", escaped(code));
  }

  void put_step(const Plan& plan, std::size_t index, const std::string& indent) {
    const Step& step = plan.steps[index];
    const int copies = takes_turns(plan, index) ? 2 : 1;
    for (int copy = 0; copy < copies; ++copy) {
      const std::string more = copies == 1 ? "" : fmt::format(" && {}=={}", turns_.at(&step), copy);
      tree_ += fmt::format("{}<ReactiveSequence name=\"{}\">\n{}  {}", indent, escaped(step.name), indent,
                           is_in(plan, index, more));
      if (step.plan && !step.plan->steps.empty())
        put(*step.plan, keys_.at(step.plan.get()), indent + "  ");
      else
        put_leaf("Action", step.skill, indent + "  ");
      tree_ += indent + "</ReactiveSequence>\n";
    }
  }

  void put(const Condition& condition, const std::string& indent) {
    if (condition.kind == Condition::Kind::kValue) {
      put_leaf("Condition", condition.value, indent);
      return;
    }
    const char* tag = condition.kind == Condition::Kind::kNot   ? "Inverter"
                      : condition.kind == Condition::Kind::kAnd ? "ReactiveSequence"
                                                                : "ReactiveFallback";
    tree_ += fmt::format("{}<{}>\n", indent, tag);
    for (const Condition& operand : condition.operands) put(operand, indent + "  ");
    tree_ += fmt::format("{}</{}>\n", indent, tag);
  }

  void put_leaf(const char* kind, const Value& value, const std::string& indent) {
    if (value.kind != Value::Kind::kCall) {
      const bool is_true = value.text == "true";
      tree_ += fmt::format("{}<{}/>\n", indent, is_true ? "AlwaysSuccess" : "AlwaysFailure");
      return;
    }
    const std::string skill = btcpp_skill(value.text);
    std::set<std::string>& ports = models_[{kind, skill}];
    tree_ += fmt::format("{}<{}", indent, skill);
    for (const Argument& one : value.arguments) {
      const std::string port = btcpp_port(one.name);
      ports.insert(port);
      const std::string text = text_of(one.value);
      const auto named = texts_.find(text);
      tree_ += fmt::format(" {}=\"{}\"", port,
                           escaped(named == texts_.end() ? text : fmt::format("{{{}}}", named->second)));
    }
    tree_ += "/>\n";
  }

  text::Diagnostics& sink_;
  const Plan* root_ = nullptr;
  std::string tree_;
  std::map<std::string, std::string> texts_;  // text in braces: its name on the blackboard
  std::map<const Plan*, std::string> keys_;
  std::map<const Step*, std::string> turns_;
  std::set<std::string> taken_;
  std::map<std::pair<std::string, std::string>, std::set<std::string>> models_;
};

}  // namespace

std::optional<std::string> write_btcpp(const Subject& subject, text::Diagnostics& sink) {
  const std::unique_ptr<Plan> plan = plan_of(subject, "BehaviorTree.CPP", sink);
  if (!plan || plan->steps.empty()) return std::nullopt;
  const std::size_t errors_before = sink.error_count();
  std::string out = TreeWriter(sink).run(*plan);
  if (sink.error_count() > errors_before) return std::nullopt;
  return out;
}

}  // namespace mlab::exports
