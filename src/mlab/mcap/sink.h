#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace mlab::mcap {

/// Where a writer's bytes go. All functions give 0, or the system's number of the error (`ENOSPC`).
class Sink {
 public:
  virtual ~Sink() = default;

  /// Appends all bytes. After an error a part of them may stand there.
  virtual int append(std::span<const std::byte> bytes) = 0;
  /// Takes away what stands behind the first `size` bytes; asked for after an error, to leave whole records.
  virtual int cut(std::uint64_t size) = 0;
  /// Comes back when what was appended outlives a loss of power.
  virtual int sync() = 0;
  /// Last of all.
  virtual int close() = 0;
};

/// A file of the disk. As long as it is open no other process opens it by this class.
class FileSink final : public Sink {
 public:
  /// What `open` found.
  struct Opened {
    std::unique_ptr<FileSink> sink;
    int error = 0;  ///< 0, or why there is no sink; `EWOULDBLOCK`: another process writes the file
  };
  /// Makes the file, or empties the one that is there. Only an ordinary file is taken (else `EINVAL`).
  static Opened create(const std::string& path);
  /// A file that is there, to go on at its end.
  static Opened open(const std::string& path);

  FileSink(const FileSink&) = delete;
  FileSink& operator=(const FileSink&) = delete;
  ~FileSink() override;

  /// For whoever reads it, too.
  int descriptor() const { return fd_; }
  std::uint64_t size() const { return at_; }

  int append(std::span<const std::byte> bytes) override;
  int cut(std::uint64_t size) override;
  int sync() override;
  int close() override;

 private:
  explicit FileSink(int fd) : fd_(fd) {}
  static Opened open_with(const std::string& path, int flags);

  int fd_;
  std::uint64_t at_ = 0;
};

}  // namespace mlab::mcap
