#include "mlab/study/failure_recordings.h"

#include <cmath>
#include <expected>
#include <filesystem>
#include <map>
#include <optional>
#include <system_error>
#include <utility>

#include <fmt/core.h>

#include "mlab/history/recorder.h"
#include "mlab/study/locked_file.h"
#include "mlab/study/one_run.h"

namespace mlab::study {
namespace {

namespace fs = std::filesystem;
using Noted = std::map<RunKey, std::string>;

constexpr const char* kDraft = ".part";

// Whether a recording can be written there until it is whole. What a process left that was ended goes.
bool is_draft_free(const std::string& path) {
  const auto left = LockedFile::open_existing(path);
  std::error_code failure;
  if (!left) return !fs::exists(fs::symlink_status(path, failure));
  return left->lock() && fs::remove(path, failure);
}

// A name in the folder that no file has.
std::string free_name(const fs::path& folder, const RunKey& key, const Plan& plan) {
  std::string stem = fmt::format("seed-{}", plan.seed(key.run));
  if (plan.combinations() > 1) stem = fmt::format("combination-{}-{}", key.combination + 1, stem);
  if (key.version == 1) stem = "against-" + stem;
  std::error_code failure;
  std::string out = (folder / (stem + ".mcap")).string();
  for (int i = 2; fs::exists(fs::symlink_status(out, failure)) || !is_draft_free(out + kDraft); ++i)
    out = (folder / fmt::format("{}-{}.mcap", stem, i)).string();
  return out;
}

bool are_equal(double a, double b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}

bool are_alike(const Row& one, const Row& other) {
  for (std::size_t i = 0; i < one.numbers.size(); ++i) {
    if (!are_equal(one.numbers[i], other.numbers[i])) return false;
  }
  return one.outcome == other.outcome && one.cause == other.cause;
}

// Written beside, and renamed once it is whole: whatever ends the process, no half recording bears the name.
class Draft {
 public:
  explicit Draft(std::string file) : file_(std::move(file)), path_(file_ + kDraft) {}
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;
  ~Draft() {
    std::error_code failure;
    if (!is_taken_) fs::remove(path_, failure);
  }
  const std::string& path() const { return path_; }
  // @return  false: it can't have its name
  bool take() {
    std::error_code failure;
    fs::rename(path_, file_, failure);
    is_taken_ = !failure;
    return is_taken_;
  }

 private:
  const std::string file_;
  const std::string path_;
  bool is_taken_ = false;
};

/// What recordings of one batch have in common.
struct Studio {
  const Definition& definition;
  const Plan& plan;
  const std::vector<std::unique_ptr<Scene>>& scenes;
  const fs::path folder;
  const RecordedAs& as;
  const std::function<bool()>& wants_end;
  Keeper* const kept;
  const Noted before;

  // What was recorded before the batch was interrupted; empty: nothing.
  std::string recorded(const RunKey& key) const {
    const auto found = before.find(key);
    std::error_code failure;
    const bool is_there = found != before.end() &&
                          folder / fs::path(found->second).filename() == found->second &&
                          fs::is_regular_file(found->second, failure);
    return is_there ? found->second : "";
  }

  // @return  the file, or what went wrong; of a run that could not be made, or that was to end, neither
  std::expected<std::string, std::string> record(const Row& row) const {
    if (std::string file = recorded(row.key); !file.empty()) return file;
    if (wants_end()) return std::string();
    auto run = scenes[row.key.version]->make_run(row.key);
    if (!run) return std::string();
    std::string file = free_name(folder, row.key, plan);
    Draft draft(file);
    history::Recorder recorder(
        [&draft] { return draft.path(); }, **run,
        history::Circumstances{as.program_version, as.overlay_folders, (*run)->seed(), as.started_at});
    const std::optional<run::RunEnd> end = carry_out(**run, definition, wants_end, &recorder);
    if (!end) return std::string();
    const Row again = row_of(**run, *end, definition);
    recorder.end(again.outcome);
    if (!recorder.problem().empty())
      return std::unexpected(fmt::format("{} could not be written: {}", file, recorder.problem()));
    if (recorder.path().empty()) return std::string();
    const bool is_as_before = are_alike(again, row);
    if (is_as_before && kept != nullptr) kept->append_recording(row.key, file);
    if (!draft.take()) return std::unexpected(fmt::format("{} can't be written", file));
    if (!is_as_before)
      return std::unexpected(fmt::format("{}: the run with seed {} did not go as before", file, row.seed));
    return file;
  }
};

}  // namespace

FailureRecordings record_failures(const Batch& batch, Summary& summary, const Definition& definition,
                                  const Plan& plan, const std::vector<std::unique_ptr<Scene>>& scenes,
                                  const std::string& folder, const RecordedAs& as, Keeper* kept,
                                  const std::function<bool()>& wants_end) {
  FailureRecordings out;
  if (summary.failures.empty()) return out;
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (!fs::is_directory(folder, failure)) {
    out.problems.push_back(fmt::format("there can't be a folder {}", folder));
    return out;
  }
  const Studio studio{definition, plan,      scenes, folder,
                      as,         wants_end, kept,   kept != nullptr ? kept->recordings() : Noted()};
  for (FailureGroup& group : summary.failures) {
    if (out.made + out.missing + out.problems.size() == kMostRecordings) {
      ++out.left_out;
      continue;
    }
    auto file = studio.record(batch.cell(group.first.version, group.first.combination).rows[group.first.run]);
    if (!file) {
      out.problems.push_back(std::move(file.error()));
    } else if (!file->empty()) {
      group.recording = std::move(*file);
      ++out.made;
    } else if (wants_end()) {
      ++out.missing;
    }
  }
  return out;
}

}  // namespace mlab::study
