#include "mlab/console/mission_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <vector>

#include <fmt/core.h>

#include "mlab/lang/mdl/mdl.h"
#include "mlab/lang/mdl/token.h"
#include "mlab/lang/mdl/tree.h"

namespace mlab::console {
namespace {

// The byte behind the line end that follows `from`, or the end of the text.
std::uint32_t next_line(std::string_view text, std::uint32_t from) {
  const std::size_t end = text.find('\n', from);
  return static_cast<std::uint32_t>(end == std::string_view::npos ? text.size() : end + 1);
}

// A line behind the token, if the next one stands on another line; else the statement goes between the two.
Insertion line_behind(const text::SourcePtr& mission, const mdl::Tokens& tokens, std::size_t token,
                      const std::string& statement) {
  const std::string_view text = mission->text();
  const mdl::Token& next = tokens.tokens[token + 1];
  if (next.kind != mdl::TokenKind::kEnd && !next.first_on_line)
    return {next.span.begin, '\n' + statement + '\n'};
  const std::uint32_t at = next_line(text, tokens.tokens[token].span.end);
  const bool is_line_open = at == text.size() && !text.ends_with('\n');
  return {at, is_line_open ? '\n' + statement + '\n' : statement + '\n'};
}

Insertion line_before(const mdl::Token& token, const std::string& statement) {
  return {token.span.begin, (token.first_on_line ? "" : "\n") + statement + '\n'};
}

bool is_name_character(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
}

bool is_word(std::string_view name) {
  return !name.empty() && std::isalpha(static_cast<unsigned char>(name[0])) != 0 &&
         std::ranges::all_of(name, is_name_character);
}

}  // namespace

Insertion overlay_statement(const text::SourcePtr& mission, const std::string& name) {
  const std::string statement = fmt::format("OVERLAY {}", written_name(name));
  text::Diagnostics unsaid;
  const mdl::Tree tree = mdl::parse(mission, unsaid);
  const mdl::Tokens tokens = mdl::lex(mission, unsaid);
  const mdl::Name* last = nullptr;
  for (const mdl::Statement& each : tree.preamble) {
    if (const auto* title = std::get_if<mdl::statement::MissionName>(&each.what)) last = &title->name;
    if (const auto* title = std::get_if<mdl::statement::Scenario>(&each.what)) last = &title->name;
    if (const auto* overlay = std::get_if<mdl::statement::OverlayFile>(&each.what)) last = &overlay->file;
  }
  if (last == nullptr) return line_before(tokens.tokens.front(), statement);
  const auto token =
      std::ranges::find_if(tokens.tokens, [&](const mdl::Token& t) { return t.span.end >= last->span.end; });
  return line_behind(mission, tokens, static_cast<std::size_t>(token - tokens.tokens.begin()), statement);
}

Insertion preamble_statement(const text::SourcePtr& mission, const std::string& statement) {
  text::Diagnostics unsaid;
  const mdl::Tokens tokens = mdl::lex(mission, unsaid);
  const auto header = std::ranges::find(tokens.tokens, mdl::TokenKind::kCommandList, &mdl::Token::kind);
  const auto index = static_cast<std::size_t>(header - tokens.tokens.begin());
  if (header == tokens.tokens.end() || index == 0) {
    return line_before(header == tokens.tokens.end() ? tokens.tokens.back() : *header, statement);
  }
  return line_behind(mission, tokens, index - 1, statement);
}

std::string written_name(const std::string& name) {
  if (is_word(name)) return name;
  return name.find_first_of("\"\n\r") == std::string::npos ? '"' + name + '"' : "";
}

std::string written_reference(const std::string& name) {
  static constexpr std::array kSpecial = {"COMMAND",   "COMMAND-LIST", "MISSION",
                                          "IMMEDIATE", "HEADING",      "FREEZE"};
  const auto is = [&](std::string_view word) { return mdl::equal_without_case(word, name); };
  const bool is_special = mdl::find_keyword(name) != nullptr || std::ranges::any_of(kSpecial, is);
  return is_word(name) && is_special ? '"' + name + '"' : written_name(name);
}

}  // namespace mlab::console
