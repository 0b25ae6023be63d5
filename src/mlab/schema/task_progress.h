#pragma once

#include "mlab/percept/percepts.h"

namespace mlab::schema {

/// What the progress of a task is judged by.
struct TaskMeasures {
  double goal_distance = 0.0;    ///< from the unit's centre to the goal [m]
  double route_remaining = 0.0;  ///< way left to the end of the route [m]
  double station_error = 0.0;    ///< from the robot to its station [m]
  double success_radius = 0.0;   ///< within this distance a goal is reached [m]
  double slop = 0.0;             ///< the station error that an OCCUPY allows [m]
  bool teleoperation_complete = false;
  double way_remaining = -1.0;  ///< to the robot's place at the end of a planned way; below 0: none is [m]
  double errands_left = 1.0;    ///< parts of a command that the unit shares which are not done; below 0:
                                ///< this robot can do no more of it
};

/// What task_progress says.
struct TaskProgress {
  bool done = false;
  double remaining = 0.0;  ///< [m]; 0 where done; infinite: it can do no more. Teleoperation has no measure:
                           ///< 1 until it is done
};

/// How far a robot is with its task now; without memory of whether it was done before.
TaskProgress task_progress(percept::Task task, const TaskMeasures& measures);

}  // namespace mlab::schema
