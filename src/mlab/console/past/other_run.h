#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mlab/console.pb.h"
#include "mlab/console/past/known_alarms.h"
#include "mlab/console/past/told_apart.h"
#include "mlab/console/run/alarms.h"
#include "mlab/console/run/event_log.h"
#include "mlab/history/replay.h"
#include "mlab/history/timeline.h"
#include "mlab/text/diagnostic.h"

namespace mlab::console {

/// Another future beside a run: both are computed again, cycle for cycle, and where their robots are is kept
/// at moments of equal distance. Belongs to one thread at a time.
class OtherRun {
 public:
  struct Settings {
    std::string name;
    bool is_recording = false;     ///< it departs from nothing: it is another run
    bool is_of_recording = false;  ///< so is the one on the line: it does not go on
    std::uint64_t from_cycle = 0;
    double from = 0.0;   ///< [s]
    double until = 0.0;  ///< it is not computed beyond [s]
    std::vector<std::string> changes;
    std::vector<std::string> remarks;
    std::vector<WhatIf::Parameter> parameters;  ///< that are set where it departs
    bool takes_over = false;                    ///< programs are to be others there
    KnownAlarms known = {};                     ///< before it departs
    std::string version;                        ///< of this program
  };

  /// A recording beside the run on the line, both from their beginning.
  /// @param own    the run on the line, at its beginning
  /// @return null where it can't be made, which is said in `sink`
  static std::unique_ptr<OtherRun> compare(std::unique_ptr<history::Replay> own,
                                           std::shared_ptr<const history::History> other,
                                           const history::ReplayTools& tools, Settings settings,
                                           text::Diagnostics& sink);
  /// A future of the run on the line: both are computed from the last checkpoint before they part.
  /// @param other  its history, as of history::branch, which goes no further than is known; it is computed on
  ///               from there
  /// @return  likewise
  static std::unique_ptr<OtherRun> depart(const history::Timeline& line,
                                          std::shared_ptr<history::History> other, Settings settings,
                                          text::Diagnostics& sink);
  OtherRun(const OtherRun&) = delete;
  OtherRun& operator=(const OtherRun&) = delete;

  /// @param seconds  that it may take, about
  /// @return  true: there is more to do
  bool advance(double seconds);
  bool is_under_way() const { return is_under_way_; }
  void encode(OtherFuture& out) const;
  /// As a recording of its own, for which it is computed once more, from the beginning.
  /// @errors  a sentence: there is none
  std::optional<std::string> save(FutureRecording& out);

 private:
  struct Side {
    std::unique_ptr<history::Replay> replay;
    bool is_over = false;
    std::string outcome;  ///< once it is over
    EventLog log;         ///< from where they depart
    Alarms alarms;
  };
  struct Track {
    OtherFuture::Robot told;
    double driven_before[2] = {};  ///< where it departs [m]
    std::uint32_t contacts_before[2] = {};
  };

  OtherRun(std::unique_ptr<history::Replay> own, std::unique_ptr<history::Replay> other, Settings settings);
  void begin_listening();
  bool depart();
  std::optional<std::string> set_parameters(run::MissionRun& run) const;
  std::vector<wire::HistoryEntry> written() const;
  void step_behind();
  void step(std::size_t side);
  void end(std::size_t side);
  bool goes_on(std::size_t side) const;
  void look_for_parting();
  void sample();
  void sample(Track& track, std::uint32_t robot);
  void note_most_apart();
  void note_before(std::size_t side);
  bool is_written(std::size_t side) const;
  void end_where_it_stopped(std::size_t side);
  void finish();
  void fail(const std::string& problem);

  const Settings settings_;
  Side sides_[2];  // the run on the line, and the other one
  bool is_under_way_ = true;
  bool has_departed_ = false;
  std::size_t takeovers_before_ = 0;
  bool awaits_takeover_ = false;
  std::optional<OtherFuture::Parting> parting_;
  double next_sample_ = 0.0;  // [s]
  double spacing_ = 0.0;      // of samples [s]
  std::vector<float> times_;
  std::map<std::uint32_t, Track> tracks_;
  ToldApart told_;  // once it is no longer under way
  std::string problem_;
};

}  // namespace mlab::console
