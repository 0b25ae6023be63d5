#include "mlab/console/drafts.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <system_error>

#include <fmt/core.h>

#include "mlab/base/hash.h"
#include "mlab/console/enclosed_file.h"
#include "mlab/text/source.h"

namespace mlab::console {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kFirstLine = "mlab draft 1 ";
constexpr const char* kRecent = "recent";
constexpr const char* kExtension = ".draft";

// The text up to the next line end, which is taken away with it.
std::string_view take_line(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

bool fits_in_a_line(std::string_view text) {
  return text.find('\n') == std::string_view::npos;
}

// What a draft's file holds: whether it had a file and which, its path, the text.
struct Stored {
  Drafts::Draft draft;
  std::string path;
};

std::optional<Stored> read_stored(const EnclosedFolder& folder, const std::string& name) {
  std::string all;
  if (!folder.read(name, text::Source::kMaxBytes + 4096, all).empty()) return std::nullopt;
  std::string_view rest = all;
  std::string_view first = take_line(rest);
  if (!first.starts_with(kFirstLine)) return std::nullopt;
  first.remove_prefix(kFirstLine.size());
  Stored out;
  out.path = take_line(rest);
  out.draft = {std::string(rest), first != "new", std::string(first)};
  return out;
}

}  // namespace

Drafts::Drafts(const std::string& folder, std::string_view project) {
  if (folder.empty()) return;
  folder_ = (fs::path(folder) / fmt::format("{:016x}", base::hash_text(project))).string();
  std::error_code cannot;
  fs::create_directories(folder_, cannot);
  fs::permissions(folder_, fs::perms::owner_all, cannot);
}

std::string Drafts::digest(std::string_view text) {
  return fmt::format("{:016x}{:016x}", base::hash_text(text), base::hash_text(text, text.size()));
}

std::string Drafts::file_of(std::string_view path) const {
  return fmt::format("{:016x}{}", base::hash_text(path), kExtension);
}

void Drafts::keep(std::string_view path, std::string_view text, const std::string* file) {
  if (folder_.empty() || !fits_in_a_line(path)) return;
  const std::string was = file == nullptr ? "new" : digest(*file);
  EnclosedFolder(folder_, {}).write(file_of(path), fmt::format("{}{}\n{}\n{}", kFirstLine, was, path, text));
}

std::optional<Drafts::Draft> Drafts::find(std::string_view path) const {
  if (folder_.empty()) return std::nullopt;
  auto stored = read_stored(EnclosedFolder(folder_, {}), file_of(path));
  if (!stored || stored->path != path) return std::nullopt;
  return std::move(stored->draft);
}

void Drafts::drop(std::string_view path) {
  if (folder_.empty()) return;
  std::error_code cannot;
  fs::remove(fs::path(folder_) / file_of(path), cannot);
}

std::vector<std::string> Drafts::new_files() const {
  std::vector<std::string> out;
  if (folder_.empty()) return out;
  const EnclosedFolder folder(folder_, {});
  for (const EnclosedFolder::Item& item : folder.items(1000)) {
    if (!item.name.ends_with(kExtension)) continue;
    const auto stored = read_stored(folder, item.name);
    if (stored && !stored->draft.had_file) out.push_back(stored->path);
  }
  std::ranges::sort(out);
  return out;
}

std::vector<Drafts::Recent> Drafts::recent() const {
  std::vector<Recent> out;
  std::string all;
  if (folder_.empty() || !EnclosedFolder(folder_, {}).read(kRecent, 1 << 20, all).empty()) return out;
  for (std::string_view rest = all; !rest.empty() && out.size() < kMostRecent;) {
    const std::string path(take_line(rest));
    out.push_back({path, std::string(take_line(rest))});
  }
  return out;
}

void Drafts::add_recent(std::string_view path, std::string_view title) {
  if (folder_.empty() || !fits_in_a_line(path) || !fits_in_a_line(title)) return;
  std::vector<Recent> all = recent();
  std::erase_if(all, [&](const Recent& entry) { return entry.path == path; });
  all.insert(all.begin(), {std::string(path), std::string(title)});
  std::string lines;
  for (const Recent& entry : all) lines += fmt::format("{}\n{}\n", entry.path, entry.title);
  EnclosedFolder(folder_, {}).write(kRecent, lines);
}

}  // namespace mlab::console
