#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mlab/history.pb.h"
#include "mlab/history/history.h"
#include "mlab/mcap/writer.h"
#include "mlab/text/diagnostic.h"

namespace google::protobuf {
class Message;
}

namespace mlab::history {

/// Writes a history to an MCAP file: a channel for each kind of entry, `/mlab/input`, `/mlab/poses`, ... What
/// came in is in the file before it has any effect; all else a second later at most, while time passes.
class RecordingWriter {
 public:
  /// The kind of an error where nothing but room was missing: the next time there may be some.
  static constexpr const char* kNoRoom = "no-room";

  /// Makes the file. One that is there already is left alone; where nothing can be written to it, there is
  /// none.
  /// @param started_at  wall clock at run time 0, seconds since 1970-01-01 00:00 UTC
  static text::Result<std::unique_ptr<RecordingWriter>> create(const std::string& path, double started_at);

  /// Goes on with a file whose writer was killed, or had ended it, and writes what is missing in it. The end
  /// of the run that stands there is taken out.
  /// @param entries  all up to now
  /// @errors  what stands there is not the beginning of `entries`, but for an end; it is as it was then. The
  ///          message says why it is not, and `kNoRoom` that it could have been
  static text::Result<std::unique_ptr<RecordingWriter>> go_on(const std::string& path, double started_at,
                                                              const std::vector<wire::HistoryEntry>& entries);

  /// After an error nothing more is written; what stands can be read.
  void put(const wire::HistoryEntry& entry);
  /// A message for other programs, on a channel of its own with its own schema: no part of the history.
  /// @param time  simulated [s]
  void put_beside(const std::string& topic, const google::protobuf::Message& message, double time);
  /// What is said of the run by people, and no part of it. In the file from now on.
  /// @return  false: the file does not go on
  bool put_metadata(const mcap::Metadata& metadata);
  /// No time passes: all that was put is in the file from now on.
  void flush();
  /// Why the file does not go on, as a sentence; empty: it does.
  const std::string& problem() const { return problem_; }
  /// The history's beginning is in the file: without it nobody can read the rest.
  bool has_begun() const { return has_begun_; }
  const std::string& path() const { return path_; }
  /// Nothing more comes.
  void close();

 private:
  RecordingWriter(std::string path, double started_at, mcap::Writer writer);
  std::uint64_t time_of(double time) const;
  mcap::ChannelId channel_of(const wire::HistoryEntry& entry);
  mcap::ChannelId channel_of(const std::string& topic, const google::protobuf::Message& message);
  void write(mcap::ChannelId channel, double time);
  void note(const mcap::WriteError& error);

  const std::string path_;
  const double started_at_;
  mcap::Writer writer_;
  std::map<int, mcap::ChannelId> channels_;        // by kind of entry
  std::map<std::string, mcap::ChannelId> beside_;  // by topic
  std::string bytes_;
  std::uint32_t count_ = 0;
  std::chrono::steady_clock::time_point flushed_;
  bool is_flushed_ = true;  // nothing was put since
  bool has_begun_ = false;
  std::string problem_;
};

/// A recording, as far as it can be read.
struct Recording {
  std::shared_ptr<History> history;
  std::string cut;  ///< how far it could be read, and why no further, as a sentence; empty: to its end
  /// Something of what was recorded was changed since. False where the file only ends too early: its writer
  /// was killed, or the rest of it did not come along.
  bool is_damaged = false;
};

/// What can be said of a recording without reading it.
struct RecordingSummary {
  std::string mission;  ///< path of its text, as it was read
  std::string version;  ///< of missionlab
  std::uint64_t seed = 0;
  double started_at = 0.0;  ///< wall clock, seconds since 1970-01-01 00:00 UTC
  double length = 0.0;      ///< of the run, as far as it was recorded [s, simulated]
  std::string outcome;      ///< empty: the run was cut off, or goes on
};

/// @errors  as `read_recording`
text::Result<RecordingSummary> summarize_recording(const std::string& path);

/// @errors  `cannot-read`, `no-mcap`; `no-recording`: it is an MCAP file, but of no run
text::Result<Recording> read_recording(const std::string& path);

}  // namespace mlab::history
