#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/flow/library.h"
#include "mlab/flow/network.h"
#include "mlab/lang/cdl/lower/arguments.h"
#include "mlab/lang/cdl/lower/binder.h"
#include "mlab/lang/cdl/lower/evaluator.h"
#include "mlab/lang/cdl/lower/findings.h"
#include "mlab/lang/cdl/lower/named_places.h"
#include "mlab/lang/cdl/lower/value.h"
#include "mlab/lang/cdl/types/arithmetic.h"

namespace mlab::cdl {

/// Arithmetic: operations and functions. What is of constants is computed at once.
class ArithmeticLowering {
 public:
  struct Parts {
    const flow::Library& library;
    Findings& findings;
    Binder& binder;
    Arguments& arguments;
    NamedPlaces& places;
    Evaluator& values;
    flow::Network& network;
  };
  explicit ArithmeticLowering(const Parts& parts)
      : library_(parts.library),
        findings_(parts.findings),
        binder_(parts.binder),
        arguments_(parts.arguments),
        places_(parts.places),
        values_(parts.values),
        network_(parts.network) {}

  /// @param path  of the node that gives the value
  Value operations(const Expression& expression, const Arithmetic& arithmetic, Scope& scope,
                   const std::string& path);
  Value function(const Expression& expression, const Call& call, const Function& function, Scope& scope,
                 const std::string& path);

 private:
  /// What is computed of values, and where the author wrote them.
  struct Operand {
    Value value;
    PortType type;
    text::Place place;
    std::string angle;  ///< node that counts it in radians
  };
  /// @param of     the sign or function that takes it
  /// @param angle  of the node that counts it in radians, if that is needed
  std::optional<Operand> operand(const Expression& expression, std::string_view of, std::string angle,
                                 Scope& scope);
  static void settle_lists(std::vector<Operand>& operands);
  static std::vector<PortType> types_of(const std::vector<Operand>& operands);
  Value compute(const Computation& how, const std::vector<Operand>& operands, const std::string& path,
                const text::Place& place);
  Value fold(const Computation& how, const std::vector<Operand>& operands, const text::Place& place);
  Value in_radians(Value value, const std::string& path, const std::string& angle, const text::Place& place);
  void link_operand(const Operand& operand, const flow::Input& input, flow::Node& node);
  void refuse(const Computation& how, const std::vector<Operand>& operands, const text::Place& place);

  const flow::Library& library_;
  Findings& findings_;
  Binder& binder_;
  Arguments& arguments_;
  NamedPlaces& places_;
  Evaluator& values_;
  flow::Network& network_;
};

}  // namespace mlab::cdl
