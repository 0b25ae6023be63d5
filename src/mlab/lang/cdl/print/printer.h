#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <fmt/core.h>

#include "mlab/lang/cdl/print/tightness.h"
#include "mlab/lang/cdl/syntax/signs.h"
#include "mlab/lang/cdl/syntax/tree.h"

namespace mlab::cdl {

/// Says the words of a tree one after the other: the grammar from the writer's side. Where they stand on
/// lines is a matter of `Out`, which has
///
///     void word(std::string_view text);   // of the language, or of a value
///     void word(const Word& word);        // that somebody chose, and perhaps wrote
///     void quoted(const Word& word);      // the same in quotes
///     void begin(const text::Place& at);  // the next word is the first of what stood there
///     bool has(const text::SourcePtr& source, text::Span whole);  // this stands there as it is to be
///     void take(const text::SourcePtr& source, text::Span whole);  // then its words are taken over
///     void line();                        // a line begins here
///     void paragraph();                   // and an empty one before it
///     void help(const std::string& help);  // of what begins here; empty: it has none
///     void begin_parameter(const std::string& help);  // its help stands behind it
///     void end_parameter();               // behind its comma
///     void separate();                    // the next one stands on a line of its own
///     std::optional<std::uint32_t> order(const text::Place& at);  // where it stands; nothing: it is new
///     std::optional<std::uint32_t> order_of_body(const Expression& body);
///     bool wants_semicolon(const Expression& body);  // a body behind which a block ends
template <class Out>
class Printer {
 public:
  explicit Printer(Out& out) : out_(out) {}

  void put(const Item& item) {
    std::visit(
        [this](const auto& one) {
          if (!take(source_of(one), one.whole)) put(one);
        },
        item);
  }

  void put(const Expression& expression) { put(expression, kAnything); }

 private:
  void say(const auto&... words) { (out_.word(words), ...); }

  bool take(const text::SourcePtr& source, text::Span whole) {
    if (!out_.has(source, whole)) return false;
    out_.take(source, whole);
    return true;
  }
  static const text::SourcePtr& source_of(const Use& use) { return use.path.place.source; }
  static const text::SourcePtr& source_of(const Layout& layout) { return layout.owner.place.source; }
  static const text::SourcePtr& source_of(const auto& one) { return one.name.place.source; }

  // ---- expressions

  void put(const Expression& expression, Tightness tightness) {
    const bool is_infix =
        std::holds_alternative<Logic>(expression.what) || std::holds_alternative<Arithmetic>(expression.what);
    const bool has_suffix = !expression.as.text.empty() || expression.active;
    // A number behind a sign is one number, and `2 m / s` a unit.
    const bool is_number = tightness == kNegated && std::holds_alternative<Number>(expression.what);
    const bool is_grouped = is_number || tightness > outermost(expression);
    if (!out_.has(expression.place.source, expression.whole)) {
      put_parts(expression, is_number || (is_infix && (has_suffix || is_grouped)));
      return;
    }
    const bool adds = is_grouped && expression.whole.begin == expression.place.span.begin;
    if (adds) out_.word("(");
    out_.take(expression.place.source, expression.whole);
    if (adds) out_.word(")");
  }

  void put_parts(const Expression& expression, bool is_grouped) {
    if (is_grouped) out_.word("(");
    out_.begin(expression.place);
    std::visit([this](const auto& what) { put(what); }, expression.what);
    if (is_grouped) out_.word(")");
    if (!expression.as.text.empty()) {
      say("as", expression.as);
    }
    if (!expression.active) return;
    out_.word("active");
    put(*expression.active, kSuffixed);
  }

  void put(const Hole& /*nothing stands there*/) {}
  void put(const Number& number) {
    out_.word(fmt::format("{}", number.value));
    if (!number.unit.text.empty()) out_.word(number.unit);
  }
  void put(const Text& text) { out_.word('"' + text.value + '"'); }
  void put(const Name& name) { out_.word(name.name); }
  void put(const List& list) {
    out_.word("[");
    for (std::size_t i = 0; i < list.items.size(); ++i) {
      if (i > 0) out_.word(",");
      put(*list.items[i]);
    }
    out_.word("]");
  }
  void put(const Call& call) {
    out_.word(call.callee);
    if (!call.has_parentheses && call.arguments.empty()) return;
    out_.word("(");
    for (std::size_t i = 0; i < call.arguments.size(); ++i) {
      if (i > 0) out_.word(",");
      put_set(call.arguments[i].name, *call.arguments[i].value);
    }
    out_.word(")");
  }
  // `name = value`, or the value alone.
  void put_set(const Word& name, const Expression& value) {
    if (!name.text.empty()) {
      say(name, "=");
    }
    put(value);
  }
  void put(const Logic& logic) {
    if (logic.connective == Connective::kNot) {
      out_.word("not");
      put(*logic.operands.front(), kInAnd);
      return;
    }
    const bool is_and = logic.connective == Connective::kAnd;
    for (std::size_t i = 0; i < logic.operands.size(); ++i) {
      if (i > 0) out_.word(is_and ? "and" : "or");
      put(*logic.operands[i], is_and ? kInAnd : kInOr);
    }
  }
  void put(const Arithmetic& arithmetic) {
    const auto& [operations, operands] = arithmetic;
    if (operations.empty() || operations.front() == Operation::kNegate) {
      out_.word("-");
      for (const ExpressionPtr& operand : operands) put(*operand, kNegated);
      return;
    }
    const Operation first = operations.front();
    const Tightness inside = first == Operation::kAdd || first == Operation::kSubtract      ? kInSum
                             : first == Operation::kMultiply || first == Operation::kDivide ? kInProduct
                                                                                            : kInComparison;
    for (std::size_t i = 0; i < operands.size(); ++i) {
      if (i > 0) out_.word(sign_of(operations[i - 1]));
      const bool is_divided = i < operations.size() && operations[i] == Operation::kDivide;
      put(*operands[i], is_divided && is_unit_of(*operands[i], *operands[i + 1]) ? kNegated : inside);
    }
  }
  void put(const Delay& delay) {
    say("delay", "(");
    put(*delay.value);
    if (delay.initial) {
      say(",", "initial", "=");
      put(*delay.initial);
    }
    out_.word(")");
  }

  // ---- blocks

  void open() {
    out_.word("{");
    out_.line();
  }
  void close() {
    out_.line();
    out_.word("}");
  }
  void end_statement() {
    out_.word(";");
    out_.line();
  }

  void put(const std::vector<Member>& members) {
    open();
    for (const Member& member : members) {
      out_.help(member.help);
      if (member.weight) {
        put(*member.weight);
        out_.word(":");
      }
      put(*member.value);
      end_statement();
    }
    close();
  }
  void put(const Cooperate& cooperate) {
    out_.word("cooperate");
    put(cooperate.members);
  }
  void put(const Compete& compete) {
    say("compete", "by");
    out_.word(
        Word{compete.rule == CompetitionRule::kPriority ? "priority" : "strength", compete.rule_word.place});
    put(compete.members);
  }
  void put(const Coordinate& coordinate) { put_by("coordinate", coordinate.by, coordinate.members); }
  void put(const Fuse& fuse) { put_by("fuse", fuse.by, fuse.members); }
  void put_by(const char* word, const Call& by, const std::vector<Member>& members) {
    say(word, "by");
    put(by);
    put(members);
  }
  void put(const Transition& transition) {
    out_.help(transition.help);
    out_.begin(transition.place);
    out_.word("when");
    put(*transition.trigger);
    say("goto", transition.target);
    if (transition.restarts) out_.word("restart");
    end_statement();
  }
  void put(const State& state) {
    if (take(state.name.place.source, state.whole)) {
      out_.line();
      return;
    }
    out_.help(state.help);
    if (state.is_start) out_.word("start");
    if (state.is_final) out_.word("final");
    say(state.name, ":");
    if (state.member) put(*state.member);
    end_statement();
    for (const Transition& transition : state.transitions) put(transition);
  }
  void put(const Sequence& sequence) {
    out_.word("sequence");
    open();
    for (const State& state : sequence.states) put(state);
    close();
  }
  void put(const Select& select) {
    say("select", "by");
    put(*select.by);
    open();
    for (const Case& one : select.cases) {
      out_.begin(one.place);
      out_.word(one.values.empty() ? "otherwise" : "case");
      for (std::size_t i = 0; i < one.values.size(); ++i) {
        if (i > 0) out_.word(",");
        out_.word(one.values[i]);
      }
      out_.word(":");
      put(*one.member);
      end_statement();
    }
    close();
  }

  // ---- parameters

  void put(const Parameter& parameter) {
    say(parameter.name, ":", parameter.type);
    if (!parameter.unit.text.empty()) {
      say("[", parameter.unit, "]");
    }
    if (parameter.initial) {
      out_.word("=");
      put(*parameter.initial);
    }
    if (!parameter.low || !parameter.high) return;
    out_.word("in");
    put_end(parameter, *parameter.low);
    out_.word("..");
    put_end(parameter, *parameter.high);
  }
  void put_end(const Parameter& parameter, const Number& end) {
    if (!take(parameter.name.place.source, end.whole)) put(end);
  }
  // With help each stands on a line of its own.
  void put(const std::vector<Parameter>& parameters) {
    const bool has_help = std::ranges::any_of(parameters, [](const Parameter& p) { return !p.help.empty(); });
    out_.word("(");
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      const Parameter& one = parameters[i];
      const bool is_last = i + 1 == parameters.size();
      const bool is_taken = take(one.name.place.source, one.whole);
      if (!is_taken) {
        out_.begin_parameter(one.help);
        put(one);
      }
      if (!is_last) out_.word(",");
      if (!is_taken) out_.end_parameter();
      if (has_help && !is_last) out_.separate();
    }
    out_.word(")");
  }
  void put_result_type(const Word& type) {
    if (type.text.empty()) return;
    say("->", type);
  }

  // ---- statements in the order in which they stand

  /// Statements of several kinds stand among each other as their author wrote them. What is new follows the
  /// one before it of its kind, or else those of the kinds before.
  class Statements {
   public:
    explicit Statements(Printer& printer, bool is_new_last = false)
        : printer_(printer), is_new_last_(is_new_last) {}
    template <class Kind>
    Statements& add(const std::vector<Kind>& all, const auto& place_of) {
      return add_at(all, [&](const Kind& one) { return printer_.out_.order(place_of(one)); });
    }
    template <class Kind>
    Statements& add_at(const std::vector<Kind>& all, const auto& order_of) {
      std::uint32_t key = last_;
      for (std::size_t i = 0; i < all.size(); ++i) {
        const std::optional<std::uint32_t> at = order_of(all[i]);
        if (at) key = i == 0 ? *at : std::max(key, *at);
        if (!at && is_new_last_) key = std::numeric_limits<std::uint32_t>::max();
        entries_.push_back({key, [this, one = &all[i]] { printer_.put(*one); }});
        last_ = std::max(last_, key);
      }
      return *this;
    }
    void put() {
      std::ranges::stable_sort(entries_, {}, &Entry::key);
      for (const Entry& entry : entries_) entry.put();
    }

   private:
    struct Entry {
      std::uint32_t key = 0;
      std::function<void()> put;
    };
    Printer& printer_;
    bool is_new_last_ = false;
    std::vector<Entry> entries_;
    std::uint32_t last_ = 0;
  };

  void put(const Let& let) {
    if (take(let.name.place.source, let.whole)) {
      out_.line();
      return;
    }
    out_.help(let.help);
    out_.word("let");
    put_set(let.name, *let.value);
    end_statement();
  }
  void put(const Word& alias) {
    out_.word("alias");
    out_.quoted(alias);
    end_statement();
  }
  void put(const Choice& choice) {
    say("use", choice.device, "for", choice.binding);
    end_statement();
  }
  void put(const Drive& drive) {
    put_set(drive.binding, *drive.value);
    end_statement();
  }
  void put(const BodySetting& setting) {
    put_set(setting.name, *setting.value);
    end_statement();
  }
  void put(const Device& device) {
    if (take(device.name.place.source, device.whole)) {
      out_.line();
      return;
    }
    out_.help(device.help);
    say(device.is_actuator ? "actuator" : "sensor", device.name, ":");
    put(device.by);
    say("binds", device.binds);
    end_statement();
  }

  // ---- declarations

  void put(const Use& use) {
    out_.word("use");
    out_.quoted(use.path);
    end_statement();
  }
  void put(const Architecture& architecture) {
    say("architecture", architecture.name);
    end_statement();
  }
  /// The body of an assemblage: no `;` has to follow where it ends in `}`.
  struct Body {
    const Expression* what = nullptr;
  };
  void put(const Body& body) {
    put(*body.what);
    if (out_.wants_semicolon(*body.what)) out_.word(";");
    out_.line();
  }
  void put(const Assemblage& assemblage) {
    out_.help(assemblage.help);
    say("assemblage", assemblage.name);
    put(assemblage.parameters);
    put_result_type(assemblage.result_type);
    if (!assemblage.body && assemblage.lets.empty() && assemblage.historic_names.empty() &&
        !assemblage.has_braces) {
      end_statement();
      return;
    }
    open();
    std::vector<Body> body;
    if (assemblage.body) body.push_back({assemblage.body.get()});
    Statements(*this)
        .add(assemblage.historic_names, [](const Word& word) { return word.place; })
        .add(assemblage.lets, [](const Let& let) { return let.name.place; })
        .add_at(body, [this](const Body& one) { return out_.order_of_body(*one.what); })
        .put();
    close();
    out_.line();
  }
  void put(const Binding& binding) {
    out_.help(binding.help);
    say("binding", binding.name);
    put(binding.parameters);
    put_result_type(binding.result_type);
    end_statement();
  }
  /// `body { ... }` of a class.
  struct Block {
    const std::vector<BodySetting>* settings = nullptr;
  };
  void put(const Block& block) {
    out_.word("body");
    open();
    for (const BodySetting& setting : *block.settings) put(setting);
    close();
    out_.line();
  }
  void put(const RobotClass& robot_class) {
    out_.help(robot_class.help);
    say("class", robot_class.name);
    if (robot_class.has_parentheses || !robot_class.parameters.empty()) put(robot_class.parameters);
    open();
    std::vector<Block> blocks;
    if (!robot_class.body.empty()) blocks.push_back({&robot_class.body});
    Statements(*this)
        .add(blocks, [](const Block& block) { return block.settings->front().name.place; })
        .add(robot_class.devices, [](const Device& device) { return device.name.place; })
        .put();
    close();
    out_.line();
  }
  void put(const Robot& robot) {
    out_.help(robot.help);
    say("robot", robot.name);
    if (robot.has_parentheses || !robot.parameters.empty()) put(robot.parameters);
    if (!robot.class_name.text.empty()) say("is", robot.class_name);
    open();
    Statements(*this)
        .add(robot.lets, [](const Let& let) { return let.name.place; })
        .add(robot.choices, [](const Choice& choice) { return choice.device.place; })
        .add(robot.drives, [](const Drive& drive) { return drive.binding.place; })
        .put();
    close();
    out_.line();
  }
  void put(const SocietyMember& member) {
    out_.begin(member.place);
    if (member.kind == SocietyMember::Kind::kTeam) {
      say("team", "of", fmt::format("{}", member.count), member.name);
    } else if (member.kind == SocietyMember::Kind::kName) {
      out_.word(member.name);
    } else {
      out_.word("caste");
      open();
      for (const SocietyMember& one : member.members) {
        put(one);
        end_statement();
      }
      close();
    }
    if (member.by.text.empty()) return;
    say("by", member.by);
  }
  void put(const Society& society) {
    out_.help(society.help);
    say("society", society.name, ":");
    put(society.what);
    end_statement();
  }
  void put(const SocietyOperator& op) {
    out_.help(op.help);
    say("operator", op.name);
    open();
    for (const Device& device : op.devices) {
      if (!take(device.name.place.source, device.whole)) {
        out_.help(device.help);
        say(device.binds, "=");
        put(device.by);
        out_.word(";");
      }
      out_.line();
    }
    close();
    out_.line();
  }

  // ---- tests

  void put(const TestStep& step) {
    if (take(step.place.source, step.whole)) {
      out_.line();
      return;
    }
    out_.help(step.help);
    out_.begin(step.place);
    if (step.kind == TestStep::Kind::kGiven || step.kind == TestStep::Kind::kGivenNo) {
      out_.word("given");
      if (step.kind == TestStep::Kind::kGivenNo) say("no", step.percept.callee);
      if (step.kind == TestStep::Kind::kGiven) put(step.percept);
    } else if (step.kind == TestStep::Kind::kAfter) {
      out_.word("after");
      put(step.span);
    } else {
      put_expectation(step);
    }
    end_statement();
  }
  void put_expectation(const TestStep& step) {
    out_.word("expect");
    if (step.when != TestStep::When::kNow) {
      out_.word(step.when == TestStep::When::kWithin ? "within" : "for");
      put(step.span);
      out_.word(":");
    }
    if (step.condition) put(*step.condition);
    if (step.is_negated) out_.word("no");
    if (step.about == TestStep::About::kState) say("state", step.fact);
    if (step.about == TestStep::About::kAction) say("action", step.fact);
  }
  void put(const Test& test) {
    out_.help(test.help);
    out_.word("test");
    out_.quoted(test.name);
    out_.word("of");
    if (test.subject) put(*test.subject);
    if (!test.class_name.text.empty()) say("on", test.class_name);
    open();
    Statements(*this)
        .add(test.lets, [](const Let& let) { return let.name.place; })
        .add(test.steps, [](const TestStep& step) { return step.place; })
        .put();
    close();
    out_.line();
  }

  // ---- layouts

  void put_numbers(std::initializer_list<double> numbers) {
    for (const double number : numbers) out_.word(fmt::format("{}", number));
  }
  void put(const LayoutEntry& entry) {
    if (!take(entry.node.place.source, entry.whole)) {
      out_.word(entry.node);
      put_numbers({entry.x, entry.y});
      out_.word(";");
    }
    out_.line();
  }
  void put(const LayoutNote& note) {
    if (!take(note.place.source, note.whole)) {
      out_.begin(note.place);
      out_.word(note.is_frame ? "frame" : "note");
      put_numbers({note.x, note.y});
      if (note.is_frame || note.width != 0.0 || note.height != 0.0 || note.lines.empty())
        put_numbers({note.width, note.height});
      for (const std::string& line : note.lines) out_.word('"' + line + '"');
      out_.word(";");
    }
    out_.line();
  }
  void put(const Layout& layout) {
    out_.word("layout");
    if (!layout.owner.text.empty()) out_.word(layout.owner);
    open();
    Statements(*this, true)
        .add(layout.entries, [](const LayoutEntry& entry) { return entry.node.place; })
        .add(layout.notes, [](const LayoutNote& note) { return note.place; })
        .put();
    close();
    out_.line();
  }

  Out& out_;
};

}  // namespace mlab::cdl
