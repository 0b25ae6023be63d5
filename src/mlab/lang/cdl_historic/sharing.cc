// What has a name and is used more than once.

#include <fmt/core.h>

#include "mlab/lang/cdl_historic/converter.h"
#include "mlab/text/shown.h"

namespace mlab::cdl_historic {
namespace {

// `Stop` twice is as good as once.
bool is_plain(const cdl::Expression& expression) {
  if (std::holds_alternative<cdl::Name>(expression.what) ||
      std::holds_alternative<cdl::Number>(expression.what))
    return true;
  const auto* called = std::get_if<cdl::Call>(&expression.what);
  return called != nullptr && called->arguments.empty() && expression.as.text.empty();
}

std::string let_name(const Symbol& symbol, const cdl::Expression& value) {
  const std::string& name = symbol.name.text;
  if (!name.starts_with('$') && !name.starts_with("AN_")) return legal_name(name);
  if (!symbol.spot.label.text.empty()) return legal_name(symbol.spot.label.text);
  const auto* called = std::get_if<cdl::Call>(&value.what);
  return called == nullptr ? std::string("shared") : "shared_" + called->callee.text;
}

}  // namespace

TypedDraft Converter::make_shared(const Symbol& symbol, const Level* level, std::string_view wanted,
                                  const text::Place& place) {
  const bool has_readers = symbol.uses + (symbol.instance == nullptr ? 1 : 0) > 1 && !units_.empty();
  if (has_readers) {
    const auto known = units_.back()->shared_at.find({symbol.expr, level});
    if (known != units_.back()->shared_at.end()) return read_shared(*units_.back(), known->second, place);
  }
  if (!open_.insert(symbol.expr).second) {
    sink_.warning("refers-to-itself", place,
                  fmt::format("`{}` is part of itself; it is left out here", text::shown(symbol.name.text)));
    return nothing(wanted, place);
  }
  TypedDraft made = make(*symbol.expr, level, wanted);
  open_.erase(symbol.expr);
  if (!has_readers || made.expr == nullptr || is_plain(*made.expr)) return made;
  Unit& unit = *units_.back();
  const auto [alike, is_new] =
      unit.shared_alike.emplace(std::pair{symbol.expr, fingerprint(*made.expr)}, unit.shared.size());
  if (is_new) {
    const std::string base = let_name(symbol, *made.expr);
    std::string name = base;
    for (int n = 2; !unit.names.insert(name).second; ++n) name = fmt::format("{}_{}", base, n);
    made.expr->as = {};
    unit.shared.push_back({name, made, {}});
  }
  unit.shared_at[{symbol.expr, level}] = alike->second;
  return read_shared(unit, alike->second, place);
}

TypedDraft Converter::read_shared(Unit& unit, std::size_t index, const text::Place& place) {
  Unit::Shared& shared = unit.shared[index];
  shared.readers.push_back(name(shared.name, place));
  return {shared.readers.back(), shared.made.type};
}

// What only one part reads stands where it is read instead.
void Converter::finish(Unit& unit) {
  for (Unit::Shared& shared : unit.shared) {
    if (shared.readers.size() > 1) {
      cdl::Let let;
      let.name.text = shared.name;
      let.value = shared.made.expr;
      unit.lets.push_back(std::move(let));
    } else if (shared.readers.size() == 1) {
      *shared.readers[0] = *shared.made.expr;
    }
  }
  unit.shared.clear();
  units_.pop_back();
}

}  // namespace mlab::cdl_historic
