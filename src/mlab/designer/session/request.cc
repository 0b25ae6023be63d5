#include "mlab/designer/session/request.h"

#include <utility>

#include <fmt/core.h>

#include "mlab/designer/drawing/drawing.h"
#include "mlab/text/shown.h"

namespace mlab::designer {

Answer answer_for(const Asker& asker) {
  Answer out;
  out.set_request(asker.request);
  out.set_ok(true);
  return out;
}

void refuse(Answer& out, std::string why) {
  out.set_ok(false);
  out.set_error(std::move(why));
}

void fail(Answer& out, const text::Diagnostic& why) {
  refuse(out, why.message);
  console::Diagnostic& d = *out.add_problems()->mutable_diagnostic();
  d.set_kind(why.kind);
  d.set_message(why.message);
  for (const std::string& hint : why.hints) d.add_hints(hint);
}

OpenConfiguration* opened(Desk& desk, const std::string& path, Answer& out) {
  OpenConfiguration* document = desk.find(path);
  if (document == nullptr) refuse(out, fmt::format("`{}` is not open", text::shown(path, 200)));
  return document;
}

OpenConfiguration* editable(Desk& desk, const std::string& path, Answer& out) {
  OpenConfiguration* document = opened(desk, path, out);
  if (document == nullptr || document->is_writable) return document;
  refuse(out, fmt::format("`{}` is read only: save it under another name, or make your own copy",
                          text::shown(path, 200)));
  return nullptr;
}

void add_location(const Model& model, const std::string& document, text::Span span, Answer& out) {
  const DrawnAt drawn = drawn_at(model, span.begin);
  Location& location = *out.mutable_location();
  location.set_document(document);
  location.set_begin(span.begin);
  location.set_end(span.end);
  location.set_page(drawn.page);
  location.set_node(drawn.node);
}

}  // namespace mlab::designer
