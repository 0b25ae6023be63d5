#include "mlab/lang/cdl/formula/formula_term.h"

#include <charconv>

#include <fmt/core.h>

namespace mlab::cdl {
namespace {

void put(const Term& term, std::string& out) {
  const auto [open, close] = brackets(term.symbol);
  out += open;
  const char letter = info(term.symbol).letter;
  if (letter != '\0') out += fmt::format("{}{}", letter, term.number);
  bool is_first = letter == '\0';
  for (const Term& member : term.members) {
    if (!is_first) out += ' ';
    is_first = false;
    put(member, out);
  }
  out += close;
}

}  // namespace

const SymbolInfo& info(Symbol symbol) {
  return kSymbols[static_cast<std::size_t>(symbol)];
}

Brackets brackets(Symbol symbol) {
  switch (symbol) {
    case Symbol::kCaste:
    case Symbol::kTeam:
      return {"'", "'"};
    case Symbol::kRobot:
      return {"{", "}"};
    case Symbol::kCooperation:
    case Symbol::kCompetition:
    case Symbol::kSequencing:
    case Symbol::kCoordination:
      return {"[", "]"};
    case Symbol::kBehavior:
      return {"<", ">"};
    case Symbol::kFusion:
    case Symbol::kPerceptualSequencing:
      return {"(", ")"};
    case Symbol::kPercept:
    case Symbol::kMotor:
    case Symbol::kActive:
      break;
  }
  return {};
}

std::string print(const Term& term) {
  std::string out;
  put(term, out);
  return out;
}

std::optional<int> instance_number(Symbol symbol, std::string_view name) {
  const std::string_view word = info(symbol).word;
  if (word.empty() || !name.starts_with(word) || name.size() == word.size()) return std::nullopt;
  name.remove_prefix(word.size());
  int number = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
  const bool is_plain = error == std::errc{} && end == name.data() + name.size() && name.front() != '0';
  return is_plain && number > 0 ? std::optional(number) : std::nullopt;
}

std::string instance_name(Symbol symbol, int number) {
  return fmt::format("{}{}", info(symbol).word, number);
}

}  // namespace mlab::cdl
