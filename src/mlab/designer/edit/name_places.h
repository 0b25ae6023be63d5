#pragma once

#include <cstdint>
#include <optional>

#include "mlab/designer.pb.h"
#include "mlab/designer/drawing/model.h"

namespace mlab::designer {

/// The byte of the text where the name of something that is drawn begins; nothing where it has none: a value,
/// an operator, an unnamed call where its own name is asked for.
std::optional<std::uint32_t> name_place(const Model& model, const NameAt& at);

}  // namespace mlab::designer
