#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "mlab/flow/program.h"
#include "mlab/geom/pose.h"
#include "mlab/text/diagnostic.h"

namespace mlab::robot {

/// The named places of a mission, for parameters of type Point. Whoever knows missions has them.
class Places {
 public:
  virtual ~Places() = default;
  /// Where a place is that people write so: a name, or two coordinates as a mission has them.
  /// @return  nothing where there is none of the name
  virtual std::optional<geom::Point> find(std::string_view words) const = 0;
  /// Adds what was meant perhaps to what is said of a place that is not there.
  virtual void explain(std::string_view words, text::Diagnostic& diagnostic) const = 0;
};

/// A point as parameters are set to it.
std::string point_words(geom::Point point);
/// What somebody sets a parameter to, as its program reads it: of a place its coordinates, if it is one.
std::string in_coordinates(const flow::Port& port, const std::string& value, const Places& places);

}  // namespace mlab::robot
