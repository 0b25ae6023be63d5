#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mlab/lang/mdl/mdl.h"
#include "mlab/lang/mdl/names.h"
#include "mlab/lang/mdl/settings.h"
#include "mlab/lang/mdl/tree.h"
#include "mlab/mission/mission.h"
#include "mlab/text/diagnostic.h"

namespace mlab::mdl {

/// Carries out the preamble in file order, which builds everything of a mission but its steps.
class Preamble {
 public:
  /// @param damage  what is missing for the rest is added here: places, where an overlay could not be read
  Preamble(mission::Mission& mission, Roster& roster, Damage& damage, std::string folder,
           const LoadOptions& options, Settings& settings, text::Diagnostics& diagnostics);

  /// All but random obstacles.
  void run(const Tree& tree);
  /// Does what CREATE-OBSTACLES asked for; to be called after `run`.
  void create_requested_obstacles();
  /// As the author wrote them.
  const std::vector<std::string>& overlays() const { return overlays_; }

 private:
  void execute(const Statement& statement);
  void load_overlay(const Name& file);
  std::optional<std::string> find_overlay(const Name& file) const {
    return mdl::find_overlay(file.text, folder_, options_);
  }
  void report_missing_overlay(const Name& file, const text::Place& at);
  void load_map(const Name& file);
  void set_area(const statement::MissionArea& area);
  void add_start_place(const statement::StartPlace& start);
  void add_obstacle(const statement::Obstacle& obstacle);
  void request_obstacles(text::Span span);
  void add_failsafe(const statement::Failsafe& failsafe, text::Span span);
  bool check_that_it_acts(const mission::Failsafe& failsafe);
  /// The corners of what OUTSIDE names; reports what has none.
  std::optional<std::vector<geom::Point>> read_fence(const Name& name);
  /// Runs `change` on the overlay and puts the options back that hang on an area or zoom stated by it.
  template <class Change>
  void with_overlay_changes(Change change);
  text::Place place(text::Span span) const { return {source_, span}; }

  /// What CREATE-OBSTACLES meant when it was executed. Only the last one leaves a trace.
  struct Request {
    mission::Options options;
    overlay::Area area;
    text::Span span;
  };

  mission::Mission& mission_;
  Roster& roster_;
  Damage& damage_;
  std::string folder_;
  const LoadOptions& options_;
  Settings& settings_;
  text::Diagnostics& diagnostics_;
  text::SourcePtr source_;
  std::vector<std::string> overlays_;
  std::size_t maps_ = 0;
  std::optional<Request> request_;
};

/// Fills the area with random obstacles as the options say; warns at `place` where they don't find room.
///
/// @param seed  where the options have none
std::vector<overlay::ObstacleDisc> create_obstacles(const mission::Options& options, overlay::Area area,
                                                    std::uint64_t seed, const text::Place& place,
                                                    text::Diagnostics& diagnostics);

/// Reads an obstacle of a mission or a typed line; reports a radius that is none.
std::optional<overlay::ObstacleDisc> read_obstacle(const statement::Obstacle& obstacle, geom::Offset origin,
                                                   const text::SourcePtr& source,
                                                   text::Diagnostics& diagnostics);

}  // namespace mlab::mdl
