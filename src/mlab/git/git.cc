#include "mlab/git/git.h"

#include <algorithm>
#include <cerrno>
#include <expected>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>

#include <fmt/core.h>

#include "mlab/git/run_git.h"

namespace mlab::git {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostList = std::size_t{4} << 20;  // bytes of a list of revisions
constexpr std::size_t kMostHash = 4096;

std::unexpected<text::Diagnostic> trouble(const std::string& message, const std::string& hint = "") {
  text::Diagnostic out;
  out.kind = "git";
  out.message = message;
  if (!hint.empty()) out.hints = {hint};
  return std::unexpected(std::move(out));
}

std::string_view first_line(std::string_view text) {
  return text.substr(0, text.find('\n'));
}

// Why git refused, in our words where it is something that happens every day.
std::unexpected<text::Diagnostic> refused(const GitAnswer& answer, const std::string& path) {
  if (answer.failure == ENOENT) return trouble("there is no program `git`", "install git, or name two files");
  if (answer.failure != 0)
    return trouble(fmt::format("the program `git` can't be started: {}",
                               std::generic_category().message(answer.failure)),
                   "name two files to compare");
  if (!answer.is_whole) return trouble(fmt::format("git took too long, or said too much, about `{}`", path));
  const std::string_view said = answer.errors;
  if (said.find("not a git repository") != std::string_view::npos)
    return trouble(fmt::format("`{}` is in no repository of git", path), "name two files to compare");
  if (said.find("dubious ownership") != std::string_view::npos)
    return trouble(
        fmt::format("the repository of `{}` belongs to somebody else, so git does not read it", path),
        "git's setting safe.directory allows it");
  if (said.find("cannot change to") != std::string_view::npos)
    return trouble(fmt::format("the folder of `{}` is not there", path));
  std::string_view line = first_line(said);
  if (line.starts_with("fatal: ")) line.remove_prefix(7);
  return trouble(fmt::format("git says of `{}`: {}", path, line));
}

bool is_good(const GitAnswer& answer) {
  return answer.failure == 0 && answer.is_whole && answer.status == 0;
}

std::vector<std::string_view> cut(std::string_view text, char at) {
  std::vector<std::string_view> out;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(at), text.size());
    out.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out;
}

/// What a revision did to a file.
struct Touch {
  char what = 'M';          // as git has it: A, C, M, R, ...
  std::string_view before;  // path; the same where it was neither renamed nor copied
  std::string_view after;
};

// STATUS, path; of a rename and of a copy STATUS, path before, path after. The oldest stands last.
std::vector<Touch> touches(const std::vector<std::string_view>& words) {
  std::vector<Touch> out;
  for (std::size_t i = 0; i + 1 < words.size();) {
    std::string_view status = words[i];
    while (status.starts_with('\n')) status.remove_prefix(1);
    if (status.empty()) {
      ++i;
      continue;
    }
    const bool has_two = (status.front() == 'R' || status.front() == 'C') && i + 2 < words.size();
    out.push_back({status.front(), words[i + 1], words[has_two ? i + 2 : i + 1]});
    i += has_two ? 3 : 2;
  }
  return out;
}

}  // namespace

// With a folder always: the name of a text, `REVISION:PATH`, is where files beside it are looked for.
TrackedFile::TrackedFile(std::string path)
    : path_(fs::path(path).has_parent_path() ? std::move(path) : "./" + path) {
  const fs::path file(path_);
  folder_ = file.parent_path().string();
  name_ = file.filename().string();
}

text::Result<std::string> TrackedFile::resolve(const std::string& revision) const {
  const GitAnswer top = run_git(folder_, {"rev-parse", "--is-inside-work-tree"}, kMostHash);
  if (!is_good(top)) return refused(top, path_);
  // Options of git don't stand where a revision is asked for.
  if (revision.empty() || revision.front() == '-')
    return trouble(fmt::format("`{}` is no revision", revision));
  const GitAnswer answer = run_git(
      folder_, {"rev-parse", "--verify", "--quiet", "--end-of-options", revision + "^{commit}"}, kMostHash);
  if (is_good(answer)) return std::string(first_line(answer.output));
  if (answer.failure != 0 || !answer.is_whole) return refused(answer, path_);
  const GitAnswer any = run_git(folder_, {"rev-parse", "--verify", "--quiet", "HEAD"}, kMostHash);
  if (!is_good(any)) return trouble(fmt::format("the repository of `{}` has no revision yet", path_));
  return trouble(fmt::format("the repository of `{}` has no revision `{}`", path_, revision));
}

text::Result<TrackedFile::Entry> TrackedFile::entry(const std::string& id, const std::string& path) const {
  const GitAnswer answer = run_git(folder_, {"ls-tree", "-z", "--full-tree", id, "--", path}, kMostList);
  if (!is_good(answer)) return refused(answer, path_);
  // MODE TYPE HASH, a tabulator, path.
  const std::string_view line = answer.output;
  const std::vector<std::string_view> words = cut(line.substr(0, line.find('\t')), ' ');
  if (words.size() < 3) return Entry{};
  return Entry{std::string(words[0]), std::string(words[2])};
}

text::Result<std::string> TrackedFile::text_of(const std::string& id, const std::string& path) const {
  const text::Result<Entry> found = path.empty() ? Entry{} : entry(id, path);
  if (!found) return std::unexpected(found.error());
  if (found->mode.empty()) return trouble(fmt::format("`{}` is not in this revision", path));
  if (found->mode == "120000") return trouble(fmt::format("`{}` is a symbolic link in this revision", path));
  if (!found->mode.starts_with("100")) return trouble(fmt::format("`{}` is no file in this revision", path));
  GitAnswer answer = run_git(folder_, {"cat-file", "blob", found->blob}, text::Source::kMaxBytes);
  if (!is_good(answer)) return refused(answer, path_);
  return std::move(answer.output);
}

// Where `git mv` has moved it, and nobody has committed that yet, HEAD has it by the name before.
TrackedFile::InHead TrackedFile::in_head() const {
  const GitAnswer ways = run_git(folder_, {"rev-parse", "--show-prefix", "--show-cdup"}, kMostList);
  const std::vector<std::string_view> lines = cut(ways.output, '\n');
  if (!is_good(ways) || lines.size() < 2) return {name_, name_};
  const std::string up(lines[1]);
  const std::string now = std::string(lines[0]) + name_;
  const GitAnswer here = run_git(folder_, {"ls-tree", "-z", "--full-tree", "HEAD", "--", now}, kMostList);
  if (!is_good(here) || !here.output.empty()) return {now, name_};
  const GitAnswer staged = run_git(folder_,
                                   {"diff-index", "--cached", "-M", "-z", "--name-status", "--diff-filter=R",
                                    "--no-relative", "--no-ext-diff", "--no-textconv", "HEAD"},
                                   kMostList);
  if (!is_good(staged)) return {now, name_};
  for (const Touch& touch : touches(cut(staged.output, '\0'))) {
    if (touch.after == now) return {std::string(touch.before), up + std::string(touch.before)};
  }
  return {now, name_};
}

std::string TrackedFile::former_name(const std::string& id) const {
  const auto [path, way] = in_head();
  const GitAnswer answer =
      run_git(folder_,
              {"log", "--follow", "-z", "--format=", "--name-status", "--no-relative", "--no-ext-diff",
               "--no-textconv", "--no-show-signature", "--end-of-options", id + "..HEAD", "--", way},
              kMostList);
  if (!is_good(answer)) return "";
  std::string out = path;
  for (const Touch& touch : touches(cut(answer.output, '\0'))) {
    if (touch.what == 'C') break;  // before, there was only what it was copied from
    if (touch.what == 'R') out = touch.before;
  }
  return out;
}

text::Result<FileThen> TrackedFile::find(const std::string& revision) const {
  const text::Result<std::string> id = resolve(revision);
  if (!id) return std::unexpected(id.error());
  const GitAnswer folder = run_git(folder_, {"rev-parse", "--show-prefix"}, kMostList);
  if (!is_good(folder)) return refused(folder, path_);
  const std::string now = folder.output.substr(0, folder.output.rfind('\n')) + name_;
  for (const bool is_now : {true, false}) {
    const std::string path = is_now ? now : former_name(*id);
    const text::Result<Entry> found = path.empty() ? Entry{} : entry(*id, path);
    if (!found) return std::unexpected(found.error());
    if (!found->mode.empty()) return FileThen{revision, *id, path};
  }
  return trouble(fmt::format("`{}` is not in revision `{}`", path_, revision));
}

text::Result<text::SourcePtr> TrackedFile::at(const FileThen& then) const {
  text::Result<std::string> found = text_of(then.id, then.path);
  if (!found) return std::unexpected(found.error());
  return std::make_shared<const text::Source>(fmt::format("{}:{}", then.revision, path_), std::move(*found));
}

text::Result<std::vector<Revision>> TrackedFile::revisions(std::size_t most) const {
  const text::Result<std::string> head = resolve("HEAD");
  if (!head) return std::unexpected(head.error());
  const GitAnswer answer = run_git(
      folder_,
      {"log", "--follow", "-z", fmt::format("--max-count={}", most), "--date=short", "--name-status",
       "--format=%x01%H%x00%cd%x00%an%x00%s", "--no-color", "--no-decorate", "--no-relative", "--no-ext-diff",
       "--no-textconv", "--no-show-signature", "--end-of-options", *head, "--", in_head().way},
      kMostList);
  if (!is_good(answer)) return refused(answer, path_);
  std::vector<Revision> out;
  const std::vector<std::string_view> blocks = cut(answer.output, '\x01');
  for (const std::string_view block : blocks) {
    const std::vector<std::string_view> words = cut(block, '\0');
    if (words.size() < 4) continue;
    Revision& one = out.emplace_back(Revision{std::string(words[0]), std::string(words[1]),
                                              std::string(words[2]), std::string(words[3]), ""});
    const std::vector<Touch> touched = touches({words.begin() + 4, words.end()});
    if (touched.empty()) continue;
    one.path = touched.back().after;
    if (touched.back().what == 'C') break;
  }
  return out;
}

text::Files TrackedFile::files_at(const FileThen& then) const {
  // From where it is today to where it was; empty: it is none of the revision's.
  const auto path_then = [folder = folder_, prefix = then.revision + ":",
                          stood = fs::path(then.path).parent_path()](const std::string& path) -> std::string {
    if (!path.starts_with(prefix)) return "";
    const fs::path way = fs::path(path.substr(prefix.size()))
                             .lexically_normal()
                             .lexically_relative(fs::path(folder).lexically_normal());
    const fs::path out = (stood / way).lexically_normal();
    return way.empty() || *out.begin() == ".." ? "" : out.string();
  };
  text::Files out;
  out.is_file = [*this, id = then.id, path_then](const std::string& path) {
    const std::string then_at = path_then(path);
    const text::Result<Entry> found = then_at.empty() ? Entry{} : entry(id, then_at);
    return found && found->mode.starts_with("100");
  };
  out.read = [*this, id = then.id, path_then](const std::string& path) -> text::Result<text::SourcePtr> {
    const std::string then_at = path_then(path);
    text::Result<std::string> found =
        then_at.empty() ? trouble("it is not of this revision") : text_of(id, then_at);
    if (!found) return trouble(fmt::format("`{}` can't be read: {}", path, found.error().message));
    return std::make_shared<const text::Source>(path, std::move(*found));
  };
  return out;
}

}  // namespace mlab::git
