#include "mlab/console/session/run_journal.h"

#include <chrono>
#include <utility>

namespace mlab::console {
namespace {

// Of entries that can't be written: then a run that nobody could go on with would fill the memory instead.
constexpr std::size_t kMostWaiting = std::size_t{64} << 20;

double system_time() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

bool tells_failures(const wire::HistoryEntry& entry) {
  return entry.answers().failed_size() > 0 || entry.answers().not_started_size() > 0;
}

// Nobody goes on with a run of which only is known what robots answered.
bool is_kept(const wire::HistoryEntry& entry) {
  if (entry.has_answers()) return tells_failures(entry) && entry.answers().answers().empty();
  return !entry.has_poses() && !entry.has_event() && !entry.has_end();
}

bool is_execute(const wire::HistoryEntry& entry) {
  return entry.input().posted().kind() == wire::HistoryPosted::EXECUTE;
}

}  // namespace

void RunJournal::go_on(std::shared_ptr<const journal::Kept> before) {
  is_held_ = false;
  before_ = std::move(before);
}

void RunJournal::hear(const wire::HistoryEntry& entry) {
  if (is_closed_) return;
  if (entry.has_end()) end();
  if (!is_kept(entry) || waiting_bytes_ > kMostWaiting) return;
  waiting_.push_back(entry.SerializeAsString());
  waiting_bytes_ += waiting_.back().size();
  is_started_ = is_started_ || entry.input().has_posted();
  if (has_begun() && entry.has_input())
    write(is_execute(entry) ? journal::Reach::kMachine : journal::Reach::kProcess, true);
  // Before the recording says that the run has come further.
  if (has_begun() && entry.has_answers()) write(journal::Reach::kProcess, false);
}

void RunJournal::keep(journal::Reach reach) {
  if (has_begun()) write(reach, false);
}

std::string RunJournal::open() {
  const auto place = folder_.place(system_time());
  if (!place) return place.error();
  auto made = journal::Journal::create(*place);
  if (!made) return made.error();
  file_ = std::move(*made);
  return "";
}

void RunJournal::add_notes(journal::Batch& batch) const {
  const std::uint64_t last = log_.last();
  const std::uint64_t first = last >= EventLog::kMost ? last - EventLog::kMost + 1 : 1;
  for (std::uint64_t number = std::max(first, noted_ + 1); number <= last; ++number) {
    if (const Log::Entry* entry = log_.find(number))
      batch.notes.push_back({number, entry->SerializeAsString()});
  }
}

void RunJournal::write(journal::Reach reach, bool is_before_input) {
  std::optional<Standing> standing = look_ ? look_() : std::nullopt;
  if (!standing) return;
  if (is_before_input) standing->progress.set_has_looked(false);
  std::string progress = standing->progress.SerializeAsString();
  journal::Batch batch;
  add_notes(batch);
  if (standing->session != session_) batch.session = standing->session;
  const bool has_come_on = progress != progress_;
  if (batch.is_empty() && waiting_.empty() && !has_come_on && reach == journal::Reach::kProcess) return;
  standing->progress.set_written_at(system_time());
  batch.progress = standing->progress;
  batch.entries = std::move(waiting_);
  problem_ = waiting_bytes_ > kMostWaiting ? "too much could not be written" : file_ ? "" : open();
  if (problem_.empty()) {
    if (const auto written = file_->write(batch, reach); !written) problem_ = written.error();
  }
  if (!problem_.empty()) {
    waiting_ = std::move(batch.entries);
    return;
  }
  waiting_.clear();
  waiting_bytes_ = 0;
  noted_ = log_.last();
  session_ = std::move(standing->session);
  progress_ = std::move(progress);
  is_over_ = batch.progress->is_over();
  if (before_) {
    journal::JournalFolder::remove(before_->path);
    before_.reset();
  }
}

void RunJournal::give_up() {
  is_over_ = true;
  if (before_) journal::JournalFolder::remove(before_->path);
  end();
}

void RunJournal::end() {
  if (file_ && is_over_) file_->remove();
  file_.reset();
  before_.reset();
  waiting_.clear();
  problem_.clear();
  is_closed_ = true;
}

}  // namespace mlab::console
