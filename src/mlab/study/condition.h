#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mlab/statistics/shares.h"
#include "mlab/study/dimension.h"
#include "mlab/study/row.h"
#include "mlab/text/diagnostic.h"

namespace mlab::study {

/// What a run has to be to count as a success: `outcome == done and contacts == 0`.
///
/// Comparisons (`==`, `!=`, `<`, `<=`, `>`, `>=`) of a run's numbers with numbers, or of `outcome` with a
/// word, joined by `and`, `or`, `not` and parentheses. A number that a run does not have makes its comparison
/// false.
class Condition {
 public:
  /// @errors  the narrowest wrong thing
  static text::Result<Condition> parse(const Written& written);

  bool holds(const Row& row) const { return holds(row, root_); }
  /// The text of the first part, of those joined by `and`, that a row does not fulfil.
  std::string unfulfilled(const Row& row) const;
  const std::string& text() const { return text_; }

 private:
  friend class ConditionParser;
  struct Node {
    enum class Kind : std::uint8_t { kAnd, kOr, kNot, kNumber, kOutcome };
    enum class Relation : std::uint8_t { kEqual, kUnequal, kLess, kAtMost, kMore, kAtLeast };
    Kind kind = Kind::kAnd;
    Relation relation = Relation::kEqual;
    Number number = Number::kDuration;
    double value = 0.0;
    std::string word;
    std::vector<std::size_t> parts;  // indices into nodes_
    std::size_t begin = 0;           // in text_
    std::size_t end = 0;
  };
  bool holds(const Row& row, std::size_t node) const;

  std::string text_;
  std::vector<Node> nodes_;
  std::size_t root_ = 0;
};

/// What the share of successes has to be: `success >= 0.95 @ 0.99`. It is met where the whole interval of
/// that confidence lies on the right side.
struct Requirement {
  std::string text;
  bool is_at_least = true;
  double share = 0.0;
  double confidence = 0.95;

  static text::Result<Requirement> parse(const Written& written);
  bool is_met(statistics::Interval interval) const {
    return is_at_least ? interval.low >= share : interval.high <= share;
  }
  /// The whole interval lies on the wrong side.
  bool is_refuted(statistics::Interval interval) const {
    return is_at_least ? interval.high < share : interval.low > share;
  }
};

/// When no more runs of a combination are needed: once all requirements are `decided`, or once its share is
/// known so well: `success +- 0.05 @ 0.95`.
struct Until {
  std::string text;
  bool is_decided = false;
  double half_width = 0.0;
  double confidence = 0.95;

  static text::Result<Until> parse(const Written& written);
};

}  // namespace mlab::study
