#pragma once

#include <limits>
#include <string>

namespace mlab::training {

/// A column of an array: one number of each robot.
struct Column {
  std::string name;  ///< `cruise`, `goal.x`, `body.ranges.3`
  std::string unit;  ///< as it stands in the array: angles are in radians; empty: none
  std::string help;
  double low = -std::numeric_limits<double>::infinity();  ///< least value that it takes, or can have
  double high = std::numeric_limits<double>::infinity();
};

}  // namespace mlab::training
