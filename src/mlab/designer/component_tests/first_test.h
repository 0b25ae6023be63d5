#pragma once

#include <string>

#include "mlab/designer/drawing/model.h"
#include "mlab/text/diagnostic.h"

namespace mlab::designer {

/// A test of an assemblage for somebody who has written none yet: it can be read as it stands, and says
/// something about what the assemblage gives. Ends with a newline.
///
/// @param component  an assemblage of the text itself; empty: its first one
/// @errors  a sentence: there is no such assemblage, a parameter that nothing could be assumed for
text::Result<std::string> first_test_of(const Model& model, const std::string& component);

}  // namespace mlab::designer
