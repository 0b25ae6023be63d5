#include "mlab/lang/mdl/commands.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include <fmt/core.h>

#include "mlab/base/angle.h"
#include "mlab/lang/mdl/mission_time.h"
#include "mlab/lang/mdl/options.h"
#include "mlab/lang/mdl/quoted.h"
#include "mlab/lang/mdl/token.h"
#include "mlab/lang/mdl/unknown_measure.h"
#include "mlab/mission/search.h"

namespace mlab::mdl {
namespace {

constexpr double kMinutesOfDay = 24.0 * 60.0;
constexpr double kRadiusOfAPoint = 25.0;    // where no place says another [m]
constexpr std::size_t kMaxPhaseLines = 50;  // of one command
constexpr std::size_t kMaxPlaces = 100;     // of one command
constexpr std::size_t kMostNamedPlaces = 4;
constexpr double kDefaultSwath = 10.0;  // [m]
constexpr double kMinSwath = 0.1;       // [m]
// Of all FOLLOW commands and phase lines together; each has points of its own.
constexpr std::size_t kMaxPoints = 4'000'000;

// How far from the centre of a place one still is there [m].
double radius_of(const overlay::ControlMeasure& measure) {
  const overlay::MeasureInfo& kind = overlay::info(measure.kind);
  const geom::Point center = measure.center();
  double radius = 0.0;
  if (measure.points.size() == 1 && kind.size == overlay::MeasureSize::kDiameter) radius = measure.size / 2.0;
  for (const geom::Point corner : measure.points) {
    if (kind.shape == overlay::MeasureShape::kRegion)
      radius = std::max(radius, geom::distance(corner, center));
  }
  return radius > 0.0 ? radius : kRadiusOfAPoint;
}

// Those that FOLLOW takes, in the order of the alphabet.
std::string words_of_lines() {
  std::vector<std::string> words;
  for (const overlay::MeasureInfo& measure : overlay::kMeasures) {
    if (measure.is_line) words.emplace_back(measure.keyword);
  }
  std::ranges::sort(words);
  return listed(words, " and ");
}

std::string written(const Location& location) {
  return location.name ? location.name->text : location.x.text + " " + location.y.text;
}

}  // namespace

CommandReader::CommandReader(Scope scope, text::SourcePtr source, text::Diagnostics& diagnostics)
    : scope_(std::move(scope)), source_(std::move(source)), diagnostics_(diagnostics) {}

std::optional<mission::Command> CommandReader::read(const Statement& statement) {
  if (const auto* action = std::get_if<statement::UnitAction>(&statement.what)) return unit_command(*action);
  if (const auto* set = std::get_if<statement::Set>(&statement.what)) {
    return read_set(*set, scope_.mission.options, scope_.mission.overlay.mission_area(), source_,
                    diagnostics_);
  }
  if (const auto* print = std::get_if<statement::Print>(&statement.what))
    return mission::Print{print->robot_info};
  if (std::holds_alternative<statement::Quit>(statement.what)) return mission::Quit{};
  return std::nullopt;
}

std::optional<mission::Command> CommandReader::unit_command(const statement::UnitAction& action) {
  const std::size_t errors = diagnostics_.error_count();
  mission::UnitCommand out;
  const bool is_known = read_addressee(action, out);
  out.task = action.task;
  if (action.location && mission::info(action.task).place == "places")
    read_places(action, out);
  else if (action.location)
    read_location(action, out);
  if (action.task == mission::Task::kSearch) out.swath = kDefaultSwath;
  if (action.step) check_lengths({&action.step->x, &action.step->y}, "an offset", source_, diagnostics_);
  if (action.step) out.start_step = {action.step->x.value, action.step->y.value};
  std::array<const Clause*, std::variant_size_v<decltype(Clause::what)>> seen{};
  for (const Clause& clause : action.clauses) {
    const Clause*& before = seen.at(clause.what.index());
    // Several phase lines are all kept.
    if (before != nullptr && !std::holds_alternative<clause::PhaseLine>(clause.what)) {
      diagnostics_
          .warning("repeated-clause", place(clause.span), "this clause takes the place of an earlier one")
          .notes.push_back({"the earlier one is here", place(before->span)});
    }
    before = &clause;
    read_clause(clause, out);
  }
  if (!is_known || diagnostics_.error_count() > errors) return std::nullopt;
  return out;
}

bool CommandReader::read_addressee(const statement::UnitAction& action, mission::UnitCommand& out) {
  if (action.robots.empty()) {
    const std::optional<std::uint32_t> unit = scope_.roster.find_unit(action.unit);
    out.unit = unit.value_or(0);
    out.place = place(action.unit.span);
    return unit.has_value();
  }
  out.unit = mission::kNoUnit;
  out.place = place({action.robots.front().span.begin, action.robots.back().span.end});
  std::map<std::uint32_t, text::Span> named;
  bool are_known = true;
  for (const Number& number : action.robots) {
    const std::optional<base::RobotId> id = scope_.roster.find_robot(number);
    are_known &= id.has_value();
    if (!id) continue;
    const auto [first, is_new] = named.try_emplace(id->value, number.span);
    if (is_new) {
      out.robots.push_back(*id);
      continue;
    }
    diagnostics_
        .warning("repeated-robot", place(number.span), fmt::format("robot {} is named already", id->value))
        .notes.push_back({"the first time is here", place(first->second)});
  }
  return are_known;
}

void CommandReader::read_location(const statement::UnitAction& action, mission::UnitCommand& out) {
  const Location& location = *action.location;
  const bool follows = action.task == mission::Task::kFollow;
  out.goal_place = place(location.span);
  if (action.task == mission::Task::kRally) out.radius = kRadiusOfAPoint;
  if (!location.name) {
    check_lengths({&location.x, &location.y}, "a coordinate", source_, diagnostics_);
    out.place_name = written(location);
    out.goal = geom::Point{location.x.value, location.y.value} + scope_.mission.overlay.origin;
    if (follows) {
      diagnostics_.error("not-a-line", place(location.span),
                         "FOLLOW takes the name of a line, found coordinates");
    }
    if (action.task == mission::Task::kSearch) read_area(location, out);
    return;
  }
  out.place_name = location.name->text;
  const overlay::ControlMeasure* found = find_place(*location.name);
  if (found == nullptr) return;
  out.goal = found->center();
  if (action.task == mission::Task::kRally) out.radius = radius_of(*found);
  if (follows) read_route(action, *found, out);
  if (action.task == mission::Task::kSearch) read_area(location, out);
}

// Of VISIT and PATROL.
void CommandReader::read_places(const statement::UnitAction& action, mission::UnitCommand& out) {
  const std::size_t errors = diagnostics_.error_count();
  std::vector<Location> all = {*action.location};
  all.insert(all.end(), action.more.begin(), action.more.end());
  for (const Location& location : all) add_place(location, out);
  out.goal_place = place({all.front().span.begin, all.back().span.end});
  for (std::size_t i = 0; i < std::min(all.size(), kMostNamedPlaces); ++i) {
    if (i > 0) out.place_name += ' ';
    out.place_name += written(all[i]);
  }
  if (all.size() > kMostNamedPlaces)
    out.place_name += fmt::format(" and {} more", all.size() - kMostNamedPlaces);
  if (!out.route.empty()) out.goal = out.route.front();
  if (diagnostics_.error_count() > errors) return;
  const std::string_view word = mission::info(action.task).word;
  if (out.route.size() > kMaxPlaces) {
    diagnostics_.error(
        "too-many-places", out.goal_place,
        fmt::format("{} takes at most {} places, here are {}", word, kMaxPlaces, out.route.size()));
  } else if (action.task == mission::Task::kPatrol &&
             std::ranges::all_of(out.route, [&](geom::Point p) { return p == out.route.front(); })) {
    diagnostics_.error("one-place", out.goal_place, "PATROL goes from place to place, and this is only one");
  }
}

// A line stands for its points.
void CommandReader::add_place(const Location& location, mission::UnitCommand& out) {
  if (!location.name) {
    check_lengths({&location.x, &location.y}, "a coordinate", source_, diagnostics_);
    out.route.push_back(geom::Point{location.x.value, location.y.value} + scope_.mission.overlay.origin);
  } else if (const overlay::ControlMeasure* found = find_place(*location.name)) {
    if (!found->is_line() || found->points.size() < 2)
      out.route.push_back(found->center());
    else if (may_copy(found->points.size(), location.span))
      out.route.insert(out.route.end(), found->points.begin(), found->points.end());
  }
  out.written.resize(out.route.size(), {written(location), place(location.span)});
}

// Of SEARCH.
void CommandReader::read_area(const Location& location, mission::UnitCommand& out) {
  const overlay::ControlMeasure* found = location.name ? scope_.places.find(location.name->text) : nullptr;
  if (location.name && found == nullptr) return;
  if (found != nullptr) out.route = mission::area_of(*found);
  if (!out.route.empty()) {
    may_copy(out.route.size(), location.span);
    return;
  }
  auto& error =
      diagnostics_.error("not-an-area", place(location.span),
                         fmt::format("SEARCH takes an area, {} has none", in_backticks(out.place_name)));
  error.hints.emplace_back("an area is an outline of three points or more, or a place with a diameter");
  if (found != nullptr) error.notes.push_back({"it is declared here", found->place});
}

void CommandReader::read_route(const statement::UnitAction& action, const overlay::ControlMeasure& line,
                               mission::UnitCommand& out) {
  const auto& points = line.kind == overlay::MeasureKind::kHallway && line.centerline.size() > 1
                           ? line.centerline
                           : line.points;
  if (line.is_line() && points.size() > 1) {
    out.goal = points.back();
    if (may_copy(points.size(), action.location->span)) out.route = points;
    return;
  }
  const std::string name = in_backticks(action.location->name->text);
  auto& error = diagnostics_.error(
      "not-a-line", place(action.location->span),
      line.is_line()
          ? fmt::format("FOLLOW takes a line, {} has a single point", name)
          : fmt::format("FOLLOW takes a line, {} is of the kind {}", name, overlay::keyword(line.kind)));
  error.hints.push_back("lines are " + words_of_lines());
  error.notes.push_back({fmt::format("{} is declared here", name), line.place});
}

bool CommandReader::may_copy(std::size_t points, text::Span span) {
  points_ += points;
  if (points_ <= kMaxPoints) return true;
  diagnostics_.error("too-many-points", place(span),
                     fmt::format("the lines of all commands together have more than {} points", kMaxPoints));
  return false;
}

void CommandReader::read_clause(const Clause& clause, mission::UnitCommand& out) {
  if (const auto* formation = std::get_if<clause::Formation>(&clause.what)) {
    out.formation = formation->formation;
    out.has_formation = true;
  } else if (const auto* technique = std::get_if<clause::Technique>(&clause.what)) {
    out.technique = technique->technique;
  } else if (const auto* speed = std::get_if<clause::Speed>(&clause.what)) {
    out.speed = std::max(0.0, speed->speed.value);
    if (speed->speed.value < 0.0) {
      diagnostics_.warning("negative-speed", place(speed->speed.span),
                           "a speed is not negative; the robots keep their own");
    }
  } else if (const auto* heading = std::get_if<clause::Heading>(&clause.what)) {
    const double degrees = heading->degrees.value;
    if (degrees < -360.0 || degrees > 360.0) {
      diagnostics_.error("number-out-of-range", place(heading->degrees.span),
                         fmt::format("a heading goes from -360 to 360 degrees, found {}",
                                     in_backticks(heading->degrees.text)));
    }
    out.heading = base::wrap_angle(base::radians(degrees));
  } else if (const auto* line = std::get_if<clause::PhaseLine>(&clause.what)) {
    read_phase_line(*line, clause.span, out);
  } else if (const auto* message = std::get_if<clause::OnCompletion>(&clause.what)) {
    out.on_completion = message->message.text;
  } else if (const auto* swath = std::get_if<clause::Swath>(&clause.what)) {
    out.swath = swath->width.value;
    check_lengths({&swath->width}, "a swath", source_, diagnostics_);
    if (swath->width.value < kMinSwath) {
      diagnostics_.error("number-out-of-range", place(swath->width.span),
                         fmt::format("a swath is at least {:g} m wide, found {}", kMinSwath,
                                     in_backticks(swath->width.text)));
    }
  } else if (const auto* until = std::get_if<clause::Until>(&clause.what)) {
    out.until = read_time(until->moment);
  }
}

void CommandReader::read_phase_line(const clause::PhaseLine& clause, text::Span span,
                                    mission::UnitCommand& out) {
  if (out.phase_lines.size() == kMaxPhaseLines) {
    diagnostics_.error("too-many-phase-lines", place(span),
                       fmt::format("a command has at most {} phase lines", kMaxPhaseLines));
    return;
  }
  mission::PhaseLine line;
  line.name = clause.line.text;
  const overlay::ControlMeasure* found = find_place(clause.line);
  if (found != nullptr && may_copy(found->points.size(), clause.line.span)) {
    line.points = found->points;
    if (line.points.size() == 1) line.radius = found->size / 2.0;
  }
  if (clause.moment) line.not_before = read_time(*clause.moment);
  if (clause.acknowledge) line.acknowledge = clause.acknowledge->text;
  line.waits = clause.waits;
  const auto same = std::ranges::find(out.phase_lines, line.name, &mission::PhaseLine::name);
  if (same == out.phase_lines.end()) {
    out.phase_lines.push_back(std::move(line));
    return;
  }
  diagnostics_.warning(
      "repeated-clause", place(span),
      fmt::format("phase line {} is named a second time, which replaces the first", in_backticks(line.name)));
  *same = std::move(line);
}

std::optional<mission::MissionTime> CommandReader::read_time(const Moment& moment) {
  const TimeReading reading = read_moment(moment);
  if (!reading.time) {
    diagnostics_.error(
        "bad-time", place(reading.span),
        fmt::format("{}, found {}", reading.problem, in_backticks(source_->text(reading.span))));
    return std::nullopt;
  }
  if (moment.number && !moment.is_timeout && moment.number->value < 0.0) {
    diagnostics_
        .warning("negative-until", place(moment.span),
                 fmt::format("this means {:g} seconds after the unit is in place", -moment.number->value))
        .hints.push_back(fmt::format("write `UNTIL TIMEOUT {:g}`", -moment.number->value));
  } else if (moment.number && !moment.is_timeout && moment.number->value >= kMinutesOfDay) {
    diagnostics_.warning(
        "until-past-midnight", place(moment.span),
        fmt::format("{} minutes after midnight is another day", in_backticks(moment.number->text)));
  }
  return reading.time;
}

const overlay::ControlMeasure* CommandReader::find_place(const Name& name) {
  const overlay::ControlMeasure* found = scope_.places.find(name.text);
  if (found == nullptr && !scope_.damage.places)
    report_unknown_measure(name, scope_.mission.overlay, scope_.overlays, scope_.places, source_,
                           diagnostics_);
  return found;
}

}  // namespace mlab::mdl
