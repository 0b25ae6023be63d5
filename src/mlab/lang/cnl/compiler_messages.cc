#include "mlab/lang/cnl/compiler_messages.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "mlab/text/shown.h"

namespace mlab::cnl {
namespace {

constexpr std::size_t kLongestMessage = 400;

using Sources = std::map<std::string, text::SourcePtr, std::less<>>;

void collect_sources(const Tree& tree, Sources& sources) {
  sources.emplace(tree.source->name(), tree.source);
  for (const Item& item : tree.items) {
    const auto* include = std::get_if<Include>(&item);
    if (include && include->tree) collect_sources(*include->tree, sources);
  }
}

// `file:line:column: word: text`
struct Line {
  std::string_view file;
  std::uint32_t line = 0;
  std::uint32_t column = 0;
  std::string_view
      level;  ///< `error`, `fatal error`, `warning`, `note`, or empty: `required from here` and the like
  std::string_view text;
};

bool take_number(std::string_view& text, std::uint32_t& number) {
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (failure != std::errc()) return false;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return true;
}

std::optional<Line> read_line(std::string_view text) {
  // The first `:digits:digits: ` ends the name of the file, which may hold colons itself.
  for (std::size_t colon = text.find(':'); colon != std::string_view::npos;
       colon = text.find(':', colon + 1)) {
    Line out;
    std::string_view rest = text.substr(colon + 1);
    if (!take_number(rest, out.line) || !rest.starts_with(':')) continue;
    rest.remove_prefix(1);
    if (!take_number(rest, out.column) || !rest.starts_with(':')) continue;
    rest.remove_prefix(1);
    rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
    out.file = text.substr(0, colon);
    out.text = rest;
    for (const std::string_view level : {"error", "fatal error", "warning", "note"}) {
      if (!rest.starts_with(level) || !rest.substr(level.size()).starts_with(": ")) continue;
      out.level = level;
      out.text = rest.substr(level.size() + 2);
    }
    return out;
  }
  return std::nullopt;
}

bool is_word(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '$';
}

// The word at a line and byte column; nowhere for a file that is not the author's.
text::Place place_of(const Line& line, const Sources& sources) {
  const auto found = sources.find(line.file);
  if (found == sources.end()) return {};
  const text::SourcePtr& source = found->second;
  const std::string_view words = source->line(line.line);
  if (words.data() == nullptr) return {source, {0, 0}};
  const auto start = static_cast<std::uint32_t>(words.data() - source->text().data());
  const auto from =
      static_cast<std::uint32_t>(std::min<std::size_t>(line.column > 0 ? line.column - 1 : 0, words.size()));
  std::uint32_t to = from;
  while (to < words.size() && is_word(words[to])) ++to;
  return {source, {start + from, start + std::max(to, from + 1)}};
}

// The last line of g++'s own words for a file that is not the author's.
std::string elsewhere(const Line& line) {
  const std::size_t slash = line.file.rfind('/');
  return fmt::format("{}:{}", line.file.substr(slash == std::string_view::npos ? 0 : slash + 1), line.line);
}

text::Diagnostic to_diagnostic(const Line& line) {
  text::Diagnostic out;
  out.kind = "cpp-error";
  if (line.level == "warning") {
    out.severity = text::Severity::kWarning;
    out.kind = "cpp-warning";
  }
  std::string_view message = line.text;
  constexpr std::string_view kAssertion = "static assertion failed: ";
  if (message.starts_with(kAssertion)) {
    message.remove_prefix(kAssertion.size());
    const bool about_state = message.find("cannot be copied byte by byte") != std::string_view::npos;
    if (about_state) {
      out.kind = "state-not-copyable";
      out.hints.emplace_back(
          "`std::array` and plain structs copy; `std::vector`, `std::string` and views of readings do not");
    }
  }
  out.message = text::shown(message, kLongestMessage);
  if (message.find("read-only") != std::string_view::npos)
    out.hints.emplace_back("inputs of a procedure are read-only");
  return out;
}

/// Reads the messages one by one; each begins with an error or a warning, and notes belong to it.
class MessageReader {
 public:
  explicit MessageReader(const Tree& tree) { collect_sources(tree, sources_); }

  void read(std::string_view output) {
    while (!output.empty()) {
      const std::size_t end = std::min(output.find('\n'), output.size());
      if (const std::optional<Line> line = read_line(output.substr(0, end))) take(*line);
      output.remove_prefix(std::min(end + 1, output.size()));
    }
  }

  const std::vector<text::Diagnostic>& messages() const { return messages_; }

 private:
  void take(const Line& line) {
    const text::Place place = place_of(line, sources_);
    if (line.level.empty() || line.level == "note") {
      const bool mends_last = place.source && !messages_.empty() && !messages_.back().place.source;
      if (mends_last) messages_.back().place = place;
      if (line.level.empty()) {
        if (place.source) led_here_ = place;
      } else if (place.source && !mends_last && !messages_.empty() &&
                 messages_.back().notes.size() < kMaxNotes) {
        messages_.back().notes.push_back({text::shown(line.text, kLongestMessage), place});
      }
      return;
    }
    messages_.push_back(to_diagnostic(line));
    messages_.back().place = place.source ? place : led_here_;
    if (!place.source) messages_.back().label = fmt::format("g++ says so of {}", elsewhere(line));
    led_here_ = {};
  }

  static constexpr std::size_t kMaxNotes = 5;

  Sources sources_;
  std::vector<text::Diagnostic> messages_;
  text::Place led_here_;  ///< the last of the author's places in the lines before a message
};

bool is_error(const text::Diagnostic& message) {
  return message.severity == text::Severity::kError;
}

// What follows from another message and says nothing new to the author.
bool follows(const text::Diagnostic& message, const std::vector<text::Diagnostic>& before) {
  if (message.message.starts_with("something that the header declares")) {
    return std::ranges::any_of(before, [](const auto& b) { return b.kind == "state-not-copyable"; });
  }
  return std::ranges::any_of(before, [&](const auto& b) {
    return b.message == message.message && b.place.source == message.place.source &&
           b.place.span == message.place.span;
  });
}

}  // namespace

std::size_t report_compiler_messages(std::string_view output, const Tree& tree,
                                     text::Diagnostics& diagnostics) {
  MessageReader reader(tree);
  reader.read(output);
  // Errors in generated text or in headers follow from those in the author's text, where there are any.
  const bool has_own = std::any_of(reader.messages().begin(), reader.messages().end(),
                                   [](const auto& m) { return is_error(m) && m.place.source != nullptr; });
  std::size_t errors = 0;
  std::vector<text::Diagnostic> said;
  for (const text::Diagnostic& message : reader.messages()) {
    if (is_error(message)) ++errors;
    if ((!message.place.source && (has_own || !is_error(message))) || follows(message, said)) continue;
    said.push_back(message);
    diagnostics.report(message);
  }
  return errors;
}

}  // namespace mlab::cnl
