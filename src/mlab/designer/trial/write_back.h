#pragma once

#include <memory>
#include <string>

#include "mlab/designer/edit/edit.h"
#include "mlab/designer/trial/trial.h"

namespace mlab::designer {

/// The text with a live value in it: where the author wrote the constant that a port of the running program
/// has there stands the value then. What is not written but a default is written.
///
/// @param tried  the configuration as it runs, of this model
/// @param port   of a parameter or constant: `movement.Searching.Noise.persistence`
/// @param value  as a person writes it, in the port's edge_unit
/// @errors  a sentence for a person: nothing of the robots has such a port, it is no constant, it stands in
///          another file, the value does not fit
text::Result<Edited> written_back(const std::shared_ptr<const Model>& model,
                                  const cdl::Environment& environment, const TrialConfiguration& tried,
                                  const std::string& port, const std::string& value);

}  // namespace mlab::designer
