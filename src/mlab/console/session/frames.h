#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "mlab/console/published/frame_encoder.h"
#include "mlab/console/session/people.h"
#include "mlab/console/session/request.h"
#include "mlab/console/session/run_control.h"

namespace mlab::console {

/// What people look at of the run while it goes on: frames, details of robots, series. Who looks at what
/// decides what is recorded.
class Frames {
 public:
  Frames(RunControl& run, People& people) : run_(run), people_(people) {}

  void watch(const Sender& sender, const Watch& watch);
  Answered read_series(const ReadSeries& read, Reply& reply);
  /// To be called whenever another run may have begun: it records what people look at.
  void follow_run();
  /// The same after somebody has gone, and now and then.
  void update_watches();
  /// Sends a frame to everybody who wants one.
  void publish();
  /// When somebody wants the next one [s].
  double next_frame() const;

 private:
  void fill(Channel& channel, Frame& out);
  void fill_details(const Watch& watch, Frame& out);
  void fill_failsafes(Channel& channel, Frame& out);
  void fill_series(Channel& channel, SeriesData& out);

  RunControl& run_;
  People& people_;
  std::uint64_t known_run_ = 0;
  RobotRows rows_;
  std::uint64_t rows_version_ = 0;  // of the world in `rows_`
  struct Sentences {
    double wall = -1e9;  ///< when they were made
    std::vector<std::string> lines;
  };
  std::map<std::uint32_t, Sentences> sentences_;  // what robots that are looked at wait for
};

}  // namespace mlab::console
