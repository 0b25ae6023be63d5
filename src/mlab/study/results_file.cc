#include "mlab/study/results_file.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iterator>
#include <string_view>
#include <system_error>
#include <utility>

#include <fmt/core.h>

#include "mlab/base/counted.h"

namespace mlab::study {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kRank = ".rank-";

std::string refusal(std::size_t runs) {
  return fmt::format(
      "holds {} runs of a batch that was interrupted: --resume goes on with them; else remove it", runs);
}

// What was killed before its first line was whole has begun nothing.
bool is_unbegun(std::string_view all, const Identity& identity) {
  return all.find('\n') == std::string_view::npos && header_line(identity).starts_with(all.substr(0, 12));
}

/// What processes did that had a part in this batch.
struct Parts {
  std::vector<Row> rows;
  std::vector<std::string> damage;
};
std::expected<Parts, std::string> parts_of(const std::string& path, const Identity& identity, bool resumes) {
  Parts out;
  for (const std::string& name : rank_files(path)) {
    const auto file = LockedFile::open_existing(name);
    if (!file) continue;
    if (!file->lock()) return std::unexpected(kResultsInUse);
    const std::string all = file->read().value_or("");
    if (all.find('\n') == std::string::npos) continue;  // it has no whole line yet
    auto contents = understand(all);
    if (std::string what = damage_of(name, contents); !what.empty()) out.damage.push_back(std::move(what));
    if (!contents) continue;
    if (resumes) {
      if (std::string what = difference(contents->header, identity); !what.empty() && !contents->rows.empty())
        return std::unexpected(std::move(what));
    }
    std::ranges::move(contents->rows, std::back_inserter(out.rows));
  }
  return out;
}

}  // namespace

std::string rank_file(const std::string& path, std::uint32_t number) {
  return fmt::format("{}{}{}", path, kRank, number);
}

std::vector<std::string> rank_files(const std::string& path) {
  const fs::path whole(path);
  const std::string start = whole.filename().string() + std::string(kRank);
  std::vector<std::string> out;
  std::error_code failure;
  const fs::path folder = whole.parent_path().empty() ? fs::path(".") : whole.parent_path();
  for (fs::directory_iterator entry(folder, failure), end; !failure && entry != end;
       entry.increment(failure)) {
    const std::string name = entry->path().filename().string();
    const std::string_view number = std::string_view(name).substr(std::min(start.size(), name.size()));
    if (!name.starts_with(start) || number.empty() || number.size() > 10 ||
        !std::ranges::all_of(number, [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }))
      continue;
    out.push_back((whole.parent_path() / name).string());
  }
  std::ranges::sort(out);
  return out;
}

void remove_rank_files(const std::string& path) {
  std::error_code failure;
  for (const std::string& part : rank_files(path)) {
    if (fs::is_regular_file(fs::symlink_status(part, failure))) fs::remove(part, failure);
  }
}

std::map<RunKey, std::string> kept_recordings(const std::string& path) {
  std::map<RunKey, std::string> out;
  std::vector<std::string> files = rank_files(path);
  files.push_back(path);
  for (const std::string& name : files) {
    const auto file = LockedFile::open_existing(name);
    for (auto& [key, recording] : recordings_in(file ? file->read().value_or("") : ""))
      out.insert_or_assign(key, std::move(recording));
  }
  return out;
}

std::string damage_of(const std::string& path, const std::expected<Contents, std::string>& contents) {
  if (!contents)
    return fmt::format(
        "{}: line 1 can't be read, by which it is known of which batch it is: the runs in it are "
        "done again",
        path);
  if (contents->damaged == 0) return "";
  return fmt::format("{}: {} can't be read{} line {}: what stood there is done again", path,
                     base::counted(contents->damaged, "line"),
                     contents->damaged == 1 ? ":" : ", the first of them", contents->first_damaged);
}

std::map<RunKey, std::string> ResultsFile::recordings() const {
  return kept_recordings(path_);
}

void ResultsFile::finish() {
  const std::string all = file_.read().value_or("");
  const std::size_t end = all.find('\n');
  const auto header = end == std::string::npos ? std::nullopt : header_in(all.substr(0, end));
  const bool is_shared = header && has_word(*header, "job");
  remove_rank_files(path_);
  std::error_code failure;
  if (!is_shared || !file_.cut(end + 1) || !file_.append(end_line())) fs::remove(path_, failure);
}

std::optional<std::string> ResultsFile::kept_word(const std::string& path, const std::string& name) {
  const auto file = LockedFile::open_existing(path);
  const auto all = file ? file->read() : std::nullopt;
  if (!all) return std::nullopt;
  const auto header = header_in(all->substr(0, all->find('\n')));
  if (!header) return std::nullopt;
  std::string word = word_in(*header, name);
  return word.empty() ? std::nullopt : std::optional(std::move(word));
}

bool ResultsFile::keeps_runs(const std::string& path) {
  if (!rank_files(path).empty()) return true;
  const auto file = LockedFile::open_existing(path);
  const auto all = file ? file->read() : std::nullopt;
  if (!all) return false;
  const auto contents = understand(*all);
  return !contents || (!contents->rows.empty() && !contents->is_over);  // what it is then is told by open()
}

std::expected<ResultsFile::Opened, std::string> ResultsFile::open(const std::string& path,
                                                                  const Identity& identity, bool resumes) {
  auto file = LockedFile::open(path, "opened");
  if (!file) return std::unexpected(file.error());
  if (!file->lock()) return std::unexpected(kResultsInUse);
  if (!file->is_there()) return open(path, identity, resumes);  // who had it has finished, and removed it
  const auto all = file->read();
  if (!all) return std::unexpected(system_error("read"));
  auto parts = parts_of(path, identity, resumes);
  if (!parts) return std::unexpected(std::move(parts.error()));
  auto contents = understand(*all);
  if (is_unbegun(*all, identity)) contents = Contents{};
  if (!contents) return std::unexpected(std::move(contents.error()));
  const std::size_t runs = contents->rows.size() + parts->rows.size();
  if (!resumes && runs > 0) return std::unexpected(refusal(runs));
  // It was begun and has nothing, perhaps for another batch; or others have done all that was to be done.
  if (runs == 0 || contents->is_over || !resumes) contents->size = 0;
  if (contents->size > 0 && resumes) {
    // Who shares a batch says in the part of each process what was read.
    Identity here = identity;
    if (has_word(contents->header, "job"))
      std::erase_if(here, [](const auto& word) { return word.first == "texts"; });
    if (std::string what = difference(contents->header, here); !what.empty())
      return std::unexpected(std::move(what));
  }
  if (!file->cut(contents->size) || (contents->size == 0 && !file->append(header_line(identity))))
    return std::unexpected(system_error("written"));
  Opened out;
  if (std::string what = damage_of(path, contents); contents->size > 0 && !what.empty())
    out.damage.push_back(std::move(what));
  std::ranges::move(parts->damage, std::back_inserter(out.damage));
  out.rows = std::move(contents->rows);
  std::ranges::move(parts->rows, std::back_inserter(out.rows));
  out.file.reset(new ResultsFile(path, std::move(*file)));
  return out;
}

}  // namespace mlab::study
