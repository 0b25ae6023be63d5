#include "mlab/documents/drafts.h"

#include <algorithm>
#include <array>

#include <fmt/core.h>

#include "mlab/base/hash.h"
#include "mlab/text/source.h"

namespace mlab::documents {
namespace {

constexpr std::string_view kFirstLine = "mlab draft 1 ";
constexpr const char* kNoFile = "new";  // in place of a file's digest
constexpr const char* kRecent = "recent";
constexpr const char* kExtension = ".draft";

// The text up to the next line end, which is taken away with it.
std::string_view take_line(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

std::string file_of(std::string_view path) {
  return StateFolder::name_of(path, kExtension);
}

bool fits_in_a_line(std::string_view text) {
  return text.find('\n') == std::string_view::npos;
}

// What a draft's file holds: whether it had a file and which, its path, the text.
struct Stored {
  Drafts::Draft draft;
  std::string path;
};

std::optional<Stored> read_stored(const StateFolder& folder, const std::string& name) {
  std::string all;
  if (!folder.read(name, text::Source::kMaxBytes + 4096, all)) return std::nullopt;
  std::string_view rest = all;
  std::string_view first = take_line(rest);
  if (!first.starts_with(kFirstLine)) return std::nullopt;
  first.remove_prefix(kFirstLine.size());
  Stored out;
  out.path = take_line(rest);
  out.draft = {std::string(rest), first != kNoFile, std::string(first)};
  return out;
}

}  // namespace

Drafts::Drafts(const std::string& folder, std::string_view project) : folder_(folder, project) {}

std::string Drafts::digest(std::string_view text) {
  return fmt::format("{:016x}{:016x}", base::hash_text(text), base::hash_text(text, text.size()));
}

std::string Drafts::keep(std::string_view path, std::string_view text, const std::string* file) {
  return keep_of(file == nullptr ? kNoFile : digest(*file), path, text);
}

std::string Drafts::keep_of(std::string_view file_digest, std::string_view path, std::string_view text) {
  if (!fits_in_a_line(path)) return "its name has more than one line";
  return folder_.write(file_of(path), fmt::format("{}{}\n{}\n{}", kFirstLine, file_digest, path, text));
}

std::string Drafts::sync(std::string_view path) const {
  return folder_.sync(file_of(path));
}

std::optional<Drafts::Draft> Drafts::find(std::string_view path) const {
  auto stored = read_stored(folder_, file_of(path));
  if (!stored || stored->path != path) return std::nullopt;
  return std::move(stored->draft);
}

std::string Drafts::drop(std::string_view path) {
  return folder_.remove(file_of(path));
}

std::vector<std::string> Drafts::paths() const {
  std::vector<std::string> out;
  for (const std::string& name : folder_.names(kExtension)) {
    const auto stored = read_stored(folder_, name);
    if (stored) out.push_back(stored->path);
  }
  std::ranges::sort(out);
  return out;
}

std::vector<Drafts::Recent> Drafts::recent() const {
  std::vector<Recent> out;
  std::string all;
  if (!folder_.read(kRecent, 1 << 20, all)) return out;
  for (std::string_view rest = all; !rest.empty() && out.size() < kMostRecent;) {
    const std::string path(take_line(rest));
    out.push_back({path, std::string(take_line(rest))});
  }
  return out;
}

void Drafts::add_recent(std::string_view path, std::string_view title) {
  if (!fits_in_a_line(path) || !fits_in_a_line(title)) return;
  std::vector<Recent> all = recent();
  std::erase_if(all, [&](const Recent& entry) { return entry.path == path; });
  all.insert(all.begin(), {std::string(path), std::string(title)});
  std::string lines;
  for (const Recent& entry : all) lines += fmt::format("{}\n{}\n", entry.path, entry.title);
  folder_.write(kRecent, lines);
}

}  // namespace mlab::documents
