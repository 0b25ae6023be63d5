#include "mlab/console/completion.h"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <utility>

#include "mlab/console/mission_text.h"
#include "mlab/console/utf8.h"
#include "mlab/lang/mdl/token.h"

namespace mlab::console {
namespace {

bool is_word_character(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_' || c == '.' || c == '/' ||
         c == '*';
}

/// The word at the cursor.
struct WordAtCursor {
  std::size_t begin = 0;
  bool is_quoted = false;
  bool is_comment = false;
};

// Strings and comments end with their line, so the line tells what the cursor is in.
WordAtCursor word_at(std::string_view text) {
  const std::size_t line = text.rfind('\n') + 1;  // npos + 1 is 0
  std::size_t quote = std::string_view::npos;
  for (std::size_t i = line; i < text.size(); ++i) {
    if (text[i] == '"') quote = quote == std::string_view::npos ? i : std::string_view::npos;
    const bool begins_word = i == line || !is_word_character(text[i - 1]);
    if (quote == std::string_view::npos && begins_word && text.substr(i).starts_with("--"))
      return {i, false, true};
  }
  if (quote != std::string_view::npos) return {quote, true, false};
  std::size_t begin = text.size();
  while (begin > line && is_word_character(text[begin - 1])) --begin;
  return {begin, false, false};
}

bool starts_with(std::string_view text, std::string_view start) {
  return text.size() >= start.size() && mdl::equal_without_case(text.substr(0, start.size()), start);
}

}  // namespace

namespace completion {

bool Candidates::matches(std::string_view candidate) const {
  return starts_with(candidate, written_);
}

void Candidates::add(const std::string& text, const std::string& kind, const std::string& help) {
  if (is_quoted_ || items_.size() == kMost || !matches(text)) return;
  Completions::Item& item = items_.emplace_back();
  item.set_text(text);
  item.set_kind(kind);
  item.set_help(help);
}

void Candidates::add_name(const std::string& name, const std::string& kind, const std::string& help,
                          const std::string& also) {
  const bool fits = matches(name) || (!also.empty() && matches(also));
  const std::string text = is_quoted_ ? '"' + name + '"' : written_reference(name);
  if (items_.size() == kMost || !fits || name.empty() || text.empty()) return;
  Completions::Item& item = items_.emplace_back();
  item.set_text(as_utf8(text));
  item.set_kind(kind);
  item.set_help(as_utf8(help));
}

}  // namespace completion

Completions complete(const Complete& request, const KnownNames& names) {
  Completions out;
  const std::string text = request.text().substr(0, request.cursor());
  const WordAtCursor word = word_at(text);
  out.set_begin(static_cast<std::uint32_t>(word.begin));
  if (word.is_comment) return out;
  completion::Candidates candidates(text.substr(word.begin + (word.is_quoted ? 1 : 0)), word.is_quoted);
  const std::string before = text.substr(0, word.begin);
  if (request.language() == Complete::OVERLAY) {
    completion::complete_overlay(before, candidates);
  } else {
    completion::complete_mission(before, request.language() == Complete::IMMEDIATE, names, candidates);
  }
  for (Completions::Item& item : candidates.take()) *out.add_items() = std::move(item);
  return out;
}

}  // namespace mlab::console
