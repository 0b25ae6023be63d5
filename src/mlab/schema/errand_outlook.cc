#include <algorithm>
#include <array>
#include <bit>
#include <string>
#include <string_view>

#include <fmt/core.h>

#include "mlab/schema/errands.h"
#include "mlab/schema/requests.h"
#include "mlab/schema/tour.h"
#include "mlab/schema/way.h"

namespace mlab::schema {
namespace {

using percept::Percepts;
using ways::PlannedWay;

// The corners and the middles of the sides of a box round all that is known, as far as the area reaches.
std::array<geom::Point, 8> places_around(const Percepts& percepts) {
  constexpr double kAway = 10.0;  // [m]
  constexpr double kInside = 1.0;
  const auto& [revision, discs, walls, bounds, edges] = percepts.ground;
  geom::Point low = percepts.pose.position;
  geom::Point high = low;
  const auto add = [&](geom::Point p, double reach) {
    low = {std::min(low.x, p.x - reach), std::min(low.y, p.y - reach)};
    high = {std::max(high.x, p.x + reach), std::max(high.y, p.y + reach)};
  };
  for (const ways::Round& disc : discs) add(disc.center, disc.radius + kAway);
  for (const geom::Segment& wall : walls) {
    add(wall.a, kAway);
    add(wall.b, kAway);
  }
  low = {std::max(low.x, bounds.x0 + kInside), std::max(low.y, bounds.y0 + kInside)};
  high = {std::min(high.x, bounds.x1 - kInside), std::min(high.y, bounds.y1 - kInside)};
  const geom::Point middle = low + (high - low) * 0.5;
  return {low,
          high,
          geom::Point{low.x, high.y},
          {high.x, low.y},
          {low.x, middle.y},
          {high.x, middle.y},
          {middle.x, low.y},
          {middle.x, high.y}};
}

bool is_shut_in(const Percepts& percepts, double radius, double margin) {
  return std::ranges::none_of(places_around(percepts), [&](geom::Point place) {
    return !plan_way(percepts.ground, way_begin(percepts, radius), place, radius, margin).is_closed_off();
  });
}

}  // namespace

geom::Point way_begin(const Percepts& percepts, double radius) {
  constexpr double kOutside = 0.5;  // [m]
  return place_outside(percepts, radius + kOutside);
}

std::optional<std::size_t> ErrandSet::take_first() {
  for (std::size_t i = 0; i < bits.size(); ++i) {
    if (bits[i] == 0) continue;
    const auto bit = static_cast<std::size_t>(std::countr_zero(bits[i]));
    bits[i] &= bits[i] - 1;
    return i * 64 + bit;
  }
  return std::nullopt;
}

std::size_t shut_in_robots(const Percepts& percepts) {
  return static_cast<std::size_t>(
      std::ranges::count_if(percepts.shared_places, [&](const percept::SharedPlace& shared) {
        const auto place = tour_place(percepts.order, shared);
        return place && place->is_shut_in;
      }));
}

std::optional<std::size_t> look_at_next(const Percepts& percepts, double radius, double margin,
                                        Outlook& outlook) {
  const auto route = percepts.order.route;
  if (outlook.looked_at < route.size()) {
    const std::size_t number = outlook.looked_at++;
    const bool leads = !plan_way(percepts.ground, way_begin(percepts, radius), route[number], radius, margin)
                            .is_closed_off();
    outlook.leads_out = outlook.leads_out || leads;
    if (leads) return number;
    outlook.closed.add(number % kMostErrands);
    if (outlook.looked_at == route.size() && !outlook.leads_out) {
      outlook.is_shut_in = is_shut_in(percepts, radius, margin);
      outlook.leads_out = !outlook.is_shut_in;
    }
  }
  return outlook.leads_out ? outlook.closed.take_first() : std::nullopt;
}

bool tell_of_shut_in(const Percepts& percepts, double radius, double margin, Outlook& outlook,
                     percept::Action& action) {
  if (!outlook.is_shut_in || percepts.order.route.empty()) return false;
  const geom::Point here = percepts.pose.position;
  if (!outlook.has_told_unit) {
    percept::Request told = share_place(here);
    told.object = tour_code(percepts.order, {.comes_to_none = true, .is_shut_in = true});
    outlook.has_told_unit = action.ask(told);
  }
  if (!outlook.closed.take_first()) return false;
  outlook.closed = {};
  const geom::Point place = percepts.order.route.front();
  const PlannedWay way = plan_way(percepts.ground, way_begin(percepts, radius), place, radius, margin);
  const geom::Point last = way.count == 0 ? here : way.whole_last();
  alert(action, "Way",
        fmt::format("no way leads out of where robot {} is: {} is in front of it", percepts.id.value,
                    what_blocks(percepts.ground, last, place)));
  return true;
}

namespace {

// Things stand on all of a piece of a SEARCH.
bool is_hidden(const Percepts& percepts, const Errands& errands, std::size_t errand) {
  return percepts.order.task == percept::Task::kSearch &&
         is_covered(percepts.ground, errands.way(errand), 0.5 * percepts.order.swath);
}

}  // namespace

bool is_nothing_to_see(const Percepts& percepts, const Errands& errands, std::size_t errand) {
  if (!is_hidden(percepts, errands, errand)) return false;
  for (std::size_t other = 0; other < errands.count(); ++other) {
    if (!is_hidden(percepts, errands, other)) return true;
  }
  return false;
}

void tell_of_lost(const Percepts& percepts, const Errands& errands, std::size_t errand, std::string_view does,
                  percept::Action& action) {
  constexpr double kBeside = 1.0;  // [m]
  const geom::Point place = errands.way(errand).front();
  std::string why = "it comes no nearer";
  if (is_hidden(percepts, errands, errand)) why = "something stands on all of it";
  for (const percept::RobotReading& robot : percepts.robots) {
    if (geom::distance(percepts.pose.point_at(robot.center), place) > robot.radius + kBeside) continue;
    why = fmt::format("robot {} stands there", robot.id.value);
    break;
  }
  alert(action, "Way",
        fmt::format("{} part {} of {}, at ({:.0f}, {:.0f}): {}", does, errand + 1, errands.count(), place.x,
                    place.y, why));
}

}  // namespace mlab::schema
