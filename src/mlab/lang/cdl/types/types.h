#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "mlab/flow/library.h"
#include "mlab/lang/cdl/configuration.h"
#include "mlab/lang/cdl/types/arithmetic.h"
#include "mlab/lang/cdl/types/port_type.h"

namespace mlab::cdl {

/// One input of what can be called, by the name that it has there.
struct InputView {
  std::string name;
  PortType type;
  const flow::Input* input = nullptr;    ///< of a procedure
  const Parameter* parameter = nullptr;  ///< of an assemblage or a binding point

  bool is_list() const { return input != nullptr && input->is_list; }
};
/// The inputs of a procedure as they are called under the name by which it was found.
std::vector<InputView> inputs_of(const flow::Library::Entry& entry);

/// The inputs of a function, explained as those of what computes it.
std::vector<InputView> inputs_of(const Function& function, const flow::Library& library);
/// `[1 m, 2 m]` among operands is what it stands beside: a point beside points, else a vector.
void settle_lists(std::vector<PortType>& operands, const std::vector<bool>& is_list);

/// All types that a parameter may have, quantities too, for "did you mean"; a library finds more.
std::vector<std::string> type_names();

/// What types things of one configuration have, from its declarations and from descriptors: nothing is
/// lowered, and nothing reported. Both must outlive it.
class Types {
 public:
  Types(const Configuration& configuration, const flow::Library& library)
      : configuration_(configuration), library_(library) {}

  /// Of a type's or a quantity's name: `length` is a real number in m.
  PortType named(std::string_view type) const;
  PortType of(const Parameter& parameter) const;
  /// What a call gives: nothing where nobody answers to the name, or who does is a sink.
  PortType of_call(const Word& callee) const;
  PortType of_call(const flow::Library::Entry& entry) const;
  /// The function of that name, where nothing that is declared has it; null: there is none.
  const Function* function(const Word& callee) const;
  /// Whether a call of it gives nothing: it is a procedure that acts.
  bool is_sink(const Word& callee) const;
  /// Empty where nobody answers to the name.
  std::vector<InputView> inputs_of(const Word& callee) const;
  PortType result_of(const Assemblage& assemblage) const;

  /// One question for a type with what was answered on the way. Many ways may lead to the same `let` or
  /// assemblage, and some go round in circles: what is asked for a second time is what is known by then.
  struct Question {
    int depth = 0;
    std::unordered_map<const void*, PortType> known;  ///< of `let`s and assemblages
  };
  /// What a name stands for where an expression stands.
  using Names = std::function<PortType(const std::string& name, Question& question)>;
  /// Of parameters and `let`s. Both must outlive it.
  Names names_of(const std::vector<Parameter>& parameters, const std::vector<Let>& lets) const;
  /// What an expression gives; a number by itself is a real one, a text by itself may be of any type.
  PortType of(const Expression& expression, const Names& names) const;
  /// Of a `let`, for `Names`.
  PortType of(const Let& let, const Names& names, Question& question) const;

 private:
  PortType of(const Expression& expression, const Names& names, Question& question) const;
  PortType of_call(const Word& callee, Question& question) const;
  PortType of_arithmetic(const Arithmetic& arithmetic, const Names& names, Question& question) const;
  PortType of_function(const Function& function, const Call& call, const Names& names,
                       Question& question) const;
  PortType of_operand(const Expression& operand, const Names& names, Question& question) const;
  PortType result_of(const Assemblage& assemblage, Question& question) const;

  const Configuration& configuration_;
  const flow::Library& library_;
};

}  // namespace mlab::cdl
