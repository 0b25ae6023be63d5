#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "mlab/lang/mdl/mdl.h"
#include "mlab/mission/maneuver.h"
#include "mlab/mission/mission.h"
#include "mlab/overlay/overlay.h"
#include "mlab/text/diagnostic.h"

namespace mlab::mdl {

/// What LoadOptions::settings do to a mission while it is read, and what is wrong with them.
class Settings {
 public:
  /// Both outlive it.
  Settings(const std::vector<Setting>& all, text::Diagnostics& diagnostics);

  /// Says where OVERLAY can't be told which.
  /// @param count  overlays that the mission names
  void check_overlays(std::size_t count);
  /// What is read in place of the overlay that the mission names so; null: itself.
  const Setting* in_place_of_overlay(std::string_view file);

  /// The mission's own SET of it does not count.
  bool replaces(const std::variant<mission::BooleanOption, mission::NumberOption>& option) const;
  /// To be called where the options are used; the area says which numbers it takes.
  void set_options(mission::Options& options, overlay::Area area);
  /// Those that a step sets itself.
  void set_options(mission::Step& step, const mission::Options& options) const;
  /// The formations that steps name.
  void set_formations(std::vector<mission::Step>& steps);

  /// Adds parameters to types, and says what was meant for nothing that the mission has.
  /// @param is_damaged  a type is missing because of a mistake that was told
  void set_parameters(mission::Mission& mission, bool is_damaged);

 private:
  struct Kept {
    const Setting* setting = nullptr;
    std::optional<mission::NumberOption> number;
    const mission::ManeuverInfo* maneuver = nullptr;  // of which two words stand
    bool is_overlay = false;
    bool is_formation = false;
    std::string_view of;    // `scout` of `scout:base_velocity`; empty: all
    std::string_view name;  // without it
    bool was_used = false;  // or is told to be wrong
  };

  void set_number(Kept& kept, mission::Options& options, overlay::Area area);
  void set_maneuver(Kept& kept, mission::Options& options);

  std::vector<Kept> all_;
  text::Diagnostics& diagnostics_;
};

}  // namespace mlab::mdl
