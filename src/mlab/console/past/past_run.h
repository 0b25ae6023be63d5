#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "mlab/console.pb.h"
#include "mlab/console/past/known_alarms.h"
#include "mlab/console/past/past_texts.h"
#include "mlab/console/past/survey.h"
#include "mlab/console/published/frame_encoder.h"
#include "mlab/console/run/event_log.h"
#include "mlab/console/run/run_notes.h"
#include "mlab/history/timeline.h"
#include "mlab/text/diagnostic.h"

namespace mlab::console {

class Condition;

/// That two times of one moment are apart, at most [s]: a sum of cycles is not quite what a person types.
inline constexpr double kMoment = 1e-6;

/// What a client has been told of moments of a run, so that it is not told again.
struct PastTold {
  std::shared_ptr<const run::Crew> crew;  ///< whose mission it knows
  std::uint64_t obstacles = 0;
  std::size_t not_started = 0;
  std::map<int, std::string> bytes;  ///< of small messages, by field of ToBrowser
  std::uint64_t recorded = 0;        ///< the version that RecordedPast has told it; 0: none
};

/// What a client wants to see.
struct PastWish {
  /// The last cycle that was over by then [s]; nothing: after `cycle`.
  std::optional<double> time;
  std::uint64_t cycle = 0;
  Watch watch;
  bool with_trails = false;
  PastTold told;
};

/// What it is to be told, in this order.
struct PastPicture {
  std::string problem;  ///< why it can't be shown, as a sentence; then there is nothing else
  std::uint64_t cycle = 0;
  double time = 0.0;  ///< [s]
  std::vector<ToBrowser> messages;
  Frame frame;
  PastTold told;
};

/// Any moment of a run, as its operators would have seen it. Belongs to one thread at a time.
class PastRun {
 public:
  struct Settings {
    /// Documents of a session by names of their sources; of a recording: null, its own are told.
    std::shared_ptr<const std::map<std::string, std::string>> documents;
    std::optional<Picture> picture;  ///< behind the map
    std::stop_token ends;            ///< who waits for a moment that is far away has had enough
  };

  /// @param history  of a run that goes on, or of a recording
  /// @return null where it can't be computed again, which is said in `sink`
  static std::unique_ptr<PastRun> make(std::shared_ptr<history::History> history, history::ReplayTools tools,
                                       Settings settings, text::Diagnostics& sink);
  PastRun(const PastRun&) = delete;
  PastRun& operator=(const PastRun&) = delete;

  /// The run that goes on: what was written of it since, and how far it has come [s].
  void add(const std::vector<wire::HistoryEntry>& entries, std::uint64_t cycle, double time);
  /// Computes moments that nobody has asked for yet.
  /// @return  true: there is more to do
  bool advance(double seconds);

  PastPicture picture(const PastWish& wish);
  /// What is asked over the whole run, as far as it is known after half a second.
  /// @errors  a sentence: too much is asked for
  std::optional<std::string> read(const ReadPast& asked, Past& out);
  /// @errors  a sentence
  std::optional<std::string> find(const FindMoments& asked, Found& out);

  /// `timeline` shows that moment then: what runs there can be asked.
  /// @errors  a sentence
  std::optional<std::string> show(std::uint64_t cycle) { return go_to(cycle); }

  /// What was known of robots by a moment before the end of that cycle, which was shown.
  KnownAlarms known_alarms(std::uint64_t cycle) const { return alarms_.before(cycle); }

  /// Moments up to here are at hand [s].
  double known_to() const { return times_.back(); }
  const history::Timeline& timeline() const { return *timeline_; }
  const history::History& history() const { return *history_; }
  /// What happened, as far as it is known.
  const EventLog& log() const { return log_; }

 private:
  PastRun(std::shared_ptr<history::History> history, Settings settings,
          std::unique_ptr<history::Timeline> timeline);
  bool can_advance() const;
  std::uint64_t cycle_at(double time);
  std::optional<std::string> go_to(std::uint64_t cycle);
  std::optional<std::string> go_to(std::uint64_t cycle, const Watch& watch, TransitionRecorder& transitions);
  DocumentPlace place(const text::Place& place) const;
  void follow_version();
  void tell_mission(PastPicture& out) const;
  void tell_map(PastPicture& out) const;
  void tell_state(PastPicture& out) const;
  void tell_trails(PastPicture& out) const;
  void fill(const Watch& watch, const TransitionRecorder& transitions, Frame& out);
  void add_survey(const ReadPast& asked);
  double time_of(std::uint64_t cycle) const;
  std::optional<std::string> begin_to_look(Condition& condition, std::uint64_t cycle);
  std::optional<std::string> find_ahead(Condition& condition, std::uint64_t from, std::size_t most,
                                        Found& out);
  std::optional<std::string> find_back(Condition& condition, std::uint64_t from, std::size_t most,
                                       Found& out);

  const Settings settings_;
  std::shared_ptr<history::History> history_;
  std::unique_ptr<history::Timeline> timeline_;
  EventLog log_;
  RunNotes notes_;             // of the first pass
  AlarmsOverTime alarms_;      // likewise
  std::vector<double> times_;  // at the end of each cycle that the first pass has made [s]
  RobotRows rows_;
  std::shared_ptr<const run::Crew> version_;  // whose texts these are:
  std::optional<PastTexts> texts_;            // of a recording
  std::uint64_t versions_ = 0;
  std::vector<std::unique_ptr<Survey>> surveys_;  // used last is last
};

}  // namespace mlab::console
