#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "mlab/console.pb.h"
#include "mlab/run/mission_run.h"

namespace mlab::console {

/// For how long vehicles have said nothing while the run stands: its own time does, too, so by that nothing
/// grows old.
class VehicleSilence {
 public:
  /// Takes what vehicles have said, and notes when that was news. Nothing is taken of a run without vehicles.
  /// @param wall  as wall_time() [s]
  /// @return  whether the run has vehicles
  bool look(run::MissionRun& run, double wall);
  /// Ages grow by the time for which nothing was new.
  void add(double wall, Status& status) const;
  void forget() { known_.clear(); }

 private:
  struct Known {
    std::uint64_t number = 0;  // of the newest report
    double since = 0.0;        // by the wall clock [s]
  };
  std::map<std::string, Known, std::less<>> known_;
};

}  // namespace mlab::console
