#pragma once

#include <cstddef>
#include <cstdint>
#include <expected>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mlab::history {

/// A moment of a run that somebody has marked, to find it again.
struct Bookmark {
  std::uint64_t id = 0;  ///< from 1, within the run
  std::uint64_t cycle = 0;
  double time = 0.0;  ///< [s, simulated]
  std::string note;   ///< plain text on one line; may be empty
  std::string by;     ///< who made it; may be empty

  friend bool operator==(const Bookmark&, const Bookmark&) = default;
};

/// How far a run goes.
struct RunExtent {
  std::uint64_t cycles = 0;
  double time = 0.0;  ///< [s]
};

/// The moment of the run that is meant where somebody wrote one that it doesn't have: by the cycle where the
/// run has that, else by the time, else the beginning or the end.
/// @param one   a time that is missing is NaN, a cycle that is missing kMostNumber + 1 or more
/// @param run   nothing: nobody knows how far it goes
/// @return  false: it was a moment of the run, and is as it was
bool move_into_run(Bookmark& one, const std::optional<RunExtent>& run);

/// The bookmarks of one run: so many, and their notes so long, whoever wrote them.
class Bookmarks {
 public:
  static constexpr std::size_t kMost = 500;
  static constexpr std::size_t kMostNote = 500;  ///< characters
  static constexpr std::size_t kMostName = 80;   ///< likewise, of who made it
  /// Ids and cycles are at most this, so that they are whole in JSON as well.
  static constexpr std::uint64_t kMostNumber = std::uint64_t{1} << 53;

  /// A new one; its id is given.
  /// @errors  a sentence; nothing has changed then, as with all of these
  std::expected<std::uint64_t, std::string> add(Bookmark one);
  std::optional<std::string> set_note(std::uint64_t id, std::string_view note);
  std::optional<std::string> remove(std::uint64_t id);
  /// One that was removed is there again.
  std::optional<std::string> take_back(std::uint64_t id);

  /// One as it was written, perhaps by a stranger: in place of one with its id.
  /// @return  false: it is none, or there are too many; it is left out then
  bool put(Bookmark one);
  /// As `remove`, without coming back; one that isn't there is no error.
  void forget(std::uint64_t id) { all_.erase(id); }

  /// By id; null: there is none.
  const Bookmark* find(std::uint64_t id) const;
  const std::map<std::uint64_t, Bookmark>& all() const { return all_; }
  /// By time.
  std::vector<Bookmark> in_order() const;
  bool is_empty() const { return all_.empty(); }

  friend bool operator==(const Bookmarks& a, const Bookmarks& b) { return a.all_ == b.all_; }

 private:
  std::map<std::uint64_t, Bookmark> all_;
  std::map<std::uint64_t, Bookmark> removed_;
  std::uint64_t last_ = 0;  // id that was given last
};

/// As a note is kept: UTF-8 on one line, without control characters, no longer than it may be.
std::string plain_note(std::string_view text, std::size_t most = Bookmarks::kMostNote);

}  // namespace mlab::history
