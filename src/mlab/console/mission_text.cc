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

bool is_name_character(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
}

bool is_word(std::string_view name) {
  return !name.empty() && std::isalpha(static_cast<unsigned char>(name[0])) != 0 &&
         std::ranges::all_of(name, is_name_character);
}

}  // namespace

Splice overlay_statement(const text::SourcePtr& mission, const std::string& name) {
  const std::string statement = fmt::format("OVERLAY {}", written_name(name));
  text::Diagnostics unsaid;
  const mdl::Tree tree = mdl::parse(mission, unsaid);
  std::vector<text::Span> words;
  for (const mdl::Token& token : mdl::lex(mission, unsaid).tokens) {
    if (token.kind != mdl::TokenKind::kEnd) words.push_back(token.span);
  }
  const mdl::Name* last = nullptr;
  for (const mdl::Statement& each : tree.preamble) {
    if (const auto* title = std::get_if<mdl::statement::MissionName>(&each.what)) last = &title->name;
    if (const auto* title = std::get_if<mdl::statement::Scenario>(&each.what)) last = &title->name;
    if (const auto* overlay = std::get_if<mdl::statement::OverlayFile>(&each.what)) last = &overlay->file;
  }
  Splices splices(mission, words);
  if (last != nullptr) {
    splices.add_line_behind(last->span, statement);
  } else if (!words.empty()) {
    splices.add_line_before(words.front(), statement);
  } else {
    splices.add_line_at_end(statement);
  }
  return splices.joined().value_or(Splice{});
}

std::string written_name(const std::string& name) {
  const std::string_view bare = std::string_view(name).substr(0, name.size() - (name.ends_with('*') ? 1 : 0));
  if (is_word(bare)) return name;
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
