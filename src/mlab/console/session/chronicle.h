#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "mlab/console/documents/documents.h"
#include "mlab/console/session.h"
#include "mlab/console/session/people.h"
#include "mlab/console/session/run_control.h"
#include "mlab/console/session/run_journal.h"
#include "mlab/history/bookmarks.h"
#include "mlab/history/recorder.h"
#include "mlab/history/shelf.h"
#include "mlab/journal/journal_folder.h"
#include "mlab/run/mission_run.h"

namespace mlab::console {

/// Entries of a history that nobody has taken yet. One thread at a time.
using HistoryEntries = std::vector<wire::HistoryEntry>;

/// What is written of the session's runs, and who reads it while they go on. Belongs to the session's thread.
class Chronicle {
 public:
  /// What it works with; all of it outlives it.
  struct Parts {
    const SessionSettings& settings;
    const OpenDocuments& documents;
    RunControl& run;
    const People& people;
    EventLog& log;
    const history::Bookmarks& bookmarks;
  };
  explicit Chronicle(const Parts& parts);
  ~Chronicle();
  Chronicle(const Chronicle&) = delete;
  Chronicle& operator=(const Chronicle&) = delete;

  /// A run is there, into which nothing has come yet: from now on its history is told.
  /// @param run  outlives what is returned
  std::unique_ptr<history::Recorder> begin(run::MissionRun& run);
  /// What came to the history of the last run since this was asked, but for poses: they are computed again.
  HistoryEntries take_entries();

  // ---- journals

  /// Of a run that is about to be computed again, to be handed to `go_on`; null: none is kept.
  std::shared_ptr<RunJournal> held_journal() const;
  /// Tells both of a run's history.
  /// @param journal  null: none is kept
  static history::Recorder::Listener listener_of(std::shared_ptr<RunJournal> journal,
                                                 std::shared_ptr<HistoryEntries> entries);
  /// Where such a run is recorded, if it can't be where it was before; may be called on any thread.
  history::Recorder::Place place_anew(const std::string& mission) const;
  /// That run takes the place of the one before.
  /// @param before  what it was computed from
  /// @param entries  of its history
  void go_on(std::shared_ptr<RunJournal> journal, const run::MissionRun& run,
             std::shared_ptr<const journal::Kept> before, std::shared_ptr<HistoryEntries> entries);
  /// Writes what has changed, if it is time to.
  void keep();
  /// Before something is acknowledged.
  void keep_now(journal::Reach reach = journal::Reach::kProcess);
  /// The run is not to be gone on with: somebody begins it anew.
  void give_up();

  /// Why the run could not be gone on with as it stands, as a sentence; empty: it could.
  std::string not_saved() const;
  /// What browsers are told.
  const Journal& message();
  /// The journal that a browser names; empty: there is none.
  std::string path_of(const std::string& name) const;
  /// Looks at what earlier sessions have left.
  void look();

 private:
  history::Recorder::Place place_of(const run::MissionRun& run);
  RunJournal::Standing standing_of(const LiveRun& live, const std::string& mission) const;
  void follow(const run::MissionRun& run);
  void tell_problem();

  const SessionSettings& settings_;
  const OpenDocuments& documents_;
  RunControl& run_;
  const People& people_;
  EventLog& log_;
  const history::Bookmarks& bookmarks_;
  const history::Shelf shelf_;
  const journal::JournalFolder folder_;
  const std::string project_;                // its folder
  bool has_named_recording_ = false;         // the first run is recorded in the file that was named
  std::shared_ptr<RunJournal> journal_;      // of the run; null: none is kept
  std::shared_ptr<HistoryEntries> entries_;  // of its history, which nobody has taken yet
  std::string told_problem_;
  double next_ = 0.0;  // when the journal is written next [s]
  Journal message_;
};

}  // namespace mlab::console
