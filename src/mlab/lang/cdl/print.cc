#include "mlab/lang/cdl/print.h"

#include <algorithm>
#include <string_view>

#include <fmt/core.h>

#include "mlab/lang/cdl/format.h"

namespace mlab::cdl {
namespace {

/// Writes words and punctuation; where lines end inside of a statement is the formatter's business.
class Printer {
 public:
  std::string run(const Tree& tree) {
    bool is_first = true;
    bool was_short = false;
    for (const Item& item : tree.items) {
      const bool is_short = std::holds_alternative<Use>(item) || std::holds_alternative<Architecture>(item);
      if (!is_first && !(is_short && was_short)) out_ += '\n';
      is_first = false;
      was_short = is_short;
      std::visit([this](const auto& one) { put(one); }, item);
    }
    return laid_out(out_);
  }

  std::string run(const Expression& expression) {
    put(expression, 0);
    std::string text = laid_out(out_);
    while (text.ends_with('\n')) text.pop_back();
    return text;
  }

 private:
  void put_help(const std::string& help) {
    std::string_view rest = help;
    while (!rest.empty()) {
      std::size_t end = rest.find('\n');
      constexpr std::size_t kWidth = 110;
      if (std::min(end, rest.size()) > kWidth) end = rest.rfind(' ', kWidth);
      const std::string_view line = rest.substr(0, end);
      out_ += line.empty() ? "///\n" : fmt::format("/// {}\n", line);
      if (end == std::string_view::npos) break;
      const bool ends_paragraph = rest[end] == '\n';
      rest.remove_prefix(end + 1);
      if (ends_paragraph && !line.empty() && !rest.empty()) out_ += "///\n";
    }
  }

  void put(const Hole& /*nothing stands there*/) {}
  void put(const Number& number) {
    out_ += fmt::format("{}", number.value);
    if (!number.unit.text.empty()) out_ += ' ' + number.unit.text;
  }

  void put(const Parameter& parameter) {
    out_ += fmt::format("{}: {}", parameter.name.text, parameter.type.text);
    if (!parameter.unit.text.empty()) out_ += fmt::format(" [{}]", parameter.unit.text);
    if (parameter.initial) {
      out_ += " = ";
      put(*parameter.initial, 0);
    }
    if (!parameter.low || !parameter.high) return;
    out_ += " in ";
    put(*parameter.low);
    out_ += " .. ";
    put(*parameter.high);
  }

  // Parameters with help stand on lines of their own, the help behind them.
  void put(const std::vector<Parameter>& parameters) {
    bool has_help = false;
    for (const Parameter& parameter : parameters) has_help |= !parameter.help.empty();
    out_ += '(';
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      put(parameters[i]);
      if (i + 1 < parameters.size()) out_ += ',';
      std::string help = parameters[i].help;
      for (char& c : help) c = c == '\n' ? ' ' : c;
      if (!help.empty()) out_ += "  ///< " + help;
      if (i + 1 < parameters.size())
        out_ += has_help ? '\n' : ' ';
      else if (!help.empty())
        out_ += '\n';
    }
    out_ += ')';
  }

  void put(const Call& call) {
    out_ += call.callee.text + "(";
    for (std::size_t i = 0; i < call.arguments.size(); ++i) {
      if (i > 0) out_ += ", ";
      if (!call.arguments[i].name.text.empty()) out_ += call.arguments[i].name.text + " = ";
      put(*call.arguments[i].value, 0);
    }
    out_ += ')';
  }

  void put(const std::vector<Member>& members) {
    out_ += " {\n";
    for (const Member& member : members) {
      put_help(member.help);
      if (member.weight) {
        put(*member.weight, 0);
        out_ += ": ";
      }
      put(*member.value, 0);
      out_ += ";\n";
    }
    out_ += '}';
  }

  void put(const Text& text) { out_ += '"' + text.value + '"'; }
  void put(const Name& name) { out_ += name.name.text; }
  void put(const List& list) {
    out_ += '[';
    for (std::size_t i = 0; i < list.items.size(); ++i) {
      if (i > 0) out_ += ", ";
      put(*list.items[i], 0);
    }
    out_ += ']';
  }
  void put(const Logic& logic) {
    if (logic.connective == Connective::kNot) {
      out_ += "not ";
      put(*logic.operands.front(), 2);
      return;
    }
    const bool is_and = logic.connective == Connective::kAnd;
    for (std::size_t i = 0; i < logic.operands.size(); ++i) {
      if (i > 0) out_ += is_and ? " and " : " or ";
      put(*logic.operands[i], is_and ? 2 : 1);
    }
  }
  void put(const Cooperate& cooperate) {
    out_ += "cooperate";
    put(cooperate.members);
  }
  void put(const Compete& compete) {
    out_ += compete.rule == CompetitionRule::kPriority ? "compete by priority" : "compete by strength";
    put(compete.members);
  }
  void put(const Coordinate& coordinate) {
    out_ += "coordinate by ";
    put(coordinate.by);
    put(coordinate.members);
  }
  void put(const Fuse& fuse) {
    out_ += "fuse by ";
    put(fuse.by);
    put(fuse.members);
  }
  void put(const Transition& transition) {
    put_help(transition.help);
    out_ += "when ";
    put(*transition.trigger, 0);
    out_ += " goto " + transition.target.text + (transition.restarts ? " restart;\n" : ";\n");
  }
  void put(const Sequence& sequence) {
    out_ += "sequence {\n";
    for (const State& state : sequence.states) {
      put_help(state.help);
      out_ += fmt::format("{}{}{}: ", state.is_start ? "start " : "", state.is_final ? "final " : "",
                          state.name.text);
      if (state.member) put(*state.member, 0);
      out_ += ";\n";
      for (const Transition& transition : state.transitions) put(transition);
    }
    out_ += '}';
  }
  void put(const Select& select) {
    out_ += "select by ";
    put(*select.by, 0);
    out_ += " {\n";
    for (const Case& one : select.cases) {
      out_ += one.values.empty() ? "otherwise" : "case ";
      for (std::size_t i = 0; i < one.values.size(); ++i) out_ += (i > 0 ? ", " : "") + one.values[i].text;
      out_ += ": ";
      put(*one.member, 0);
      out_ += ";\n";
    }
    out_ += '}';
  }
  void put(const Delay& delay) {
    out_ += "delay(";
    put(*delay.value, 0);
    if (delay.initial) {
      out_ += ", initial = ";
      put(*delay.initial, 0);
    }
    out_ += ')';
  }

  // `tightness`: 0 takes anything, 1 what stands between `or`, 2 what stands between `and` and behind `not`.
  void put(const Expression& expression, int tightness) {
    const auto* logic = std::get_if<Logic>(&expression.what);
    const bool has_suffix = !expression.as.text.empty() || expression.active;
    bool needs = logic != nullptr && has_suffix;
    if (logic != nullptr && logic->connective == Connective::kOr) needs |= tightness > 0;
    if (logic != nullptr && logic->connective == Connective::kAnd) needs |= tightness > 0;
    if (needs) out_ += '(';
    std::visit([this](const auto& what) { put(what); }, expression.what);
    if (needs) out_ += ')';
    if (!expression.as.text.empty()) out_ += " as " + expression.as.text;
    if (!expression.active) return;
    out_ += " active ";
    const bool is_logic = std::holds_alternative<Logic>(expression.active->what);
    if (is_logic) out_ += '(';
    put(*expression.active, 0);
    if (is_logic) out_ += ')';
  }

  void put(const std::vector<Let>& lets) {
    for (const Let& let : lets) {
      put_help(let.help);
      out_ += "let " + let.name.text + " = ";
      put(*let.value, 0);
      out_ += ";\n";
    }
  }

  void put(const Use& use) { out_ += fmt::format("use \"{}\";\n", use.path.text); }
  void put(const Architecture& architecture) {
    out_ += fmt::format("architecture {};\n", architecture.name.text);
  }
  void put(const Assemblage& assemblage) {
    put_help(assemblage.help);
    out_ += "assemblage " + assemblage.name.text;
    put(assemblage.parameters);
    if (!assemblage.result_type.text.empty()) out_ += " -> " + assemblage.result_type.text;
    if (!assemblage.body && assemblage.lets.empty() && assemblage.historic_names.empty()) {
      out_ += ";\n";
      return;
    }
    out_ += " {\n";
    for (const Word& name : assemblage.historic_names) out_ += fmt::format("alias \"{}\";\n", name.text);
    put(assemblage.lets);
    if (assemblage.body) {
      put(*assemblage.body, 0);
      out_ += out_.ends_with('}') ? "\n" : ";\n";
    }
    out_ += "}\n";
  }
  void put(const Binding& binding) {
    put_help(binding.help);
    out_ += "binding " + binding.name.text;
    put(binding.parameters);
    if (!binding.result_type.text.empty()) out_ += " -> " + binding.result_type.text;
    out_ += ";\n";
  }
  void put(const Device& device) {
    put_help(device.help);
    out_ += fmt::format("{} {}: ", device.is_actuator ? "actuator" : "sensor", device.name.text);
    put(device.by);
    out_ += fmt::format(" binds {};\n", device.binds.text);
  }
  void put(const RobotClass& robot_class) {
    put_help(robot_class.help);
    out_ += "class " + robot_class.name.text;
    if (!robot_class.parameters.empty()) put(robot_class.parameters);
    out_ += " {\n";
    if (!robot_class.body.empty()) {
      out_ += "body {\n";
      for (const BodySetting& setting : robot_class.body) {
        out_ += setting.name.text + " = ";
        put(*setting.value, 0);
        out_ += ";\n";
      }
      out_ += "}\n";
    }
    for (const Device& device : robot_class.devices) put(device);
    out_ += "}\n";
  }
  void put(const Robot& robot) {
    put_help(robot.help);
    out_ += "robot " + robot.name.text;
    if (!robot.parameters.empty()) put(robot.parameters);
    if (!robot.class_name.text.empty()) out_ += " is " + robot.class_name.text;
    out_ += " {\n";
    put(robot.lets);
    for (const Choice& choice : robot.choices)
      out_ += fmt::format("use {} for {};\n", choice.device.text, choice.binding.text);
    for (const Drive& drive : robot.drives) {
      out_ += drive.binding.text + " = ";
      put(*drive.value, 0);
      out_ += ";\n";
    }
    out_ += "}\n";
  }
  void put(const SocietyMember& member) {
    if (member.kind == SocietyMember::Kind::kTeam) {
      out_ += fmt::format("team of {} {}", member.count, member.name.text);
    } else if (member.kind == SocietyMember::Kind::kName) {
      out_ += member.name.text;
    } else {
      out_ += "caste {\n";
      for (const SocietyMember& one : member.members) {
        put(one);
        out_ += ";\n";
      }
      out_ += '}';
    }
    if (!member.by.text.empty()) out_ += " by " + member.by.text;
  }
  void put(const Society& society) {
    put_help(society.help);
    out_ += "society " + society.name.text + ": ";
    put(society.what);
    out_ += ";\n";
  }
  void put(const SocietyOperator& op) {
    put_help(op.help);
    out_ += "operator " + op.name.text + " {\n";
    for (const Device& device : op.devices) {
      put_help(device.help);
      out_ += device.binds.text + " = ";
      put(device.by);
      out_ += ";\n";
    }
    out_ += "}\n";
  }
  void put(const LayoutNote& note) {
    out_ += fmt::format("{} {} {}", note.is_frame ? "frame" : "note", note.x, note.y);
    const bool has_size = note.width != 0.0 || note.height != 0.0 || note.lines.empty();
    if (has_size) out_ += fmt::format(" {} {}", note.width, note.height);
    for (const std::string& line : note.lines) out_ += fmt::format(" \"{}\"", line);
    out_ += ";\n";
  }
  void put(const Layout& layout) {
    out_ += layout.owner.text.empty() ? "layout {\n" : "layout " + layout.owner.text + " {\n";
    for (const LayoutEntry& entry : layout.entries)
      out_ += fmt::format("{} {} {};\n", entry.node.text, entry.x, entry.y);
    for (const LayoutNote& note : layout.notes) put(note);
    out_ += "}\n";
  }

  std::string out_;
};

}  // namespace

std::string print(const Tree& tree) {
  return Printer().run(tree);
}

std::string print(const Expression& expression) {
  return Printer().run(expression);
}

}  // namespace mlab::cdl
