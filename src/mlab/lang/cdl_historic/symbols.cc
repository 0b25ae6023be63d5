#include "mlab/lang/cdl_historic/symbols.h"

#include <algorithm>
#include <utility>

namespace mlab::cdl_historic {

Symbols::Symbols(const Tree& tree) {
  for (const Instance& instance : tree.instances) {
    add({instance.name, instance.what.get(), &instance, instance.spot, 0});
    walk(*instance.what, true);
  }
  for (const ExprPtr& expr : tree.expressions) walk(*expr, false);
  // Instances and expressions were walked one after the other.
  for (auto& [name, same] : symbols_) {
    std::ranges::stable_sort(same, {}, [](const Symbol& symbol) { return symbol.name.place.span.begin; });
  }
  for (const Instance& instance : tree.instances) count(*instance.what);
  for (const ExprPtr& expr : tree.expressions) count(*expr);
}

void Symbols::add(Symbol symbol) {
  symbols_[symbol.name.text].push_back(std::move(symbol));
}

void Symbols::walk(const Expr& expr, bool is_named) {
  if (!is_named && expr.kind != Expr::Kind::kReference) {
    for (const Word& name : expr.inline_names) add({name, &expr, nullptr, expr.spot, 0});
  }
  walk(expr.settings);
}

void Symbols::walk(const std::vector<Setting>& settings) {
  for (const Setting& setting : settings) {
    if (setting.value.expr != nullptr) walk(*setting.value.expr, false);
    if (setting.value.rule != nullptr) walk(setting.value.rule->members);
    walk(setting.value.list);
  }
}

void Symbols::count(const Expr& expr) {
  if (expr.kind == Expr::Kind::kReference) {
    if (const Symbol* symbol = find(expr.name)) ++symbol->uses;
  }
  count(expr.settings);
}

void Symbols::count(const std::vector<Setting>& settings) {
  for (const Setting& setting : settings) {
    if (setting.value.expr != nullptr) count(*setting.value.expr);
    if (setting.value.rule != nullptr) count(setting.value.rule->members);
    count(setting.value.list);
  }
}

const Symbol* Symbols::find(std::string_view name, std::uint32_t at) const {
  const auto it = symbols_.find(name);
  if (it == symbols_.end()) return nullptr;
  const std::vector<Symbol>& same = it->second;
  const auto after = std::ranges::upper_bound(
      same, at, {}, [](const Symbol& symbol) { return symbol.name.place.span.begin; });
  return after == same.begin() ? &same.front() : &*(after - 1);
}

}  // namespace mlab::cdl_historic
