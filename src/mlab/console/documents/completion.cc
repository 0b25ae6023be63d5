#include "mlab/console/documents/completion.h"

#include <string_view>

#include "mlab/text/utf8.h"

namespace mlab::console {

Completions complete(const Complete& request, const KnownNames& names) {
  const auto kind = request.language() == Complete::OVERLAY   ? assist::StatementKind::kOverlay
                    : request.language() == Complete::MISSION ? assist::StatementKind::kMission
                                                              : assist::StatementKind::kTyped;
  const std::string_view text = std::string_view(request.text()).substr(0, request.cursor());
  const assist::Completions found = assist::complete_statement(text, kind, names);
  Completions out;
  out.set_begin(found.replaced.begin);
  for (const assist::Candidate& one : found.candidates) {
    Completions::Item& item = *out.add_items();
    item.set_text(text::as_utf8(one.text));
    item.set_kind(one.kind);
    item.set_help(text::as_utf8(one.help));
  }
  return out;
}

}  // namespace mlab::console
