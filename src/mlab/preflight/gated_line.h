#pragma once

#include <memory>
#include <string>

#include "mlab/preflight/gate.h"
#include "mlab/vehicle/line.h"

namespace mlab::preflight {

/// The way to a vehicle on which nothing passes, in either direction, before the permit lets it: a run that
/// was not let pass does not know where its vehicle is, so no robot gets it as its body.
std::unique_ptr<vehicle::Line> gated(std::string vehicle, std::unique_ptr<vehicle::Line> line,
                                     std::shared_ptr<const Permit> permit);

}  // namespace mlab::preflight
