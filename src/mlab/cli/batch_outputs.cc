#include "mlab/cli/batch_outputs.h"

#include <cstdio>
#include <filesystem>
#include <string_view>
#include <system_error>

#include <fmt/core.h>

#include "mlab/cli/clock.h"
#include "mlab/cli/commands.h"
#include "mlab/cli/files.h"
#include "mlab/cli/interrupt.h"
#include "mlab/cli/places.h"
#include "mlab/cli/version.h"
#include "mlab/study/page.h"
#include "mlab/study/table.h"
#include "mlab/text/shown.h"

namespace mlab::cli {
namespace {

namespace fs = std::filesystem;

// Where failures are recorded; empty: nowhere.
std::string recordings_of(const study::Definition& definition) {
  if (definition.recordings == study::kNoRecordings) return {};
  if (!definition.recordings.empty()) return definition.recordings;
  const std::string& beside = !definition.page.empty() ? definition.page : definition.table;
  std::error_code failure;
  if (beside.empty() || (fs::exists(beside, failure) && !fs::is_regular_file(beside, failure))) return {};
  return fs::path(beside).replace_extension(".failures").string();
}

bool deliver_file(const char* what, const std::string& file, const std::string& text) {
  if (write_file(file, text, was_interrupted)) {
    fmt::print("{}: {}\n", what, file);
    return true;
  }
  fmt::print(stderr, "mlab batch: the {} {} could not be written{}\n", what, file, why_not_written());
  return false;
}

// The ending of its name says what is written; a dash is no file.
bool is_well_named(std::string_view option, const std::string& file) {
  const bool is_page = option == "--html";
  const std::string ending = fs::path(file).extension().string();
  if (is_page ? ending == ".html" || ending == ".htm" : ending == ".csv" || ending == ".json") return true;
  wrong_batch_usage(fmt::format("{} {}: expected {}{}", option, text::shown(file),
                                is_page ? "FILE.html" : "FILE.csv or FILE.json",
                                file == "-" ? "; it is written to a file, not to standard output" : ""));
  return false;
}

}  // namespace

int wrong_batch_usage(const std::string& message) {
  fmt::print(stderr, "mlab batch: {}\n", message);
  return kBadInput;
}

// What is written can be, and is nothing that is read.
bool outputs_are_usable(const study::Definition& definition, const std::string& study_file,
                        const std::string& results) {
  const std::string problem = problem_with_outputs(
      {{"--table", definition.table}, {"--html", definition.page}, {"--results", results}},
      {{"mission", definition.mission.text},
       {"mission of --against", definition.against.text},
       {"file of --environment", definition.environment.text},
       {"definition", study_file}});
  if (!problem.empty()) {
    wrong_batch_usage(problem);
    return false;
  }
  if (!definition.table.empty() && !is_well_named("--table", definition.table)) return false;
  if (!definition.page.empty() && !is_well_named("--html", definition.page)) return false;
  const std::string recordings = recordings_of(definition);
  std::error_code failure;
  if (recordings.empty() || !fs::exists(fs::symlink_status(recordings, failure)) ||
      fs::is_directory(recordings, failure))
    return true;
  wrong_batch_usage(fmt::format("--recordings {}: that is no folder", recordings));
  return false;
}

study::FailureRecordings deliver_recordings(const study::Batch& batch, study::Summary& summary,
                                            const study::Definition& definition, const study::Plan& plan,
                                            const Scenes& scenes, study::Keeper* kept) {
  const std::string folder = recordings_of(definition);
  if (folder.empty()) return {};
  study::FailureRecordings out = study::record_failures(
      batch, summary, definition, plan, scenes.all, folder,
      {kVersion, overlay_folders(), wall_clock().epoch_seconds}, kept, was_interrupted);
  for (const std::string& problem : out.problems) fmt::print(stderr, "mlab batch: {}\n", problem);
  return out;
}

bool deliver_all(const study::Batch& batch, const study::Summary& summary,
                 const study::FailureRecordings& recordings, const study::Definition& definition,
                 const study::Plan& plan, const std::string& title) {
  bool is_whole = recordings.problems.empty();
  if (!definition.table.empty()) {
    const bool is_json = fs::path(definition.table).extension() == ".json";
    is_whole &= deliver_file("table", definition.table,
                             is_json ? study::json_of(batch, summary, definition, plan, kVersion)
                                     : study::csv_of(batch, summary, definition, plan));
  }
  if (!definition.page.empty())
    is_whole &=
        deliver_file("page", definition.page,
                     study::page_of(batch, summary, definition, plan, {title, definition.page, kVersion}));
  if (recordings.made > 0)
    fmt::print("recordings: {}{}\n", (fs::path(recordings_of(definition)) / "").string(),
               recordings.left_out == 0 ? std::string()
                                        : fmt::format(" (of the {} most frequent causes; {} more have none)",
                                                      study::kMostRecordings, recordings.left_out));
  return is_whole;
}

}  // namespace mlab::cli
