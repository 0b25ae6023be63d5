#include "mlab/study/failure_recordings.h"

#include <cmath>
#include <expected>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include <fmt/core.h>

#include "mlab/history/recorder.h"
#include "mlab/study/one_run.h"

namespace mlab::study {
namespace {

namespace fs = std::filesystem;

// A name in the folder that no file has.
std::string free_name(const fs::path& folder, const RunKey& key, const Plan& plan) {
  std::string stem = fmt::format("seed-{}", plan.seed(key.run));
  if (plan.combinations() > 1) stem = fmt::format("combination-{}-{}", key.combination + 1, stem);
  if (key.version == 1) stem = "against-" + stem;
  std::error_code failure;
  fs::path out = folder / (stem + ".mcap");
  for (int i = 2; fs::exists(fs::symlink_status(out, failure)); ++i)
    out = folder / fmt::format("{}-{}.mcap", stem, i);
  return out.string();
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

/// What recordings of one batch have in common.
struct Studio {
  const Definition& definition;
  const Plan& plan;
  const std::vector<std::unique_ptr<Scene>>& scenes;
  const fs::path folder;
  const RecordedAs& as;
  const std::function<bool()>& wants_end;

  // @return  the file, or what went wrong; of a run that could not be made neither
  std::expected<std::string, std::string> record(const Row& before) const {
    auto run = scenes[before.key.version]->make_run(before.key);
    if (!run) return std::string();
    std::string file = free_name(folder, before.key, plan);
    history::Recorder recorder(
        [&file] { return file; }, **run,
        history::Circumstances{as.program_version, as.overlay_folders, (*run)->seed(), as.started_at});
    const std::optional<run::RunEnd> end = carry_out(**run, definition, wants_end, &recorder);
    if (!end) return std::string();
    const Row again = row_of(**run, *end, definition);
    recorder.end(again.outcome);
    if (!recorder.problem().empty())
      return std::unexpected(fmt::format("{} is not whole: {}", file, recorder.problem()));
    if (recorder.path().empty()) return std::string();
    Row same = again;
    same.key = before.key;
    if (!are_alike(same, before))
      return std::unexpected(fmt::format("{}: the run with seed {} did not go as before", file, before.seed));
    return file;
  }
};

}  // namespace

FailureRecordings record_failures(const Batch& batch, Summary& summary, const Definition& definition,
                                  const Plan& plan, const std::vector<std::unique_ptr<Scene>>& scenes,
                                  const std::string& folder, const RecordedAs& as,
                                  const std::function<bool()>& wants_end) {
  FailureRecordings out;
  if (summary.failures.empty()) return out;
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (!fs::is_directory(folder, failure)) {
    out.problems.push_back(fmt::format("there can't be a folder {}", folder));
    return out;
  }
  const Studio studio{definition, plan, scenes, folder, as, wants_end};
  for (FailureGroup& group : summary.failures) {
    if (wants_end()) break;
    if (out.made + out.problems.size() == kMostRecordings) {
      ++out.left_out;
      continue;
    }
    auto file = studio.record(batch.cell(group.first.version, group.first.combination).rows[group.first.run]);
    if (!file) {
      out.problems.push_back(std::move(file.error()));
    } else if (!file->empty()) {
      group.recording = std::move(*file);
      ++out.made;
    }
  }
  return out;
}

}  // namespace mlab::study
