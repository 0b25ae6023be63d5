#include "mlab/assist/statement_candidates.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

#include "mlab/lang/mdl/token.h"

namespace mlab::assist {
namespace {

bool is_word_character(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_' || c == '.' || c == '/' ||
         c == '*';
}

bool is_name_character(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
}

bool is_word(std::string_view name) {
  return !name.empty() && std::isalpha(static_cast<unsigned char>(name[0])) != 0 &&
         std::ranges::all_of(name, is_name_character);
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

std::string written_reference(const std::string& name) {
  static constexpr std::array kSpecial = {"COMMAND",   "COMMAND-LIST", "MISSION",
                                          "IMMEDIATE", "HEADING",      "FREEZE"};
  const auto is = [&](std::string_view word) { return mdl::equal_without_case(word, name); };
  const bool is_special = mdl::find_keyword(name) != nullptr || std::ranges::any_of(kSpecial, is);
  return is_word(name) && is_special ? '"' + name + '"' : written_name(name);
}

bool StatementCandidates::matches(std::string_view candidate) const {
  return starts_with(candidate, written_);
}

void StatementCandidates::add(const std::string& text, const std::string& kind, const std::string& help) {
  if (is_quoted_ || items_.size() == kMostCandidates || !matches(text)) return;
  items_.push_back({.text = text, .kind = kind, .detail = "", .help = help});
}

void StatementCandidates::add_name(const std::string& name, const std::string& kind, const std::string& help,
                                   const std::string& also) {
  const bool fits = matches(name) || (!also.empty() && matches(also));
  const std::string text = is_quoted_ ? '"' + name + '"' : written_reference(name);
  if (items_.size() == kMostCandidates || !fits || name.empty() || text.empty()) return;
  items_.push_back({.text = text, .kind = kind, .detail = "", .help = help});
}

Completions complete_statement(std::string_view text, StatementKind kind, const KnownNames& names) {
  const WordAtCursor word = word_at(text);
  Completions out;
  out.replaced = {static_cast<std::uint32_t>(word.begin), static_cast<std::uint32_t>(text.size())};
  if (word.is_comment) return out;
  StatementCandidates candidates(std::string(text.substr(word.begin + (word.is_quoted ? 1 : 0))),
                                 word.is_quoted);
  const std::string before(text.substr(0, word.begin));
  if (kind == StatementKind::kOverlay) {
    complete_overlay(before, candidates);
  } else {
    complete_mission(before, kind == StatementKind::kTyped, names, candidates);
  }
  out.candidates = candidates.take();
  out.is_cut = out.candidates.size() == kMostCandidates;
  return out;
}

}  // namespace mlab::assist
