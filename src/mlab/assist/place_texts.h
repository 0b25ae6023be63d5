#pragma once

#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "mlab/assist/languages.h"
#include "mlab/assist/targets.h"
#include "mlab/lang/mdl/names.h"
#include "mlab/overlay/overlay.h"

namespace mlab::assist {

/// What the texts of `place("Pond")` in configurations name: places on the maps of the project's missions
/// that run those configurations. The missions are read once, when something asks for the first time.
class PlaceTexts {
 public:
  /// @param around  outlives this
  explicit PlaceTexts(const Surroundings& around) : around_(around) {}

  /// Ascending; for one text as many names as there are places that it means on different maps.
  std::vector<Name> in(const Text& configuration);

 private:
  struct Map {
    explicit Map(overlay::Overlay of) : overlay(std::move(of)), places(overlay) {}
    Map(const Map&) = delete;
    Map& operator=(const Map&) = delete;
    overlay::Overlay overlay;
    mdl::PlaceIndex places;
  };

  void read_missions();
  void read_mission(const Text& mission);
  /// A configuration, and what it uses, stand on a map.
  void join(const std::string& path, const Map& map);
  const std::vector<std::string>& used_by(const std::string& path);

  const Surroundings& around_;
  Targets targets_;
  bool is_read_ = false;
  std::deque<Map> maps_;
  std::map<std::string, std::vector<const Map*>> maps_of_;   // by canonical path of the configuration
  std::map<std::string, std::vector<std::string>> used_by_;  // canonical paths
  std::map<std::string, text::SourcePtr> sources_;           // of the project's configurations
};

}  // namespace mlab::assist
