#pragma once

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <typeindex>
#include <utility>
#include <vector>

#include "mlab/lang/cdl/print/reprint.h"
#include "mlab/lang/cdl/syntax/parts.h"
#include "mlab/lang/cdl/syntax/tree.h"

namespace mlab::cdl {

/// What is to become of parts of one tree. They are noted while one reads it, in any order, and done all at
/// once, the inner ones before those that hold them; the tree stays as it is. What is named has to stand in
/// the tree itself.
class Changes {
 public:
  /// @param tree  has to outlive it
  explicit Changes(const Tree& tree) : tree_(tree) {}

  bool empty() const { return constructs_.empty() && expressions_.empty() && added_.empty(); }

  /// @param how  gets a copy with all that was changed inside of it
  template <class X>
  void change(const X& what, std::function<void(X&)> how) {
    constructs_[key_of(what)].how.push_back(
        [how = std::move(how)](void* now) { how(*static_cast<X*>(now)); });
  }
  void rename(const Word& word, const std::string& by) {
    change<Word>(word, [by](Word& now) { now.text = by; });
  }
  /// Takes one of a list away.
  template <class X>
  void remove(const X& what) {
    constructs_[key_of(what)].is_removed = true;
  }
  /// Another expression in its place; null where it may be missing: none.
  void replace(const Expression& what, ExpressionPtr by) { expressions_[&what] = std::move(by); }
  /// A declaration before one that is there; null: behind all.
  void add(Item item, const Item* before) { added_.emplace_back(before, std::move(item)); }

  /// An expression as it is afterwards, wherever it is to stand.
  ExpressionPtr of(const ExpressionPtr& what) const {
    ExpressionPtr out = what;
    rewrite(what, out);
    return out;
  }
  ExpressionPtr of(const Expression& what) const;
  /// The tree afterwards: what stands in it as before has its place in the old text.
  Tree tree_after() const;
  /// The text afterwards.
  Reprinted done() const;

 private:
  struct Rewritten {
    std::deque<Item> made;
    std::vector<const Item*> items;  ///< in their order: of the tree, added, or made
  };
  Rewritten rewritten() const;

  using Key = std::pair<const void*, std::type_index>;
  struct Construct {
    bool is_removed = false;
    std::vector<std::function<void(void*)>> how;
  };

  template <class X>
  static Key key_of(const X& what) {
    return {&what, typeid(X)};
  }
  template <class X>
  const Construct* find(const X& what) const {
    const auto found = constructs_.find(key_of(what));
    return found == constructs_.end() ? nullptr : &found->second;
  }

  // Each makes of a copy what the changes make of it. @return whether there were any
  template <class X>
  bool rewrite(const X& old, X& now) const;
  bool rewrite(const ExpressionPtr& old, ExpressionPtr& now) const;
  template <class X>
  bool rewrite(const std::vector<X>& old, std::vector<X>& now) const;
  template <class... X>
  bool rewrite(const std::variant<X...>& old, std::variant<X...>& now) const;

  const Tree& tree_;
  std::map<Key, Construct> constructs_;
  std::map<const Expression*, ExpressionPtr> expressions_;
  std::vector<std::pair<const Item*, Item>> added_;
};

}  // namespace mlab::cdl
