#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

#include "mlab/difference/fingerprint.h"
#include "mlab/lang/cdl/lower/owner_model.h"

namespace mlab::difference {

/// Which of the things of one list are which of another; -1: none.
struct Pairs {
  Pairs(std::size_t before, std::size_t after) : to_after(before, -1), to_before(after, -1) {}
  void put(std::size_t before, std::size_t after) {
    to_after[before] = static_cast<int>(after);
    to_before[after] = static_cast<int>(before);
  }
  bool are_free(std::size_t before, std::size_t after) const {
    return to_after[before] < 0 && to_before[after] < 0;
  }
  /// What both have stands in the same order.
  bool keep_order() const {
    int last = -1;
    for (const int at : to_after) {
      if (at < 0) continue;
      if (at < last) return false;
      last = at;
    }
    return true;
  }

  std::vector<int> to_after;
  std::vector<int> to_before;
};

/// Pairs what has no partner yet and the same key, in order. A key that says nothing is for none.
/// @param before_key  of the thing at an index, as `after_key`; the type's first value: none
template <class BeforeKey, class AfterKey>
void pair_by(Pairs& pairs, const BeforeKey& before_key, const AfterKey& after_key) {
  using Key = decltype(after_key(std::size_t{}));
  struct Queue {
    std::vector<std::size_t> all;
    std::size_t next = 0;
  };
  std::unordered_map<Key, Queue> free;
  for (std::size_t i = 0; i < pairs.to_before.size(); ++i) {
    if (pairs.to_before[i] >= 0) continue;
    Key key = after_key(i);
    if (key != Key{}) free[std::move(key)].all.push_back(i);
  }
  for (std::size_t i = 0; i < pairs.to_after.size(); ++i) {
    if (pairs.to_after[i] >= 0) continue;
    const Key key = before_key(i);
    const auto found = key == Key{} ? free.end() : free.find(key);
    if (found == free.end() || found->second.next == found->second.all.size()) continue;
    pairs.put(i, found->second.all[found->second.next++]);
  }
}

/// The same for keys that only one thing on either side has.
template <class BeforeKey, class AfterKey>
void pair_by_unique(Pairs& pairs, const BeforeKey& before_key, const AfterKey& after_key) {
  using Key = decltype(after_key(std::size_t{}));
  std::unordered_map<Key, std::pair<int, int>> count;
  for (std::size_t i = 0; i < pairs.to_after.size(); ++i)
    if (pairs.to_after[i] < 0) ++count[before_key(i)].first;
  for (std::size_t i = 0; i < pairs.to_before.size(); ++i)
    if (pairs.to_before[i] < 0) ++count[after_key(i)].second;
  const auto alone = [&](const Key& key) {
    const auto found = count.find(key);
    return found != count.end() && found->second == std::pair(1, 1) ? key : Key{};
  };
  pair_by(
      pairs, [&](std::size_t i) { return alone(before_key(i)); },
      [&](std::size_t i) { return alone(after_key(i)); });
}

/// Both versions' constructs as numbers that can be compared with each other.
struct Prints {
  explicit Prints(const Renames& known) : renames(known), before(known), after(none()) {}
  const Renames& renames;
  Fingerprints before;
  Fingerprints after;

 private:
  static const Renames& none() {
    static const Renames kNone;
    return kNone;
  }
};

/// What stands on its page by itself, and not for a parameter, a `let` or an actuator.
bool is_component(const cdl::ModelNode& node);
/// What a node is: `Noise`, `compete by priority`, `value`.
std::string component_of(const cdl::ModelNode& node);
/// The name that its author gave it; empty: none.
const std::string& given_name(const cdl::ModelNode& node);
/// What a person calls it: the name that it was given, or what it is, with its number where it has one.
std::string label_of(const cdl::ModelNode& node);
/// The values of a case, as they stand there: `2, 4`.
std::string case_words(const cdl::Case& one);

/// Inputs by what they are called in the version after; lists have several.
using InputGroups = std::map<std::string, std::vector<const cdl::ModelInput*>>;
/// @param renames  null: of the version after
InputGroups inputs_of(const cdl::ModelNode& node, const Renames* renames);

/// Which nodes of two pages are the same.
Pairs match_nodes(const cdl::ModelPage& before, const cdl::ModelPage& after, Prints& prints);
/// Which states of two sequences are the same.
Pairs match_states(const cdl::Sequence& before, const cdl::Sequence& after, Prints& prints);
/// Which transitions of a state are the same.
/// @param targets  what states are called afterwards
Pairs match_transitions(const cdl::State& before, const cdl::State& after, const Renames::Names& targets,
                        Prints& prints);

}  // namespace mlab::difference
