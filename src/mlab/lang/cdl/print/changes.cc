#include "mlab/lang/cdl/print/changes.h"

#include <tuple>

namespace mlab::cdl {
namespace {

// Calls `each` with the parts of two constructs of one kind, and says whether it was true of any.
template <class X>
bool any_part(const X& old, X& now, const auto& each) {
  const auto old_parts = parts(old);
  const auto now_parts = parts(now);
  bool out = false;
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    ((out = each(std::get<I>(old_parts), std::get<I>(now_parts)) || out), ...);
  }(std::make_index_sequence<std::tuple_size_v<std::remove_const_t<decltype(old_parts)>>>());
  return out;
}

}  // namespace

template <class X>
bool Changes::rewrite(const X& old, X& now) const {
  bool is_changed = false;
  if constexpr (requires { parts(old); })
    is_changed = any_part(old, now, [this](const auto& a, auto& b) { return rewrite(a, b); });
  const Construct* own = find(old);
  for (std::size_t i = 0; own != nullptr && i < own->how.size(); ++i) {
    own->how[i](&now);
    is_changed = true;
  }
  if constexpr (requires { now.whole; }) {
    if (is_changed) now.whole = {};
  }
  return is_changed;
}

bool Changes::rewrite(const ExpressionPtr& old, ExpressionPtr& now) const {
  if (!old) return false;
  if (const auto by = expressions_.find(old.get()); by != expressions_.end()) {
    now = by->second;
    return true;
  }
  const auto copy = std::make_shared<Expression>(*old);
  const bool is_changed = rewrite(*old, *copy);
  if (is_changed) now = copy;
  return is_changed;
}

template <class X>
bool Changes::rewrite(const std::vector<X>& old, std::vector<X>& now) const {
  bool is_changed = false;
  std::vector<X> out;
  out.reserve(old.size());
  for (const X& one : old) {
    const Construct* own = find(one);
    if (own != nullptr && own->is_removed) {
      is_changed = true;
      continue;
    }
    out.push_back(one);
    is_changed = rewrite(one, out.back()) || is_changed;
  }
  if (is_changed) now = std::move(out);
  return is_changed;
}

template <class... X>
bool Changes::rewrite(const std::variant<X...>& old, std::variant<X...>& now) const {
  return std::visit([&]<class One>(const One& one) { return rewrite(one, std::get<One>(now)); }, old);
}

ExpressionPtr Changes::of(const Expression& what) const {
  const auto out = std::make_shared<Expression>(what);
  rewrite(what, *out);
  return out;
}

Changes::Rewritten Changes::rewritten() const {
  Rewritten out;
  const auto add_before = [&](const Item* before) {
    for (const auto& [where, item] : added_) {
      if (where == before) out.items.push_back(&item);
    }
  };
  for (const Item& old : tree_.items) {
    add_before(&old);
    const bool is_removed =
        std::visit([&](const auto& one) { return find(one) != nullptr && find(one)->is_removed; }, old);
    if (is_removed) continue;
    Item& now = out.made.emplace_back(old);
    out.items.push_back(rewrite(old, now) ? &now : &old);
  }
  add_before(nullptr);
  return out;
}

Tree Changes::tree_after() const {
  const Rewritten now = rewritten();
  Tree out;
  out.source = tree_.source;
  for (const Item* item : now.items) out.items.push_back(*item);
  return out;
}

Reprinted Changes::done() const {
  const Rewritten now = rewritten();
  return reprint(tree_, now.items);
}

}  // namespace mlab::cdl
