#include "mlab/export/btcpp.h"

#include <map>
#include <set>
#include <vector>

#include <fmt/core.h>

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

  std::optional<std::string> run(const Plan& plan) {
    const std::size_t errors_before = sink_.error_count();
    put(plan, "    ");
    if (sink_.error_count() > errors_before) return std::nullopt;
    std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
    out += fmt::format("<root BTCPP_format=\"4\" main_tree_to_execute=\"{}\">\n  <BehaviorTree ID=\"{}\">\n",
                       escaped(plan.name), escaped(plan.name));
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
  void refuse(const text::Place& place, std::string message, std::string hint) {
    sink_.error("not-a-tree", place, std::move(message)).hints = {std::move(hint)};
  }

  // The steps from the start on, each with the one step that follows. Empty where that is no chain.
  std::vector<const Step*> chain(const Plan& plan, bool& repeats) {
    std::vector<const Step*> out;
    std::set<std::size_t> seen;
    std::size_t at = plan.start;
    while (seen.insert(at).second) {
      const Step& step = plan.steps[at];
      out.push_back(&step);
      if (step.exits.empty()) return out;
      for (const Step::Exit& exit : step.exits) {
        if (exit.target == step.exits.front().target) continue;
        refuse(exit.place, fmt::format("state `{}` leads to several states", step.name),
               "a behavior tree has no transitions; a sequence that is one has a single next state in each");
        return {};
      }
      at = step.exits.front().target;
    }
    repeats = true;
    if (at == plan.start) return out;
    refuse(out.back()->exits.front().place,
           fmt::format("state `{}` leads back into the middle", out.back()->name),
           "a behavior tree repeats from its start, or ends");
    return {};
  }

  void put(const Plan& plan, const std::string& indent) {
    bool repeats = false;
    const std::vector<const Step*> steps = chain(plan, repeats);
    if (steps.empty()) return;
    const std::string inner = repeats ? indent + "  " : indent;
    if (repeats) tree_ += indent + "<Repeat num_cycles=\"-1\">\n";
    tree_ += inner + "<Sequence>\n";
    for (const Step* step : steps) put(*step, inner + "  ");
    tree_ += inner + "</Sequence>\n";
    if (repeats) tree_ += indent + "</Repeat>\n";
  }

  // A step lasts until one of its conditions holds; a last one as long as its skill does.
  void put(const Step& step, const std::string& indent) {
    if (step.exits.empty()) {
      put_member(step, indent);
      return;
    }
    tree_ += fmt::format("{}<ReactiveFallback name=\"{}\">\n", indent, escaped(step.name));
    for (const Step::Exit& exit : step.exits) put(exit.condition, indent + "  ");
    put_member(step, indent + "  ");
    tree_ += indent + "</ReactiveFallback>\n";
  }
  void put_member(const Step& step, const std::string& indent) {
    if (step.plan)
      put(*step.plan, indent);
    else
      put_leaf("Action", step.skill, indent);
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
    std::set<std::string>& ports = models_[{kind, value.text}];
    tree_ += fmt::format("{}<{} ID=\"{}\"", indent, kind, escaped(value.text));
    for (const Argument& one : value.arguments) {
      // `name` and `ID` are the element's own.
      const std::string port = one.name == "name" || one.name == "ID" ? one.name + "_" : one.name;
      ports.insert(port);
      tree_ += fmt::format(" {}=\"{}\"", port, escaped(text_of(one.value)));
    }
    tree_ += "/>\n";
  }

  text::Diagnostics& sink_;
  std::string tree_;
  std::map<std::pair<std::string, std::string>, std::set<std::string>> models_;
};

}  // namespace

std::optional<std::string> write_btcpp(const Subject& subject, text::Diagnostics& sink) {
  const std::unique_ptr<Plan> plan = plan_of(subject, "BehaviorTree.CPP", sink);
  return plan && !plan->steps.empty() ? TreeWriter(sink).run(*plan) : std::nullopt;
}

}  // namespace mlab::exports
