#pragma once

#include <cstddef>
#include <cstdint>
#include <expected>
#include <memory>
#include <optional>
#include <string>

#include "mlab/mcap/records.h"
#include "mlab/mcap/sink.h"

namespace mlab::mcap {

/// How a file is written. What a file that is gone on with says of itself stays.
struct WriterOptions {
  Header header = {.profile = {}, .library = "missionlab"};
  /// A chunk is written once its records have so many bytes, uncompressed; at most 16 MiB. Larger ones take
  /// less room, of smaller ones less has to be read for a moment.
  std::size_t chunk_bytes = std::size_t{1} << 20;
  bool is_compressed = true;  ///< by zstd
  int level = 1;              ///< of zstd, from 1 (fast) to 19 (small)
};

/// Why something was not written.
///
/// What is said to be kept is what the system has taken; after an error of `sync` it may have been wrong.
struct WriteError {
  /// The system's number: `ENOSPC`, `EIO`, `EFBIG`, `EDQUOT`, ... After such an error the writer is dead.
  /// `EINVAL`: this one thing can't be written, as the message says; all else goes on.
  int code = 0;
  std::string message;
  std::uint64_t kept_bytes = 0;     ///< of the file, whole records; a reader finds all that is in them
  std::uint64_t kept_messages = 0;  ///< that can be read
  std::uint64_t lost_messages = 0;  ///< that were taken, and will not be there
};

using Written = std::expected<void, WriteError>;

/// Writes an MCAP file: messages in chunks, with indexes and a summary at its end.
///
///     auto writer = Writer::create("run.mcap");
///     const auto poses = writer->add_channel({.topic = "/poses", .message_encoding = "json"});
///     writer->write({.channel = *poses, .log_time = now, .publish_time = now, .data = bytes});
///     writer->close();
///
/// What was flushed is readable whatever happens afterwards: a process that is killed leaves a file that ends
/// with whole records, save for the last one. So flush as often as it would hurt to lose what came since,
/// once a second say. `resume` goes on with such a file.
///
/// An error is a value, and nothing throws. Once the disk has refused something the writer is dead: it cuts
/// off what was written in part, and all functions give the same error. Writing a message asks for no heap
/// once a chunk of its size was written. One thread at a time.
class Writer {
 public:
  /// Makes the file, or replaces the one that is there.
  static std::expected<Writer, WriteError> create(const std::string& path, const WriterOptions& options = {});
  static std::expected<Writer, WriteError> onto(std::unique_ptr<Sink> sink,
                                                const WriterOptions& options = {});
  struct Resumed;
  /// Goes on with a file that was cut off anywhere, or was closed: what is behind the last whole record (of a
  /// closed one: its summary) is cut off, and all that stands in front of it stays. One that ends before its
  /// header does is begun anew.
  /// @errors  `ENOENT`, ...; `EWOULDBLOCK`: another process writes it; `EINVAL`: it is no MCAP file, or holds
  ///          what would be lost (chunks compressed by lz4, messages outside of chunks); it is as it was
  /// @param most_bytes  the file is taken as if it were cut off there, where it is longer: at the beginning
  ///                    of a chunk that is not to stay
  static std::expected<Resumed, WriteError> resume(const std::string& path, const WriterOptions& options = {},
                                                   std::uint64_t most_bytes = UINT64_MAX);

  Writer(Writer&& from) noexcept;
  Writer& operator=(Writer&& from) noexcept;
  /// Closes the file; who wants to know whether that went well calls `close`.
  ~Writer();

  /// @param schema  its id is given by the writer. One that is there already, also of a file that is gone on
  ///                with, keeps its id and is not written again.
  std::expected<SchemaId, WriteError> add_schema(const Schema& schema);
  /// As `add_schema`. It names its schema, or none (0). Both are written in front of the next message.
  std::expected<ChannelId, WriteError> add_channel(const Channel& channel);

  /// Takes a message, whose bytes are copied. They may come in any order of time; readers are quicker where
  /// they come in theirs.
  /// @errors  `EINVAL`: nobody added its channel, or it has more than `kMostRecordBytes`
  [[nodiscard]] Written write(const Message& message);
  [[nodiscard]] Written attach(const Attachment& attachment);
  [[nodiscard]] Written add(const Metadata& metadata);

  /// Hands all messages to the system: they outlive this process.
  [[nodiscard]] Written flush();
  /// And to the disk: they outlive a loss of power.
  [[nodiscard]] Written sync();
  /// Flushes, writes the summary, and closes the file. A second time it does nothing.
  [[nodiscard]] Written close();

  /// What the file will say of itself, with what is not flushed yet.
  const Summary& summary() const;
  /// The error that the writer died of; null: it lives, or was closed.
  const WriteError* failure() const;

 private:
  class State;
  explicit Writer(std::unique_ptr<State> state);

  std::unique_ptr<State> state_;
};

/// A file that is gone on with, and what was found in it.
struct Writer::Resumed {
  Writer writer;                ///< its summary says what is there: channels, messages, the latest time
  std::uint64_t cut_bytes = 0;  ///< that were cut off
  std::string why;              ///< as `Ending::sentence`; empty: it had been closed
  bool is_begun_anew = false;   ///< it ended before its header did
};

}  // namespace mlab::mcap
