#pragma once

#include <cstdint>
#include <expected>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mlab/history/history.h"
#include "mlab/journal.pb.h"

namespace mlab::journal {

/// An entry of the session's log: bytes that whoever wrote them understands.
struct Note {
  std::uint64_t number = 0;  ///< ascending, from 1
  std::string bytes;
};

/// What is written together: all of it, or nothing.
struct Batch {
  std::vector<std::string> entries;  ///< wire::HistoryEntry, in order
  std::vector<Note> notes;
  std::optional<std::string> session;  ///< wire::JournalSession, where it has changed
  std::optional<wire::JournalProgress> progress;
  bool is_empty() const { return entries.empty() && notes.empty() && !session && !progress; }
};

/// What is written outlives...
enum class Reach : std::uint8_t {
  kProcess,  ///< this process, whatever ends it
  kMachine,  ///< a loss of power, too
};

/// The journal of one run, which is being written. An error is a sentence, changes nothing in the file, and
/// may go away: the same batch can be tried again.
class Journal {
 public:
  /// Of `user_version`.
  static constexpr int kFormat = 1;
  /// Log entries that are kept, the newest.
  static constexpr std::uint64_t kMostNotes = 10'000;

  /// @param path  a file that is not there yet
  static std::expected<std::unique_ptr<Journal>, std::string> create(const std::string& path);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  std::expected<void, std::string> write(const Batch& batch, Reach reach = Reach::kProcess);
  /// Closes the file, and removes it: there is nothing to go on with.
  void remove();
  const std::string& path() const;

 private:
  struct State;
  explicit Journal(std::unique_ptr<State> state);

  std::unique_ptr<State> state_;
};

/// What a journal says of its run without all of it being read.
struct Stand {
  wire::JournalSession session;
  wire::JournalProgress progress;
};

/// What is kept of a run that a process has left. No other process can have it as long as this lives.
struct Kept {
  std::string path;
  Stand stand;
  /// Up to where `stand.progress` says.
  std::shared_ptr<history::History> history;
  std::vector<Note> notes;
  std::string cut;  ///< what is missing at its end, as a sentence; empty: nothing is
  std::shared_ptr<void> hold;
};

struct Unreadable {
  enum class Kind : std::uint8_t {
    kOther,
    kHeld,     ///< another process writes or reads it
    kEmpty,    ///< its writer was killed before anything was in it
    kForeign,  ///< it is no journal, a damaged one, or one of another version of this program
  };
  Kind kind = Kind::kOther;
  std::string why;  ///< as a sentence
};

/// Anything may stand in the file.
std::expected<Stand, Unreadable> read_stand(const std::string& path);
std::expected<Kept, Unreadable> read_journal(const std::string& path);

}  // namespace mlab::journal
