#include "mlab/console/documents/mission_text.h"

#include <vector>

#include "mlab/lang/mdl/mdl.h"
#include "mlab/lang/mdl/token.h"
#include "mlab/lang/mdl/tree.h"
#include "mlab/text/word_changes.h"

namespace mlab::console {
text::Splice overlay_statement(const text::SourcePtr& mission, const std::string& name) {
  const bool is_quoted = written_name(name).starts_with('"');
  const std::string statement = mdl::print({{}, {}, mdl::statement::OverlayFile{{name, is_quoted, {}}}});
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
  text::WordChanges changes(mission, words);
  if (last != nullptr) {
    changes.add_line_behind(last->span, statement);
  } else if (!words.empty()) {
    changes.add_line_before(words.front(), statement);
  } else {
    changes.add_line_at_end(statement);
  }
  return changes.joined().value_or(text::Splice{});
}

}  // namespace mlab::console
