#include "mlab/history/recorder.h"

#include <utility>

namespace mlab::history {

Recorder::Recorder(Place place, run::MissionRun& run, const Circumstances& circumstances)
    : place_(std::move(place)),
      started_at_(circumstances.started_at),
      writer_([this](const wire::HistoryEntry& entry) { put(entry); }) {
  writer_.begin(run, circumstances);
}

Recorder::~Recorder() {
  writer_.leave();
  if (file_) file_->close();
}

void Recorder::put(const wire::HistoryEntry& entry) {
  if (file_) {
    file_->put(entry);
    return;
  }
  if (!problem_.empty()) return;
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
  for (const wire::HistoryEntry& entry : waiting) file_->put(entry);
}

void Recorder::end(const std::string& outcome) {
  writer_.end(outcome);
  if (file_) file_->close();
}

}  // namespace mlab::history
