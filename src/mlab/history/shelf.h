#pragma once

#include <cstddef>
#include <cstdint>
#include <expected>
#include <string>
#include <utility>
#include <vector>

namespace mlab::history {

/// A recording on the shelf.
struct ShelvedRun {
  std::string path;
  std::string name;  ///< `2026-11-26 07.31.02 demo_c`
  std::uint64_t bytes = 0;
  bool is_marked = false;  ///< it stays until somebody takes the mark away
};

/// Recordings of one project that are made without being asked for: the newest are kept, and those that
/// somebody has marked. Two processes may use one shelf.
class Shelf {
 public:
  static constexpr std::size_t kMostRuns = 50;
  static constexpr std::uint64_t kMostBytes = std::uint64_t{2} << 30;

  /// @param folder  made when it is needed; empty: nothing is kept
  explicit Shelf(std::string folder) : folder_(std::move(folder)) {}

  /// Where a run that begins now is recorded. The oldest runs that have no mark go, until there is room for
  /// one more.
  /// @param mission  path of its text; its name is part of the recording's
  /// @param now      wall clock, seconds since 1970-01-01 00:00 UTC
  /// @errors  why nothing can be kept there, as a sentence
  std::expected<std::string, std::string> place_for(const std::string& mission, double now) const;

  /// The newest first. Where the folder can't be read there are none.
  std::vector<ShelvedRun> runs() const;
  /// Marks a recording, or takes its mark away.
  /// @errors  why not, as a sentence
  static std::expected<void, std::string> set_mark(const std::string& path, bool is_marked);
  const std::string& folder() const { return folder_; }

 private:
  void make_room() const;

  std::string folder_;
};

}  // namespace mlab::history
