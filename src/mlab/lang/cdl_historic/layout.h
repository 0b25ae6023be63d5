#pragma once

#include <string>
#include <vector>

#include "mlab/lang/cdl/syntax/tree.h"

namespace mlab::cdl_historic {

/// A node of a drawing and where the historic screen showed it [pixels].
struct Node {
  std::string name;
  double x = 0.0;
  double y = 0.0;
};

/// The drawing of one assemblage, robot or society.
struct Drawing {
  std::string owner;
  std::vector<Node> nodes;
};

/// Room that a node takes on our canvas, with its margin [canvas units].
inline constexpr double kNodeWidth = 200.0;
inline constexpr double kNodeHeight = 90.0;

/// Scales a drawing to our canvas and moves nodes apart where they overlap. What was left of, right of, above
/// or below something stays so.
cdl::Layout laid_out(const Drawing& drawing);

}  // namespace mlab::cdl_historic
