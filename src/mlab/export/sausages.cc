#include "mlab/export/sausages.h"

#include <cmath>

#include <fmt/core.h>

#include "mlab/export/plan.h"

namespace mlab::exports {
namespace {

// `UserWait` and `user_wait` are `user-wait`: symbols of Lisp have no case of their own.
std::string symbol(std::string_view name) {
  std::string out;
  for (const char c : name) {
    const bool is_upper = c >= 'A' && c <= 'Z';
    if (is_upper && !out.empty() && out.back() != '-') out += '-';
    out += c == '_' ? '-' : is_upper ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return out;
}

std::string number(double value) {
  std::string out = fmt::format("{}", value);
  // A Lisp reader takes `40` for an integer.
  if (out.find_first_of(".en") == std::string::npos) out += ".0";
  if (const std::size_t e = out.find('e'); e != std::string::npos) out[e] = 'd';
  return out;
}

std::string lisp_text(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + '"';
}

std::string lisp(const Value& value) {
  switch (value.kind) {
    case Value::Kind::kNumber:
      return number(value.number);
    case Value::Kind::kText:
      return lisp_text(value.text);
    case Value::Kind::kWord:
      return value.text == "true" ? "t" : value.text == "false" ? "nil" : symbol(value.text);
    case Value::Kind::kList: {
      std::string out = "(vector";
      for (const Value& item : value.items) out += " " + lisp(item);
      return out + ")";
    }
    case Value::Kind::kCall: {
      std::string out = "(" + symbol(value.text);
      for (const Argument& one : value.arguments)
        out += fmt::format(" ({} {})", symbol(one.name), lisp(one.value));
      return out + ")";
    }
  }
  return "nil";
}

std::string lisp(const Condition& condition) {
  if (condition.kind == Condition::Kind::kValue) return lisp(condition.value);
  std::string out = condition.kind == Condition::Kind::kNot   ? "(not"
                    : condition.kind == Condition::Kind::kAnd ? "(and"
                                                              : "(or";
  for (const Condition& operand : condition.operands) out += " " + lisp(operand);
  return out + ")";
}

class PlanWriter {
 public:
  std::string run(const Plan& plan) {
    out_ = fmt::format(
        ";; The plan of robot {}: docs/languages/exports.md says how it is to be read.\n(setq start-loc "
        "'(0.0 0.0))\n(defplan the-plan ()\n",
        plan.name);
    put(plan, "  ", "");
    out_ += ")\n";
    return std::move(out_);
  }

 private:
  static std::size_t size(const Plan& plan) {
    std::size_t out = 0;
    for (const Step& step : plan.steps) out += 1 + (step.plan ? size(*step.plan) : 0);
    return out;
  }

  // Ids count the steps in the order of the text; a sequence inside has one as well.
  void put(const Plan& plan, const std::string& indent, const std::string& head) {
    std::vector<std::size_t> ids;
    std::size_t id = next_;
    for (const Step& step : plan.steps) {
      ids.push_back(id);
      id += 1 + (step.plan ? size(*step.plan) : 0);
    }
    out_ += fmt::format("{}(sequence\n{}{}  (start {})", indent, head, indent, ids[plan.start]);
    for (const Step& step : plan.steps) put(step, ids, indent + "  ");
    out_ += ")";
  }

  void put(const Step& step, const std::vector<std::size_t>& ids, const std::string& indent) {
    const std::string inner = indent + "  ";
    std::string head =
        fmt::format("{}(plan-id {})\n{}(name {})\n", inner, next_++, inner, lisp_text(step.name));
    if (step.is_final) head += inner + "(final t)\n";
    if (!step.exits.empty()) {
      head += inner + "(transitions";
      for (const Step::Exit& exit : step.exits)
        head += fmt::format("\n{}  ({} {}{})", inner, lisp(exit.condition), ids[exit.target],
                            exit.restarts ? " restart" : "");
      head += ")\n";
    }
    out_ += fmt::format("\n{};; {}\n", indent, step.name);
    if (step.plan) {
      put(*step.plan, indent, head);
      return;
    }
    out_ += fmt::format("{}(link {}\n{}", indent, symbol(step.skill.text), head);
    for (const Argument& one : step.skill.arguments)
      out_ += fmt::format("{}({} {})\n", inner, symbol(one.name), lisp(one.value));
    out_.back() = ')';
  }

  std::string out_;
  std::size_t next_ = 0;
};

}  // namespace

std::optional<std::string> write_sausages(const Subject& subject, text::Diagnostics& sink) {
  const std::string& architecture = subject.configuration.architecture;
  if (architecture != "UGV") {
    sink.warning("other-architecture", subject.robot.name.place,
                 fmt::format("SAUSAGES plans are for the architecture UGV, and this is for {}",
                             architecture.empty() ? "AuRA" : architecture))
        .hints = {"a vehicle has to know skills and conditions of these names"};
  }
  const std::unique_ptr<Plan> plan = plan_of(subject, "SAUSAGES", sink);
  return plan && !plan->steps.empty() ? std::optional(PlanWriter().run(*plan)) : std::nullopt;
}

}  // namespace mlab::exports
