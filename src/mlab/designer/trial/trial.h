#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "mlab/designer/drawing/model.h"
#include "mlab/geom/pose.h"
#include "mlab/overlay/overlay.h"
#include "mlab/text/diagnostic.h"

namespace mlab::designer {

/// What of a configuration is to be seen running.
struct TrialWish {
  std::string declaration;  ///< assemblage, robot or society; empty: the only society, robot or assemblage
  int count = 1;            ///< of an assemblage or robot
};

/// The configuration with all that it lacks to run: a body, a robot.
struct TrialConfiguration {
  text::SourcePtr source;                           ///< named as that of the model
  std::vector<std::pair<std::string, int>> robots;  ///< declarations, and how many of each
  std::vector<std::string> notes;                   ///< what was assumed, sentences for a person
};

/// Completes a configuration. What its author wrote stays where it is, but for what is put behind a robot's
/// name to give it a class.
///
/// @errors  a sentence for a person: nothing or several that could be meant, nothing that moves a robot, a
///          parameter that nothing could be assumed for
text::Result<TrialConfiguration> complete_for_trial(const std::shared_ptr<const Model>& model,
                                                    const cdl::Environment& environment,
                                                    const TrialWish& wish);

/// What a parameter that has to be given could be; empty: nobody can know.
std::string stand_in(const cdl::Parameter& parameter);

/// Where a byte of the completed text stands in the author's; what was added counts as its end or the place
/// where it was put.
std::uint32_t place_before_trial(std::string_view author, std::string_view completed, std::uint32_t byte);

/// What a trial's robots are started on.
struct TrialField {
  std::string overlay;              ///< as a mission names it
  geom::Point origin;               ///< of the mission's coordinates [m, world]
  geom::Point goal;                 ///< of the robots' order [m, world]
  std::vector<geom::Point> starts;  ///< at least one [m, world]; robots beyond start beside the last
};

/// The mission that starts all robots, and orders them to a place for ever.
std::string trial_mission(const TrialConfiguration& configuration, const std::string& file,
                          const TrialField& field);

/// An overlay with some obstacles, attractors and a basket, where nobody has chosen one.
extern const char* const kTrialOverlay;
inline constexpr overlay::Area kTrialArea{160.0, 120.0};  ///< of it
inline constexpr geom::Point kTrialStart{80.0, 48.0};
inline constexpr geom::Point kTrialGoal{136.0, 96.0};

}  // namespace mlab::designer
