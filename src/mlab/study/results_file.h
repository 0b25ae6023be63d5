#pragma once

#include <expected>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mlab/study/locked_file.h"
#include "mlab/study/result_lines.h"
#include "mlab/study/row.h"

namespace mlab::study {

inline constexpr const char* kResultsInUse = "is in use by another batch that runs now";

/// Where a batch keeps what is done.
class Keeper {
 public:
  Keeper() = default;
  Keeper(const Keeper&) = delete;
  Keeper& operator=(const Keeper&) = delete;
  virtual ~Keeper() = default;

  /// @return  false: it can't be written
  virtual bool append(const Row& row) = 0;
  /// A failure is about to be in this file, whole.
  /// @return  likewise
  virtual bool append_recording(const RunKey& key, const std::string& file) = 0;
  /// What was appended of recordings, by this process or by others, now or before the batch was interrupted.
  virtual std::map<RunKey, std::string> recordings() const = 0;
  /// What other processes have done since somebody asked last.
  virtual std::vector<Row> news() { return {}; }
  /// Another process says that nothing is left to do.
  virtual bool is_over() const { return false; }
};

/// The file in which a batch of one process keeps what is done, a line for each run as it ends. Whatever ends
/// the process, what stands there counts; a line that was not finished does not. Files beside it, of several
/// processes that did a part of the same batch (SharedResults), count as well.
class ResultsFile final : public Keeper {
 public:
  struct Opened;
  /// Makes the file, or goes on with one that is there.
  /// @param resumes  else a file that has runs in it is left alone
  /// @errors  a sentence about the file: `holds 12 runs of a batch that was interrupted; ...`
  static std::expected<Opened, std::string> open(const std::string& path, const Identity& identity,
                                                 bool resumes);
  /// What was kept under a name when a file was begun; nothing where there is none, or it is another file.
  static std::optional<std::string> kept_word(const std::string& path, const std::string& name);

  /// Whether runs are kept there whose table has not been written yet.
  static bool keeps_runs(const std::string& path);

  bool append(const Row& row) override { return file_.append(row_line(row)); }
  bool append_recording(const RunKey& key, const std::string& file) override {
    return file_.append(recording_line(key, file));
  }
  std::map<RunKey, std::string> recordings() const override;
  /// Table and page were written: the file and all beside it go. What several processes began leaves a mark,
  /// for those of them that come late.
  void finish();

 private:
  ResultsFile(std::string path, LockedFile file) : path_(std::move(path)), file_(std::move(file)) {}

  std::string path_;
  LockedFile file_;
};

struct ResultsFile::Opened {
  std::unique_ptr<ResultsFile> file;
  std::vector<Row> rows;            ///< that it has already, in no order
  std::vector<std::string> damage;  ///< what can't be read in it, and in those beside it: a sentence for each
};

/// Files beside that of the batch in which single processes keep their part: `out.csv.runs.rank-2`.
std::string rank_file(const std::string& path, std::uint32_t number);
std::vector<std::string> rank_files(const std::string& path);
void remove_rank_files(const std::string& path);
/// What can't be read in a file of a batch, as a sentence; empty: all of it can.
/// @param contents  what was understood of it
std::string damage_of(const std::string& path, const std::expected<Contents, std::string>& contents);
/// What stands of recordings in the file of a batch, and in those beside it.
std::map<RunKey, std::string> kept_recordings(const std::string& path);

}  // namespace mlab::study
