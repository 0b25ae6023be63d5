#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mlab/lang/mdl/tree.h"
#include "mlab/overlay/overlay.h"
#include "mlab/text/source.h"

namespace mlab::console {

/// A name by which a command of the mission means a place of the map.
struct PlaceReference {
  text::Span word;
  std::string name;
  std::uint32_t measure = 0;  ///< index into the overlay
};

/// All of a mission that are found on the map.
std::vector<PlaceReference> place_references(const mdl::Tree& mission, const overlay::Overlay& map);

/// What is to stand instead of a reference, so that it means `measure` of the changed map: with the word for
/// its kind where the author wrote one. Empty where no name does.
std::string renamed_reference(const PlaceReference& reference, const overlay::Overlay& changed,
                              std::uint32_t measure);

}  // namespace mlab::console
