// What a configuration consists of, as an editor asks for it: read out of the tree.

#include "mlab/assist/cdl_scan.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "mlab/base/overloaded.h"
#include "mlab/lang/cdl/lower/tests.h"
#include "mlab/lang/cdl/types/arithmetic.h"

namespace mlab::assist {
namespace {

using Kind = CdlWant::Kind;

std::string text_of(const std::optional<cdl::Number>& number) {
  if (!number) return "";
  return fmt::format("{}{}{}", number->value, number->unit.text.empty() ? "" : " ", number->unit.text);
}

class Collector {
 public:
  explicit Collector(const text::SourcePtr& source) {
    out_.source = source;
    out_.written = cdl::read_as_written(source);
    const std::vector<cdl::Token>& tokens = out_.written.tokens.tokens;
    end_ = tokens.back().span.begin;
    last_end_ = tokens.size() < 2 ? 0 : tokens[tokens.size() - 2].span.end;
  }

  CdlScan run() {
    for (const cdl::Item& item : out_.written.tree.items)
      std::visit([this](const auto& one) { add(one); }, item);
    for (const std::string& word : out_.written.next_words)
      want({.kind = Kind::kKeyword, .words = {as_offered(word)}});
    if (out_.written.ends_inside) out_.open_declaration = static_cast<int>(out_.declarations.size()) - 1;
    return std::move(out_);
  }

 private:
  // ---- where the text ends

  /// With what always follows.
  static std::string as_offered(const std::string& word) {
    return word == "team" ? "team of" : word == "otherwise" ? "otherwise: " : word;
  }
  void want(CdlWant one) { out_.wants.push_back(std::move(one)); }
  bool is_at_end(const text::Place& place) const { return place.source && place.span.begin >= end_; }
  /// Whether this is what should stand where the text ends.
  bool is_next(const cdl::Word& word) const { return word.text.empty() && is_at_end(word.place); }

  // ---- names

  CdlDeclaration& current() { return out_.declarations.back(); }

  /// @return  its index; -1 where it is missing
  int add_name(const cdl::Word& word, NameKind kind, bool is_declaration = false) {
    if (word.text.empty()) return -1;
    CdlName name;
    name.span = word.place.span;
    name.kind = kind;
    name.is_declaration = is_declaration;
    name.text = word.text;
    name.declaration = static_cast<int>(out_.declarations.size()) - 1;
    out_.names.push_back(std::move(name));
    return static_cast<int>(out_.names.size()) - 1;
  }
  CdlName& name_at(int i) { return out_.names[static_cast<std::size_t>(i)]; }

  /// A name that something else declares; where it is missing at the end, this is what could stand there.
  int use(const cdl::Word& word, NameKind kind, CdlWant wanted) {
    if (is_next(word)) want(std::move(wanted));
    return add_name(word, kind);
  }

  template <class Declaration>
  void declare(const Declaration& what, NameKind kind) {
    CdlDeclaration& one = out_.declarations.emplace_back();
    one.kind = kind;
    one.name = what.name.text;
    one.span = what.name.place.span;
    one.whole = what.whole;
    one.help = what.help;
    add_name(what.name, kind, true);
  }

  // ---- declarations

  void add(const cdl::Use& use) {
    if (is_next(use.path)) {
      want({.kind = Kind::kFile});
      return;
    }
    const text::Span quoted = use.path.place.span;
    out_.uses.push_back(
        {.span = {quoted.begin + 1, quoted.end - 1}, .kind = NameKind::kFile, .text = use.path.text});
  }

  void add(const cdl::Architecture& architecture) {
    use(architecture.name, NameKind::kArchitecture, {.kind = Kind::kKeyword, .words = {"AuRA", "UGV"}});
  }

  void add(const cdl::Assemblage& assemblage) {
    declare(assemblage, NameKind::kAssemblage);
    current().assemblage = &assemblage;
    parameters(assemblage.parameters);
    use(assemblage.result_type, NameKind::kType, {.kind = Kind::kType});
    current().result_type = assemblage.result_type.text;
    lets(assemblage.lets);
    expression(assemblage.body, {.type = value_type(assemblage.result_type.text, "")});
  }

  void add(const cdl::Binding& binding) {
    declare(binding, NameKind::kBinding);
    parameters(binding.parameters);
    use(binding.result_type, NameKind::kType, {.kind = Kind::kType});
    current().result_type = binding.result_type.text;
  }

  void add(const cdl::RobotClass& robot_class) {
    declare(robot_class, NameKind::kClass);
    parameters(robot_class.parameters);
    for (const cdl::BodySetting& setting : robot_class.body) {
      use(setting.name, NameKind::kBodySetting, {.kind = Kind::kBodySetting});
      expression(setting.value, {});
    }
    for (const cdl::Device& one : robot_class.devices) device(one);
  }

  void device(const cdl::Device& one) {
    add_name(one.name, NameKind::kDevice, true);
    service(one);
    use(one.binds, NameKind::kBinding, {.kind = Kind::kBinding});
    current().devices.push_back({one.name.text, one.name.place.span, one.whole, one.binds.text,
                                 one.by.callee.text, one.help, one.is_actuator});
  }

  void service(const cdl::Device& device) {
    if (is_next(device.by.callee)) want({.kind = Kind::kValue});
    call(device.by, {}, device.whole.end);
  }

  void add(const cdl::Robot& robot) {
    declare(robot, NameKind::kRobot);
    current().robot = &robot;
    parameters(robot.parameters);
    use(robot.class_name, NameKind::kClass, {.kind = Kind::kClass});
    current().class_name = robot.class_name.text;
    lets(robot.lets);
    for (const cdl::Choice& choice : robot.choices) {
      use(choice.device, NameKind::kDevice, {.kind = Kind::kDevice});
      use(choice.binding, NameKind::kBinding, {.kind = Kind::kBinding, .device = choice.device.text});
    }
    for (const cdl::Drive& drive : robot.drives) {
      use(drive.binding, NameKind::kBinding, {.kind = Kind::kActuator});
      expression(drive.value,
                 {.type = drive.binding.text == "movement" ? ValueType{"Vector", ""} : ValueType{}});
    }
  }

  void add(const cdl::SocietyOperator& op) {
    declare(op, NameKind::kOperator);
    for (const cdl::Device& one : op.devices) {
      use(one.binds, NameKind::kBinding, {.kind = Kind::kBinding});
      service(one);
    }
  }

  void add(const cdl::Society& society) {
    declare(society, NameKind::kSociety);
    member_of_society(society.what);
  }

  void member_of_society(const cdl::SocietyMember& member) {
    use(member.name, NameKind::kRobot, {.kind = Kind::kMember});
    for (const cdl::SocietyMember& one : member.members) member_of_society(one);
    use(member.by, NameKind::kOperator, {.kind = Kind::kSocietyOperator});
  }

  void add(const cdl::Test& test) {
    CdlDeclaration& one = out_.declarations.emplace_back();
    one.kind = NameKind::kTest;
    one.name = test.name.text;
    one.span = {test.name.place.span.begin + 1,
                std::max(test.name.place.span.begin + 1, test.name.place.span.end - 1)};
    one.whole = test.whole;
    one.help = test.help;
    const int subject = static_cast<int>(out_.names.size());
    expression(test.subject, {});
    const bool is_call = test.subject && std::holds_alternative<cdl::Call>(test.subject->what) &&
                         subject < static_cast<int>(out_.names.size());
    use(test.class_name, NameKind::kClass, {.kind = Kind::kClass});
    current().class_name = test.class_name.text;
    if (test.subject)
      current().lets.push_back({cdl::subject_name(test).text, test.subject->place.span,
                                test.subject->place.span, "", test.subject.get(), true});
    lets(test.lets);
    for (const cdl::TestStep& one_step : test.steps) step(one_step, is_call ? subject : -1);
  }

  /// @param subject  index of the callee that is tested; -1: it is none
  void step(const cdl::TestStep& step, int subject) {
    using About = cdl::TestStep::About;
    if (step.kind == cdl::TestStep::Kind::kAfter || step.when != cdl::TestStep::When::kNow) span(step.span);
    if (step.kind == cdl::TestStep::Kind::kGiven || step.kind == cdl::TestStep::Kind::kGivenNo) {
      percept(step.percept);
    } else if (step.kind == cdl::TestStep::Kind::kExpect && step.about == About::kCondition) {
      expression(step.condition, {.type = {"bool", ""}});
    } else if (step.about == About::kAction) {
      use(step.fact, NameKind::kPercept, {.kind = Kind::kAction});
    } else if (step.about == About::kState) {
      if (is_next(step.fact) && subject >= 0) want({.kind = Kind::kTestState, .wanted = {.call = subject}});
      state_of(subject, step.fact);
    }
  }

  void span(const cdl::Number& span) {
    if (is_next(span.unit)) want({.kind = Kind::kKeyword, .words = {"cycles"}});
    if (span.unit.text != "cycle" && span.unit.text != "cycles") number(span, {.type = {"double", "s"}});
  }

  /// Its inputs are no component's: their values are read, and their names are words.
  void percept(const cdl::Call& percept) {
    use(percept.callee, NameKind::kPercept, {.kind = Kind::kPercept});
    const cdl::TestPerceptInfo* const info = cdl::test_percept_named(percept.callee.text);
    std::size_t position = 0;
    for (const cdl::Argument& argument : percept.arguments) {
      const std::string& name = argument.name.text;
      CdlWanted wanted;
      for (std::size_t i = 0; info != nullptr && i < info->inputs.size(); ++i) {
        if (name.empty() ? i == position : name == info->inputs[i].name)
          wanted.type = value_type(std::string(info->inputs[i].type), "");
      }
      position += name.empty() ? 1 : 0;
      const bool could_be_name = name.empty() && info != nullptr && is_at_end(argument.value->place) &&
                                 std::holds_alternative<cdl::Hole>(argument.value->what);
      for (std::size_t i = position - 1; could_be_name && i < info->inputs.size(); ++i)
        want({.kind = Kind::kKeyword, .words = {std::string(info->inputs[i].name) + " = "}});
      expression(argument.value, wanted);
    }
  }

  /// The last name of `Outer.Inner`.
  void state_of(int subject, const cdl::Word& path) {
    const std::size_t dot = path.text.rfind('.');
    cdl::Word word = path;
    if (dot != std::string::npos) {
      word.text = path.text.substr(dot + 1);
      word.place.span.begin = word.place.span.end - static_cast<std::uint32_t>(word.text.size());
    }
    const int name = add_name(word, NameKind::kState);
    if (name >= 0) name_at(name).owner = subject;
  }

  void add(const cdl::Layout& layout) {
    if (is_next(layout.owner)) want({.kind = Kind::kOwner});
    const int owner = path(layout.owner, -1);
    const int page = owner < 0 ? -1 : static_cast<int>(out_.names.size()) - 1;
    for (const cdl::LayoutEntry& entry : layout.entries) {
      if (is_next(entry.node) && owner >= 0) want({.kind = Kind::kNode, .wanted = {.call = owner}});
      path(entry.node, owner, page);
    }
  }

  /// The names of `Searching.Noise`, one by one.
  /// @param before  index of the name that the first stands inside of
  /// @return  index of the first
  int path(const cdl::Word& path, int owner, int before = -1) {
    int first = -1;
    const std::string_view all = path.place.source ? out_.source->text(path.place.span) : std::string_view();
    const auto is_part = [](char c) {
      return cdl::is_name(std::string_view(&c, 1)) || (c >= '0' && c <= '9');
    };
    for (std::size_t i = 0; i < all.size();) {
      std::size_t end = i;
      while (end < all.size() && is_part(all[end])) ++end;
      if (end > i) {
        const auto begin = path.place.span.begin + static_cast<std::uint32_t>(i);
        const text::Span span{begin, begin + static_cast<std::uint32_t>(end - i)};
        const int at =
            add_name({std::string(all.substr(i, end - i)), {path.place.source, span}}, NameKind::kNode);
        name_at(at).owner = owner >= 0 ? owner : first;
        name_at(at).declaration = -1;
        name_at(at).before = before;
        before = at;
        first = first < 0 ? at : first;
      }
      i = std::max(end, i + 1);
    }
    if (path.text.ends_with('.') && path.place.span.end == last_end_)
      want({.kind = Kind::kNode, .wanted = {.call = owner >= 0 ? owner : first}});
    return first;
  }

  void parameters(const std::vector<cdl::Parameter>& parameters) {
    for (const cdl::Parameter& one : parameters) parameter(one);
  }

  void parameter(const cdl::Parameter& parameter) {
    CdlParameter one;
    one.span = parameter.name.place.span;
    one.whole = parameter.whole;
    one.input.name = parameter.name.text;
    one.input.type = parameter.type.text;
    one.input.unit = parameter.unit.text;
    one.input.help = parameter.help;
    one.input.value = value_type(one.input.type, one.input.unit);
    one.input.low = text_of(parameter.low);
    one.input.high = text_of(parameter.high);
    if (parameter.initial) one.input.initial = out_.source->text(parameter.initial->place.span);
    const CdlWanted wanted{.type = one.input.value};
    add_name(parameter.name, NameKind::kParameter, true);
    use(parameter.type, NameKind::kType, {.kind = Kind::kType});
    use(parameter.unit, NameKind::kUnit, {.kind = Kind::kUnitName});
    expression(parameter.initial, wanted);
    if (parameter.low) number(*parameter.low, wanted);
    if (parameter.high) number(*parameter.high, wanted);
    current().parameters.push_back(std::move(one));
  }

  void lets(const std::vector<cdl::Let>& lets) {
    for (const cdl::Let& let : lets) {
      add_name(let.name, NameKind::kLet, true);
      expression(let.value, {});
      current().lets.push_back({let.name.text, let.name.place.span, let.whole, let.help, let.value.get()});
    }
  }

  // ---- expressions

  void expression(const cdl::ExpressionPtr& one, const CdlWanted& wanted) {
    if (!one) return;
    literal(*one, wanted);
    std::visit(base::Overloaded{
                   [&](const cdl::Hole&) {
                     if (is_at_end(one->place)) want({.kind = Kind::kValue, .wanted = wanted});
                   },
                   [&](const cdl::Number& number) { this->number(number, wanted); },
                   [](const cdl::Text&) {},
                   [&](const cdl::Name& name) { named(name.name, wanted); },
                   [&](const cdl::List& list) { this->list(list, wanted); },
                   [&](const cdl::Call& call) { this->call(call, wanted, one->place.span.end); },
                   [&](const cdl::Logic& logic) {
                     for (const cdl::ExpressionPtr& operand : logic.operands)
                       expression(operand, {.type = {"bool", ""}});
                   },
                   [&](const cdl::Arithmetic& arithmetic) {
                     current().formulas.push_back(one.get());
                     for (const cdl::ExpressionPtr& operand : arithmetic.operands) expression(operand, {});
                   },
                   [&](const cdl::Cooperate& what) { members(what.members); },
                   [&](const cdl::Compete& what) { members(what.members); },
                   [&](const cdl::Coordinate& what) {
                     by_operator(what, {"Vector", ""}, wanted, one->place.span.end);
                   },
                   [&](const cdl::Fuse& what) { by_operator(what, {}, wanted, one->place.span.end); },
                   [&](const cdl::Sequence& what) { sequence(what, one->place.span.begin, wanted); },
                   [&](const cdl::Select& what) { select(what, wanted); },
                   [&](const cdl::Delay& what) { delay(what, wanted); },
               },
               one->what);
    if (add_name(one->as, NameKind::kNode, true) >= 0)
      current().nodes.push_back({one->as.text, one->as.place.span, one.get()});
    expression(one->active, {});
  }

  void literal(const cdl::Expression& one, const CdlWanted& wanted) {
    const auto* number = std::get_if<cdl::Number>(&one.what);
    const bool is_literal = number != nullptr || std::holds_alternative<cdl::Text>(one.what) ||
                            std::holds_alternative<cdl::List>(one.what);
    if (is_literal && wanted.call >= 0 && !wanted.in_list)
      out_.literals.push_back({one.place.span, wanted, number != nullptr && number->unit.text.empty()});
  }

  void number(const cdl::Number& number, const CdlWanted& wanted) {
    const int unit = use(number.unit, NameKind::kUnit, {.kind = Kind::kUnit, .wanted = wanted});
    if (unit >= 0) name_at(unit).wanted = wanted;
  }

  void named(const cdl::Word& word, const CdlWanted& wanted) {
    CdlName& name = name_at(add_name(word, NameKind::kWord));
    name.is_value = true;
    name.wanted = wanted;
  }

  void list(const cdl::List& list, const CdlWanted& wanted) {
    CdlWanted inner = wanted;
    inner.in_list = true;
    if (inner.call < 0 && (inner.type.type == "Vector" || inner.type.type == "Point"))
      inner.type = {"double", inner.type.unit};
    for (const cdl::ExpressionPtr& item : list.items) expression(item, inner);
  }

  /// @param end  of the call in the text
  void call(const cdl::Call& call, const CdlWanted& wanted, std::uint32_t end) {
    const int callee = add_name(call.callee, NameKind::kProcedure);
    if (callee < 0) return;
    name_at(callee).wanted = wanted;
    place(call);
    CdlWant next{.kind = Kind::kArgument, .wanted = {.call = callee}};
    const bool is_open = !call.is_closed && end == last_end_;
    if (is_open) out_.open_calls.push_back({callee, 0, ""});
    const std::size_t open = out_.open_calls.size();
    for (const cdl::Argument& argument : call.arguments) {
      const std::string& given = argument.name.text;
      next.wanted.position = next.positional;
      if (is_open) {
        out_.open_calls[open - 1].position = next.positional;
        out_.open_calls[open - 1].argument = given;
      }
      CdlWanted value = next.wanted;
      value.argument = given;
      if (!given.empty()) {
        next.given.insert(given);
        name_at(add_name(argument.name, NameKind::kArgument)).wanted = value;
      } else if (std::holds_alternative<cdl::Hole>(argument.value->what) &&
                 is_at_end(argument.value->place)) {
        want(next);
        continue;
      } else if (next.given.empty()) {
        ++next.positional;
      }
      expression(argument.value, value);
    }
  }

  /// `place("Pond")`: a text that names something.
  void place(const cdl::Call& call) {
    if (call.callee.text != cdl::kPlaceFunction || call.arguments.size() != 1) return;
    const cdl::Expression& argument = *call.arguments.front().value;
    const auto* const text = std::get_if<cdl::Text>(&argument.what);
    if (text == nullptr || text->value.empty()) return;
    const text::Span quoted = argument.place.span;
    const text::Span bare{quoted.begin + 1, quoted.end - 1};
    if (quoted.end < quoted.begin + 2 || out_.source->text(bare) != text->value) return;
    out_.places.push_back({.span = bare, .kind = NameKind::kPlace, .text = text->value});
  }

  void members(const std::vector<cdl::Member>& members, const ValueType& type = {"Vector", ""}) {
    for (const cdl::Member& member : members) {
      expression(member.weight, {.type = type});
      expression(member.value, {.type = type});
    }
  }

  template <class Operator>
  void by_operator(const Operator& what, const ValueType& type, const CdlWanted& wanted, std::uint32_t end) {
    if (is_next(what.by.callee)) want({.kind = Kind::kOperator});
    call(what.by, wanted, end);
    members(what.members, type);
  }

  void sequence(const cdl::Sequence& sequence, std::uint32_t begin, const CdlWanted& wanted) {
    for (const cdl::State& state : sequence.states) {
      name_at(add_name(state.name, NameKind::kState, true)).sequence = begin;
      expression(state.member, wanted);
      for (const cdl::Transition& transition : state.transitions) {
        expression(transition.trigger, {.type = {"bool", ""}});
        const int target =
            use(transition.target, NameKind::kState, {.kind = Kind::kState, .sequence = begin});
        if (target >= 0) name_at(target).sequence = begin;
      }
      current().states.push_back({state.name.text, state.name.place.span, state.whole, state.help, begin,
                                  state.is_start, state.is_final});
    }
  }

  void select(const cdl::Select& select, const CdlWanted& wanted) {
    expression(select.by, {});
    for (const cdl::Case& one : select.cases) {
      for (const cdl::Word& value : one.values) {
        if (is_next(value)) want({.kind = Kind::kCaseValue, .selector = select.by.get()});
        if (cdl::is_name(value.text)) add_name(value, NameKind::kWord);
      }
      expression(one.member, wanted);
    }
  }

  void delay(const cdl::Delay& delay, const CdlWanted& wanted) {
    expression(delay.value, wanted);
    const bool is_next_argument = delay.initial && std::holds_alternative<cdl::Hole>(delay.initial->what) &&
                                  is_at_end(delay.initial->place) && last_end_ > 0 &&
                                  out_.source->text()[last_end_ - 1] == ',';
    if (is_next_argument) {
      want({.kind = Kind::kKeyword, .words = {"initial = "}});
    } else {
      expression(delay.initial, wanted);
    }
  }

  CdlScan out_;
  std::uint32_t end_ = 0;       // where the text ends
  std::uint32_t last_end_ = 0;  // and its last token
};

}  // namespace

CdlScan scan_cdl(const text::SourcePtr& source) {
  return Collector(source).run();
}

}  // namespace mlab::assist
