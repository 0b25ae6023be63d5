#include "mlab/history/recorded_names.h"

#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>

namespace mlab::history {
namespace {

namespace fs = std::filesystem;

std::string whole(const std::string& path) {
  std::error_code failure;
  const fs::path out = fs::absolute(path, failure);
  return (failure ? fs::path(path) : out).lexically_normal().string();
}

std::string normal(const std::string& path) {
  return fs::path(path).lexically_normal().string();
}

// Nothing where the path does not lead out of the mission's folder.
std::string_view behind_ups(std::string_view path) {
  constexpr std::string_view kUp = "../";
  if (!path.starts_with(kUp)) return "";
  while (path.starts_with(kUp)) path.remove_prefix(kUp.size());
  return path;
}

}  // namespace

void RecordedNames::shorten(std::string& path) const {
  if (path.empty() || (folder_.empty() && !fs::path(path).is_absolute())) return;
  const bool is_mixed = fs::path(path).is_absolute() != fs::path(folder_).is_absolute();
  const fs::path relative =
      is_mixed ? fs::path(whole(path)).lexically_relative(whole(folder_.empty() ? "." : folder_))
               : fs::path(normal(path)).lexically_relative(normal(folder_));
  if (relative.empty()) return;
  path = relative == "." ? "" : relative.string();
}

void RecordedNames::shorten(wire::HistoryMission& mission) const {
  shorten(*mission.mutable_path());
  shorten(*mission.mutable_folder());
  shorten(*mission.mutable_program_folder());
}

wire::HistoryBeginning RecordedNames::in_recording(wire::HistoryBeginning beginning) const {
  shorten(*beginning.mutable_mission());
  for (std::string& folder : *beginning.mutable_overlay_folders()) shorten(folder);
  return beginning;
}

wire::HistoryEntry RecordedNames::in_recording(wire::HistoryEntry entry) const {
  if (entry.has_text()) shorten(*entry.mutable_text()->mutable_path());
  if (entry.has_beginning()) *entry.mutable_beginning() = in_recording(std::move(*entry.mutable_beginning()));
  if (entry.has_input() && entry.input().has_exchanged())
    shorten(*entry.mutable_input()->mutable_exchanged()->mutable_mission());
  return entry;
}

void RecordedSources::add(const text::SourcePtr& source) {
  by_path_.insert_or_assign(normal(source->name()), source);
}

// A text may name a file that lies elsewhere by its whole path; of that the recording has what is behind the
// folder that it shares with the mission's.
text::SourcePtr RecordedSources::find(const std::string& path) const {
  const std::string wanted = normal(path);
  if (const auto found = by_path_.find(wanted); found != by_path_.end()) return found->second;
  if (!fs::path(wanted).is_absolute()) return nullptr;
  text::SourcePtr out;
  std::size_t longest = 0;
  for (const auto& [name, source] : by_path_) {
    const std::string_view end = behind_ups(name);
    if (end.size() <= longest || !wanted.ends_with('/' + std::string(end))) continue;
    longest = end.size();
    out = source;
  }
  return out;
}

}  // namespace mlab::history
