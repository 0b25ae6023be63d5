#pragma once

#include <string_view>

#include "mlab/designer.pb.h"

// How large things are drawn. The page goes by the same rules (web/designer/drawing/form.ts, states/form.ts);
// there the letters are measured, here they are guessed.

namespace mlab::designer {

/// [pixels at scale 1]
struct DrawnSize {
  double width = 0.0;
  double height = 0.0;
};

DrawnSize size_of(const Node& node, const Drawing& drawing);
DrawnSize size_of(const State& state);

/// How wide a text is, near enough to leave room for it.
/// @param size  of the letters [pixels]
double text_width(std::string_view text, double size, bool is_bold = false);

}  // namespace mlab::designer
