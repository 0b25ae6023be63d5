#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "mlab/flow/library.h"
#include "mlab/flow/network.h"
#include "mlab/lang/cdl/configuration.h"
#include "mlab/lang/cdl/lower/arguments.h"
#include "mlab/lang/cdl/lower/binder.h"
#include "mlab/lang/cdl/lower/elaboration.h"
#include "mlab/lang/cdl/lower/equipment.h"
#include "mlab/lang/cdl/lower/evaluator.h"
#include "mlab/lang/cdl/lower/findings.h"
#include "mlab/lang/cdl/lower/value.h"

namespace mlab::cdl {

/// What is flattened for.
enum class Purpose {
  kRun,
  kCheck,  ///< nobody runs it: binding points are taken as they are declared
};

/// Calls: of procedures, of assemblages, of binding points, of the devices that serve these.
class CallLowering {
 public:
  struct Parts {
    const Configuration& configuration;
    const flow::Library& library;
    const Elaboration& elaboration;
    Findings& findings;
    Binder& binder;
    Arguments& arguments;
    Equipment& equipment;
    Evaluator& values;
    Scopes& scopes;
    flow::Network& network;
    /// Of assemblages that were checked: the type and unit of their value. Calls need not look into them
    /// again.
    std::map<const Assemblage*, std::pair<const flow::TypeInfo*, std::string>>& results;
  };
  CallLowering(const Parts& parts, Purpose purpose) : parts_(parts), purpose_(purpose) {}

  Value call(const Call& call, Scope& scope, const Spot& spot, const text::Place& place);
  /// A procedure that stands in the library.
  Value procedure(const Word& callee, const flow::Library::Entry& entry,
                  const std::vector<GivenArgument>& given, const std::string& path, const text::Place& place);
  /// The value of an assemblage whose parameters have theirs.
  Value assemblage(const Assemblage& assemblage, Scope& scope, const text::Place& place);
  /// The same, with all of its `let`s, whoever calls it: names of the scope are its parameters.
  Value check_value(const Assemblage& assemblage, Scope& scope);
  /// The value of a parameter that nobody gives; nothing where it has no default.
  Value default_of(const Parameter& parameter, Scope& scope);
  Value unknown_callee(const Word& callee);

  // ---- devices

  /// What a device gives that serves a binding point.
  /// @param asked  what is asked of it; what the device itself says holds
  Value serve(const DeviceUse& use, std::vector<GivenArgument> asked, const Spot& spot,
              const text::Place& place);
  /// The value moves the device.
  /// @param path  of the device's node
  void drive(const DeviceUse& use, const Value& value, const std::string& path, const text::Place& place);

 private:
  Value binding(const Call& call, const Binding& binding, Scope& scope, const Spot& spot,
                const text::Place& place);
  /// What a configuration asks for by the name of a binding point, and defaults.
  std::vector<GivenArgument> asked_of(const Binding& binding, const Call& call, Scope& scope,
                                      const text::Place& place);
  Value instantiate(const Word& callee, const std::vector<GivenArgument>& given, const Spot& spot,
                    const text::Place& place);
  Value instantiate_assemblage(const Word& callee, const Assemblage& assemblage,
                               const std::vector<GivenArgument>& given, const Spot& spot,
                               const text::Place& place);
  Value stand_still(const Assemblage& assemblage, Scope& scope, const PortType& result,
                    const text::Place& place);
  Value value_of(const GivenArgument& given);
  void link_argument(const InputView& view, const GivenArgument& given, flow::Node& node);
  bool enter(const Assemblage& assemblage, const Word& callee);

  const Parts parts_;
  const Purpose purpose_;
  std::vector<const Assemblage*> open_;  // that are being instantiated
};

}  // namespace mlab::cdl
