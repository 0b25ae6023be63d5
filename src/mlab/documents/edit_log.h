#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace mlab::documents {

/// What was edited, to be undone and done again without limit. Knows nothing of what an edit is: texts, the
/// world, parameters of robots bring their own ways.
class EditLog {
 public:
  struct Edit {
    std::string name;            ///< for people: `move AA-AA1`
    std::function<void()> undo;  ///< makes what it was
    std::function<void()> redo;  ///< makes it again
    bool merges = true;          ///< it may be one with others of its name
  };
  /// Edits of the same name within this time of each other are one [s].
  static constexpr double kMergeWithin = 1.0;

  /// An edit that has been done. What had been undone before it can no longer be done again.
  /// @param now  any clock that doesn't go back [s]
  void add(Edit edit, double now);
  /// The next edit is one of its own, whatever its name.
  void separate() { may_merge_ = false; }
  /// False where there is nothing to undo.
  bool undo();
  bool redo();
  void clear();

  /// Names of what `undo` and `redo` would do; empty: nothing.
  std::string undo_name() const { return done_ == 0 ? "" : entries_[done_ - 1].name; }
  std::string redo_name() const { return done_ == entries_.size() ? "" : entries_[done_].name; }
  /// Their numbers, which grow with every new edit; 0: nothing. They go on after `clear`.
  std::uint64_t undo_number() const { return done_ == 0 ? 0 : entries_[done_ - 1].number; }
  std::uint64_t redo_number() const { return done_ == entries_.size() ? 0 : entries_[done_].number; }

 private:
  struct Entry {
    std::string name;
    std::uint64_t number = 0;
    double time = 0.0;  ///< of the last of its edits
    std::vector<Edit> edits;
  };

  std::vector<Entry> entries_;
  std::size_t done_ = 0;  // entries before this one are done, the others undone
  std::uint64_t last_number_ = 0;
  bool may_merge_ = false;
};

}  // namespace mlab::documents
