#include "mlab/history/bookmark_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "mlab/mcap/reader.h"
#include "mlab/text/shown.h"

namespace mlab::history {
namespace {

using nlohmann::json;

constexpr std::string_view kRecord = "missionlab bookmark";
constexpr int kBookmarkFormat = 1;
// More than the longest file that is written here.
constexpr std::size_t kMostBesideBytes = std::size_t{4} << 20;
// Each change of a recording is one, and a stranger may have written any number.
constexpr std::size_t kMostRecords = 100'000;

template <class Number>
std::optional<Number> number_of(const mcap::Pairs& values, std::string_view name) {
  const auto found = values.find(name);
  if (found == values.end()) return std::nullopt;
  Number out{};
  const char* const end = found->second.data() + found->second.size();
  const auto [at, error] = std::from_chars(found->second.data(), end, out);
  return error == std::errc{} && at == end ? std::optional(out) : std::nullopt;
}

std::string pair_text(const mcap::Pairs& values, std::string_view name) {
  const auto found = values.find(name);
  return found == values.end() ? "" : found->second;
}

constexpr std::uint64_t kNoCycle = std::numeric_limits<std::uint64_t>::max();
constexpr double kNoTime = std::numeric_limits<double>::quiet_NaN();

/// What was written, perhaps by a stranger, at moments of the run; which of them were none is told.
class Taken {
 public:
  explicit Taken(const std::optional<RunExtent>& run) : run_(run) {}

  bool put(Bookmark one) {
    const double time = one.time;
    const std::uint64_t id = one.id;
    const bool is_moved = move_into_run(one, run_);
    const std::string name = one.note.empty() ? fmt::format("bookmark {}", id) : plain_note(one.note, 40);
    if (!bookmarks_.put(std::move(one))) return false;
    moved_.erase(id);
    if (is_moved)
      moved_[id] =
          std::isnan(time) ? fmt::format("`{}` (no time)", name) : fmt::format("`{}` ({:g} s)", name, time);
    return true;
  }
  void forget(std::uint64_t id) {
    bookmarks_.forget(id);
    moved_.erase(id);
  }
  const Bookmarks& bookmarks() const { return bookmarks_; }
  const std::map<std::uint64_t, std::string>& moved() const { return moved_; }

 private:
  std::optional<RunExtent> run_;
  Bookmarks bookmarks_;
  std::map<std::uint64_t, std::string> moved_;  // by id, in words
};

std::string moved_words(const std::map<std::uint64_t, std::string>& moved) {
  constexpr std::size_t kMostNamed = 5;
  std::string names;
  std::size_t count = 0;
  for (const auto& [id, words] : moved) {
    if (++count <= kMostNamed) names += (names.empty() ? "" : ", ") + words;
  }
  if (count == 0) return "";
  if (count > kMostNamed) names += fmt::format(" and {} more", count - kMostNamed);
  return fmt::format(
      "{} at moments that the run doesn't have, and moved to its beginning, its end or their cycle: {}",
      count == 1 ? "one was written" : fmt::format("{} were written", count), names);
}

void take_record(const mcap::Pairs& values, Taken& out) {
  const auto id = number_of<std::uint64_t>(values, "id");
  if (!id) return;
  if (values.contains("removed")) {
    out.forget(*id);
    return;
  }
  out.put({*id, number_of<std::uint64_t>(values, "cycle").value_or(kNoCycle),
           number_of<double>(values, "time").value_or(kNoTime), pair_text(values, "note"),
           pair_text(values, "by")});
}

Taken recorded_in(const std::string& recording, const std::optional<RunExtent>& run, std::uint64_t& highest) {
  Taken out(run);
  const auto reader = mcap::Reader::open(recording);
  if (!reader) return out;
  std::size_t count = 0;
  for (const mcap::MetadataIndex& index : reader->summary().metadata) {
    if (index.name != kRecord) continue;
    if (++count > kMostRecords) break;
    const auto record = reader->metadata(index);
    if (!record) continue;
    take_record(record->values, out);
    highest = std::max(highest, number_of<std::uint64_t>(record->values, "id").value_or(0));
  }
  return out;
}

/// What stands beside a recording.
struct Beside {
  std::string bytes;
  bool is_there = false;
  std::string problem;
};

std::string reason() {
  return std::generic_category().message(errno);
}

Beside bytes_of(const std::string& path) {
  Beside out;
  // One that is no file at all, a pipe say, would never end.
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (file < 0) {
    out.is_there = errno != ENOENT;
    if (out.is_there) out.problem = fmt::format("`{}` can't be read: {}", text::shown(path, 200), reason());
    return out;
  }
  out.is_there = true;
  struct stat status{};
  if (::fstat(file, &status) != 0 || !S_ISREG(status.st_mode))
    out.problem = fmt::format("`{}` is no file", text::shown(path, 200));
  else if (status.st_size > static_cast<off_t>(kMostBesideBytes))
    out.problem = fmt::format("`{}` has more than {} bytes", text::shown(path, 200), kMostBesideBytes);
  while (out.problem.empty() && out.bytes.size() <= kMostBesideBytes) {
    char piece[16384];
    const ssize_t count = ::read(file, piece, sizeof piece);
    if (count == 0) break;
    if (count < 0) {
      if (errno == EINTR) continue;
      out.problem = fmt::format("`{}` can't be read: {}", text::shown(path, 200), reason());
      break;
    }
    out.bytes.append(piece, static_cast<std::size_t>(count));
  }
  ::close(file);
  return out;
}

std::optional<std::uint64_t> whole(const json& from, const char* name) {
  const auto found = from.find(name);
  if (found == from.end() || !found->is_number_unsigned()) return std::nullopt;
  return found->get<std::uint64_t>();
}

double time_in(const json& from) {
  const auto found = from.find("time");
  return found != from.end() && found->is_number() ? found->get<double>() : kNoTime;
}

std::string text_in(const json& from, const char* name) {
  const auto found = from.find(name);
  return found != from.end() && found->is_string() ? found->get<std::string>() : "";
}

// Numbers that JSON doesn't have, as NaN and 1e999, as null: no note is lost for one.
std::string with_numbers_only(std::string_view bytes) {
  const auto is_of_word = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '+' || c == '-' || c == '.';
  };
  std::string out;
  for (std::size_t at = 0; at < bytes.size();) {
    std::size_t end = at + 1;
    if (bytes[at] == '"') {
      while (end < bytes.size() && bytes[end] != '"') end += bytes[end] == '\\' ? 2 : 1;
      end = std::min(end + 1, bytes.size());
      out += bytes.substr(at, end - at);
    } else if (is_of_word(bytes[at])) {
      while (end < bytes.size() && is_of_word(bytes[end])) ++end;
      const std::string_view word = bytes.substr(at, end - at);
      double number = 0.0;
      const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), number);
      const bool is_number =
          error == std::errc{} && stop == word.data() + word.size() && std::isfinite(number);
      out += is_number || word == "true" || word == "false" ? word : "null";
    } else {
      out += bytes[at];
    }
    at = end;
  }
  return out;
}

// @return  false: it is nothing that this program has written
bool parse_beside(const std::string& bytes, KeptBookmarks& out, Taken& taken) {
  // Nothing in it is nested deeper than three times; so is what is read, that nobody's nesting fills the
  // stack.
  const json read = json::parse(
      with_numbers_only(bytes), [](int depth, json::parse_event_t, json&) { return depth <= 3; }, false);
  if (!read.is_object() || whole(read, "format") != kBookmarkFormat) return false;
  const auto list = read.find("bookmarks");
  if (list == read.end() || !list->is_array()) return false;
  out.recorded_to = whole(read, "recorded_to").value_or(0);
  std::size_t left_out = 0;
  for (const json& one : *list) {
    const auto id = one.is_object() ? whole(one, "id") : std::nullopt;
    const bool is_one = id && taken.bookmarks().find(*id) == nullptr &&
                        taken.put({*id, whole(one, "cycle").value_or(kNoCycle), time_in(one),
                                   text_in(one, "note"), text_in(one, "by")});
    left_out += is_one ? 0 : 1;
  }
  out.bookmarks = taken.bookmarks();
  out.moved = moved_words(taken.moved());
  if (left_out > 0)
    out.problem = fmt::format(
        "{} of its entries {} left out: each has an `id` of its own, and a run has at most {} of them",
        left_out, left_out == 1 ? "is" : "are", Bookmarks::kMost);
  return true;
}

std::string as_json(const KeptBookmarks& kept) {
  json list = json::array();
  for (const auto& [id, one] : kept.bookmarks.all())
    list.push_back(
        {{"id", id}, {"cycle", one.cycle}, {"time", one.time}, {"note", one.note}, {"by", one.by}});
  const json whole_file = {
      {"format", kBookmarkFormat}, {"recorded_to", kept.recorded_to}, {"bookmarks", list}};
  return whole_file.dump(1, ' ', false, json::error_handler_t::replace) + "\n";
}

std::optional<std::string> write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(file, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return reason();
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  if (::fsync(file) != 0) return reason();
  return std::nullopt;
}

std::optional<std::string> replace_file(const std::string& path, const std::string& bytes) {
  const std::string made = fmt::format("{}.{}.new", path, ::getpid());
  ::unlink(made.c_str());
  const int file = ::open(made.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, 0666);
  if (file < 0) return reason();
  std::optional<std::string> problem = write_all(file, bytes);
  if (::close(file) != 0 && !problem) problem = reason();
  if (!problem && ::rename(made.c_str(), path.c_str()) != 0) problem = reason();
  if (problem) ::unlink(made.c_str());
  return problem;
}

}  // namespace

mcap::Metadata bookmark_record(const Bookmark& one) {
  return {std::string(kRecord),
          {{"id", fmt::format("{}", one.id)},
           {"cycle", fmt::format("{}", one.cycle)},
           {"time", fmt::format("{}", one.time)},
           {"note", one.note},
           {"by", one.by}}};
}

mcap::Metadata bookmark_record(std::uint64_t id) {
  return {std::string(kRecord), {{"id", fmt::format("{}", id)}, {"removed", "true"}}};
}

std::string bookmark_path(const std::string& recording) {
  return recording + ".bookmarks";
}

KeptBookmarks read_bookmarks(const std::string& recording, const std::optional<RunExtent>& run) {
  std::uint64_t highest = 0;
  const Taken recorded = recorded_in(recording, run, highest);
  KeptBookmarks out;
  out.run = run;
  Taken taken(run);
  Beside beside = bytes_of(bookmark_path(recording));
  out.problem = std::move(beside.problem);
  if (beside.is_there && out.problem.empty() && !parse_beside(beside.bytes, out, taken))
    out.problem =
        fmt::format(R"(it is no JSON of the form {{"format": {}, "bookmarks": [...]}})", kBookmarkFormat);
  if (beside.is_there && !out.problem.empty() && !out.problem.starts_with('`'))
    out.problem = fmt::format("`{}`: {}", text::shown(bookmark_path(recording), 200), out.problem);
  out.written = std::move(beside.bytes);
  // Others that came into the recording since, as it was still being written then.
  std::map<std::uint64_t, std::string> moved = taken.moved();
  for (const auto& [id, one] : recorded.bookmarks().all()) {
    if (id <= out.recorded_to) continue;
    if (const auto found = recorded.moved().find(id); found != recorded.moved().end()) moved.insert(*found);
    if (out.bookmarks.find(id) == nullptr)
      out.bookmarks.put(one);
    else if (!out.bookmarks.add(one))
      out.problem = "there are more bookmarks than a run may have, and the last ones are left out";
  }
  out.moved = moved_words(moved);
  out.recorded_to = std::max(out.recorded_to, std::min(highest, Bookmarks::kMostNumber));
  return out;
}

std::expected<void, std::string> write_bookmarks(const std::string& recording, KeptBookmarks& kept) {
  const std::string path = bookmark_path(recording);
  const Beside there = bytes_of(path);
  if (there.is_there && there.problem.empty() && there.bytes != kept.written)
    return std::unexpected(fmt::format(
        "`{}` was written by another program meanwhile: open the recording anew", text::shown(path, 200)));
  KeptBookmarks before;
  Taken taken(kept.run);
  // What would be left out or otherwise stays, too.
  const bool is_readable =
      there.problem.empty() && (!there.is_there || (parse_beside(there.bytes, before, taken) &&
                                                    before.problem.empty() && before.moved.empty()));
  if (!is_readable && ::rename(path.c_str(), (path + ".unreadable").c_str()) != 0)
    return std::unexpected(fmt::format("`{}` can't be put aside: {}", text::shown(path, 200), reason()));
  std::string bytes = as_json(kept);
  if (const auto problem = replace_file(path, bytes))
    return std::unexpected(fmt::format("`{}` can't be written: {}", text::shown(path, 200), *problem));
  kept.written = std::move(bytes);
  return {};
}

}  // namespace mlab::history
