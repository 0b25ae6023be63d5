#pragma once

#include <optional>
#include <string_view>

#include "mlab/mission/mission.h"
#include "mlab/robot/program/places.h"

namespace mlab::run {

/// The places of a mission's overlays. Of what has several points it is the middle, as for commands;
/// coordinates have the overlays' origin added.
class MissionPlaces final : public robot::Places {
 public:
  /// The mission must outlive it.
  explicit MissionPlaces(const mission::Mission& mission) : mission_(mission) {}

  std::optional<geom::Point> find(std::string_view words) const override;
  void explain(std::string_view words, text::Diagnostic& diagnostic) const override;

 private:
  const mission::Mission& mission_;
};

}  // namespace mlab::run
