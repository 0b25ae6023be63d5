#include "mlab/cli/resumable.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "mlab/cli/files.h"
#include "mlab/cli/places.h"
#include "mlab/documents/drafts.h"
#include "mlab/documents/project_folder.h"
#include "mlab/documents/state_folder.h"
#include "mlab/text/shown.h"

namespace mlab::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kJournals = "journals";

bool is_below(const std::string& path, const std::string& folder) {
  const fs::path whole(path);
  const fs::path root(folder);
  return std::ranges::mismatch(root, whole).in1 == root.end();
}

journal::JournalFolder::Found look(const std::string& folder) {
  journal::JournalFolder::Found found = journal::JournalFolder(folder).look();
  for (const std::string& sentence : found.set_aside) fmt::print(stderr, "mlab run: warning: {}\n", sentence);
  return found;
}

// Of all projects that anything is kept of.
std::vector<journal::Unfinished> look_everywhere() {
  std::vector<journal::Unfinished> out;
  std::error_code failure;
  for (fs::directory_iterator each(state_folder(), failure); !failure && each != fs::directory_iterator();
       each.increment(failure)) {
    std::error_code none;
    const fs::path folder = each->path() / kJournals;
    if (fs::is_directory(folder, none))
      std::ranges::move(look(folder.string()).runs, std::back_inserter(out));
  }
  return out;
}

// Of which mission those are that other processes have is not known here.
std::string told_of_held(std::size_t held) {
  if (held == 0) return "";
  return held == 1 ? ", but another process has one of this project"
                   : fmt::format(", but other processes have {} of this project", held);
}

std::expected<journal::Unfinished, std::string> newest(std::vector<journal::Unfinished> runs,
                                                       const std::string& what, std::size_t held) {
  const auto last = std::ranges::max_element(
      runs, {}, [](const journal::Unfinished& run) { return run.stand.progress.written_at(); });
  if (last == runs.end())
    return std::unexpected(fmt::format("there is no run of {} that did not end{}", what, told_of_held(held)));
  return std::move(*last);
}

}  // namespace

std::string journal_folder(const std::string& project) {
  const std::string folder = documents::StateFolder(state_folder(), project).path();
  return folder.empty() ? "" : (fs::path(folder) / kJournals).string();
}

std::string mission_file(const journal::Unfinished& run) {
  const std::string& mission = run.stand.session.mission();
  const fs::path path = mission.starts_with(documents::kExampleFiles)
                            ? fs::path(example_folder()) / mission.substr(documents::kExampleFiles.size())
                        : mission.starts_with(documents::kOutsideFiles)
                            ? fs::path(mission.substr(documents::kOutsideFiles.size()))
                            : fs::path(run.stand.session.project()) / mission;
  std::error_code none;
  return fs::is_regular_file(path, none) ? path.string() : "";
}

bool is_mission_gone(const journal::Unfinished& run) {
  const wire::JournalSession& session = run.stand.session;
  return mission_file(run).empty() &&
         !documents::Drafts(state_folder(), session.project()).find(session.mission());
}

std::expected<journal::Unfinished, std::string> find_resumable(const RunOptions& options) {
  const std::string first = !options.project.empty()  ? options.project
                            : options.mission.empty() ? "."
                                                      : fs::absolute(options.mission).parent_path().string();
  const std::string project = documents::ProjectFolder({first, ""}).folder();
  auto [runs, set_aside, held] = look(journal_folder(project));
  if (!options.mission.empty()) {
    std::erase_if(runs, [&](const journal::Unfinished& run) {
      std::error_code differs;
      return !fs::equivalent(mission_file(run), options.mission, differs);
    });
    return newest(std::move(runs), fmt::format("`{}`", text::shown(options.mission)), held);
  }
  if (runs.empty() && options.project.empty()) {
    runs = look_everywhere();
    std::erase_if(runs, [&](const journal::Unfinished& run) {
      return !is_below(run.stand.session.project(), project);
    });
  }
  return newest(std::move(runs), fmt::format("the project {}, or of one below it,", project), held);
}

}  // namespace mlab::cli
