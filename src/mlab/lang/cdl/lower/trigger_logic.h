#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "mlab/flow/library.h"
#include "mlab/lang/cdl/configuration.h"

namespace mlab::cdl {

/// What can be told of triggers without running them. A call that perceives something is a fact that may be
/// true or false; the same call, written again, is the same fact.
class TriggerLogic {
 public:
  enum class Constant { kNo, kTrue, kFalse, kSome /* one of the two, always the same */ };

  /// What a transition is, behind those that stand above it in its state.
  struct Verdict {
    Constant constant = Constant::kNo;
    bool is_hidden = false;                ///< whenever its trigger is true, one above is true as well
    bool is_same = false;                  ///< one above alone says exactly the same
    std::optional<std::size_t> hidden_by;  ///< the one above that suffices; none: it takes several
  };

  TriggerLogic(const Configuration& configuration, const flow::Library& library)
      : configuration_(configuration), library_(library) {}

  /// One for each transition of a state. Names are those of the declaration that the state stands in.
  std::vector<Verdict> judge(const State& state, const std::vector<Parameter>& parameters,
                             const std::vector<Let>& lets);

 private:
  struct Scope {
    const std::vector<Parameter>* parameters;
    const std::vector<Let>* lets;
    int depth;  // of names and assemblages that were followed
  };

  Constant constant(const Expression& expression, const Scope& scope) const;
  Constant constant_call(const Call& call, const Scope& scope) const;
  Constant constant_name(const std::string& name, const Scope& scope) const;
  Constant constant_logic(const Logic& logic, const Scope& scope) const;
  bool is_literal(const Expression& expression, const Scope& scope) const;
  void collect_facts(const Expression& expression, const Scope& scope);
  bool is_true(const Expression& expression, unsigned facts) const;
  Verdict verdict(const State& state, std::size_t index, const Scope& scope) const;

  const Configuration& configuration_;
  const flow::Library& library_;
  // What a trigger is made of: a fact, by its bit, or what it always is.
  struct Leaf {
    std::optional<unsigned> fact;
    bool is_true = false;
  };
  std::map<std::string, unsigned> facts_;  // the bit of each, by its text
  std::unordered_map<const Expression*, Leaf> leaves_;
};

}  // namespace mlab::cdl
