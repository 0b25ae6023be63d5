#pragma once

#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "mlab/designer/drawing/graph.h"

namespace mlab::designer {

/// The names that are taken in assemblages and robots: those that stand there, and those that an edit has
/// given, which stand there from the next commit on.
class OwnerNames {
 public:
  /// Whether a `let` or a parameter of the owner is called so.
  bool is_taken(const OwnerGraph& owner, std::string_view name) const;
  /// The wanted one, or with a number behind it; one that no node and no state of the owner's own page has,
  /// either.
  std::string free_name(const OwnerGraph& owner, const std::string& wanted) const;
  /// From now on it is taken.
  void give(const OwnerGraph& owner, const std::string& name) { given_.emplace(owner.name, name); }

 private:
  std::set<std::pair<std::string, std::string>> given_;  // owners and names
};

}  // namespace mlab::designer
