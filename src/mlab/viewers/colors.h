#pragma once

#include <string_view>

#include "mlab/viewers.pb.h"

namespace mlab::viewers {

/// A colour by its X11 name, in any letter case, with or without blanks. One that is not known is a grey.
/// @param alpha  0: can't be seen, 1: covers what is behind
foxglove::Color color_named(std::string_view name, double alpha = 1.0);

}  // namespace mlab::viewers
