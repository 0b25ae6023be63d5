#pragma once

#include <string>
#include <vector>

#include "mlab/console.pb.h"
#include "mlab/overlay/overlay.h"
#include "mlab/text/diagnostic.h"
#include "mlab/text/splice.h"

namespace mlab::console {

/// The texts that a map is made of.
struct MapTexts {
  struct OverlayText {
    std::string path;  ///< as the browser names it
    text::SourcePtr source;
  };
  text::SourcePtr mission;
  std::vector<OverlayText>
      overlays;  ///< in the order in which the mission names them first; some may come again
  /// Of every OVERLAY statement: the index of its overlay; kMissing where it could not be opened.
  std::vector<std::uint32_t> order;
  static constexpr std::uint32_t kMissing = ~0U;
  const overlay::Overlay* map = nullptr;  ///< what these texts mean; its places are in them
};

/// A change of one of the texts.
struct TextEdit {
  text::SourcePtr source;
  text::Splice splice;
};

/// Changes of the map as changes of the texts that say it: of overlays, and of SP, OBSTACLE and MISSION-AREA
/// in the mission. Only the words that have to change do; everything else stays byte for byte. Coordinates
/// are written to 0.01 m, those that did not change stay as they were written; a UTM point that is moved
/// becomes metres. Where a place gets another name, the commands that name it do too.
///
/// Indices are those of the scene (obstacles: `obstacles_in_scene_order`).
/// @param target  path of the overlay that new things go to; empty: the first one
/// @errors  a sentence for a person: a thing that stands in no text, points that a kind can't have, a name
/// that would
///          change what commands mean, two changes of the same thing
text::Result<std::vector<TextEdit>> edit_map(const MapTexts& texts,
                                             const google::protobuf::RepeatedPtrField<MapChange>& changes,
                                             const std::string& target);

/// Random obstacles of the historic generator as OBSTACLE statements, over the mission area. With `replace`,
/// all that are written and the mission's CREATE-OBSTACLES go; without, the new ones keep clear of them.
/// @param is_complete  false where no room was found for all
/// @errors  coverage not in 0..30, radii that are not above 0
text::Result<std::vector<TextEdit>> create_obstacles(const MapTexts& texts, const CreateObstacles& request,
                                                     std::uint32_t seed, bool& is_complete);

}  // namespace mlab::console
