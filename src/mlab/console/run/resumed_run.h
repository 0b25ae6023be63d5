#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "mlab/console/run/event_log.h"
#include "mlab/console/run/live_run.h"
#include "mlab/history/recorder.h"
#include "mlab/history/remaker.h"
#include "mlab/journal/journal.h"

namespace mlab::console {

/// A run that was cut off, as it stood then.
struct ResumedRun {
  std::unique_ptr<LiveRun> live;  ///< null: it is not there, and `why` says why not
  std::string why;                ///< as a sentence; empty: nobody wanted it any more
  std::vector<Log::Entry> told;   ///< what its log did not hold yet
  std::unique_ptr<EventLog> log;  ///< that `live` writes until LiveRun::go_on_in
};

/// What is made of the run, beside itself.
struct ResumeParts {
  history::ReplayTools tools;
  std::string version;               ///< of this program
  history::Recorder::Place place;    ///< of a recording, where the one before can't be gone on with
  history::Recorder::Listener hear;  ///< of its history from the beginning
};

/// Computes the run of a journal again, as far as it is known to have come: by the journal, or by its
/// recording, which may have gone on for a moment longer. On any thread.
/// @param is_unwanted  asked now and then: true ends it
ResumedRun resume_run(const journal::Kept& kept, const ResumeParts& parts,
                      const std::function<bool()>& is_unwanted);

}  // namespace mlab::console
