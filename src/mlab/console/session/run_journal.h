#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "mlab/console/run/event_log.h"
#include "mlab/history.pb.h"
#include "mlab/journal/journal.h"
#include "mlab/journal/journal_folder.h"

namespace mlab::console {

/// Keeps the journal of one run: from the moment in which somebody starts it until it is over. What comes
/// into the run is written before it has any effect, with all that was told before. What can't be written
/// waits, and is tried again: the journal never has a gap. One thread at a time.
class RunJournal {
 public:
  /// How run and session stand.
  struct Standing {
    wire::JournalProgress progress;
    std::string session;  ///< wire::JournalSession
  };
  /// Nothing: the run that is meant has gone.
  using Look = std::function<std::optional<Standing>()>;

  /// @param log  of the session; outlives this
  RunJournal(const journal::JournalFolder& folder, const EventLog& log) : folder_(folder), log_(log) {}

  /// From now on it can be asked how all stands.
  void follow(Look look) { look_ = std::move(look); }
  /// The run is one that is computed again: nothing is written until `go_on`.
  void hold() { is_held_ = true; }
  /// @param before  what it was computed from: it is held until all of it is written anew, and goes then
  void go_on(std::shared_ptr<const journal::Kept> before);

  /// As history::Recorder::Listener.
  void hear(const wire::HistoryEntry& entry);
  /// Writes what has changed.
  void keep(journal::Reach reach = journal::Reach::kProcess);
  /// The run is not to be gone on with.
  void give_up();
  /// Looks no more: the session ends, perhaps before the run does.
  void leave() { look_ = {}; }

  /// Why what was done last is not written, as a sentence; empty: it is.
  const std::string& problem() const { return problem_; }

 private:
  bool has_begun() const { return is_started_ && !is_held_ && !is_closed_; }
  void write(journal::Reach reach, bool is_before_input);
  void add_notes(journal::Batch& batch) const;
  std::string open();
  void end();

  const journal::JournalFolder& folder_;
  const EventLog& log_;
  Look look_;
  std::unique_ptr<journal::Journal> file_;
  std::shared_ptr<const journal::Kept> before_;
  std::vector<std::string> waiting_;  // entries that are not written
  std::size_t waiting_bytes_ = 0;
  std::uint64_t noted_ = 0;  // number of the last log entry that is written
  std::string session_;      // as it is written
  std::string progress_;     // likewise, without when that was
  std::string problem_;
  bool is_held_ = false;
  bool is_started_ = false;  // somebody has asked for something
  bool is_over_ = false;
  bool is_closed_ = false;
};

}  // namespace mlab::console
