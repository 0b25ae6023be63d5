#include "mlab/preflight/store.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "mlab/base/hash.h"
#include "mlab/text/private_folder.h"
#include "mlab/text/shown.h"

namespace mlab::preflight {
namespace {

namespace fs = std::filesystem;

constexpr double kKeptFor = 24 * 3600.0;  // after it was signed [s]
constexpr std::size_t kMostFiles = 1000;
constexpr std::string_view kEnding = ".json";

// One for each text in each fleet.
std::string name_of(const Checklist& checklist) {
  const std::string key = checklist.fleet + "/" + checklist.digest;
  return fmt::format("{:016x}{}", base::hash_text(key), kEnding);
}

std::vector<fs::path> files_in(const std::string& folder) {
  std::vector<fs::path> out;
  std::error_code cannot;
  for (fs::directory_iterator at(folder, cannot), end; !cannot && at != end && out.size() < kMostFiles;
       at.increment(cannot)) {
    std::error_code gone;
    if (at->path().extension() == kEnding && at->is_regular_file(gone)) out.push_back(at->path());
  }
  std::ranges::sort(out);
  return out;
}

// @return  why not; none: it is written
std::error_code write(const fs::path& path, const std::string& text) {
  errno = 0;  // the stream does not say why, but what it called does
  std::ofstream file(path, std::ios::binary);
  file << text;
  if (file.flush()) return {};
  return {errno != 0 ? errno : EIO, std::generic_category()};
}

std::optional<SignedChecklist> read(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  return file ? read_signed(text) : std::nullopt;
}

}  // namespace

std::string Store::keep(const SignedChecklist& checklist) const {
  if (folder_.empty()) return "neither XDG_STATE_HOME nor HOME names a folder to keep it in";
  if (const auto made = text::make_private_folder(folder_); !made) return made.error();
  for (const fs::path& one : files_in(folder_)) {
    const auto old = read(one);
    std::error_code kept;
    if (old && checklist.signature.at - old->signature.at > kKeptFor) fs::remove(one, kept);
  }
  const fs::path path = fs::path(folder_) / name_of(checklist.checklist);
  const fs::path part = path.string() + fmt::format(".{}.part", ::getpid());
  std::error_code failure = write(part, json_of(checklist));
  if (!failure) fs::rename(part, path, failure);
  if (!failure) return "";
  std::error_code left;
  fs::remove(part, left);
  return fmt::format("`{}` can't be written: {}", path.string(), failure.message());
}

std::expected<SignedChecklist, std::string> Store::find(const Checklist& now, double at) const {
  const std::string own = name_of(now);
  std::string why = "nobody has signed one for this mission yet";
  double newest = -1.0;  // of those that don't hold; that of these very texts says best why
  for (const fs::path& path : files_in(folder_)) {
    auto found = read(path);
    if (!found) {
      if (path.filename() == own)
        return std::unexpected(
            fmt::format("the file of it, `{}`, can't be read: sign anew", text::shown(path.string(), 200)));
      continue;
    }
    if (found->checklist.mission != now.mission || found->checklist.fleet != now.fleet) continue;
    std::string reason = why_it_does_not_hold(*found, now, at);
    if (reason.empty()) return *std::move(found);
    const double age = path.filename() == own ? at + kKeptFor : found->signature.at;
    if (age < newest) continue;
    newest = age;
    why = std::move(reason);
  }
  return std::unexpected(std::move(why));
}

}  // namespace mlab::preflight
