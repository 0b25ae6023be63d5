#include "mlab/history/shelf.h"

#include <algorithm>
#include <cctype>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <functional>
#include <system_error>
#include <utility>

#include <fmt/chrono.h>
#include <fmt/core.h>

#include "mlab/history/bookmark_file.h"
#include "mlab/text/private_folder.h"
#include "mlab/text/shown.h"

namespace mlab::history {
namespace {

namespace fs = std::filesystem;

constexpr const char* kExtension = ".mcap";
constexpr const char* kMark = ".marked";  // an empty file beside the recording
constexpr std::size_t kMostName = 60;     // characters of the mission's

std::string mark_of(const std::string& path) {
  return path + kMark;
}

// What is no letter or digit is told apart badly in lists, and may mean something to a shell.
std::string plain_name(const std::string& mission) {
  std::string out = fs::path(mission).stem().string().substr(0, kMostName);
  std::ranges::replace_if(
      out, [](unsigned char c) { return c >= 0x80 || (std::isalnum(c) == 0 && c != '-' && c != '_'); }, '_');
  return out.empty() ? "mission" : out;
}

}  // namespace

std::vector<ShelvedRun> Shelf::runs() const {
  std::vector<ShelvedRun> out;
  std::error_code failure;
  for (fs::directory_iterator each(folder_, failure); !failure && each != fs::directory_iterator();
       each.increment(failure)) {
    const fs::path& path = each->path();
    std::error_code gone;
    if (path.extension() != kExtension || !each->is_regular_file(gone)) continue;
    const std::uintmax_t bytes = each->file_size(gone);
    out.push_back(
        {path.string(), path.stem().string(), gone ? 0 : bytes, fs::exists(mark_of(path.string()), gone)});
  }
  std::ranges::sort(out, std::ranges::greater{}, &ShelvedRun::name);
  return out;
}

void Shelf::make_room() const {
  std::size_t count = 1;  // the one that comes
  std::uint64_t bytes = 0;
  for (const ShelvedRun& run : runs()) {
    if (run.is_marked) continue;
    bytes += run.bytes;
    if (++count <= kMostRuns && bytes <= kMostBytes) continue;
    std::error_code kept;
    if (fs::remove(run.path, kept)) fs::remove(bookmark_path(run.path), kept);
  }
}

std::expected<std::string, std::string> Shelf::place_for(const std::string& mission, double now) const {
  if (folder_.empty()) return std::unexpected("there is no folder to keep runs in");
  if (const auto made = text::make_private_folder(folder_); !made) return std::unexpected(made.error());
  make_room();
  const std::string stem =
      fmt::format("{:%Y-%m-%d %H.%M.%S} {}", fmt::gmtime(static_cast<std::time_t>(now)), plain_name(mission));
  std::string path = (fs::path(folder_) / (stem + kExtension)).string();
  std::error_code none;
  for (int n = 2; fs::exists(path, none); ++n)
    path = (fs::path(folder_) / fmt::format("{} {}{}", stem, n, kExtension)).string();
  return path;
}

std::expected<void, std::string> Shelf::set_mark(const std::string& path, bool is_marked) {
  std::error_code failure;
  if (!is_marked) {
    fs::remove(mark_of(path), failure);
    if (failure)
      return std::unexpected(
          fmt::format("`{}` can't be removed: {}", text::shown(mark_of(path)), failure.message()));
    return {};
  }
  std::ofstream mark(mark_of(path));
  mark.close();
  if (!mark) return std::unexpected(fmt::format("`{}` can't be written", text::shown(mark_of(path))));
  return {};
}

}  // namespace mlab::history
