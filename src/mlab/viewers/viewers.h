#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "mlab/mission/effect.h"
#include "mlab/run/mission_run.h"
#include "mlab/viewers.pb.h"

namespace mlab::viewers {

/// Rates at which a run is told, of simulated time [Hz].
struct Rates {
  double poses = 10.0;
  double scene = 1.0;  ///< whether anything in the world has changed, and pieces of the robots' ways
};

/// Watches a run, and tells it in the messages that viewers show without configuration:
///
///     /tf               FrameTransforms  of each robot (`robot_3`) in the world (`map`)
///     /robots/3/pose    PoseInFrame      the same of one, for plots
///     /scene            SceneUpdate      the map: obstacles, walls, control measures, objects
///     /scene/robots     SceneUpdate      robots, in their own frames
///     /scene/goals      SceneUpdate      where orders lead
///     /scene/ways       SceneUpdate      where robots went, piece by piece
///     /log              Log              what is told
///
/// Who jumps to a moment of a recording gets the last message of each topic before it; so those of `/scene`,
/// `/scene/robots` and `/scene/goals` are complete, each in itself. Ids of entities stay the same.
class Viewers {
 public:
  using Sink = std::function<void(const std::string& topic, const google::protobuf::Message& message)>;
  /// @param started_at  wall clock at run time 0, seconds since 1970-01-01 00:00 UTC
  /// @param run         outlives this
  Viewers(Sink sink, const run::MissionRun& run, double started_at, Rates rates = {})
      : sink_(std::move(sink)), run_(run), started_at_(started_at), rates_(rates) {}

  /// Some time may have passed; at first, that nothing has happened yet.
  void note_cycle();
  /// An effect of the run's executive.
  void see(const mission::Effect& effect);

 private:
  google::protobuf::Timestamp now() const;
  foxglove::SceneEntity& entity(foxglove::SceneUpdate& update, const std::string& id) const;
  void tell_poses();
  void tell_map();
  void tell_robots();
  void tell_goals();
  void tell_ways();
  /// Adds deletions of what was there before, and sends where anything differs from what was sent last.
  void send_scene(const std::string& topic, foxglove::SceneUpdate& update);

  Sink sink_;
  const run::MissionRun& run_;
  double started_at_;
  Rates rates_;
  double next_poses_ = 0.0;  // [s]
  double next_scene_ = 0.0;  // [s]
  struct Sent {
    std::uint64_t hash = 0;
    std::vector<std::string> ids;  // ascending
  };
  std::map<std::string, Sent> sent_;  // by topic
  struct Way {
    std::uint32_t piece = 0;
    std::vector<geom::Point> points;
  };
  std::map<std::uint32_t, Way> ways_;  // by robot
};

}  // namespace mlab::viewers
