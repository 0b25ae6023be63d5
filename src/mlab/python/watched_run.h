#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "mlab/history/recorder.h"
#include "mlab/mission/effect.h"
#include "mlab/python/mission_file.h"
#include "mlab/run/mission_run.h"

namespace mlab::python {

/// A run, with what it has said, what it asks, and what records it. Belongs to one thread at a time.
class WatchedRun {
 public:
  /// Something that was told.
  struct Said {
    double time = 0.0;  ///< [s]
    std::string kind;   ///< `message`, `warning`, `step started`, ...
    std::string text;
  };
  /// The last of them are kept.
  static constexpr std::size_t kMostSaid = 10'000;

  /// @param record  file that does not exist yet; empty: it is not recorded
  WatchedRun(std::shared_ptr<const MissionFile> file, std::unique_ptr<run::MissionRun> run,
             const std::string& record);
  ~WatchedRun();
  WatchedRun(const WatchedRun&) = delete;
  WatchedRun& operator=(const WatchedRun&) = delete;

  run::MissionRun& run() { return *run_; }
  const run::MissionRun& run() const { return *run_; }
  const MissionFile& file() const { return *file_; }

  /// Execute: the mission begins, or goes on after a pause.
  void execute() { run_->post(mission::event::Execute{}); }
  bool is_recorded() const { return recorder_ != nullptr; }
  /// Why it is not recorded as it was to be, as a sentence; empty: it is.
  std::string recording_problem() const { return recorder_ ? recorder_->problem() : ""; }
  /// @param wants_end  asked in each cycle, and while a robot's own process is waited for
  /// @param after      called after each cycle
  /// @return  how many cycles went by: fewer where the mission is over, waits for somebody, or an end was
  /// wanted
  std::uint64_t step(std::uint64_t cycles, const std::function<bool()>& wants_end,
                     const std::function<void()>& after = {});
  /// Nothing but an answer, or going on after a pause, moves it.
  bool is_waiting() const { return is_waiting_; }
  void note_input() { is_waiting_ = false; }

  const std::deque<Said>& said() const { return said_; }
  /// Not answered yet, by their numbers.
  const std::map<std::uint32_t, std::string>& questions() const { return questions_; }
  void answer(std::uint32_t question, bool proceed);

  /// What an order says, for the robots that it names; everything else goes on.
  /// @return  false: there were errors, all in `sink`
  bool order(const std::string& line, text::Diagnostics& sink);

  /// The recording is complete.
  /// @errors  why it is not, as a sentence; empty: it is, or there is none
  std::string end_recording();

 private:
  void see(const mission::Effect& effect);

  std::shared_ptr<const MissionFile> file_;
  std::unique_ptr<run::MissionRun> run_;
  std::unique_ptr<history::Recorder> recorder_;
  std::deque<Said> said_;
  std::map<std::uint32_t, std::string> questions_;
  bool is_waiting_ = false;
};

}  // namespace mlab::python
