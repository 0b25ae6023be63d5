#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/flow/behavior.h"

namespace mlab::flow {

/// The behaviors and types that a network may name. Holds pointers to descriptors, which outlive it.
class Library {
 public:
  struct Entry {
    const Behavior* behavior = nullptr;
    const Alias* alias = nullptr;  ///< null: found by its own name
  };

  /// Knows the types of port_types.h, and no behavior.
  Library();

  /// Adds behaviors with all their aliases, and the types of their ports. A later one of the same name
  /// replaces the earlier, so that a mission may bring its own version.
  void add(std::span<const Behavior* const> behaviors);
  void add_type(const TypeInfo& type, std::string_view alias = {});

  /// Null behavior where there is none of that name. Names are compared exactly.
  Entry find(std::string_view name) const;
  /// Null where there is none. Historic type names (`obs_array`, `boolean`, ...) are found as well.
  const TypeInfo* find_type(std::string_view name) const;

  /// All behaviors by their own name, in alphabetical order.
  std::vector<const Behavior*> behaviors() const;
  /// Every name that `find` knows, for "did you mean".
  std::vector<std::string> names() const;

 private:
  std::map<std::string, Entry, std::less<>> entries_;
  std::map<std::string, const TypeInfo*, std::less<>> types_;
};

}  // namespace mlab::flow
