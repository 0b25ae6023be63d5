#include "mlab/study/shared_results.h"

#include <algorithm>
#include <iterator>
#include <string_view>
#include <thread>
#include <utility>

#include <fmt/core.h>

namespace mlab::study {
namespace {

constexpr const char* kJob = "job";
constexpr const char* kClock = "start-time";

// The file for all is locked for the moment in which somebody reads or begins it. A batch of one process
// locks it for as long as it runs.
bool lock_for_a_moment(const LockedFile& file) {
  constexpr std::chrono::milliseconds kPause{20};
  constexpr int kTries = 250;
  for (int i = 0; i < kTries; ++i) {
    if (file.lock()) return true;
    std::this_thread::sleep_for(kPause);
  }
  return false;
}

/// What files of a batch there are.
struct Found {
  std::size_t runs = 0;
  bool is_in_use = false;
  std::vector<std::string> damage;
};
Found look_at(const std::string& path) {
  Found out;
  for (const std::string& name : rank_files(path)) {
    const auto file = LockedFile::open_existing(name);
    if (!file) continue;
    if (!file->lock()) out.is_in_use = true;
    const std::string all = file->read().value_or("");
    if (all.find('\n') == std::string::npos) continue;  // it has no whole line yet
    const auto contents = understand(all);
    std::size_t size = 0;
    out.runs += contents ? contents->rows.size() : rows_in(all, size).size();
    if (std::string what = damage_of(name, contents); !what.empty()) out.damage.push_back(std::move(what));
  }
  return out;
}

Identity with_clock(const std::string& start_time, Identity here) {
  for (auto& [name, word] : here) {
    if (name == kClock && word.empty()) word = start_time;
  }
  return here;
}

/// What becomes of who wants to take part.
enum class Entry { kBegins, kJoins, kIsLate };

// @param contents  of the file for all
std::expected<Entry, std::string> entry_of(const Contents& contents, const Found& found,
                                           const Identity& identity, const Share& share, bool resumes) {
  const std::size_t runs = contents.rows.size() + found.runs;
  const bool is_same_job = word_in(contents.header, kJob) == share.job;
  const std::string what =
      difference(contents.header, with_clock(word_in(contents.header, kClock), identity));
  if (contents.size > 0 && is_same_job && what.empty()) {
    if (contents.is_over) return Entry::kIsLate;
    // Who knows of no job may have come back to what was interrupted.
    if (!share.job.empty() || resumes || found.is_in_use || runs == 0) return Entry::kJoins;
  }
  if (found.is_in_use)
    return std::unexpected(what.empty() || contents.size == 0
                               ? std::string(kResultsInUse)
                               : fmt::format("{}: it {}", kResultsInUse, what));
  if (contents.is_over || runs == 0) return Entry::kBegins;
  if (!resumes)
    return std::unexpected(fmt::format(
        "holds {} runs of a batch that was interrupted: --resume goes on with them; else remove it", runs));
  if (contents.size > 0 && !what.empty()) return std::unexpected(what);
  return contents.size > 0 ? Entry::kJoins : Entry::kBegins;
}

}  // namespace

SharedResults::SharedResults(std::string path, std::string own, LockedFile file)
    : path_(std::move(path)), own_(std::move(own)), file_(std::move(file)) {}

std::expected<SharedResults::Joined, std::string> SharedResults::join(const std::string& path,
                                                                      const Identity& identity,
                                                                      const std::string& now,
                                                                      const Share& share, bool resumes) {
  // Processes that were told to end may still be at it when who started them goes on.
  constexpr std::chrono::milliseconds kPause{100};
  constexpr int kTries = 100;
  for (int i = 1;; ++i) {
    auto joined = join_at_once(path, identity, now, share, resumes);
    const bool is_in_use = !joined && joined.error() == kResultsInUse;
    if (!is_in_use || !resumes || i == kTries) return joined;
    std::this_thread::sleep_for(kPause);
  }
}

std::expected<SharedResults::Joined, std::string> SharedResults::join_at_once(const std::string& path,
                                                                              const Identity& identity,
                                                                              const std::string& now,
                                                                              const Share& share,
                                                                              bool resumes) {
  auto all = LockedFile::open(path, "opened");
  if (!all) return std::unexpected(all.error());
  if (!lock_for_a_moment(*all)) return std::unexpected(kResultsInUse);
  // Who had it has finished, and removed it.
  if (!all->is_there()) return join_at_once(path, identity, now, share, resumes);
  const auto text = all->read();
  if (!text) return std::unexpected(system_error("read"));
  auto contents = understand(*text);
  const bool is_unbegun = text->find('\n') == std::string::npos &&
                          header_line(identity).starts_with(std::string_view(*text).substr(0, 12));
  if (is_unbegun) contents = Contents{};
  if (!contents) return std::unexpected(std::move(contents.error()));
  const std::string own = rank_file(path, share.number);
  Found found = look_at(path);
  const auto entry = entry_of(*contents, found, identity, share, resumes);
  if (!entry) return std::unexpected(entry.error());
  Joined out;
  Identity header = with_clock(*entry == Entry::kBegins ? now : word_in(contents->header, kClock), identity);
  out.start_time = word_in(header, kClock);
  if (*entry == Entry::kIsLate) return out;
  if (*entry == Entry::kBegins) {
    if (!resumes) {
      remove_rank_files(path);
      found.damage.clear();
    }
    header.emplace_back(kJob, share.job);
    if (!all->cut(0) || !all->append(header_line(header))) return std::unexpected(system_error("written"));
    contents->size = all->size().value_or(0);
  } else if (!all->cut(contents->size)) {
    return std::unexpected(system_error("written"));
  } else if (std::string what = damage_of(path, contents); !what.empty()) {
    out.damage.push_back(std::move(what));
  }
  std::ranges::move(found.damage, std::back_inserter(out.damage));
  auto file = LockedFile::open(own, "begun beside it");
  if (!file) return std::unexpected(file.error());
  if (!file->lock()) return std::unexpected(kResultsInUse);
  out.results.reset(new SharedResults(path, own, std::move(*file)));
  out.results->beginning_ = contents->size;
  return out;
}

std::optional<std::string> SharedResults::begin(const Identity& identity) {
  for (const std::string& name : rank_files(path_)) {
    const auto other = LockedFile::open_existing(name);
    const std::string text = other ? other->read().value_or("") : "";
    const std::size_t end = text.find('\n');
    const auto header = end == std::string::npos ? std::nullopt : header_in(text.substr(0, end));
    if (!header) continue;
    if (std::string what = difference(*header, identity); !what.empty()) return what;
  }
  const std::string text = file_.read().value_or("");
  std::size_t size = 0;
  rows_in(text, size);
  if (size > 0 && !header_in(text.substr(0, text.find('\n'))))
    return fmt::format("needs {}, and that {}", own_, understand(text).error());
  if (!file_.cut(size) || (size == 0 && !file_.append(header_line(identity)))) return system_error("written");
  return std::nullopt;
}

bool SharedResults::append(const Row& row) {
  if (!file_.append(row_line(row))) return false;
  constexpr std::chrono::seconds kBetweenSyncs{1};
  const auto now = std::chrono::steady_clock::now();
  if (now - synced_ < kBetweenSyncs) return true;
  synced_ = now;
  file_.sync();
  return true;
}

bool SharedResults::append_recording(const RunKey& key, const std::string& file) {
  if (!file_.append(recording_line(key, file))) return false;
  file_.sync();
  return true;
}

// A file is opened anew each time: only so does a network's file system say what others have written.
std::vector<Row> SharedResults::news() {
  std::vector<Row> out;
  std::vector<std::string> files = rank_files(path_);
  files.push_back(path_);
  for (const std::string& name : files) {
    std::size_t& seen = seen_[name];
    if (name == own_ && seen > 0) continue;  // of an earlier life: all else was done here
    const auto file = LockedFile::open_existing(name);
    if (!file || file->size().value_or(0) <= seen) continue;
    const std::string lines = file->read(seen).value_or("");
    if (seen == 0 && !header_in(lines.substr(0, lines.find('\n')))) continue;  // nobody knows of which batch
    std::size_t size = 0;
    std::ranges::move(rows_in(lines, size), std::back_inserter(out));
    seen += size;
  }
  return out;
}

bool SharedResults::is_over() const {
  const auto all = LockedFile::open_existing(path_);
  if (!all || all->size().value_or(0) <= beginning_) return false;
  const auto contents = understand(all->read().value_or(""));
  return contents && contents->is_over;
}

void SharedResults::finish(bool keeps) {
  if (keeps) return;
  const auto all = LockedFile::open_existing(path_);
  if (!all || !lock_for_a_moment(*all)) return;
  const std::size_t size = all->size().value_or(0);
  const auto contents = understand(all->read().value_or(""));
  if (!contents || !all->cut(size) || !all->append(end_line())) return;
  remove_rank_files(path_);
}

}  // namespace mlab::study
