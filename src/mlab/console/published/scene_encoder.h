#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "mlab/binding/world_view.h"
#include "mlab/console.pb.h"
#include "mlab/overlay/overlay.h"
#include "mlab/text/diagnostic.h"

namespace mlab::console {

/// Where something stands, for a browser.
struct DocumentPlace {
  std::string document;    ///< empty: nowhere that can be edited
  std::uint32_t line = 0;  ///< from 1; 0: nowhere
};
using PlaceOf = std::function<DocumentPlace(const text::Place&)>;

/// The map as a message, without its revision. What does not stand in a document by itself (obstacles of
/// CREATE-OBSTACLES, what waypoint files bring) has none.
Scene encode_scene(const overlay::Overlay& map, const PlaceOf& place_of);

/// Behind the rest, the obstacles of a world that the scene does not have.
void add_other_obstacles(const binding::WorldView& world, Scene& scene);
/// Another number where other round obstacles are in the world.
std::uint64_t obstacles_key(const binding::WorldView& world);

/// The obstacles of the map in the order in which the scene has them, as indices into `Overlay::obstacles`:
/// first those that stand in a document.
std::vector<std::uint32_t> obstacles_in_scene_order(const overlay::Overlay& map, const PlaceOf& place_of);

/// False for what CREATE-OBSTACLES made: it has the place of that word.
bool is_written(const overlay::ObstacleDisc& obstacle);

Diagnostic encode_diagnostic(const text::Diagnostic& diagnostic, const PlaceOf& place_of);

Measure::Kind encode_kind(overlay::MeasureKind kind);
overlay::MeasureKind decode_kind(Measure::Kind kind);

}  // namespace mlab::console
