#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "mlab/console.pb.h"
#include "mlab/geom/pose.h"

namespace mlab::console {

/// What happened, for people: the last kMost entries, numbered from 1 without gaps.
class EventLog {
 public:
  static constexpr std::size_t kMost = 10000;

  struct Entry {
    Log::Kind kind = Log::MESSAGE;
    std::string text;
    std::uint32_t robot = 0;  ///< 0: none
    std::string unit;         ///< empty: none
    std::optional<geom::Point> place;
    bool is_alert = false;
  };

  /// @param time  of the run [s]
  void add(double time, Entry entry);
  /// Number of the last entry; 0: there is none.
  std::uint64_t last() const { return last_; }
  /// How many of a kind there ever were.
  std::uint64_t count(Log::Kind kind) const { return counts_[static_cast<std::size_t>(kind)]; }
  /// Another run begins: alerts until now are of an earlier one.
  void begin_run() { alerts_after_ = last_; }
  std::uint64_t alerts_after() const { return alerts_after_; }
  /// The entry of that number, as it is told; null: it is not kept.
  const Log::Entry* find(std::uint64_t number) const;
  /// Entries of an earlier session come before those that are there. All get other numbers, so that whoever
  /// looks is told of all of them again.
  /// @param alerts_after  number of one of them
  void put_before(std::vector<Log::Entry> earlier, std::uint64_t alerts_after);
  /// An entry as it was told elsewhere.
  void add_told(Log::Entry told);
  /// All entries after that number, as far as they are kept. `is_whole` is set where some of them are not.
  void encode_since(std::uint64_t number, Log& out) const;

 private:
  std::deque<Log::Entry> entries_;
  std::array<std::uint64_t, Log::Kind_ARRAYSIZE> counts_{};
  std::uint64_t last_ = 0;
  std::uint64_t alerts_after_ = 0;
};

}  // namespace mlab::console
