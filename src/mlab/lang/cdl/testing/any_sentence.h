#pragma once

#include <cstddef>
#include <initializer_list>
#include <utility>
#include <vector>

#include "mlab/lang/cdl/formula/formula_term.h"

namespace mlab::cdl::testing {

/// Any sentence: an instance that stands twice is the same each time, so whole terms are reused.
///
/// @param Pick  (low, end): a number from `low`, below `end`
template <class Pick>
class AnySentence {
 public:
  explicit AnySentence(Pick pick) : pick_(std::move(pick)) {}

  Term society(int depth) {
    const int kind = depth <= 0 ? 0 : pick_(0, 3);
    if (kind == 0) {
      known_.clear();
      percepts_.clear();
      Term robot;
      robot.symbol = Symbol::kRobot;
      robot.members.push_back(assemblage(3));
      return robot;
    }
    Term out;
    out.symbol = kind == 1 ? Symbol::kCaste : Symbol::kTeam;
    out.number = fresh();
    const int count = pick_(2, 4);
    const Term first = society(depth - 1);
    for (int i = 0; i < count; ++i) out.members.push_back(kind == 2 || i == 0 ? first : society(depth - 1));
    return out;
  }

 private:
  int fresh() { return number_ += pick_(1, 4); }
  std::size_t index(const std::vector<Term>& of) {
    return static_cast<std::size_t>(pick_(0, static_cast<int>(of.size())));
  }
  Symbol one_of(std::initializer_list<Symbol> symbols) {
    return symbols.begin()[pick_(0, static_cast<int>(symbols.size()))];
  }
  bool maybe() { return pick_(0, 3) == 0; }

  Term assemblage(int depth) {
    if (!known_.empty() && maybe()) return known_[index(known_)];
    Term out;
    if (depth <= 0 || maybe()) {
      out.symbol = Symbol::kBehavior;
      if (maybe()) out.members.push_back(leaf(Symbol::kActive, fresh()));
      out.members.push_back(percept(2));
      if (!maybe()) out.members.push_back(leaf(Symbol::kMotor, fresh()));
    } else {
      out.symbol =
          one_of({Symbol::kCooperation, Symbol::kCompetition, Symbol::kSequencing, Symbol::kCoordination});
      out.number = fresh();
      const int count = pick_(2, 4);
      for (int i = 0; i < count; ++i) out.members.push_back(assemblage(depth - 1));
    }
    known_.push_back(out);
    return out;
  }

  Term percept(int depth) {
    if (!percepts_.empty() && maybe()) return percepts_[index(percepts_)];
    Term out = leaf(Symbol::kPercept, maybe() ? 0 : fresh());
    if (depth > 0 && maybe()) {
      out.symbol = one_of({Symbol::kFusion, Symbol::kPerceptualSequencing});
      out.number = fresh();
      const int count = pick_(2, 4);
      for (int i = 0; i < count; ++i) out.members.push_back(percept(depth - 1));
    }
    percepts_.push_back(out);
    return out;
  }

  static Term leaf(Symbol symbol, int number) {
    Term out;
    out.symbol = symbol;
    out.number = number;
    return out;
  }

  Pick pick_;
  int number_ = 0;
  std::vector<Term> known_;
  std::vector<Term> percepts_;
};

}  // namespace mlab::cdl::testing
