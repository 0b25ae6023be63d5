#include "mlab/schema/task_progress.h"

#include <algorithm>
#include <limits>

#include "mlab/schema/errands.h"

namespace mlab::schema {

TaskProgress task_progress(percept::Task task, const TaskMeasures& measures) {
  const auto within = [](double value, double limit) {
    return TaskProgress{value <= limit, std::max(0.0, value - limit)};
  };
  const TaskProgress arrival = within(measures.goal_distance, measures.success_radius);
  const bool is_planned = measures.way_remaining >= 0.0;
  const TaskProgress place_on_way = within(measures.way_remaining, 0.0);
  switch (task) {
    case percept::Task::kMoveTo:
    case percept::Task::kSweepTo:
      return is_planned ? place_on_way : arrival;
    case percept::Task::kFollow:
      return is_planned ? place_on_way : within(measures.route_remaining, measures.success_radius);
    case percept::Task::kOccupy: {
      if (is_planned) return place_on_way;
      const TaskProgress place = within(measures.station_error, measures.slop);
      return {arrival.done && place.done, arrival.remaining + place.remaining};
    }
    case percept::Task::kVisit:
    case percept::Task::kSearch:
    case percept::Task::kPatrol: {
      // No length, but something that changes as long as the robot comes on.
      constexpr double kNoLength = -1e9;
      constexpr double kErrand = 1e6;
      if (measures.errands_left < 0.0) return {false, std::numeric_limits<double>::infinity()};
      // Towards the end of a way that leads no farther, too.
      const bool is_closed = measures.way_remaining >= kClosedEnd;
      const double on_way =
          std::clamp(measures.way_remaining - (is_closed ? kClosedEnd : 0.0), 0.0, 0.5 * kErrand);
      return {measures.errands_left <= 0.0, kNoLength + kErrand * measures.errands_left + on_way};
    }
    case percept::Task::kTeleoperate:
      return {measures.teleoperation_complete, measures.teleoperation_complete ? 0.0 : 1.0};
    case percept::Task::kStart:
    case percept::Task::kStop:
      return {true, 0.0};
    case percept::Task::kNone:
      break;
  }
  return {};
}

}  // namespace mlab::schema
