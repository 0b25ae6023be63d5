#include "mlab/journal/journal_folder.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <filesystem>
#include <functional>
#include <system_error>

#include <fmt/chrono.h>
#include <fmt/core.h>

#include "mlab/text/private_folder.h"
#include "mlab/text/shown.h"

namespace mlab::journal {
namespace {

namespace fs = std::filesystem;

constexpr const char* kExtension = ".journal";
// What SQLite has beside a file; the file itself last, so that a kill in between leaves a whole one.
constexpr std::array<const char*, 4> kParts = {"-shm", "-journal", "-wal", ""};

}  // namespace

std::expected<std::string, std::string> JournalFolder::place(double now) const {
  if (folder_.empty()) return std::unexpected("there is no folder to keep it in");
  if (const auto made = text::make_private_folder(folder_); !made) return std::unexpected(made.error());
  const std::string stem =
      fmt::format("{:%Y-%m-%d %H.%M.%S} {}", fmt::gmtime(static_cast<std::time_t>(now)), ::getpid());
  std::string path = (fs::path(folder_) / (stem + kExtension)).string();
  std::error_code none;
  for (int n = 2; fs::exists(path, none); ++n)
    path = (fs::path(folder_) / fmt::format("{} {}{}", stem, n, kExtension)).string();
  return path;
}

std::vector<std::string> JournalFolder::paths() const {
  std::vector<std::string> out;
  std::error_code failure;
  if (folder_.empty()) return out;
  for (fs::directory_iterator each(folder_, failure); !failure && each != fs::directory_iterator();
       each.increment(failure)) {
    std::error_code gone;
    if (each->path().extension() == kExtension && each->is_regular_file(gone))
      out.push_back(each->path().string());
  }
  std::ranges::sort(out);
  return out;
}

JournalFolder::Found JournalFolder::look() const {
  using Kind = Unreadable::Kind;
  Found out;
  for (const std::string& path : paths()) {
    auto stand = read_stand(path);
    if (stand && !stand->progress.is_over()) {
      out.runs.push_back({path, std::move(*stand)});
    } else if (stand || stand.error().kind == Kind::kEmpty) {
      remove(path);
    } else if (stand.error().kind == Kind::kForeign) {
      out.set_aside.push_back(set_aside(path, stand.error().why));
    } else if (stand.error().kind == Kind::kHeld) {
      ++out.held;
    }
  }
  std::ranges::stable_sort(out.runs, std::ranges::greater{},
                           [](const Unfinished& run) { return run.stand.progress.written_at(); });
  while (out.runs.size() > kMost) {
    remove(out.runs.back().path);
    out.runs.pop_back();
  }
  return out;
}

std::string JournalFolder::set_aside(const std::string& path, const std::string& why) {
  std::error_code cannot;
  std::string to = path + ".unreadable";
  for (int n = 2; fs::exists(to, cannot); ++n) to = fmt::format("{}.unreadable{}", path, n);
  for (const char* const part : kParts) {
    std::error_code none;
    if (fs::exists(path + part, none)) fs::rename(path + part, to + part, cannot);
  }
  return fmt::format("the journal of a run can't be read, and lies in `{}` now: {}", text::shown(to), why);
}

void JournalFolder::remove(const std::string& path) {
  std::error_code none;
  for (const char* const part : kParts) fs::remove(path + part, none);
}

}  // namespace mlab::journal
