#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "mlab/history.pb.h"
#include "mlab/history/history.h"
#include "mlab/percept/action.h"
#include "mlab/percept/needs.h"

namespace mlab::history {

/// What a stranger's entry of answers says that no robot can have answered, as a sentence; nothing: all is
/// well.
/// @param before  cycle of the entry of answers before; 0: there is none
std::optional<std::string> what_is_wrong(const wire::HistoryEntry& entry, std::uint64_t before);

/// What one robot answered in one cycle.
struct RecordedAnswer {
  percept::Action action;
  percept::Needs needs;
  std::string fault;
  std::string failure;
  double silence = 0.0;      ///< [s]
  double percept_age = 0.0;  ///< [s]
};

/// Finds what robots answered in a cycle; quickest where one cycle follows the other. Keeps no more than the
/// cycle that it stands at.
class RecordedAnswers {
 public:
  /// @param history  may grow
  explicit RecordedAnswers(std::shared_ptr<const History> history) : history_(std::move(history)) {}

  /// Goes to that cycle, back or ahead.
  void go_to(std::uint64_t cycle);
  /// In the cycle at which it stands; null: nothing is known of it. Until `go_to`.
  const RecordedAnswer* find(std::uint32_t robot) const;

 private:
  void enter(std::size_t entry);
  void take(const wire::HistoryAnswer& answer);

  std::shared_ptr<const History> history_;
  std::uint64_t cycle_ = 0;
  std::optional<std::size_t> entry_;  // of History::answers, in which the cycle lies
  int next_ = 0;                      // of its answers
  std::map<std::uint32_t, RecordedAnswer> known_;
};

}  // namespace mlab::history
