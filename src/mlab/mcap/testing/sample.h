#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "mlab/mcap/encode.h"
#include "mlab/mcap/reader.h"
#include "mlab/mcap/writer.h"

namespace mlab::mcap::testing {

/// A message that owns its bytes, its channel told by its topic.
struct Said {
  std::string topic;
  std::uint32_t sequence = 0;
  std::uint64_t log_time = 0;
  std::uint64_t publish_time = 0;
  std::string data;

  friend bool operator==(const Said&, const Said&) = default;
};
std::ostream& operator<<(std::ostream& out, const Said& said);

/// Keeps what is written, up to so many bytes; then it refuses as a disk does that is full in the middle of a
/// write.
class MemorySink final : public Sink {
 public:
  explicit MemorySink(std::shared_ptr<Buffer> bytes, std::size_t room = SIZE_MAX, int error = 0)
      : bytes_(std::move(bytes)), room_(room), error_(error) {}

  int append(std::span<const std::byte> bytes) override;
  int cut(std::uint64_t size) override;
  int sync() override { return 0; }
  int close() override { return 0; }

 private:
  std::shared_ptr<Buffer> bytes_;
  std::size_t room_;
  int error_;
};

/// What is to be recorded, and after how many messages each chunk is flushed.
struct Script {
  std::vector<Said> messages;
  std::size_t per_flush = 3;
  WriterOptions options;
  bool has_extras = true;  ///< an attachment behind the first flush, metadata behind the second
};

/// A script of so many messages of three topics, with times that go back now and then.
Script script_of(std::size_t messages);

/// Adds what the script needs that is not there, and records it from its message `from` on.
/// @return  what the writer says first that is an error
Written play(Writer& writer, const Script& script, std::size_t from = 0);
/// The file that comes out of it.
Buffer file_of(const Script& script);

Reader reader_of(const Buffer& bytes, const Limits& limits = {});
/// All that the iterator gives; broken chunks are left out and counted.
std::vector<Said> all(const Reader& reader, const Selection& selection = {}, std::size_t* broken = nullptr);
/// In the order in which a reader gives them.
std::vector<Said> in_order(std::vector<Said> messages);

std::span<const std::byte> bytes_of(std::string_view text);

/// A file in a folder of its own, which goes with it.
class ScratchFile {
 public:
  ScratchFile();
  ~ScratchFile();
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;

  const std::string& folder() const { return folder_; }
  const std::string& path() const { return path_; }
  void put(std::span<const std::byte> bytes) const;
  Buffer bytes() const;

 private:
  std::string folder_;
  std::string path_;
};

}  // namespace mlab::mcap::testing
