#include "mlab/history/recorder.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

namespace mlab::history {

Recorder::Recorder(Place place, run::MissionRun& run, const Circumstances& circumstances, Listener listener,
                   bool is_held)
    : run_(run),
      place_(std::move(place)),
      listener_(std::move(listener)),
      started_at_(circumstances.started_at),
      names_(run.crew()->mission->folder),
      is_held_(is_held),
      writer_([this](const wire::HistoryEntry& entry) { put(entry); }) {
  writer_.begin(run, circumstances);
}

Recorder::~Recorder() {
  writer_.leave();
  if (file_) file_->close();
}

void Recorder::put(const wire::HistoryEntry& entry) {
  if (is_held_) {
    waiting_.push_back(entry);
    return;
  }
  if (listener_) listener_(entry);
  if (file_) {
    file_->put(names_.in_recording(entry));
    return;
  }
  if (!place_ || !problem_.empty()) return;
  waiting_.push_back(entry);
  if (entry.has_input() && entry.input().has_posted()) begin_file();
}

void Recorder::begin_file() {
  const std::vector<wire::HistoryEntry> waiting = std::exchange(waiting_, {});
  const auto place = place_();
  if (!place) {
    problem_ = place.error();
    return;
  }
  auto file = RecordingWriter::create(*place, started_at_);
  if (!file) {
    problem_ = file.error().message;
    return;
  }
  file_ = std::move(*file);
  path_ = file_->path();
  for (const wire::HistoryEntry& entry : waiting) file_->put(names_.in_recording(entry));
  if (file_->has_begun() || file_->problem().empty()) return;
  // Nobody could read what there is.
  problem_ = file_->problem();
  file_.reset();
  std::error_code stays;
  std::filesystem::remove(std::exchange(path_, {}), stays);
}

void Recorder::go_on(const std::string& file) {
  is_held_ = false;
  if (listener_) std::ranges::for_each(waiting_, listener_);
  const bool was_started = std::ranges::any_of(waiting_, [](const wire::HistoryEntry& entry) {
    return entry.has_input() && entry.input().has_posted();
  });
  if (!place_) waiting_.clear();
  if (!place_ || !was_started) return;
  std::vector<wire::HistoryEntry> in_file;
  in_file.reserve(waiting_.size());
  for (const wire::HistoryEntry& entry : waiting_) in_file.push_back(names_.in_recording(entry));
  text::Diagnostic none;
  none.message = "it was not recorded before";
  auto resumed =
      file.empty() ? std::unexpected(std::move(none)) : RecordingWriter::go_on(file, started_at_, in_file);
  if (!resumed && resumed.error().kind == RecordingWriter::kNoRoom) {
    // There is none for a new one either. Who resumes the run the next time goes on with this one.
    path_ = file;
    problem_ = std::move(resumed.error().message);
    waiting_.clear();
    return;
  }
  if (!resumed) {
    why_anew_ = std::move(resumed.error().message);
    begin_file();
    return;
  }
  is_same_file_ = true;
  file_ = std::move(*resumed);
  path_ = file_->path();
  waiting_.clear();
}

void Recorder::end(const std::string& outcome) {
  writer_.end(outcome);
  if (file_) file_->close();
}

}  // namespace mlab::history
