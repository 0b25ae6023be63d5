#include "mlab/cli/plot.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "mlab/base/angle.h"
#include "mlab/text/escape.h"

namespace mlab::cli {
namespace {

constexpr double kPictureWidth = 960.0;  // [px]
constexpr double kBorder = 16.0;

// From the world (metres, y up) to the picture (pixels, y down).
struct View {
  geom::Point low;
  geom::Point high;
  double scale = 1.0;  // [px/m]

  double x(geom::Point p) const { return kBorder + (p.x - low.x) * scale; }
  double y(geom::Point p) const { return kBorder + (high.y - p.y) * scale; }
  double width() const { return 2 * kBorder + (high.x - low.x) * scale; }
  double height() const { return 2 * kBorder + (high.y - low.y) * scale; }
};

// The mission area, or less of it where nothing but emptiness would be shown.
View view_of(const run::MissionRun& run, const std::vector<std::vector<geom::Point>>& ways) {
  View view;
  const overlay::Area area = run.mission().overlay.mission_area();
  view.high = {area.width, area.height};
  for (const auto& way : ways) {
    for (const geom::Point p : way) {
      view.low = {std::min(view.low.x, p.x), std::min(view.low.y, p.y)};
      view.high = {std::max(view.high.x, p.x), std::max(view.high.y, p.y)};
    }
  }
  view.scale = (kPictureWidth - 2 * kBorder) / std::max(1e-6, view.high.x - view.low.x);
  return view;
}

std::string points_of(const View& view, const std::vector<geom::Point>& points) {
  std::string out;
  for (const geom::Point p : points)
    out += fmt::format("{}{:.1f},{:.1f}", out.empty() ? "" : " ", view.x(p), view.y(p));
  return out;
}

std::string label(const View& view, geom::Point at, double below, std::string_view text) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" class=\"label\">{}</text>\n", view.x(at),
                     view.y(at) + below, text::markup(text));
}

bool is_area(overlay::MeasureKind kind) {
  return !overlay::info(kind).is_line;
}

// Drawn as broad as it is.
bool is_lane(overlay::MeasureKind kind) {
  const overlay::MeasureSign sign = overlay::info(kind).sign;
  return sign == overlay::MeasureSign::kArrow || sign == overlay::MeasureSign::kRoad;
}

std::string measure_svg(const View& view, const overlay::ControlMeasure& measure) {
  std::string out;
  double width_px = 1.0;
  const bool is_solid = overlay::info(measure.kind).substance == overlay::Substance::kSolid;
  if (is_area(measure.kind) && measure.points.size() == 1) {
    out = fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" class=\"place\"/>\n",
                      view.x(measure.points[0]), view.y(measure.points[0]),
                      std::max(3.0, measure.size / 2.0 * view.scale));
  } else {
    const char* shape = is_area(measure.kind) ? "polygon" : "polyline";
    const char* look = is_area(measure.kind) ? "place" : is_solid ? "wall" : "line";
    width_px = is_solid ? 2.0 : 1.0;
    if (is_lane(measure.kind)) {
      look = "lane";
      width_px = std::max(1.0, measure.size * view.scale);
    }
    out = fmt::format("<{} points=\"{}\" class=\"{}\" stroke-width=\"{:.1f}\"/>\n", shape,
                      points_of(view, measure.points), look, width_px);
  }
  return out;
}

geom::Point middle_of_longest_piece(const std::vector<geom::Point>& line) {
  geom::Point out = line.front();
  double longest = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double length = geom::distance(line[i - 1], line[i]);
    if (length <= longest) continue;
    longest = length;
    out = line[i - 1] + (line[i] - line[i - 1]) * 0.5;
  }
  return out;
}

std::string measure_label(const View& view, const overlay::ControlMeasure& measure) {
  using enum overlay::MeasureKind;
  if (!measure.shows_label || measure.name.empty()) return "";
  if (is_area(measure.kind)) {
    const bool is_small = measure.points.size() == 1 && measure.size * view.scale < 40.0;
    return label(view, measure.center(), is_small ? 16.0 : 4.0, measure.name);
  }
  const geom::Point first = measure.points.front();
  const geom::Point last = measure.points.back();
  if (measure.kind == kPhaseLine || measure.kind == kLineOfDeparture) {
    return label(view, first.y < last.y ? first : last, 14.0, measure.name);  // at the lower end
  }
  const double half_width = is_lane(measure.kind) ? measure.size * view.scale / 2.0 : 0.0;
  return label(view, middle_of_longest_piece(measure.points), -6.0 - half_width, measure.name);
}

constexpr std::string_view kStyle =
    "<style>svg{background:#fff}.place{fill:#f1f5f9;stroke:#475569}.line{fill:none;stroke:#94a3b8;stroke-"
    "dasharray:6 4}"
    ".lane{fill:none;stroke:#e2e8f0}.wall{fill:none;stroke:#0f172a}.rock{fill:#334155}.met{fill:#0f172a;fill-"
    "opacity:.55}"
    ".label{font:12px "
    "sans-serif;fill:#334155;text-anchor:middle}.way{fill:none;stroke-width:1.5;stroke-opacity:.8}</style>\n";
constexpr std::string_view kColors[] = {"#2563eb", "#dc2626", "#059669", "#d97706",
                                        "#7c3aed", "#0891b2", "#be185d", "#4d7c0f"};

}  // namespace

void Plot::note(const run::MissionRun& run) {
  if (run.time() < next_) return;
  next_ = run.time() + kEvery;
  const auto& robots = run.fleet().robots();
  ways_.resize(std::min(robots.size(), kMost));
  for (std::size_t i = 0; i < ways_.size(); ++i) {
    if (robots[i].life == fleet::RobotLife::kNotStarted) continue;
    ways_[i].push_back(run.fleet().pose(robots[i]).position);
    if (!robots[i].program->vehicle().empty()) note_met(run, robots[i]);
  }
}

void Plot::note_met(const run::MissionRun& run, const fleet::FleetRobot& robot) {
  const geom::Pose pose = run.fleet().pose(robot);
  const percept::Percepts percepts =
      run.fleet().perceive_at(robot, pose, {{percept::Sensor::kObstacles}}, run.cycle_duration());
  for (const percept::Obstacle& obstacle : percepts.obstacles) {
    const binding::Disc disc{pose.point_at(obstacle.center), obstacle.radius};
    const bool is_known = std::ranges::any_of(
        met_, [&](const binding::Disc& other) { return geom::distance(other.center, disc.center) < kSame; });
    if (!is_known && met_.size() < kMostThings) met_.push_back(disc);
  }
}

std::string Plot::svg(const run::MissionRun& run) const {
  const View view = view_of(run, ways_);
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" "
      "height=\"{1:.0f}\">\n",
      view.width(), view.height());
  out += kStyle;
  out += fmt::format("<title>{}</title>\n", text::markup(run.mission().name));
  for (const overlay::ControlMeasure& measure : run.mission().overlay.measures) {
    if (!measure.points.empty()) out += measure_svg(view, measure);
  }
  for (const binding::Disc& disc : run.world().discs()) {
    out += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" class=\"rock\"/>\n",
                       view.x(disc.center), view.y(disc.center), std::max(1.0, disc.radius * view.scale));
  }
  for (const binding::MovingDisc& disc : run.world().moving_discs()) {
    out += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" class=\"rock\"/>\n",
                       view.x(disc.center), view.y(disc.center), std::max(1.0, disc.radius * view.scale));
  }
  for (const binding::Disc& disc : met_) {
    out += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" class=\"met\"/>\n",
                       view.x(disc.center), view.y(disc.center), std::max(2.0, disc.radius * view.scale));
  }
  const auto& robots = run.fleet().robots();
  for (std::size_t i = 0; i < ways_.size(); ++i) {
    const std::string_view color = kColors[i % std::size(kColors)];
    out += fmt::format("<polyline points=\"{}\" class=\"way\" stroke=\"{}\"/>\n", points_of(view, ways_[i]),
                       color);
    if (robots[i].life == fleet::RobotLife::kNotStarted) continue;
    const geom::Pose pose = run.fleet().pose(robots[i]);
    // A robot is drawn long enough to be seen: a rectangle with one pointed end.
    out += fmt::format(
        "<path d=\"M-7,-4 H2 L8,0 L2,4 H-7 Z\" fill=\"{}\" transform=\"translate({:.1f} {:.1f}) "
        "rotate({:.1f})\"/>\n",
        color, view.x(pose.position), view.y(pose.position), -base::degrees(pose.heading));
  }
  for (const overlay::ControlMeasure& measure : run.mission().overlay.measures) {
    if (!measure.points.empty()) out += measure_label(view, measure);
  }
  return out + "</svg>\n";
}

}  // namespace mlab::cli
