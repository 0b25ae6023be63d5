#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/flow/library.h"
#include "mlab/lang/cdl/configuration.h"
#include "mlab/lang/cdl/port_type.h"

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
  PortType of_call(const Word& callee) const { return of_call(callee, 0); }
  PortType of_call(const flow::Library::Entry& entry) const;
  /// Whether a call of it gives nothing: it is a procedure that acts.
  bool is_sink(const Word& callee) const;
  /// Empty where nobody answers to the name.
  std::vector<InputView> inputs_of(const Word& callee) const;
  PortType result_of(const Assemblage& assemblage) const { return result_of(assemblage, 0); }

  /// What a name stands for where an expression stands. Hands `depth` on to `of`.
  using Names = std::function<PortType(const std::string& name, int depth)>;
  /// Of parameters and `let`s. Both must outlive it.
  Names names_of(const std::vector<Parameter>& parameters, const std::vector<Let>& lets) const;
  /// What an expression gives; a number by itself is a real one.
  PortType of(const Expression& expression, const Names& names, int depth = 0) const;

 private:
  PortType of_call(const Word& callee, int depth) const;
  PortType result_of(const Assemblage& assemblage, int depth) const;

  const Configuration& configuration_;
  const flow::Library& library_;
};

}  // namespace mlab::cdl
