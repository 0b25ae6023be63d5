#include "mlab/console/mission_text.h"

#include <vector>

#include <fmt/core.h>

#include "mlab/lang/mdl/mdl.h"
#include "mlab/lang/mdl/token.h"
#include "mlab/lang/mdl/tree.h"

namespace mlab::console {
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

}  // namespace mlab::console
