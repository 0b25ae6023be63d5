#pragma once

#include <string>
#include <utility>
#include <vector>

#include "mlab/designer/drawing/sizes.h"
#include "mlab/lang/cdl/configuration.h"

namespace mlab::designer {

/// Something drawn, and where its upper left corner is.
struct DrawnBox {
  std::string name;
  double x = 0.0;
  double y = 0.0;
  DrawnSize size;
};

/// Moves boxes right and down until none lies on another and there is room between them. What was left of,
/// right of, above or below something stays so; what has room already stays where it is.
void spread(std::vector<DrawnBox>& boxes, double room_across, double room_down);

/// How far right or down, whichever is less, `boxes` have to go as a whole until none lies on one of `taken`,
/// and there is room between them [pixels]. Nothing where they are free as they stand.
std::pair<double, double> way_aside(const std::vector<DrawnBox>& boxes, const std::vector<DrawnBox>& taken);

/// `spread` for every page of a configuration that has a layout: those that came from elsewhere do not know
/// how large things are drawn here. A text that can't be read comes back as it is.
std::string spread_out(std::string text, const cdl::Environment& environment);

/// What of a page its author has placed.
std::vector<DrawnBox> placed_boxes(const Drawing& drawing);

}  // namespace mlab::designer
