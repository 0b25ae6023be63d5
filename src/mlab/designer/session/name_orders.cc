#include "mlab/designer/session/name_orders.h"

#include <algorithm>
#include <utility>

#include "mlab/designer/edit/name_places.h"
#include "mlab/designer/session/desk_texts.h"
#include "mlab/text/utf8.h"

namespace mlab::designer {
namespace {

constexpr std::size_t kMostHits = 200;

void refuse_name(const project::NoAnswer& why, Answer& out) {
  refuse(out, why.why);
  if (why.path.empty()) return;
  Location& location = *out.mutable_location();
  location.set_document(why.path);
  location.set_begin(why.span.begin);
  location.set_end(why.span.end);
}

}  // namespace

NameOrders::NameOrders(Desk& desk, project::ProjectTexts& texts)
    : desk_(desk), texts_(texts), names_(texts, is_configuration) {}

std::optional<NameOrders::NamePlace> NameOrders::asked_name(const NameAt& at, Answer& out) {
  const OpenConfiguration* document = opened(desk_, at.document(), out);
  if (document == nullptr) return std::nullopt;
  const Model& model = at.is_drawn() ? *document->drawn : *document->model;
  const std::optional<std::uint32_t> cursor = at.is_drawn() ? name_place(model, at) : at.cursor();
  if (cursor) return NamePlace{{model.source(), assist::Language::kConfiguration}, *cursor};
  fail(out, {text::Severity::kError, "no-name", "this has no name of its own", {}, {}, {}, {}});
  return std::nullopt;
}

void NameOrders::find_uses(const FindUses& request, Answer& out) {
  // What has no name of its own is one of many.
  NameAt at = request.at();
  if (const OpenConfiguration* document = desk_.find(at.document());
      document != nullptr && at.is_drawn() && !name_place(*document->drawn, at))
    at.set_of_component(true);
  const std::optional<NamePlace> asked = asked_name(at, out);
  if (!asked) return;
  auto found = names_.uses(asked->text, asked->cursor);
  if (found)
    *out.mutable_uses() = std::move(*found);
  else
    refuse_name(found.error(), out);
}

void NameOrders::plan_rename(const PlanRename& request, Answer& out) {
  const std::optional<NamePlace> asked = asked_name(request.at(), out);
  if (!asked) return;
  auto found = names_.plan(asked->text, asked->cursor, request.name());
  if (found)
    *out.mutable_plan() = std::move(*found);
  else
    refuse_name(found.error(), out);
}

void NameOrders::rename_everywhere(const RenameEverywhere& request, Answer& out) {
  const std::optional<NamePlace> asked = asked_name(request.at(), out);
  if (!asked) return;
  auto done = names_.rename(asked->text, asked->cursor, request.name(), request.seal(), wall_time());
  if (done)
    *out.mutable_plan() = std::move(*done);
  else
    refuse_name(done.error(), out);
}

void NameOrders::undo_rename(Answer& out) {
  const project::Answer<bool> done = names_.take_back(wall_time());
  if (!done) refuse_name(done.error(), out);
}

void NameOrders::find_definition(const OpenConfiguration& document, std::uint32_t cursor, Answer& out) {
  const auto found = names_.definition({document.model->source(), assist::Language::kConfiguration}, cursor);
  if (!found) {
    refuse_name(found.error(), out);
    return;
  }
  const std::string path = desk_.document_of(found->source->name());
  if (path == document.path)
    add_location(*document.drawn, path, found->span, out);
  else
    add_location(Model(found->source, desk_.environment()), path, found->span, out);
}

void NameOrders::search(const Search& request, Answer& out) {
  index_.update(texts_.all(), texts_.surroundings());
  const std::size_t most = std::clamp<std::size_t>(request.most(), 1, kMostHits);
  names::HitList& list = *out.mutable_hits();
  list.set_left_out(texts_.left_out());
  for (const assist::ProjectIndex::Hit& found : index_.find(request.query(), most)) {
    const assist::Entry& entry = *found.entry;
    const std::string path = texts_.path_of(entry.source->name());
    names::Hit& hit = *list.add_hits();
    hit.set_name(text::as_utf8(entry.name));
    hit.set_kind(entry.kind);
    hit.set_detail(text::as_utf8(entry.detail));
    hit.set_within(text::as_utf8(entry.within));
    hit.set_help(text::as_utf8(entry.help));
    hit.set_path(text::as_utf8(path));
    hit.set_can_open(is_configuration(path));
    hit.set_begin(entry.span.begin);
    hit.set_end(entry.span.end);
    hit.set_line(entry.source->line_column(entry.span.begin).line);
  }
}

}  // namespace mlab::designer
