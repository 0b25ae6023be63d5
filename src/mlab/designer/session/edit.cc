#include <utility>

#include <fmt/core.h>

#include "mlab/designer/edit/edit.h"
#include "mlab/designer/session/parts.h"

namespace mlab::designer {

void Designer::Parts::edit(const Edit& request, Answer& out) {
  OpenConfiguration* one = editable(request.document(), out);
  if (one == nullptr) return;
  if (one->is_outdated()) {
    out.set_ok(false);
    out.set_error("the text has a slip of grammar: mend it first, or undo it");
    return;
  }
  text::Result<Edited> done = edited(one->drawn, desk_.environment(), request, desk_.offered(*one));
  if (!done) {
    fail(out, done.error());
    return;
  }
  if (done->text.size() > text::Source::kMaxBytes) {
    out.set_ok(false);
    out.set_error("the text would be too long");
    return;
  }
  // Moving the same node on and on is one step.
  const bool may_merge = request.changes(0).has_arrange() || request.changes(0).has_set_value();
  desk_.store().change(*one, done->text, std::move(done->name), now(), may_merge);
  desk_.changed(*one);
}

void Designer::Parts::copy(const Copy& request, Answer& out) {
  const OpenConfiguration* one = opened(request.document(), out);
  if (one == nullptr) return;
  text::Result<std::string> text = copied(*one->drawn, request);
  if (!text) {
    fail(out, text.error());
    return;
  }
  out.set_text(std::move(*text));
}

}  // namespace mlab::designer
