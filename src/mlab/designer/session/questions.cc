#include "mlab/designer/session/questions.h"

#include <fmt/core.h>

#include "mlab/assist/service.h"
#include "mlab/designer/drawing/shapes.h"
#include "mlab/designer/edit/edit.h"
#include "mlab/text/shown.h"
#include "mlab/text/utf8.h"

namespace mlab::designer {

namespace {

console::Completions completions_of(const assist::Completions& found) {
  console::Completions out;
  out.set_begin(found.replaced.begin);
  for (const assist::Candidate& one : found.candidates) {
    console::Completions::Item& item = *out.add_items();
    item.set_text(text::as_utf8(one.text));
    item.set_kind(one.kind);
    const bool has_both = !one.detail.empty() && !one.help.empty();
    item.set_help(text::as_utf8(one.detail + (has_both ? "\n" : "") + one.help));
  }
  return out;
}

}  // namespace

void Questions::fits(const Fits& request, Answer& out) {
  const OpenConfiguration* document = opened(desk_, request.document(), out);
  if (document == nullptr) return;
  *out.mutable_fits() = fitting(*document->drawn, request, desk_.offered(*document));
}

void Questions::describe(const Describe& request, Answer& out) {
  OpenConfiguration* document = opened(desk_, request.document(), out);
  if (document == nullptr) return;
  const std::vector<Offered> offered = desk_.offered(*document);
  const Offered* file = find_offered(offered, *document->drawn, request.component());
  const Model& model = file != nullptr ? *file->model : *document->drawn;
  const std::optional<Callable> component = model.components().find(request.component());
  if (!component) {
    refuse(out, fmt::format("nothing answers to `{}`", text::shown(request.component())));
    return;
  }
  *out.mutable_component() = palette_entry(*component, model, desk_.context(*document));
  out.mutable_component()->set_help(component->help);
  if (file == nullptr) return;
  out.mutable_component()->set_group("This project");
  out.mutable_component()->set_source(file->document);
}

void Questions::ask_language(const AskLanguage& request, Answer& out) {
  const OpenConfiguration* document = opened(desk_, request.document(), out);
  if (document == nullptr) return;
  const assist::Text text{document->model->source(), assist::Language::kConfiguration};
  switch (request.what()) {
    case AskLanguage::COMPLETE: {
      const assist::Completions found = assist::complete(text, request.cursor(), desk_.surroundings());
      *out.mutable_completions() = completions_of(found);
      return;
    }
    case AskLanguage::HOVER: {
      Hover& hover = *out.mutable_hover();
      const auto found = assist::hover(text, request.cursor(), desk_.surroundings());
      if (!found) return;
      hover.set_markdown(text::as_utf8(found->markdown));
      hover.set_begin(found->span.begin);
      hover.set_end(found->span.end);
      return;
    }
    case AskLanguage::DEFINITION:
      names_.find_definition(*document, request.cursor(), out);
      return;
    case AskLanguage::PAGE:
      add_location(*document->drawn, document->path, {request.cursor(), request.cursor()}, out);
      return;
    default:
      refuse(out, "this designer does not know that question");
  }
}

}  // namespace mlab::designer
