#include "mlab/lang/cdl/formula/formula.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include <fmt/core.h>

#include "mlab/lang/cdl/formula/formula_parts.h"
#include "mlab/lang/cdl/formula/formula_term.h"

namespace mlab::cdl {
namespace {

constexpr std::size_t kMaxText = std::size_t{16} << 20;

class Writer {
 public:
  Writer(const Configuration& configuration, const flow::Library& library, text::Diagnostics& sink)
      : configuration_(configuration), parts_(configuration, library, sink), sink_(sink) {}

  Formula run() {
    std::vector<Term> sentences;
    for (const auto& tree : configuration_.trees) {
      for (const Item& item : tree->items) collect_references(item);
    }
    for (const auto& tree : configuration_.trees) {
      for (const Item& item : tree->items) {
        if (const auto* robot = std::get_if<Robot>(&item);
            robot != nullptr && !referenced_.contains(robot->name.text))
          sentences.push_back(robot_term(*robot));
        if (const auto* one = std::get_if<Society>(&item);
            one != nullptr && !referenced_.contains(one->name.text))
          sentences.push_back(society_term(one->what, one->name.text));
      }
    }
    if (sink_.has_errors()) return {};
    if (sentences.empty()) {
      sink_.error("no-robot", {configuration_.source, {0, 0}}, "there is no robot to write a sentence of")
          .hints = {
          "a sentence of the grammar is of a robot or of a society: `robot NAME { movement = ...; }`"};
      return {};
    }
    for (Term& sentence : sentences) number(sentence);
    for (const Term& sentence : sentences) {
      std::string text = print(sentence);
      length_ += text.size();
      out_.sentences.push_back(std::move(text));
    }
    return std::move(out_);
  }

 private:
  // What an instance is, until all of them have numbers: `Term::number` is an index into `instances_`.
  struct Instance {
    Symbol symbol;
    std::string name;
    std::string what;
    std::string owner;
    int number = 0;
  };

  void collect_references(const Item& item) {
    if (const auto* society = std::get_if<Society>(&item)) collect_names(society->what);
  }
  void collect_names(const SocietyMember& member) {
    if (!member.name.text.empty()) referenced_.insert(member.name.text);
    for (const SocietyMember& one : member.members) collect_names(one);
  }

  // One part may have several roles, each an instance: what it is, what its inputs make together, ...
  enum Role { kItself, kInputs, kBeside, kPercepts, kActivePart };
  int instance(const void* key, Role role, Symbol symbol, const std::string& name, const std::string& what,
               const std::string& owner) {
    const auto [it, is_new] = index_.try_emplace({key, role}, static_cast<int>(instances_.size()));
    if (is_new) instances_.push_back({symbol, name, what, owner, 0});
    return it->second;
  }
  Term term(Symbol symbol, const Part& part, Role role, const std::string& what) {
    Term out;
    out.symbol = symbol;
    out.number = instance(part.origin == nullptr ? &part : part.origin, role, symbol,
                          role == kItself || role == kActivePart ? part.name : "", what, part.owner);
    return out;
  }
  // An operator with one member is the member, one with none the empty percept.
  Term grouped(Term op, std::vector<Term> members) {
    if (members.size() == 1) return std::move(members.front());
    op.members = std::move(members);
    return op;
  }
  static Term empty_percept() {
    Term out;
    out.number = -1;
    return out;
  }
  static Term behavior(std::vector<Term> members) {
    Term out;
    out.symbol = Symbol::kBehavior;
    out.members = std::move(members);
    return out;
  }

  Term society_term(const SocietyMember& member, const std::string& name) {
    if (++society_depth_ > 100) {
      sink_.error("nested-too-deep", member.place, "societies stand in each other too deep, or in a circle");
      --society_depth_;
      return empty_percept();
    }
    Term out = society_of(member, name);
    --society_depth_;
    return out;
  }
  Term society_of(const SocietyMember& member, const std::string& name) {
    if (member.kind == SocietyMember::Kind::kName) return named_term(member.name);
    Term out;
    const bool is_team = member.kind == SocietyMember::Kind::kTeam;
    out.symbol = is_team ? Symbol::kTeam : Symbol::kCaste;
    std::string what =
        is_team ? fmt::format("team of {} {}", member.count, member.name.text) : std::string("caste");
    if (!member.by.text.empty()) what += " by " + member.by.text;
    out.number = instance(&member, kItself, out.symbol, name, what, name);
    if (is_team) {
      const Term one = named_term(member.name);
      for (int i = 0; i < member.count && !is_too_long(); ++i) {
        out.members.push_back(one);
        length_ += 64;
      }
    } else {
      for (const SocietyMember& one : member.members) out.members.push_back(society_term(one, ""));
    }
    if (out.members.size() == 1) return std::move(out.members.front());
    return out;
  }
  Term named_term(const Word& name) {
    if (const auto found = configuration_.robots.find(name.text); found != configuration_.robots.end())
      return robot_term(*found->second);
    if (const auto found = configuration_.societies.find(name.text); found != configuration_.societies.end())
      return society_term(found->second->what, name.text);
    sink_.error("unknown-robot", name.place, fmt::format("unknown robot or society `{}`", name.text));
    return empty_percept();
  }

  Term robot_term(const Robot& robot) {
    if (const auto found = robots_.find(&robot); found != robots_.end()) return found->second;
    Term out;
    out.symbol = Symbol::kRobot;
    std::vector<Term> driven;
    for (const Part* part : parts_.robot(robot)) driven.push_back(assemblage(*part));
    if (driven.empty()) driven.push_back(behavior({empty_percept()}));
    Term op;
    op.symbol = Symbol::kCoordination;
    if (driven.size() > 1)
      op.number = instance(&robot, kItself, op.symbol, "", "the robot's actuators", robot.name.text);
    out.members.push_back(grouped(std::move(op), std::move(driven)));
    robots_.emplace(&robot, out);
    return out;
  }

  Term assemblage(const Part& part) {
    length_ += 4;
    if (is_too_long()) return behavior({empty_percept()});
    if (!part.moves) return perceiving(part);
    std::vector<Term> moving;
    std::vector<const Part*> perceived;
    for (const Part* member : part.members) {
      if (part.kind != Part::Kind::kProcess || member->moves)
        moving.push_back(assemblage(*member));
      else
        perceived.push_back(member);
    }
    if (moving.empty()) return primitive(part, perceived);
    Term out = grouped(term(operator_of(part), part, kItself, part.what), std::move(moving));
    if (part.active == nullptr) return out;
    Term both = term(Symbol::kCoordination, part, kBeside, "an active part beside its assemblage");
    both.members.push_back(std::move(out));
    both.members.push_back(behavior({active(*part.active), percept_of(*part.active)}));
    return both;
  }

  bool is_too_long() {
    if (length_ > kMaxText && !sink_.has_errors())
      sink_.error("formula-too-long", {},
                  "the sentence is longer than 16 MiB: what has many readers stands there often");
    return length_ > kMaxText;
  }

  static Symbol operator_of(const Part& part) {
    switch (part.kind) {
      case Part::Kind::kCooperation:
        return Symbol::kCooperation;
      case Part::Kind::kCompetition:
        return Symbol::kCompetition;
      case Part::Kind::kSequencing:
        return Symbol::kSequencing;
      default:
        return Symbol::kCoordination;
    }
  }

  // <P> or <a P>
  Term perceiving(const Part& part) {
    if (part.active == nullptr) return behavior({percept(part)});
    return behavior({active(*part.active), with_inputs_of(part.active, {&part}, part)});
  }
  // <P m> or <a P m>
  Term primitive(const Part& part, const std::vector<const Part*>& perceived) {
    Term motor = term(Symbol::kMotor, part, kItself, part.what);
    if (part.active == nullptr) return behavior({fusion_of(part, perceived), std::move(motor)});
    return behavior({active(*part.active), with_inputs_of(part.active, perceived, part), std::move(motor)});
  }
  Term active(const Part& part) { return term(Symbol::kActive, part, kActivePart, part.what); }
  Term percept_of(const Part& active) { return fusion_of(active, active.members); }
  // What the active part perceives goes with what the behavior does.
  Term with_inputs_of(const Part* active, std::vector<const Part*> perceived, const Part& part) {
    for (const Part* input : active->members) {
      if (std::ranges::find(perceived, input) == perceived.end()) perceived.push_back(input);
    }
    return fusion_of(part, perceived);
  }

  Term fusion_of(const Part& part, const std::vector<const Part*>& inputs) {
    std::vector<Term> terms = percepts(inputs);
    if (terms.empty()) return empty_percept();
    if (terms.size() == 1) return std::move(terms.front());
    return grouped(term(Symbol::kFusion, part, kInputs, "inputs of " + part.what), std::move(terms));
  }

  // Each once, and nothing empty.
  std::vector<Term> percepts(const std::vector<const Part*>& inputs) {
    std::vector<Term> out;
    for (const Part* input : inputs) {
      Term one = percept(*input);
      if (one.number < 0) continue;
      const bool is_there = std::ranges::any_of(
          out, [&](const Term& other) { return other.symbol == one.symbol && other.number == one.number; });
      if (!is_there) out.push_back(std::move(one));
    }
    return out;
  }

  Term percept(const Part& part) {
    length_ += 4;
    const bool is_empty = part.kind == Part::Kind::kProcess && part.what == "p0" && part.members.empty();
    if (is_empty || is_too_long()) return empty_percept();
    if (part.moves) return fused(part, kPercepts, percepts(part.members));
    if (part.kind == Part::Kind::kProcess && part.members.empty())
      return term(Symbol::kPercept, part, kItself, part.what);
    if (part.kind == Part::Kind::kProcess) return fused(part, kItself, percepts(part.members));
    // The author lists these: the same may stand there twice.
    std::vector<Term> terms;
    for (const Part* member : part.members) terms.push_back(percept(*member));
    const bool is_fusion = part.kind == Part::Kind::kFusion;
    return grouped(
        term(is_fusion ? Symbol::kFusion : Symbol::kPerceptualSequencing, part, kItself, part.what),
        std::move(terms));
  }
  Term fused(const Part& part, Role role, std::vector<Term> terms) {
    if (terms.empty()) return empty_percept();
    if (terms.size() == 1) return std::move(terms.front());
    return grouped(term(Symbol::kFusion, part, role, part.what), std::move(terms));
  }

  // Numbers in the order of the sentence; those that a name asks for first.
  void reserve() {
    for (Instance& one : instances_) {
      const auto wanted = instance_number(one.symbol, one.name);
      if (wanted && taken_.insert({one.symbol, *wanted}).second) one.number = *wanted;
    }
    is_reserved_ = true;
  }
  void number(Term& term) {
    if (!is_reserved_) reserve();
    if (info(term.symbol).letter == '\0') {
      // no number
    } else if (term.number < 0) {
      term.number = 0;
    } else {
      Instance& one = instances_[static_cast<std::size_t>(term.number)];
      if (one.number == 0) {
        int& next = next_[term.symbol];
        while (!taken_.insert({term.symbol, ++next}).second) {
        }
        one.number = next;
      }
      if (named_.insert(term.number).second)
        out_.names.push_back(
            {fmt::format("{}{}", info(term.symbol).letter, one.number), one.what, one.owner});
      term.number = one.number;
    }
    for (Term& member : term.members) number(member);
  }

  const Configuration& configuration_;
  Parts parts_;
  text::Diagnostics& sink_;
  Formula out_;
  std::set<std::string, std::less<>> referenced_;
  std::map<const Robot*, Term> robots_;
  std::map<std::pair<const void*, Role>, int> index_;
  std::vector<Instance> instances_;
  std::set<std::pair<Symbol, int>> taken_;
  std::map<Symbol, int> next_;
  std::set<int> named_;
  std::size_t length_ = 0;
  int society_depth_ = 0;
  bool is_reserved_ = false;
};

}  // namespace

Formula formula(const Configuration& configuration, const flow::Library& library, text::Diagnostics& sink) {
  return Writer(configuration, library, sink).run();
}

std::string print(const Formula& formula) {
  std::string out;
  for (const std::string& sentence : formula.sentences) out += sentence + "\n";
  if (!formula.names.empty()) out += '\n';
  std::size_t width = 0;
  for (const FormulaName& name : formula.names) width = std::max(width, name.symbol.size());
  for (const FormulaName& name : formula.names) {
    out += fmt::format("// {:<{}}  {}", name.symbol, width, name.what);
    out += name.owner.empty() || name.owner == name.what ? "\n" : fmt::format(", in {}\n", name.owner);
  }
  return out;
}

}  // namespace mlab::cdl
