#pragma once

#include <bit>
#include <concepts>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>

#include "mlab/base/hash.h"
#include "mlab/lang/cdl/syntax/parts.h"
#include "mlab/lang/cdl/syntax/tree.h"

namespace mlab::difference {

/// What declarations of the text before, and their parameters, are called in the one after. Names that are
/// the same don't stand here.
struct DeclarationRenames {
  using Names = std::map<std::string, std::string, std::less<>>;
  Names declarations;
  std::map<std::string, Names, std::less<>> parameters;  ///< by the declaration's name before
};

/// The same for whoever stands in one of them.
class Renames {
 public:
  using Names = DeclarationRenames::Names;

  Renames() : Renames(none()) {}
  /// @param text  must outlive this
  explicit Renames(const DeclarationRenames& text) : text_(text) {}

  static const std::string& in(const Names& names, const std::string& name) {
    const auto found = names.find(name);
    return found == names.end() ? name : found->second;
  }
  const std::string& declaration(const std::string& name) const { return in(text_.declarations, name); }
  const std::string& parameter(const std::string& callee, const std::string& name) const {
    const auto found = text_.parameters.find(callee);
    return found == text_.parameters.end() ? name : in(found->second, name);
  }

  Names own;  ///< parameters and `let`s of the owner in hand

 private:
  static const DeclarationRenames& none() {
    static const DeclarationRenames kNone;
    return kNone;
  }

  const DeclarationRenames& text_;
};

template <class X, class... Ones>
inline constexpr bool kIsOneOf = (std::same_as<X, Ones> || ...);

/// Constructs of which all that is compared stands in their parts.
template <class Construct>
inline constexpr bool kIsAllParts =
    kIsOneOf<Construct, cdl::Hole, cdl::List, cdl::Member, cdl::Cooperate, cdl::Coordinate, cdl::Fuse,
             cdl::Sequence, cdl::Case, cdl::Select, cdl::Delay, cdl::Let, cdl::Assemblage, cdl::Binding,
             cdl::BodySetting, cdl::RobotClass, cdl::Drive, cdl::Choice, cdl::Robot, cdl::SocietyOperator,
             cdl::Society, cdl::Test, cdl::Use, cdl::Architecture>;

/// Numbers that are the same where two constructs say the same: places, comments, help, parentheses that
/// nobody needs aside.
class Fingerprints {
 public:
  using Print = std::uint64_t;

  /// @param renames  by which names are read; must outlive this
  explicit Fingerprints(const Renames& renames) : renames_(renames) {}

  /// With the name that it was given.
  Print of(const cdl::Expression& expression) {
    return base::combine_bits(content(expression), base::hash_text(expression.as.text));
  }
  Print of(const cdl::ExpressionPtr& expression) { return expression ? of(*expression) : 0; }
  /// Without its own name.
  Print content(const cdl::Expression& expression) {
    if (const auto found = known_.find(&expression); found != known_.end()) return found->second;
    Print out = expression.what.index() + 1;
    std::visit([&](const auto& what) { put(out, what); }, expression.what);
    put(out, expression.active);
    known_.emplace(&expression, out);
    return out;
  }
  /// Of any other construct, its own name included.
  template <class Construct>
  Print of(const Construct& construct) {
    Print out = 1;
    put(out, construct);
    return out;
  }

 private:
  static void add(Print& to, Print what) { to = base::combine_bits(to, what); }
  static void add(Print& to, const std::string& text) { add(to, base::hash_text(text)); }

  void put(Print& to, const cdl::ExpressionPtr& expression) { add(to, of(expression)); }
  static void put(Print& to, const cdl::Word& word) { add(to, word.text); }
  template <class X>
  void put(Print& to, const std::vector<X>& all) {
    add(to, all.size());
    for (const X& one : all) put(to, one);
  }
  void put(Print& to, const std::optional<cdl::Number>& number) {
    add(to, number ? 1 : 2);
    if (number) put(to, *number);
  }
  void put(Print& to, const cdl::Name& name) { add(to, Renames::in(renames_.own, name.name.text)); }
  void put(Print& to, const cdl::Call& call) {
    add(to, renames_.declaration(call.callee.text));
    add(to, call.arguments.size());
    for (const cdl::Argument& argument : call.arguments) {
      add(to, renames_.parameter(call.callee.text, argument.name.text));
      put(to, argument.value);
    }
  }
  void put(Print& to, const cdl::SocietyMember& member) {
    add(to, static_cast<Print>(member.kind));
    add(to, static_cast<Print>(member.count));
    add(to, renames_.declaration(member.name.text));
    add(to, renames_.declaration(member.by.text));
    put(to, member.members);
  }
  template <class Construct>
    requires requires(const Construct& x) { cdl::parts(x); }
  void put(Print& to, const Construct& construct) {
    put_own(to, construct);
    std::apply([&](const auto&... part) { (put(to, part), ...); }, cdl::parts(construct));
  }

  // What no part says. A construct that has nothing of its own is listed, so that none is forgotten.
  template <class Construct>
    requires kIsAllParts<Construct>
  static void put_own(Print& /*to*/, const Construct& /*has nothing of its own*/) {}
  static void put_own(Print& to, const cdl::Number& x) { add(to, std::bit_cast<Print>(x.value)); }
  static void put_own(Print& to, const cdl::Text& x) { add(to, x.value); }
  static void put_own(Print& to, const cdl::Arithmetic& x) {
    add(to, x.operations.size());
    for (const cdl::Operation one : x.operations) add(to, static_cast<Print>(one));
  }
  static void put_own(Print& to, const cdl::Logic& x) { add(to, static_cast<Print>(x.connective)); }
  static void put_own(Print& to, const cdl::Compete& x) { add(to, static_cast<Print>(x.rule)); }
  static void put_own(Print& to, const cdl::Transition& x) { add(to, x.restarts ? 1 : 0); }
  static void put_own(Print& to, const cdl::State& x) {
    add(to, (x.is_start ? 1 : 0) + (x.is_final ? 2 : 0));
  }
  static void put_own(Print& to, const cdl::TestStep& x) {
    for (const auto part : {static_cast<int>(x.kind), static_cast<int>(x.when), static_cast<int>(x.about)})
      add(to, static_cast<Print>(part));
    add(to, x.is_negated ? 1 : 0);
  }
  static void put_own(Print& to, const cdl::Device& x) { add(to, x.is_actuator ? 1 : 0); }
  void put_own(Print& to, const cdl::Parameter& x) {
    put(to, x.low);
    put(to, x.high);
  }

  const Renames& renames_;
  std::unordered_map<const cdl::Expression*, Print> known_;
};

}  // namespace mlab::difference
