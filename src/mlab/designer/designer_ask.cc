// Questions, which change nothing.

#include <fmt/core.h>

#include "mlab/designer/designer_parts.h"
#include "mlab/designer/edit.h"
#include "mlab/designer/shapes.h"
#include "mlab/text/shown.h"

namespace mlab::designer {

void Designer::Parts::fits(const Fits& request, Answer& out) {
  const OpenConfiguration* one = desk_.find(request.document());
  if (one == nullptr) {
    out.set_ok(false);
    out.set_error("the document is not open");
    return;
  }
  *out.mutable_fits() = fitting(*one->drawn, request);
}

void Designer::Parts::describe(const Describe& request, Answer& out) {
  OpenConfiguration* one = desk_.find(request.document());
  if (one == nullptr) {
    out.set_ok(false);
    out.set_error("the document is not open");
    return;
  }
  const std::optional<Callable> component = one->drawn->components().find(request.component());
  if (!component) {
    out.set_ok(false);
    out.set_error(fmt::format("nothing answers to `{}`", text::shown(request.component())));
    return;
  }
  *out.mutable_component() = palette_entry(*component, *one->drawn, desk_.context(*one));
  out.mutable_component()->set_help(component->help);
}

void Designer::Parts::ask_language(const AskLanguage& request, Answer& out) {
  const OpenConfiguration* one = desk_.find(request.document());
  if (one == nullptr) {
    out.set_ok(false);
    out.set_error("the document is not open");
    return;
  }
  if (request.what() != AskLanguage::PAGE) {
    out.set_ok(false);
    out.set_error("this designer does not know that request");
    return;
  }
  const DrawnAt drawn = drawn_at(*one->drawn, request.cursor());
  Location& location = *out.mutable_location();
  location.set_document(one->path);
  location.set_begin(request.cursor());
  location.set_end(request.cursor());
  location.set_page(drawn.page);
  location.set_node(drawn.node);
}

}  // namespace mlab::designer
