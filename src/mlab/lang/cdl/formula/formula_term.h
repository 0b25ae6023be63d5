#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/text/source.h"

namespace mlab::cdl {

/// What a symbol of the grammar G stands for.
enum class Symbol {
  kCaste,
  kTeam,
  kRobot,
  kCooperation,
  kCompetition,
  kSequencing,
  kCoordination,
  kBehavior,
  kFusion,
  kPerceptualSequencing,
  kPercept,
  kMotor,
  kActive,
};

/// How a symbol is written, and how instances of it are called in a configuration: `+7`, `cooperation7`.
struct SymbolInfo {
  Symbol symbol;
  char letter;             ///< `\0`: has no number
  std::string_view word;   ///< of an instance's name
  std::string_view plain;  ///< for messages
};
inline constexpr std::array<SymbolInfo, 13> kSymbols{{
    {Symbol::kCaste, '/', "caste", "a caste"},
    {Symbol::kTeam, '*', "team", "a team"},
    {Symbol::kRobot, '\0', "", "a robot"},
    {Symbol::kCooperation, '+', "cooperation", "a cooperation"},
    {Symbol::kCompetition, '-', "competition", "a competition"},
    {Symbol::kSequencing, '%', "sequencing", "a sequencing"},
    {Symbol::kCoordination, '@', "coordination", "a coordination"},
    {Symbol::kBehavior, '\0', "", "a behavior"},
    {Symbol::kFusion, '#', "fusion", "a fusion"},
    {Symbol::kPerceptualSequencing, '=', "perceptual_sequencing", "a perceptual sequencing"},
    {Symbol::kPercept, 'p', "p", "a perceptual process"},
    {Symbol::kMotor, 'm', "m", "a motor process"},
    {Symbol::kActive, 'a', "a", "an active perception process"},
}};
const SymbolInfo& info(Symbol symbol);

/// One phrase of a sentence. A behavior has, in this order, an active part or none, a percept, a motor part
/// or none.
struct Term {
  Symbol symbol = Symbol::kPercept;
  int number = 0;  ///< of the instance; percept 0 is the empty one
  std::vector<Term> members;
  text::Place place;
};

/// `[+1 <p1 m1> <(#1 p1 p2) m2>]`
std::string print(const Term& term);

/// The number in an instance's name: 7 of `cooperation7`; nothing where the name is none of the symbol's.
std::optional<int> instance_number(Symbol symbol, std::string_view name);
/// `cooperation7`
std::string instance_name(Symbol symbol, int number);

/// What stands in front of an operator's members, and behind them.
struct Brackets {
  std::string_view open;
  std::string_view close;
};
Brackets brackets(Symbol symbol);

}  // namespace mlab::cdl
