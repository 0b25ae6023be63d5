#pragma once

#include <expected>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "mlab/history/history_writer.h"
#include "mlab/history/recorded_names.h"
#include "mlab/history/recording_file.h"
#include "mlab/mission/effect.h"
#include "mlab/run/mission_run.h"

namespace mlab::history {

/// What becomes of a run's history: it is told to who listens, and is kept in a file from the moment in which
/// somebody starts the run. Whatever becomes of the file, the run goes on.
class Recorder {
 public:
  /// Where the file is to be; asked once, when the run is started.
  /// @errors  why there is no such place, as a sentence
  using Place = std::function<std::expected<std::string, std::string>()>;
  /// Hears each entry in the moment in which it is made, before what it tells of has an effect.
  using Listener = std::function<void(const wire::HistoryEntry& entry)>;

  /// @param place     empty: there is no file
  /// @param run       nothing has come into it yet; outlives this
  /// @param listener  empty: nobody listens
  /// @param is_held   the run is computed again up to where it was cut off: nothing is recorded and nobody
  ///                  hears of it until `go_on`
  Recorder(Place place, run::MissionRun& run, const Circumstances& circumstances, Listener listener = {},
           bool is_held = false);
  ~Recorder();
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  void see(const mission::Effect& effect) { writer_.see(effect); }
  void note_cycle() { writer_.note_cycle(); }
  /// There is a file, and nothing is wrong with it.
  bool is_recording() const { return file_ && file_->problem().empty(); }
  /// As RecordingWriter; nothing happens where there is no file.
  void put_beside(const std::string& topic, const google::protobuf::Message& message) {
    if (file_) file_->put_beside(topic, message, run_.time());
  }
  /// As RecordingWriter::put_metadata.
  /// @return  false: there is no file, or it does not go on
  bool put_metadata(const mcap::Metadata& metadata) { return file_ && file_->put_metadata(metadata); }
  /// No time passes.
  void note_rest() {
    writer_.note_rest();
    if (file_) file_->flush();
  }
  /// The run goes on from here. What was held is told and recorded: in that file, where it holds the
  /// beginning of the same, else in a new one; where only room is missing for the former, not at all.
  /// @param file  empty: there is none
  void go_on(const std::string& file);
  /// The recording is complete. Without, it is one of a run that was cut off.
  void end(const std::string& outcome);

  /// Empty: nobody has started the run, or there is no place.
  const std::string& path() const { return path_; }
  /// The run was cut off, and its recording goes on in the same file.
  bool is_same_file() const { return is_same_file_; }
  /// Why the recording of a run that was cut off is a new one, as a sentence; empty: it is not.
  const std::string& why_anew() const { return why_anew_; }
  /// Why the recording does not go on, as a sentence; empty: it does.
  const std::string& problem() const { return file_ ? file_->problem() : problem_; }

 private:
  void put(const wire::HistoryEntry& entry);
  void begin_file();

  const run::MissionRun& run_;
  const Place place_;
  const Listener listener_;
  const double started_at_;
  const RecordedNames names_;                // the listener hears those of this machine
  std::vector<wire::HistoryEntry> waiting_;  // until there is a file
  bool is_held_;
  std::unique_ptr<RecordingWriter> file_;
  std::string path_;
  std::string problem_;  // where nothing is written to a file
  bool is_same_file_ = false;
  std::string why_anew_;
  HistoryWriter writer_;
};

}  // namespace mlab::history
