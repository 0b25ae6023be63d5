#include "mlab/text/diagnostic.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include <fmt/core.h>

#include "mlab/text/colors.h"
#include "mlab/text/shown.h"

namespace mlab::text {
namespace {

constexpr std::size_t kShownColumns = 100;

struct Excerpt {
  std::string text;
  std::size_t caret = 0;   // first caret, counted in characters of `text`
  std::size_t carets = 1;  // how many
};

bool is_first_byte(char c) {
  return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U;
}

// The line split into characters, so that cutting it never cuts a character in two.
std::vector<std::string> characters(std::string_view line) {
  std::vector<std::string> out;
  for (const char c : line) {
    const auto u = static_cast<unsigned char>(c);
    if (is_first_byte(c) || out.empty()) {
      out.emplace_back(1, c == '\t' ? ' ' : u < 0x20 || u == 0x7f ? '?' : c);
    } else {
      out.back() += c;
    }
  }
  return out;
}

// The part of the line around the carets. Only bytes near them are looked at: a line may be the whole of a
// large file.
Excerpt excerpt(const Source& source, Span span) {
  constexpr std::size_t kReach = 4 * kShownColumns;  // bytes; a character has at most four
  const std::string_view line = source.line(source.line_column(span.begin).line);
  const std::size_t begin = std::min<std::size_t>(
      span.begin -
          std::min<std::size_t>(span.begin, static_cast<std::size_t>(line.data() - source.text().data())),
      line.size());
  const std::size_t end = std::clamp<std::size_t>(begin + (span.end - span.begin), begin, line.size());
  const std::size_t window = begin - std::min(begin, kReach);
  const std::vector<std::string> before = characters(line.substr(window, begin - window));
  const std::vector<std::string> after = characters(line.substr(begin, kReach));
  const std::size_t from = before.size() > kShownColumns * 3 / 4 ? before.size() - kShownColumns / 2 : 0;
  const std::size_t room = kShownColumns - (before.size() - from);
  Excerpt out;
  if (from > 0 || window > 0) out.text = "...";
  out.caret = out.text.size() + before.size() - from;
  for (std::size_t i = from; i < before.size(); ++i) out.text += before[i];
  for (std::size_t i = 0; i < after.size() && i < room; ++i) out.text += after[i];
  if (after.size() > room || begin + kReach < line.size()) out.text += "...";
  const std::size_t marked = characters(line.substr(begin, std::min(end - begin, kReach))).size();
  out.carets = std::clamp<std::size_t>(marked, 1, room);
  return out;
}

// As a terminal may have it: whoever wrote a file chooses what stands in names of files and words of
// messages.
std::string harmless(std::string_view text) {
  std::string out;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    out += (at == 0 ? "" : "\n") + shown(text.substr(at, end - at), std::string_view::npos);
    at = end + 1;
  }
  return out;
}

std::string location(const Place& place) {
  if (!place.source) return "";
  const LineColumn at = place.source->line_column(place.span.begin);
  return fmt::format("{}:{}:{}: ", harmless(place.source->name()), at.line, at.column);
}

// Escape sequences around a piece of text, where colours are wanted.
struct Paint {
  bool is_on;
  const char* of_level;

  std::string painted(const char* code, const std::string& text) const {
    return is_on && !text.empty() ? fmt::format("\x1b[{}m{}\x1b[0m", code, text) : text;
  }
  std::string level(const std::string& text) const { return painted(of_level, text); }
  std::string bold(const std::string& text) const { return painted("1", text); }
  std::string hint(const std::string& text) const { return painted("36", text); }
};

std::string small_letters(std::string_view name) {
  std::string out(name);
  for (char& c : out) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

// Levenshtein's distance: how many letters have to be changed, added or taken away. `limit` stands for that
// many or more.
std::size_t changes_between(std::string_view from, std::string_view to, std::size_t limit) {
  if (to.size() >= from.size() + limit || from.size() >= to.size() + limit) return limit;
  std::vector<std::size_t> row(to.size() + 1);
  for (std::size_t j = 0; j < row.size(); ++j) row[j] = j;
  for (std::size_t i = 0; i < from.size(); ++i) {
    std::size_t diagonal = row[0];
    std::size_t least = row[0] = i + 1;
    for (std::size_t j = 0; j < to.size(); ++j) {
      const std::size_t change = diagonal + (from[i] == to[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({change, row[j] + 1, diagonal + 1});
      least = std::min(least, row[j + 1]);
    }
    if (least >= limit) return limit;
  }
  return std::min(row.back(), limit);
}

}  // namespace

void Diagnostics::report(Diagnostic diagnostic) {
  std::size_t& count = diagnostic.severity == Severity::kError     ? error_count_
                       : diagnostic.severity == Severity::kWarning ? warning_count_
                                                                   : note_count_;
  if (count++ < kMaxErrors) items_.push_back(std::move(diagnostic));
}

Diagnostic& Diagnostics::add(Severity severity, std::string kind, Place place, std::string message) {
  const std::size_t before = items_.size();
  report({severity, std::move(kind), std::move(message), std::move(place), {}, {}, {}});
  return items_.size() > before ? items_.back() : dropped_ = {};
}

Diagnostic& Diagnostics::error(std::string kind, Place place, std::string message) {
  return add(Severity::kError, std::move(kind), std::move(place), std::move(message));
}

Diagnostic& Diagnostics::warning(std::string kind, Place place, std::string message) {
  return add(Severity::kWarning, std::move(kind), std::move(place), std::move(message));
}

Diagnostic& Diagnostics::note(std::string kind, Place place, std::string message) {
  return add(Severity::kNote, std::move(kind), std::move(place), std::move(message));
}

std::string_view name(Severity severity) {
  constexpr std::string_view kNames[] = {"error", "warning", "note"};
  return kNames[static_cast<std::size_t>(severity)];
}

namespace {

std::string rendered(const Diagnostic& diagnostic, bool in_colors) {
  constexpr const char* kPaints[] = {"1;31", "1;33", "1;36"};
  const Paint paint{in_colors, kPaints[static_cast<std::size_t>(diagnostic.severity)]};
  std::string out = fmt::format("{}{}: {} [{}]\n", paint.bold(location(diagnostic.place)),
                                paint.level(std::string(name(diagnostic.severity))),
                                paint.bold(harmless(diagnostic.message)), diagnostic.kind);
  if (const Source* source = diagnostic.place.source.get()) {
    const LineColumn at = source->line_column(diagnostic.place.span.begin);
    const Excerpt shown = excerpt(*source, diagnostic.place.span);
    out += fmt::format("{:>5} | {}\n", at.line, shown.text);
    const std::string marked = std::string(shown.carets, '^') + (diagnostic.label.empty() ? "" : " ");
    out += fmt::format("      | {}{}\n", std::string(shown.caret, ' '),
                       paint.level(marked + harmless(diagnostic.label)));
  } else if (!diagnostic.label.empty()) {
    out += fmt::format("      = {}\n", harmless(diagnostic.label));
  }
  for (const std::string& hint : diagnostic.hints)
    out += fmt::format("      = {}: {}\n", paint.hint("hint"), harmless(hint));
  for (const Note& note : diagnostic.notes)
    out += fmt::format("{}{}: {}\n", location(note.place), paint.hint("note"), harmless(note.message));
  return out;
}

std::string rendered(const Diagnostics& diagnostics, bool in_colors) {
  std::string out;
  for (const Diagnostic& item : diagnostics.items()) out += rendered(item, in_colors);
  const std::size_t said = diagnostics.items().size();
  const std::size_t all = diagnostics.error_count() + diagnostics.warning_count() + diagnostics.note_count();
  if (all > said) out += fmt::format("... and {} more\n", all - said);
  return out;
}

}  // namespace

std::string render(const Diagnostic& diagnostic) {
  return rendered(diagnostic, false);
}

std::string render(const Diagnostics& diagnostics) {
  return rendered(diagnostics, false);
}

std::string render_in_colors(const Diagnostic& diagnostic) {
  return rendered(diagnostic, true);
}

std::string render_in_colors(const Diagnostics& diagnostics) {
  return rendered(diagnostics, true);
}

std::string nearest_name(std::string_view name, std::span<const std::string> candidates) {
  const std::string wanted = small_letters(name);
  std::string best;
  std::size_t best_distance =
      name.size() / 3 + 2;  // more changes than this, and somebody meant something else
  for (const std::string& candidate : candidates) {
    const std::size_t longer = std::max(wanted.size(), candidate.size());
    if (longer - std::min(wanted.size(), candidate.size()) >= best_distance) continue;
    const std::size_t distance = changes_between(wanted, small_letters(candidate), best_distance);
    if (distance >= best_distance || distance >= longer) continue;
    best_distance = distance;
    best = candidate;
  }
  return best;
}

}  // namespace mlab::text
