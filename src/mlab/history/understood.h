#pragma once

#include <cstddef>
#include <deque>
#include <expected>
#include <memory>
#include <string>

#include "mlab/history/history.h"
#include "mlab/history/remaker.h"
#include "mlab/run/input.h"
#include "mlab/text/diagnostic.h"

namespace mlab::history {

/// What came into the run of a history, understood once, for all who compute it again.
class Understood {
 public:
  /// What is made of an entry; the error is a sentence.
  using One = std::expected<run::Input, std::string>;

  Understood(std::shared_ptr<const History> history, ReplayTools tools)
      : history_(std::move(history)), remaker_(history_, std::move(tools)) {}

  const std::shared_ptr<const History>& history() const { return history_; }
  Remaker& remaker() { return remaker_; }
  /// @param index  of History::inputs; all before it are understood first
  const One& input(std::size_t index);
  /// For another history, which begins as this one does: what is understood already is not read again, and
  /// programs are the same.
  /// @param inputs  so many of History::inputs, the first, are those of both
  std::shared_ptr<Understood> branch(std::shared_ptr<const History> history, std::size_t inputs);

 private:
  std::shared_ptr<const History> history_;
  Remaker remaker_;
  std::deque<One> inputs_;
};

}  // namespace mlab::history
