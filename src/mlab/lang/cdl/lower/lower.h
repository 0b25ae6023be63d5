#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>

#include "mlab/flow/library.h"
#include "mlab/flow/network.h"
#include "mlab/flow/program.h"
#include "mlab/lang/cdl/configuration.h"
#include "mlab/text/diagnostic.h"

namespace mlab::cdl {

/// What was said of a configuration already: an assemblage that two robots use is wrong once.
struct EarlierFindings {
  std::set<std::string> keys;
  std::set<std::string> wrong_classes;  ///< with errors of their own, which their robots would say again
  /// Of assemblages that were checked: the type and unit of their value. Calls need not look into them again.
  std::map<const Assemblage*, std::pair<const flow::TypeInfo*, std::string>> results;
};

/// A robot made flat: what its program is built from, and what its class says of the body.
struct LoweredRobot {
  flow::Network network;
  std::map<std::string, double> body;  ///< `radius`: 0.35, ... in SI units
};

/// Flattens one robot: recursion resolved, parameters and arguments bound, binding points served by the
/// devices of the robot's class, or by the operator of the society that it is in. Each node carries the place
/// of the CDL that made it.
///
/// @param library  knows the procedures of the configuration as well
/// @errors  everything that is wrong with what the robot uses; the network then is not to be built
LoweredRobot lower(const Configuration& configuration, const Robot& robot, const flow::Library& library,
                   text::Diagnostics& sink, EarlierFindings& said);

/// The program of a flattened robot. Null where there were errors: loops that no delay breaks, and whatever
/// only shows when all is put together.
std::shared_ptr<const flow::Program> build(const LoweredRobot& robot, const flow::Library& library,
                                           text::Diagnostics& sink, EarlierFindings& said);

/// Checks all that the configuration's own files declare, used or not, except for the robots.
void check_declarations(const Configuration& configuration, const flow::Library& library,
                        text::Diagnostics& sink, EarlierFindings& said);

/// What is odd about them and no error: to be asked only where nothing has errors, since these may be the
/// cause.
void warn_of_declarations(const Configuration& configuration, const flow::Library& library,
                          text::Diagnostics& sink);

/// Checks the robots as well: `mlab check`.
void check(const Configuration& configuration, const flow::Library& library, text::Diagnostics& sink);

}  // namespace mlab::cdl
