#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mlab/base/id.h"
#include "mlab/console.pb.h"
#include "mlab/console/run/alarms.h"
#include "mlab/run/mission_run.h"

namespace mlab::console {

/// The started robots of one cycle as they stand in Frame.robots, gathered once for all who look.
class RobotRows {
 public:
  /// One robot, byte by byte as it is sent.
  struct Row {
    std::uint32_t id;
    float x;
    float y;
    std::uint16_t heading;
    std::uint8_t flags;
    std::uint8_t reserved;
  };
  static_assert(sizeof(Row) == 16);

  /// @param alarms         by place in the fleet; may be shorter
  /// @param teleoperated   ascending
  void gather(const run::MissionRun& run, const std::vector<Alarms::Robot>& alarms,
              std::span<const base::RobotId> teleoperated);
  void clear() { rows_.clear(); }
  std::span<const Row> rows() const { return rows_; }

  /// Those inside of the view go to `robots`, all where there is none. @return how many were left out
  std::uint32_t encode(const std::optional<Box>& view, std::string& robots) const;

 private:
  std::vector<Row> rows_;
};

/// 65536 is a full turn.
std::uint16_t packed_heading(double heading);

/// How many robots have not been started.
std::size_t count_not_started(const run::MissionRun& run);
/// Robots that have not been started, where they will be, as in Starts.robots.
void encode_starts(const run::MissionRun& run, std::string& out);
/// Stations of all robots in a formation, as in Frame.stations.
void encode_stations(const run::MissionRun& run, std::string& out);
/// Wanted velocities of all running robots, as in Frame.vectors.
void encode_vectors(const run::MissionRun& run, std::string& out);
/// Objects that are not where the overlay has them, as in Frame.objects.
void encode_objects(const run::MissionRun& run, std::string& out);

}  // namespace mlab::console
