#include "mlab/console/published/watched.h"

#include <string>
#include <vector>

#include "mlab/console/published/frame_encoder.h"
#include "mlab/console/published/robot_detail.h"

namespace mlab::console {

void encode_watched(const run::MissionRun& run, const Watch& watch, Frame& out) {
  out.set_cycle(run.cycle());
  if (watch.with_stations()) encode_stations(run, *out.mutable_stations());
  if (watch.with_vectors()) encode_vectors(run, *out.mutable_vectors());
  encode_objects(run, *out.mutable_objects());
}

void encode_watched(const run::MissionRun& run, const fleet::FleetRobot& robot, const Watch& watch,
                    const Estimates& estimates, const TransitionRecorder& transitions, RobotDetail& out) {
  const std::uint32_t id = robot.id.value;
  DetailWishes wishes = {watch.with_ports(), watch.with_readings(), transitions.before(id)};
  if (watch.ports_size() > 0 && robot.workings().program) {
    const std::vector<std::string> paths(watch.ports().begin(), watch.ports().end());
    wishes.some_ports = port_indices(*robot.workings().program, paths);
  }
  encode_detail(run, estimates, robot, wishes, out);
  transitions.encode(id, out);
}

}  // namespace mlab::console
