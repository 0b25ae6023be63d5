#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "mlab/console/documents/documents.h"
#include "mlab/console/inbox.h"
#include "mlab/console/run/resumed_run.h"
#include "mlab/console/session.h"
#include "mlab/console/session/chronicle.h"
#include "mlab/console/session/robot_parameters.h"
#include "mlab/console/session/run_control.h"
#include "mlab/console/workshop.h"

namespace mlab::console {

/// Makes runs out of the documents' mission, on a thread of its own where that takes long, and brings the run
/// to what the documents say and to what is typed. Belongs to the session's thread.
class RunMaker {
 public:
  /// What it works with; all of it outlives it.
  struct Parts {
    const SessionSettings& settings;
    OpenDocuments& documents;
    RunControl& run;
    RobotParameters& parameters;
    EventLog& log;
    Inbox& inbox;
    Chronicle& chronicle;
  };
  /// @param meanwhile  what a run calls while it waits for a robot's own process: true ends the wait
  RunMaker(const Parts& parts, std::function<bool()> meanwhile);
  /// Ends what is being made.
  ~RunMaker();
  RunMaker(const RunMaker&) = delete;
  RunMaker& operator=(const RunMaker&) = delete;
  void end();

  /// Another mission is open: its run is made.
  void follow_other_mission();
  /// After a change of the documents: tells what they have to say, and the run goes on with what they mean.
  void follow_documents();
  /// Opens a mission that has no file, or gives its run other programs, and tells once what became of it.
  void start_trial(const Trial& trial, TrialDone done);

  /// Goes on with a run that was cut off. The mission that it is of is open.
  /// @param done  called once it is there
  void resume(const std::shared_ptr<const journal::Kept>& kept, std::function<void()> done);

  Answered restart(const Sender& sender, const Control& control);
  Answered typed(const Sender& sender, const Typed& typed, Reply& reply);
  Answered set_option(const Sender& sender, const SetOption& option);

  /// The mission that runs, with what was typed; null: none.
  const mission::Mission* mission() const { return plain_.get(); }
  std::uint64_t seed() const { return seed_; }
  /// Files that programs are made from have changed: what runs next makes its programs anew.
  void forget_programs() { ++files_; }

  /// Where the programs of the mission that is open come from, and what they may do.
  robot::ProgramSources program_sources() const;

 private:
  using CrewPtr = std::shared_ptr<const run::Crew>;
  using MissionPtr = std::shared_ptr<const mission::Mission>;
  using FilesPtr = std::shared_ptr<const text::Files>;

  /// @param trial_files  that programs of a trial are read with; null: those on disk
  robot::ProgramSources program_sources_with(const text::Files* trial_files) const;

  /// @param known  programs that need not be built again; null: none
  void load(std::uint64_t seed, const CrewPtr& known = nullptr);
  bool are_programs_old() const { return made_of_ != files_; }
  void adopt(const CrewPtr& crew, std::unique_ptr<run::MissionRun> run, const text::Diagnostics& problems);
  void take_over(const Trial& trial, const TrialDone& done);
  Answered why_not_taken_over(const Trial& trial) const;
  void finish_takeover(const CrewPtr& crew, const FilesPtr& files, const text::Diagnostics& problems,
                       const TrialDone& done);
  void answer_trial(const std::string& error, const text::Diagnostics& problems);
  void take_notices();
  /// What was typed holds for the documents' new mission, too, as far as it can.
  void follow_edited_mission();
  /// The run goes on with another version of its mission.
  /// @return false: what it needs is being made, it will happen later
  bool change_mission(MissionPtr plain);
  void exchange(std::uint64_t number, const CrewPtr& crew, const text::Diagnostics& problems);
  void finish_resumption(ResumedRun resumed, const std::shared_ptr<const journal::Kept>& kept,
                         std::shared_ptr<RunJournal> journal, std::shared_ptr<HistoryEntries> entries,
                         const std::function<void()>& done);
  /// Texts may have changed while nobody was here.
  void follow_changes_since();
  void report_problems(const text::Diagnostics& problems);

  const SessionSettings& settings_;
  OpenDocuments& documents_;
  RunControl& run_;
  RobotParameters& parameters_;
  EventLog& log_;
  Inbox& inbox_;
  Chronicle& chronicle_;
  const std::function<bool()> meanwhile_;

  /// Number of the last load or change of the mission; what older ones bring is thrown away.
  std::atomic<std::uint64_t> number_ = 0;
  std::uint64_t seed_ = 1;
  run::RunSettings run_settings_;         // of the next run, but for its seed
  std::uint64_t files_ = 0;               // how often files of programs have changed
  std::uint64_t made_of_ = 0;             // the same when the programs of what runs were made
  MissionPtr from_documents_;             // that the run follows
  MissionPtr plain_;                      // the same with what was typed
  std::vector<std::string> typed_edits_;  // lines that added to the mission
  FilesPtr trial_files_;                  // that programs of a trial are read with
  TrialDone trial_done_;                  // who waits for it; empty: nobody
  bool executes_trial_ = false;

  std::stop_source jobs_end_;           // stops a C++ compiler that a job waits for
  std::unique_ptr<Workshop> workshop_;  // ends before everything that its jobs report to
};

}  // namespace mlab::console
