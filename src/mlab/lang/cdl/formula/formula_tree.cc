// Sentences of G as configurations.

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>

#include <fmt/core.h>

#include "mlab/lang/cdl/formula/formula.h"
#include "mlab/lang/cdl/formula/formula_parser.h"

namespace mlab::cdl {
namespace {

using Instance = std::pair<Symbol, int>;

// The instance that a term stands for: a behavior is known by its motor process.
std::optional<Instance> instance_of(const Term& term) {
  if (term.symbol == Symbol::kRobot || (term.symbol == Symbol::kPercept && term.number == 0))
    return std::nullopt;
  if (term.symbol != Symbol::kBehavior) return Instance{term.symbol, term.number};
  const Term& last = term.members.back();
  if (last.symbol == Symbol::kMotor) return Instance{Symbol::kMotor, last.number};
  return std::nullopt;
}

bool equal(const Term& a, const Term& b) {
  return a.symbol == b.symbol && a.number == b.number && std::ranges::equal(a.members, b.members, equal);
}

std::string written(const Instance& instance) {
  return fmt::format("{}{}", info(instance.first).letter, instance.second);
}

class Checker {
 public:
  explicit Checker(text::Diagnostics& sink) : sink_(sink) {}

  bool run(const std::vector<Term>& sentences) {
    for (const Term& sentence : sentences) {
      sentence_ = &sentence;
      check_society(sentence);
    }
    return !failed_;
  }

 private:
  struct Use {
    const Term* term = nullptr;
    const Term* robot = nullptr;  // null: a society
    const Term* sentence = nullptr;
  };

  void check_society(const Term& term) {
    if (term.symbol == Symbol::kRobot) {
      robot_ = &term;
      check(term, false);
      return;
    }
    note(term, {term.symbol, term.number}, nullptr);
    if (term.symbol == Symbol::kCaste) {
      for (const Term& member : term.members) check_society(member);
      return;
    }
    for (const Term& member : term.members) {
      if (equal(member, term.members.front())) continue;
      if (failed_) return;
      text::Diagnostic& d =
          fail("unlike-team", member, fmt::format("the members of team `*{}` differ", term.number));
      d.label = "this is not like the first";
      d.notes.push_back({"the first is here", term.members.front().place});
      d.hints = {"a caste, `'/1 ...'`, is of different ones"};
    }
    check_society(term.members.front());
  }

  void check(const Term& term, bool is_motor_of_behavior) {
    if (const auto instance = instance_of(term); instance && !is_motor_of_behavior)
      note(term, *instance, robot_);
    for (const Term& member : term.members)
      check(member, term.symbol == Symbol::kBehavior && member.symbol == Symbol::kMotor);
  }

  static bool is_same_robot(const Term* a, const Term* b) {
    return a == b || (a != nullptr && b != nullptr && equal(*a, *b));
  }

  void note(const Term& term, const Instance& instance, const Term* robot) {
    const auto [it, is_new] = uses_.try_emplace(instance, Use{&term, robot, sentence_});
    const Use& first = it->second;
    if (is_new || failed_) return;
    if (!equal(*first.term, term)) {
      fail("two-meanings", term, fmt::format("`{}` stands for two different things", written(instance)))
          .hints = {"an instance may be used several times, each time alike; another one has another number"};
    } else if (first.sentence != sentence_ || !is_same_robot(first.robot, robot)) {
      fail("instance-of-another-robot", term,
           fmt::format("`{}` is an instance of another robot", written(instance)))
          .hints = {"robots share no instances: give this one a number of its own"};
    } else {
      return;
    }
    text::Diagnostic& d = *last_;
    d.notes.push_back({"it stands there first", first.term->place});
  }

  text::Diagnostic& fail(const char* kind, const Term& term, std::string message) {
    failed_ = true;
    last_ = &sink_.error(kind, term.place, std::move(message));
    return *last_;
  }

  text::Diagnostics& sink_;
  std::map<Instance, Use> uses_;
  text::Diagnostic* last_ = nullptr;
  const Term* robot_ = nullptr;
  const Term* sentence_ = nullptr;
  bool failed_ = false;
};

ExpressionPtr expression(Expression what, const text::Place& place) {
  what.place = place;
  return std::make_shared<const Expression>(std::move(what));
}

class Builder {
 public:
  Tree run(const text::SourcePtr& source, const std::vector<Term>& sentences) {
    tree_.source = source;
    declare_robot_class();
    for (const Term& sentence : sentences) {
      societies_.clear();
      society(sentence);
    }
    return std::move(tree_);
  }

 private:
  // One actuator is enough: G does not tell them apart. Its input is called as that of the library's Drive.
  void declare_robot_class() {
    Binding movement;
    movement.name.text = "movement";
    movement.parameters.push_back({{"v", {}}, {"Vector", {}}, {}, nullptr, {}, {}, {}});
    tree_.items.emplace_back(std::move(movement));
    RobotClass robot_class;
    robot_class.name.text = "FormulaRobot";
    Device base;
    base.is_actuator = true;
    base.name.text = "base";
    base.by.callee.text = "Drive";
    base.binds.text = "movement";
    robot_class.devices.push_back(std::move(base));
    tree_.items.emplace_back(std::move(robot_class));
  }

  std::string society(const Term& term) {
    for (const auto& [known, name] : societies_) {
      if (equal(*known, term)) return name;
    }
    std::string name = term.symbol == Symbol::kRobot ? robot(term) : society_of(term);
    societies_.emplace_back(&term, name);
    return name;
  }

  std::string society_of(const Term& term) {
    Society out;
    out.name = {instance_name(term.symbol, term.number), term.place};
    out.what.place = term.place;
    if (term.symbol == Symbol::kTeam) {
      out.what.kind = SocietyMember::Kind::kTeam;
      out.what.count = static_cast<int>(term.members.size());
      out.what.name = {society(term.members.front()), term.members.front().place};
    } else {
      out.what.kind = SocietyMember::Kind::kCaste;
      for (const Term& member : term.members) {
        SocietyMember one;
        one.name = {society(member), member.place};
        one.place = member.place;
        out.what.members.push_back(std::move(one));
      }
    }
    std::string name = out.name.text;
    tree_.items.emplace_back(std::move(out));
    return name;
  }

  void count(const Term& term) {
    const auto instance = instance_of(term);
    const bool is_known = instance && ++counts_[*instance] > 1;
    if (is_known) return;  // what stands in it is one with it
    for (const Term& member : term.members) {
      if (term.symbol != Symbol::kBehavior || member.symbol != Symbol::kMotor) count(member);
    }
  }

  std::string robot(const Term& term) {
    counts_.clear();
    lets_.clear();
    Robot out;
    out.name = {fmt::format("Robot{}", ++robots_), term.place};
    out.class_name = {"FormulaRobot", term.place};
    robot_ = &out;
    count(term.members.front());
    ExpressionPtr value = any(term.members.front());
    if (value) out.drives.push_back({{"movement", term.place}, std::move(value)});
    std::string name = out.name.text;
    tree_.items.emplace_back(std::move(out));
    return name;
  }

  // The value of a term; null for the empty percept alone.
  ExpressionPtr any(const Term& term) {
    const auto instance = instance_of(term);
    if (!instance || counts_[*instance] < 2) return made(term);
    const Word name{"the_" + instance_name(instance->first, instance->second), term.place};
    if (lets_.insert(*instance).second) {
      Let let;
      let.name = name;
      let.value = made(term);
      robot_->lets.push_back(std::move(let));
    }
    return expression({Name{name}, {}, nullptr, {}}, term.place);
  }

  ExpressionPtr made(const Term& term) {
    switch (term.symbol) {
      case Symbol::kBehavior:
        return behavior(term);
      case Symbol::kCooperation:
        return expression({Cooperate{members(term)}, as(term), nullptr, {}}, term.place);
      case Symbol::kCompetition:
        return expression(
            {Compete{CompetitionRule::kPriority, {"priority", {}}, members(term)}, as(term), nullptr, {}},
            term.place);
      case Symbol::kSequencing:
      case Symbol::kPerceptualSequencing:
        return sequence(term);
      case Symbol::kCoordination:
      case Symbol::kFusion:
        return call(term.symbol, term.number, values(term), term.place);
      default:
        return term.number == 0 ? nullptr : call(term.symbol, term.number, {}, term.place);
    }
  }

  ExpressionPtr behavior(const Term& term) {
    const bool has_active = term.members.front().symbol == Symbol::kActive;
    const Term& percept = term.members[has_active ? 1 : 0];
    const Term& last = term.members.back();
    ExpressionPtr value = any(percept);
    if (last.symbol == Symbol::kMotor) {
      std::vector<ExpressionPtr> inputs;
      if (value) inputs.push_back(std::move(value));
      value = call(Symbol::kMotor, last.number, inputs, last.place);
    }
    if (!has_active) return value;
    const Term& active = term.members.front();
    Expression out = value ? *value : *call(Symbol::kPercept, 0, {}, term.place);
    out.active = any(active);
    return expression(std::move(out), term.place);
  }

  static Word as(const Term& term) { return {instance_name(term.symbol, term.number), term.place}; }

  std::vector<ExpressionPtr> values(const Term& term) {
    std::vector<ExpressionPtr> out;
    for (const Term& member : term.members) out.push_back(value_or_empty(member));
    return out;
  }
  std::vector<Member> members(const Term& term) {
    std::vector<Member> out;
    for (const Term& member : term.members) out.push_back({nullptr, value_or_empty(member), {}});
    return out;
  }
  ExpressionPtr value_or_empty(const Term& term) {
    ExpressionPtr out = any(term);
    return out ? out : call(Symbol::kPercept, 0, {}, term.place);
  }

  ExpressionPtr sequence(const Term& term) {
    Sequence out;
    for (std::size_t i = 0; i < term.members.size(); ++i) {
      State state;
      state.name = {fmt::format("s{}", i + 1), term.members[i].place};
      state.place = term.members[i].place;
      state.is_start = i == 0;
      state.member = value_or_empty(term.members[i]);
      Transition next;
      next.trigger =
          expression({Call{{"advance", term.members[i].place}, {}}, {}, nullptr, {}}, term.members[i].place);
      next.target = {fmt::format("s{}", (i + 1) % term.members.size() + 1), term.members[i].place};
      next.place = term.members[i].place;
      state.transitions.push_back(std::move(next));
      out.states.push_back(std::move(state));
    }
    if (!has_advance_)
      declare("advance", 0, "bool", "true when a sequence is to go on; the sentence does not say when",
              term.place);
    has_advance_ = true;
    return expression({std::move(out), as(term), nullptr, {}}, term.place);
  }

  ExpressionPtr call(Symbol symbol, int number, const std::vector<ExpressionPtr>& inputs,
                     const text::Place& place) {
    Call out;
    out.callee = {instance_name(symbol, number), place};
    for (const ExpressionPtr& input : inputs) out.arguments.push_back({{}, input});
    if (declared_.insert({symbol, number}).second)
      declare(out.callee.text, inputs.size(), "Vector", "", place);
    return expression({std::move(out), {}, nullptr, {}}, place);
  }

  void declare(const std::string& name, std::size_t inputs, const char* type, const char* help,
               const text::Place& place) {
    Assemblage out;
    out.name = {name, place};
    out.help = help;
    out.result_type = {type, place};
    for (std::size_t i = 0; i < inputs; ++i) {
      Parameter input;
      input.name = {inputs == 1 ? std::string("percept") : fmt::format("member{}", i + 1), place};
      input.type = {"Vector", place};
      out.parameters.push_back(std::move(input));
    }
    tree_.items.emplace_back(std::move(out));
  }

  Tree tree_;
  Robot* robot_ = nullptr;
  int robots_ = 0;
  bool has_advance_ = false;
  std::vector<std::pair<const Term*, std::string>> societies_;
  std::set<Instance> declared_;
  std::map<Instance, int> counts_;
  std::set<Instance> lets_;
};

}  // namespace

bool check_sentences(const std::vector<Term>& sentences, text::Diagnostics& sink) {
  return Checker(sink).run(sentences);
}

Tree parse_formula(const text::SourcePtr& source, text::Diagnostics& sink) {
  const std::vector<Term> sentences = parse_sentences(source, sink);
  if (!check_sentences(sentences, sink) || sentences.empty()) {
    Tree empty;
    empty.source = source;
    return empty;
  }
  return Builder().run(source, sentences);
}

}  // namespace mlab::cdl
