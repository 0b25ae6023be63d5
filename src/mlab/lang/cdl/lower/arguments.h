#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mlab/lang/cdl/lower/findings.h"
#include "mlab/lang/cdl/lower/value.h"

namespace mlab::cdl {

/// An argument with the scope that it is to be read in.
struct GivenArgument {
  Word name;  ///< empty: by position
  ExpressionPtr expression;
  Scope* scope = nullptr;
  std::optional<Value> value = std::nullopt;  ///< instead of `expression`: what it stands for already
  text::Place place = {};
};

std::vector<GivenArgument> given_by(const Call& call, Scope& scope);

/// Finds out what arguments are for, and says what is wrong with that.
class Arguments {
 public:
  explicit Arguments(Findings& findings) : findings_(findings) {}

  /// Per argument the index of what it is for; -1 where that is wrong, which was said.
  /// @param assemblage  that is called; null: something else is
  std::vector<int> match(const Word& callee, const std::vector<GivenArgument>& given,
                         const std::vector<std::string>& names, const Assemblage* assemblage = nullptr);
  void say_missing(const Word& callee, const std::string& name, const PortType& type,
                   const std::string& help);

 private:
  /// The index of the input that an argument names; -1: there is none.
  int index_of_name(const Word& callee, const Word& name, const std::vector<std::string>& names,
                    const Assemblage* assemblage);

  Findings& findings_;
};

}  // namespace mlab::cdl
