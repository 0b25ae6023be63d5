#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "mlab/lang/cdl/syntax/tree.h"

namespace mlab::cdl {

/// Names that stand right below a path.
using NamesBelow = std::set<std::string, std::less<>>;

/// What the nodes that one owner makes are called: an assemblage, a robot, or the arguments of a device. All
/// paths are below the place where the owner runs; the node that gives the owner's own value has the path "".
/// Made by `Elaboration`. Keys point into the tree, which must outlive it.
class NodeNames {
 public:
  struct Paths {
    std::string path;    ///< of the node that gives the expression's value
    std::string inside;  ///< where an active part stands beside it: of what it passes on; else as `path`
    /// Of a node between the expression and who reads it: `and` of several joins two at a time, a member's
    /// strength is its length, an active part is asked whether it is idle. Empty: there is none.
    std::string behind;
    /// Of a node that counts in radians what is computed. Empty: there is none.
    std::string angle = {};
    /// Of nodes that count an operand in radians, should it come in degrees: in the order in which operands
    /// are written. Empty: it is a literal.
    std::vector<std::string> operand_angles = {};
  };

  /// Of an expression that makes a node; of all others, and of what stands deeper than anything may, empty.
  /// @param time  how often it was asked for before: a binding's default is evaluated wherever the binding is
  ///              called without that argument
  const Paths& of(const Expression& expression, std::size_t time = 0) const;
  bool is_repeated(const Expression& expression) const { return again_.contains(&expression); }
  /// Of a `let`'s value, where it makes a node.
  const std::string& of(const Let& let) const { return found(lets_, &let); }
  /// What the nodes of a state stand below.
  const std::string& of(const State& state) const { return found(states_, &state); }
  /// Of the actuator that a robot drives.
  const std::string& of(const Drive& drive) const { return found(drives_, &drive); }

  /// What is called already right below the node of a call when what it calls starts to name its own.
  const NamesBelow& below(const Expression& call) const;
  /// What is called right below the owner, by itself and by who was there before; without what only `let`s
  /// make that nothing reads.
  const NamesBelow& top() const { return top_; }
  /// Whether these are the same where `taken` stands right below the owner before it names its nodes.
  bool stay_with(const NamesBelow& taken) const;

 private:
  friend class Naming;

  template <class Key>
  static const std::string& found(const std::unordered_map<const Key*, std::string>& in, const Key* key) {
    static const std::string kNone;
    const auto at = in.find(key);
    return at == in.end() ? kNone : at->second;
  }

  std::unordered_map<const Expression*, Paths> paths_;
  std::map<const Expression*, std::vector<Paths>> again_;  // from the second time on
  std::unordered_map<const Let*, std::string> lets_;
  std::unordered_map<const State*, std::string> states_;
  std::unordered_map<const Drive*, std::string> drives_;
  std::unordered_map<const Expression*, NamesBelow> below_;  // where there are any
  NamesBelow top_;
  bool hands_on_ = false;  // what gives the owner's value names its nodes right below it as well
};

/// Two parts of a path; either may be empty.
std::string joined_path(std::string_view path, std::string_view below);
/// What a node is called that nobody gave a name: `Noise`, `cooperate`. Empty: the expression makes none.
std::string default_name(const Expression& expression);
/// What of a trigger is computed: a `not` around it is part of the transition.
const Expression& condition_of(const Expression& trigger);
/// `case_2`, `otherwise`: what the node of a case's member is called.
std::string case_name(const Case& one);

}  // namespace mlab::cdl
