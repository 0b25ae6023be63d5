#include "mlab/lang/mdl/preamble.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

#include <fmt/core.h>

#include "mlab/lang/mdl/options.h"
#include "mlab/lang/mdl/quoted.h"
#include "mlab/lang/mdl/unknown_measure.h"
#include "mlab/lang/odl/odl.h"
#include "mlab/overlay/random_obstacles.h"

namespace mlab::mdl {
namespace {

namespace fs = std::filesystem;

// Files are read one by one, so a mission that names endless many must not keep the machine busy.
constexpr std::size_t kMaxOverlays = 100;
constexpr std::size_t kMaxMaps = 100;
constexpr std::size_t kMaxFenceCorners = 1000;

// All on one straight line, or nearly so.
bool are_in_line(std::span<const geom::Point> points) {
  constexpr double kAside = 1e-3;  // [m]
  if (points.size() < 3) return true;
  const auto far = [&](geom::Point p) { return geom::distance(p, points.front()); };
  const geom::Segment line{points.front(), *std::ranges::max_element(points, {}, far)};
  return std::ranges::all_of(
      points, [&](geom::Point p) { return geom::distance(nearest_point(line, p), p) < kAside; });
}
constexpr double kMaxFailsafeSeconds = 86'400.0;

}  // namespace

std::optional<std::string> find_overlay(const std::string& name, const std::string& folder,
                                        const LoadOptions& options) {
  if (name.empty() || name.find('\0') != std::string::npos) return std::nullopt;
  std::vector<std::string> folders = {folder, ""};
  folders.insert(folders.end(), options.overlay_folders.begin(), options.overlay_folders.end());
  for (const std::string& each : folders) {
    std::string path = (fs::path(each) / name).lexically_normal().string();
    if (options.files.is_file(path)) return path;
  }
  return std::nullopt;
}

Preamble::Preamble(mission::Mission& mission, Roster& roster, Damage& damage, std::string folder,
                   const LoadOptions& options, Settings& settings, text::Diagnostics& diagnostics)
    : mission_(mission),
      roster_(roster),
      damage_(damage),
      folder_(std::move(folder)),
      options_(options),
      settings_(settings),
      diagnostics_(diagnostics) {}

void Preamble::run(const Tree& tree) {
  source_ = tree.source;
  std::size_t overlays = 0;
  for (const Statement& statement : tree.preamble) {
    if (const auto* robot = std::get_if<statement::NewRobot>(&statement.what))
      roster_.announce_type(robot->name);
    if (std::holds_alternative<statement::OverlayFile>(statement.what)) ++overlays;
  }
  settings_.check_overlays(overlays);
  for (const Statement& statement : tree.preamble) execute(statement);
  settings_.set_options(mission_.options, mission_.overlay.mission_area());
  roster_.define_units_of_societies();
}

void Preamble::execute(const Statement& statement) {
  if (const auto* name = std::get_if<statement::MissionName>(&statement.what)) {
    mission_.name = name->name.text;
  } else if (const auto* scenario = std::get_if<statement::Scenario>(&statement.what)) {
    mission_.scenario = scenario->name.text;
  } else if (const auto* overlay = std::get_if<statement::OverlayFile>(&statement.what)) {
    load_overlay(overlay->file);
  } else if (const auto* area = std::get_if<statement::MissionArea>(&statement.what)) {
    set_area(*area);
  } else if (const auto* map = std::get_if<statement::LoadMap>(&statement.what)) {
    load_map(map->file);
  } else if (const auto* start = std::get_if<statement::StartPlace>(&statement.what)) {
    add_start_place(*start);
  } else if (const auto* obstacle = std::get_if<statement::Obstacle>(&statement.what)) {
    add_obstacle(*obstacle);
  } else if (std::holds_alternative<statement::CreateObstacles>(statement.what)) {
    request_obstacles(statement.span);
  } else if (const auto* robot = std::get_if<statement::NewRobot>(&statement.what)) {
    if (!roster_.define_type(*robot)) damage_.types = damage_.units = true;
  } else if (const auto* unit = std::get_if<statement::UnitDefinition>(&statement.what)) {
    roster_.define_unit(*unit);
  } else if (const auto* set = std::get_if<statement::Set>(&statement.what)) {
    if (settings_.replaces(set->option)) return;
    const auto command =
        read_set(*set, mission_.options, mission_.overlay.mission_area(), source_, diagnostics_);
    if (command) apply_set(*command, mission_.options);
  } else if (const auto* print = std::get_if<statement::Print>(&statement.what)) {
    mission_.prints.push_back({print->robot_info});
  } else if (const auto* failsafe = std::get_if<statement::Failsafe>(&statement.what)) {
    add_failsafe(*failsafe, statement.span);
  }
}

template <class Change>
void Preamble::with_overlay_changes(Change change) {
  overlay::Overlay& overlay = mission_.overlay;
  const std::optional<overlay::Area> area = std::exchange(overlay.area, std::nullopt);
  const std::optional<double> zoom = std::exchange(overlay.zoom_percent, std::nullopt);
  const std::string scenario = std::exchange(overlay.scenario, "");
  change();
  if (overlay.area) {
    reset_for_area(*overlay.area, mission_.options);
  } else {
    overlay.area = area;
  }
  if (overlay.zoom_percent) {
    mission_.options.zoom_percent = *overlay.zoom_percent;
  } else {
    overlay.zoom_percent = zoom;
  }
  if (overlay.scenario.empty()) {
    overlay.scenario = scenario;
  } else {
    mission_.scenario = overlay.scenario;
  }
}

void Preamble::load_overlay(const Name& file) {
  if (overlays_.size() == kMaxOverlays) {
    diagnostics_.error("too-many-overlays", place(file.span),
                       fmt::format("a mission has at most {} overlays", kMaxOverlays));
  }
  const Setting* instead = settings_.in_place_of_overlay(file.text);
  Name used = file;
  if (instead != nullptr) used.text = instead->value;
  overlays_.push_back(used.text);
  if (overlays_.size() > kMaxOverlays) return;
  const std::optional<std::string> path = find_overlay(used);
  if (!path) {
    report_missing_overlay(used, instead != nullptr ? instead->value_place : place(file.span));
    damage_.places = true;
    return;
  }
  with_overlay_changes([&] {
    if (!odl::load_overlay(*path, mission_.overlay, diagnostics_, options_.files)) damage_.places = true;
  });
}

// Old missions name files by suffixes that their overlays no longer have, so the other one is tried for a
// hint.
void Preamble::report_missing_overlay(const Name& file, const text::Place& at) {
  auto& error = diagnostics_.error("missing-overlay", at,
                                   fmt::format("there is no overlay {}", in_backticks(file.text)));
  error.label = "neither beside the mission nor in the current folder";
  for (const char* suffix : {".odl", ".ovl"}) {
    Name other = file;
    other.text = fs::path(file.text).replace_extension(suffix).string();
    if (find_overlay(other)) error.hints.push_back(fmt::format("there is {}", in_backticks(other.text)));
  }
}

void Preamble::load_map(const Name& file) {
  if (maps_++ == kMaxMaps) {
    diagnostics_.error("too-many-maps", place(file.span),
                       fmt::format("a mission loads at most {} maps", kMaxMaps));
  }
  if (maps_ > kMaxMaps) return;
  const std::string mission_file = (fs::path(folder_) / "mission").string();
  with_overlay_changes([&] {
    odl::load_map(file.text, mission_file, place(file.span), mission_.overlay, diagnostics_, options_.files);
  });
}

void Preamble::set_area(const statement::MissionArea& area) {
  for (const Number* side : {&area.width, &area.height}) {
    if (side->value > 0.0) continue;
    diagnostics_.error("number-out-of-range", place(side->span),
                       fmt::format("a side of the mission area is longer than 0 metres, found {}",
                                   in_backticks(side->text)));
    return;
  }
  if (!check_lengths({&area.width, &area.height}, "a side of the mission area", source_, diagnostics_))
    return;
  mission_.overlay.area = overlay::Area{area.width.value, area.height.value};
  reset_for_area(*mission_.overlay.area, mission_.options);
}

void Preamble::add_start_place(const statement::StartPlace& start) {
  if (!check_lengths({&start.x, &start.y}, "a coordinate", source_, diagnostics_)) return;
  overlay::ControlMeasure measure;
  measure.kind = overlay::MeasureKind::kStartPoint;
  measure.name = start.name.text;
  measure.shows_label = !measure.name.ends_with('*');
  if (!measure.shows_label) measure.name.pop_back();
  measure.points = {geom::Point{start.x.value, start.y.value} + mission_.overlay.origin};
  measure.place = place(start.name.span);
  mission_.overlay.measures.push_back(std::move(measure));
}

void Preamble::add_obstacle(const statement::Obstacle& obstacle) {
  if (const auto read = read_obstacle(obstacle, mission_.overlay.origin, source_, diagnostics_)) {
    mission_.overlay.obstacles.push_back(*read);
  }
}

void Preamble::add_failsafe(const statement::Failsafe& failsafe, text::Span span) {
  const mission::FailsafeConditionInfo& condition = mission::info(failsafe.condition);
  mission::Failsafe out{.condition = failsafe.condition,
                        .action = failsafe.action,
                        .type_name = failsafe.type ? failsafe.type->text : "",
                        .types = {},
                        .seconds = failsafe.seconds ? failsafe.seconds->value : condition.default_seconds,
                        .share = failsafe.share ? failsafe.share->value / 100.0 : 0.0,
                        .fence_name = failsafe.fence ? failsafe.fence->text : "",
                        .fence = {},
                        .place = place(span)};
  if (mission_.failsafes.size() == mission::kMostFailsafes) {
    diagnostics_.error("too-many-failsafes", place(span),
                       fmt::format("a mission has at most {} failsafes", mission::kMostFailsafes));
    return;
  }
  if (!(out.seconds >= 0.0) || out.seconds > kMaxFailsafeSeconds) {
    diagnostics_.error("number-out-of-range", place(failsafe.seconds->span),
                       fmt::format("AFTER goes from 0 to {:g} seconds, found {}", kMaxFailsafeSeconds,
                                   in_backticks(failsafe.seconds->text)));
    return;
  }
  if (failsafe.share && !(out.share > 0.0 && out.share <= 1.0)) {
    diagnostics_.error(
        "number-out-of-range", place(failsafe.share->span),
        fmt::format("BELOW is more than 0 and at most 100 %, found {}", in_backticks(failsafe.share->text)));
    return;
  }
  if (mission::info(failsafe.action).needs_fence && !condition.has_fence) {
    diagnostics_
        .error("failsafe-without-fence", place(failsafe.action_span),
               fmt::format("{} has no line to drive back from", condition.word))
        .hints.emplace_back("`REVERSE INSIDE` goes with OUTSIDE");
    return;
  }
  if (failsafe.type) {
    auto types = roster_.types_named(*failsafe.type);
    if (!types) return;
    out.types = std::move(*types);
  }
  if (failsafe.fence) {
    auto fence = read_fence(*failsafe.fence);
    if (!fence) return;
    out.fence = std::move(*fence);
  }
  if (!check_that_it_acts(out)) return;
  mission_.failsafes.push_back(std::move(out));
}

// One that an earlier row always is before would never act.
bool Preamble::check_that_it_acts(const mission::Failsafe& failsafe) {
  const auto is_always_before = [&](const mission::Failsafe& before) {
    const auto is_of = [&](const std::string& type) { return before.is_of(type); };
    const bool has_same_robots =
        before.types.empty() || (!failsafe.types.empty() && std::ranges::all_of(failsafe.types, is_of));
    return has_same_robots && before.condition == failsafe.condition && before.fence == failsafe.fence &&
           before.share >= failsafe.share && before.seconds <= failsafe.seconds;
  };
  const auto before = std::ranges::find_if(mission_.failsafes, is_always_before);
  if (before == mission_.failsafes.end()) return true;
  diagnostics_
      .error("failsafe-never-acts", failsafe.place,
             fmt::format("{} stands above it, is never later, and has the higher rank",
                         in_backticks(mission::words_of(*before))))
      .notes.push_back({"it stands here", before->place});
  return false;
}

std::optional<std::vector<geom::Point>> Preamble::read_fence(const Name& name) {
  const overlay::ControlMeasure* found = overlay::find_measure(mission_.overlay, name.text);
  if (found == nullptr) {
    if (!damage_.places)
      report_unknown_measure(name, mission_.overlay, overlays_, PlaceIndex(mission_.overlay), source_,
                             diagnostics_);
    return std::nullopt;
  }
  std::vector<geom::Point> out = found->points;
  if (out.size() > 1 && out.front() == out.back()) out.pop_back();
  std::string problem;
  if (found->kind != overlay::MeasureKind::kBoundary) {
    problem = fmt::format("is a {}: a fence is a BOUNDARY", overlay::info(found->kind).keyword);
  } else if (out.size() > kMaxFenceCorners) {
    problem = fmt::format("has {} corners: a fence has at most {}", out.size(), kMaxFenceCorners);
  } else if (are_in_line(out)) {
    problem = "encloses nothing: a fence is a BOUNDARY of three points or more that are not in line";
  } else {
    return out;
  }
  auto& error = diagnostics_.error("no-fence", place(name.span),
                                   fmt::format("{} {}", in_backticks(name.text), problem));
  error.notes.push_back({"it is declared here", found->place});
  return std::nullopt;
}

void Preamble::request_obstacles(text::Span span) {
  std::vector<overlay::ObstacleDisc>& before = mission_.overlay.obstacles;
  if (!before.empty()) {
    diagnostics_
        .warning("obstacles-removed", place(span),
                 before.size() == 1
                     ? "CREATE-OBSTACLES removes the obstacle that was placed before it"
                     : fmt::format("CREATE-OBSTACLES removes the {} obstacles that were placed before it",
                                   before.size()))
        .notes.push_back({"the first one is here", before.front().place});
  }
  before.clear();
  settings_.set_options(mission_.options, mission_.overlay.mission_area());
  request_ = Request{mission_.options, mission_.overlay.mission_area(), span};
}

void Preamble::create_requested_obstacles() {
  if (!request_) return;
  mission_.has_obstacles_by_seed = !request_->options.seed;
  std::vector<overlay::ObstacleDisc> created =
      create_obstacles(request_->options, request_->area, options_.seed, place(request_->span), diagnostics_);
  std::vector<overlay::ObstacleDisc>& placed = mission_.overlay.obstacles;
  placed.insert(placed.begin(), created.begin(), created.end());
}

std::vector<overlay::ObstacleDisc> create_obstacles(const mission::Options& options, overlay::Area area,
                                                    std::uint64_t seed, const text::Place& place,
                                                    text::Diagnostics& diagnostics) {
  const overlay::ObstacleField field{options.obstacle_coverage, options.min_obstacle_radius,
                                     options.max_obstacle_radius};
  if (field.min_radius > field.max_radius) {
    diagnostics.warning(
        "radii-exchanged", place,
        fmt::format("MIN-OBSTACLE-RADIUS {:g} is more than MAX-OBSTACLE-RADIUS {:g}; they change places",
                    field.min_radius, field.max_radius));
  }
  const std::uint32_t used_seed =
      options.seed ? overlay::obstacle_seed(*options.seed) : static_cast<std::uint32_t>(seed);
  overlay::CreatedObstacles created = overlay::create_obstacles(area, field, used_seed);
  if (!created.is_complete) {
    diagnostics.warning(
        "obstacles-left-out", place,
        fmt::format("after {} obstacles no room was found for more", created.obstacles.size()));
  }
  for (overlay::ObstacleDisc& obstacle : created.obstacles) obstacle.place = place;
  return std::move(created.obstacles);
}

std::optional<overlay::ObstacleDisc> read_obstacle(const statement::Obstacle& obstacle, geom::Offset origin,
                                                   const text::SourcePtr& source,
                                                   text::Diagnostics& diagnostics) {
  const text::Place all{source, {obstacle.x.span.begin, obstacle.radius.span.end}};
  if (!(obstacle.radius.value > 0.0)) {
    diagnostics.error("number-out-of-range", {source, obstacle.radius.span},
                      fmt::format("an obstacle's radius is more than 0 metres, found {}",
                                  in_backticks(obstacle.radius.text)));
    return std::nullopt;
  }
  if (!check_lengths({&obstacle.x, &obstacle.y}, "a coordinate", source, diagnostics)) return std::nullopt;
  if (!check_lengths({&obstacle.radius}, "a radius", source, diagnostics)) return std::nullopt;
  return overlay::ObstacleDisc{geom::Point{obstacle.x.value, obstacle.y.value} + origin,
                               obstacle.radius.value, 0.0, all};
}

}  // namespace mlab::mdl
