#include "mlab/documents/edit_log.h"

#include <ranges>
#include <utility>

namespace mlab::documents {

void EditLog::add(Edit edit, double now) {
  entries_.resize(done_);
  const bool is_same = may_merge_ && edit.merges && done_ > 0 && entries_.back().name == edit.name &&
                       now - entries_.back().time <= kMergeWithin;
  if (!is_same) {
    entries_.push_back({edit.name, ++last_number_, now, {}});
    ++done_;
  }
  entries_.back().time = now;
  may_merge_ = edit.merges;
  entries_.back().edits.push_back(std::move(edit));
}

bool EditLog::undo() {
  if (done_ == 0) return false;
  may_merge_ = false;
  for (const Edit& edit : std::views::reverse(entries_[--done_].edits)) edit.undo();
  return true;
}

bool EditLog::redo() {
  if (done_ == entries_.size()) return false;
  may_merge_ = false;
  for (const Edit& edit : entries_[done_++].edits) edit.redo();
  return true;
}

void EditLog::clear() {
  entries_.clear();
  done_ = 0;
  may_merge_ = false;
}

}  // namespace mlab::documents
