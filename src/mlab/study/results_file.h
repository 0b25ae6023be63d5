#pragma once

#include <cstdint>
#include <expected>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mlab/study/row.h"

namespace mlab::study {

/// What a batch is, in words by name: two batches are the same where all of them are equal.
using Identity = std::vector<std::pair<std::string, std::string>>;

/// The file in which a batch keeps what is done, a line for each run as it ends. Whatever ends the process,
/// what stands there counts; a line that was not finished does not.
class ResultsFile {
 public:
  struct Opened;
  /// Makes the file, or goes on with one that is there.
  /// @param resumes  else a file that has runs in it is left alone
  /// @errors  a sentence about the file: `holds 12 runs of a batch that was interrupted; ...`
  static std::expected<Opened, std::string> open(const std::string& path, const Identity& identity,
                                                 bool resumes);
  /// What was kept under a name when a file was begun; nothing where there is none, or it is another file.
  static std::optional<std::string> kept_word(const std::string& path, const std::string& name);

  ~ResultsFile();
  ResultsFile(const ResultsFile&) = delete;
  ResultsFile& operator=(const ResultsFile&) = delete;

  /// @return  false: it can't be written
  bool append(const Row& row) const;
  const std::string& path() const { return path_; }

 private:
  ResultsFile(std::string path, int descriptor) : path_(std::move(path)), descriptor_(descriptor) {}

  std::string path_;
  int descriptor_;
};

struct ResultsFile::Opened {
  std::unique_ptr<ResultsFile> file;
  std::vector<Row> rows;  ///< that it has already, in no order
};

}  // namespace mlab::study
