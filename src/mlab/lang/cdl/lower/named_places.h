#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

#include "mlab/flow/network.h"
#include "mlab/lang/cdl/lower/arguments.h"
#include "mlab/lang/cdl/lower/findings.h"
#include "mlab/lang/cdl/lower/value.h"
#include "mlab/lang/cdl/types/types.h"

namespace mlab::cdl {

/// `place("Gate")`: places that a mission's overlay has, as parameters of the network that the mission sets.
class NamedPlaces {
 public:
  NamedPlaces(const Types& types, Findings& findings, Arguments& arguments, flow::Network& network)
      : types_(types), findings_(findings), arguments_(arguments), network_(network) {}

  /// What no parameter may be called: all that stands in the robot itself.
  void avoid(const NamesBelow& taken) { taken_ = &taken; }
  /// The position of the place.
  Value call(const Call& call, Scope& scope, const text::Place& place);
  /// The name of the place, where the expression is `place("Gate")`; null: it is something else, or wrong.
  const std::string* name_in(const Expression& expression) const;

 private:
  /// What the parameter of a place is called that has none yet.
  std::string parameter_for(std::string_view place);

  const Types& types_;
  Findings& findings_;
  Arguments& arguments_;
  flow::Network& network_;
  const NamesBelow* taken_ = nullptr;
  std::unordered_map<std::string, std::string> parameters_;  // by place
  std::unordered_map<std::string, int> stems_;               // how many places asked for a parameter's name
  std::unordered_set<std::string> names_;                    // of the parameters
};

}  // namespace mlab::cdl
