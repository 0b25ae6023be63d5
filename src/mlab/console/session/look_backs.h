#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "mlab/console/documents/documents.h"
#include "mlab/console/inbox.h"
#include "mlab/console/past/past_run.h"
#include "mlab/console/past/recorded_past.h"
#include "mlab/console/session.h"
#include "mlab/console/session/chronicle.h"
#include "mlab/console/session/people.h"
#include "mlab/console/session/run_control.h"
#include "mlab/console/workshop.h"

namespace mlab::console {

/// Who looks at which moment of the run but now. Moments are computed on a thread of their own, so the run
/// goes on meanwhile. Belongs to the session's thread.
class LookBacks {
 public:
  /// What it works with; all of it outlives it.
  struct Parts {
    const SessionSettings& settings;
    const OpenDocuments& documents;
    Chronicle& chronicle;
    RunControl& run;
    People& people;
    EventLog& log;
    Inbox& inbox;
  };
  explicit LookBacks(const Parts& parts);
  ~LookBacks();
  LookBacks(const LookBacks&) = delete;
  LookBacks& operator=(const LookBacks&) = delete;
  void end();

  /// In place of a run of the session's own.
  void open(std::shared_ptr<history::History> recording);
  bool is_recording() const { return recording_ != nullptr; }

  // ---- what is asked

  Answered look_back(const Sender& sender, const LookBack& look);
  /// Their answers come later.
  Answered read_past(const Sender& sender, const ReadPast& asked, const Reply& reply);
  Answered find_moments(const Sender& sender, const FindMoments& asked, const Reply& reply);
  /// Somebody has come: in a recording there is nothing but the past.
  void begin(const Sender& sender);
  void forget(ConnectionId connection) { lookers_.erase(connection); }
  /// Hands the past to who answers a request with it later, on the workshop's thread.
  /// @param find  @errors a sentence
  Answered ask_past(ConnectionId to, std::uint32_t request,
                    std::function<Answered(PastRun& past, Reply& reply)> find);
  /// On the workshop's thread, with what it can be computed again by; null: it can't be.
  void with_past(std::function<void(PastRun* past)> job);
  history::ReplayTools tools() const;
  /// Why somebody who looks at another moment can't give an order; nothing: he looks at now.
  Answered why_no_order(ConnectionId connection) const;

  // ---- what is told

  /// Called when another run may have begun: everybody looks at that one.
  void follow_run();
  /// Asks for what somebody wants to see next.
  void publish();
  /// When that will be [s].
  double next() const;
  void encode(TimeLine& out) const;
  /// Grows where that has changed.
  std::uint64_t line_revision();
  /// Whom the run as it goes on is to be told anew, since this was asked last.
  std::vector<ConnectionId> take_returned() { return std::exchange(returned_, {}); }

 private:
  /// The run that can be looked back at, for its thread. What others read of it is atomic.
  struct Past {
    std::shared_ptr<history::History> history;
    std::unique_ptr<PastRun> run;  // made when somebody asks for it
    std::string why_not;           // it can't be
    // Of a recording, where it can't be, or from where on it is not what was written.
    std::unique_ptr<RecordedPast> recorded;
    std::uint64_t log_told = 0;
    std::atomic<double> known_to = 0.0;  // [s]
  };
  struct Looker {
    std::optional<PastWish> wish;  // that nobody works at yet; its rest is filled in then
    bool is_sought = false;  // that wish is a moment that somebody has named, and not where time has got to
    bool is_under_way = false;
    bool was_sought = false;  // what is under way
    bool is_new = true;       // has been told nothing of the past
    bool wants_trails = false;
    double asked = 0.0;  // when the last wish came [s]
    double time = 0.0;   // of the run, where it is [s]
    std::uint64_t cycle = 0;
    double speed = 0.0;
    double played = 0.0;  // up to when time has passed there [s]
    std::uint64_t watch = 0;
    PastTold told;
  };
  using PastPtr = std::shared_ptr<Past>;

  Answered why_not() const;
  Past& past();
  void work(std::function<void(Past& past)> job);
  /// Answers a request with what is found out on the workshop's thread.
  void answer(ConnectionId to, std::uint32_t request,
              std::function<Answered(PastRun& past, Reply& reply)> find);
  static void make(Past& past, const history::ReplayTools& tools, PastRun::Settings settings);
  static PastPicture picture(Past& past, const PastWish& wish, const history::ReplayTools& tools);
  void ask(ConnectionId connection, Looker& looker, const Channel& channel);
  bool play(Looker& looker, double wall);
  void take(ConnectionId connection, PastPicture picture);
  void report(const PastPtr& past);
  void take_log(const std::vector<Log::Entry>& entries);
  void keep_on();
  void tell_moment(ConnectionId connection, const Looker& looker, const std::string& problem) const;
  void return_to_now(ConnectionId connection, const std::string& problem);
  double run_end() const;
  std::uint64_t last_cycle() const;

  const SessionSettings& settings_;
  const OpenDocuments& documents_;
  Chronicle& chronicle_;
  RunControl& run_;
  People& people_;
  EventLog& log_;
  Inbox& inbox_;
  std::shared_ptr<history::History> recording_;
  std::uint64_t known_run_ = 0;
  PastPtr past_;               // of the run there is; null: nobody has looked back yet
  std::string why_not_;        // it can't be,
  std::string only_recorded_;  // or what was recorded is shown in its place,
  std::string why_slow_;       // or only slowly,
  std::string parted_;         // or not to its end; as TimeLine has them
  bool keeps_on_ = false;      // its first pass is being made
  std::map<ConnectionId, Looker> lookers_;
  std::vector<ConnectionId> returned_;
  std::string line_told_;
  double line_looked_ = -1e9;
  std::uint64_t line_revision_ = 1;
  std::stop_source ends_;
  std::unique_ptr<Workshop> workshop_;  // ends before everything that its jobs report to
};

}  // namespace mlab::console
