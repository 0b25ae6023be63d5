#pragma once

#include <cstdint>
#include <string>

#include "mlab/console/run/event_log.h"
#include "mlab/console/session.h"
#include "mlab/console/session/people.h"
#include "mlab/console/session/request.h"
#include "mlab/console/session/run_control.h"
#include "mlab/history/bookmark_file.h"
#include "mlab/journal.pb.h"

namespace mlab::console {

/// Moments that people mark: of the run, or of the recording that was opened. Those of a run are in its
/// journal as long as it goes on (Chronicle), and in its recording; those of a recording that is complete, or
/// can't be gone on with, are in a file beside it. Belongs to the session's thread.
class BookmarkOrders {
 public:
  /// What it works with; all of it outlives it.
  struct Parts {
    const SessionSettings& settings;
    RunControl& run;
    EventLog& log;
    history::KeptBookmarks& kept;  ///< of the run, or of the recording; nobody else changes them
  };
  explicit BookmarkOrders(const Parts& parts) : parts_(parts) {}

  /// The recording of the settings was opened.
  void open_recording();
  /// Called when another run may have begun: it has none yet.
  void follow_run();
  /// A run that was cut off is there again.
  void recall(const wire::JournalSession& session);
  /// What could not be written is tried again now and then.
  /// @param is_last  the session ends
  void keep(bool is_last = false);

  Answered set(const Sender& sender, const SetBookmark& wanted, Reply& reply);
  Answered remove(const RemoveBookmark& wanted);

  void encode(console::Bookmarks& out) const;
  /// Grows where that has changed.
  std::uint64_t revision() const { return revision_; }

 private:
  bool is_recording() const { return parts_.settings.recording.history != nullptr; }
  Answered why_not() const;
  void warn(std::string text);
  Answered make(const Sender& sender, const SetBookmark& wanted, Reply& reply);
  void write(std::uint64_t changed);
  void write_beside(const std::string& recording);
  void note(std::string kept_in, std::string not_kept);

  const Parts parts_;
  std::uint64_t known_run_ = 0;
  std::string kept_in_;
  std::string not_kept_;
  std::string unwritten_;  // the recording beside which they are still to be written; empty: all is
  double next_try_ = 0.0;  // [s]
  std::uint64_t revision_ = 1;
};

}  // namespace mlab::console
