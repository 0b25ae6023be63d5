#pragma once

#include <cstdint>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mlab/percepts_file.pb.h"
#include "mlab/text/diagnostic.h"

namespace mlab::recording {

/// Writes a file of percepts (proto/mlab/percepts_file.proto).
class PerceptsWriter {
 public:
  /// @errors  `can-not-write`
  static text::Result<std::unique_ptr<PerceptsWriter>> create(const std::string& path, std::uint64_t seed,
                                                              const std::string& mission);

  void write(const wire::RecordedEntry& entry);
  /// Says that nothing is missing; nothing is written after it.
  /// @errors  `can-not-write`: something did not get into the file, now or before
  std::optional<text::Diagnostic> finish();

 private:
  explicit PerceptsWriter(std::string path) : path_(std::move(path)), out_(path_, std::ios::binary) {}

  std::string path_;
  std::ofstream out_;
  std::string bytes_;
  bool is_too_large_ = false;  // an entry, for who reads it
  std::uint64_t cycles_ = 0;
};

/// Reads such a file. It may come from a stranger: percepts_check.h says what is looked at.
class PerceptsReader {
 public:
  /// Looks through the whole file first, so that who reads it afterwards meets no error.
  /// @errors  `no-percepts`: it can't be read, is another kind of file, is broken or cut; the sentence says
  /// at
  ///          which byte, what stands there, and what should
  static text::Result<std::unique_ptr<PerceptsReader>> open(const std::string& path);

  const std::string& path() const { return path_; }
  const wire::RecordedHead& head() const { return head_; }
  std::uint64_t cycles() const { return cycles_; }
  /// Each start of a robot, in the order of time.
  const std::vector<wire::RecordedBody>& bodies() const { return bodies_; }

  /// The next entry behind the head; null behind the last one. Valid until `take`.
  const wire::RecordedEntry* peek();
  void take() { has_next_ = false; }

 private:
  explicit PerceptsReader(std::string path) : path_(std::move(path)) {}
  std::optional<std::string> read_entry();
  std::optional<std::string> look_through();
  std::optional<std::string> look_at_entry(bool& has_ended);

  std::string path_;
  std::ifstream in_;
  std::uint64_t at_ = 0;  // where the entry begins that was read last [bytes]
  std::uint64_t end_ = 0;
  std::string bytes_;
  wire::RecordedEntry entry_;
  bool has_next_ = false;
  wire::RecordedHead head_;
  std::vector<wire::RecordedBody> bodies_;
  std::uint64_t cycles_ = 0;
};

}  // namespace mlab::recording
