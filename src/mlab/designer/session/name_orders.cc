#include "mlab/designer/session/name_orders.h"

#include <algorithm>

#include <fmt/core.h>

#include "mlab/designer/edit/name_places.h"
#include "mlab/text/shown.h"
#include "mlab/text/utf8.h"

namespace mlab::designer {
namespace {

constexpr std::size_t kMostHits = 200;
constexpr std::size_t kLongestPart = 120;  // of a line beside a name [bytes]

bool is_configuration(const std::string& path) {
  return path.ends_with(".cdl") || path.starts_with("new:");
}

void replace_all(std::string& text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
}

std::string beginning_of(std::string_view text) {
  if (text.size() > kLongestPart) text = text.substr(0, kLongestPart);
  return text::as_utf8(text);
}

std::string end_of(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  text.remove_prefix(std::min(begin, text.size()));
  if (text.size() > kLongestPart) text.remove_prefix(text.size() - kLongestPart);
  return text::as_utf8(text);
}

names::Use use_message(const text::Place& place) {
  names::Use out;
  const text::Source& source = *place.source;
  out.set_begin(place.span.begin);
  out.set_end(place.span.end);
  out.set_line(source.line_column(place.span.begin).line);
  const std::string_view all = source.text();
  const std::size_t before =
      place.span.begin == 0 ? std::string_view::npos : all.rfind('\n', place.span.begin - 1);
  const std::size_t begin = before == std::string_view::npos ? 0 : before + 1;
  const std::size_t end = std::min(all.find('\n', place.span.end), all.size());
  out.set_before(end_of(all.substr(begin, place.span.begin - begin)));
  out.set_name(text::as_utf8(source.text(place.span)));
  out.set_after(beginning_of(all.substr(place.span.end, end - place.span.end)));
  return out;
}

}  // namespace

std::optional<NameOrders::NamePlace> NameOrders::asked_name(const NameAt& at, Answer& out) {
  const OpenConfiguration* document = opened(desk_, at.document(), out);
  if (document == nullptr) return std::nullopt;
  const Model& model = at.is_drawn() ? *document->drawn : *document->model;
  const std::optional<std::uint32_t> cursor = at.is_drawn() ? name_place(model, at) : at.cursor();
  if (cursor) return NamePlace{{model.source(), assist::Language::kConfiguration}, *cursor};
  fail(out, {text::Severity::kError, "no-name", "this has no name of its own", {}, {}, {}, {}});
  return std::nullopt;
}

std::string NameOrders::path_of(const text::SourcePtr& source) const {
  std::string out = texts_.path_of(source);
  return out.empty() ? source->name() : out;
}

names::File& NameOrders::file_message(const text::SourcePtr& source,
                                      google::protobuf::RepeatedPtrField<names::File>& files) {
  const std::string path = path_of(source);
  if (files.empty() || files.rbegin()->path() != path) {
    names::File& file = *files.Add();
    file.set_path(text::as_utf8(path));
    file.set_can_open(is_configuration(path));
    const OpenConfiguration* document = desk_.find(path);
    file.set_is_unsaved(document != nullptr && (document->is_dirty() || !document->saved));
  }
  return *files.rbegin();
}

void NameOrders::find_uses(const FindUses& request, Answer& out) {
  // What has no name of its own is one of many.
  NameAt at = request.at();
  if (const OpenConfiguration* document = desk_.find(at.document());
      document != nullptr && at.is_drawn() && !name_place(*document->drawn, at))
    at.set_of_component(true);
  const std::optional<NamePlace> asked = asked_name(at, out);
  if (!asked) return;
  const assist::Uses found = assist::uses(asked->text, asked->cursor, texts_.surroundings());
  if (found.name.empty()) {
    refuse(out, "there is no name here");
    return;
  }
  names::UseList& list = *out.mutable_uses();
  list.set_name(text::as_utf8(found.name));
  list.set_kind(found.kind);
  list.set_is_library(found.is_library);
  list.set_left_out(texts_.left_out());
  for (const assist::Use& use : found.places) {
    names::Use& made = *file_message(use.place.source, *list.mutable_files()).add_uses();
    made = use_message(use.place);
    made.set_kind(use.kind);
    made.set_within(text::as_utf8(use.within));
    made.set_is_declaration(use.is_declaration);
  }
}

void NameOrders::refuse_name(const assist::Refusal& refusal, Answer& out) {
  refuse(out, text::as_utf8(refusal.message));
  if (!refusal.place.source) return;
  const std::string document = texts_.path_of(refusal.place.source);
  out.set_error(fmt::format("{} ({}, line {})", out.error(), document,
                            refusal.place.source->line_column(refusal.place.span.begin).line));
  Location& location = *out.mutable_location();
  location.set_document(is_configuration(document) ? document : "");
  location.set_begin(refusal.place.span.begin);
  location.set_end(refusal.place.span.end);
}

std::optional<assist::Renaming> NameOrders::plan(const NameAt& at, const std::string& name, Answer& out) {
  const std::optional<NamePlace> asked = asked_name(at, out);
  if (!asked) return std::nullopt;
  auto done = assist::rename(asked->text, asked->cursor, name, texts_.surroundings());
  if (!done) {
    refuse_name(done.error(), out);
    return std::nullopt;
  }
  names::Plan& plan = *out.mutable_plan();
  plan.set_from(text::as_utf8(done->from));
  plan.set_kind(done->kind);
  plan.set_to(name);
  std::string sealed = name;
  for (const assist::Change& change : done->changes) {
    names::File& file = file_message(change.source, *plan.mutable_files());
    sealed += fmt::format("\n{}\n{}", file.path(), change.source->text());
    for (const assist::Splice& splice : change.splices) {
      names::Use& use = *file.add_uses();
      use = use_message({change.source, splice.span});
      use.set_becomes(splice.text);
    }
  }
  for (const assist::Renaming::Kept& kept : done->kept)
    file_message(kept.source, *plan.mutable_files()).set_kept(kept.why);
  for (std::string& note : done->notes) {
    // Files by the names that people know them by.
    for (const assist::Change& change : done->changes)
      replace_all(note, change.source->name(), path_of(change.source));
    for (const assist::Renaming::Kept& kept : done->kept)
      replace_all(note, kept.source->name(), path_of(kept.source));
    plan.add_notes(text::as_utf8(note));
  }
  if (std::string left_out = texts_.left_out(); !left_out.empty()) plan.add_notes(std::move(left_out));
  plan.set_seal(documents::Drafts::digest(sealed));
  return std::move(*done);
}

void NameOrders::plan_rename(const PlanRename& request, Answer& out) {
  plan(request.at(), request.name(), out);
}

void NameOrders::rename_everywhere(const RenameEverywhere& request, Answer& out) {
  const std::optional<assist::Renaming> planned = plan(request.at(), request.name(), out);
  if (!planned) return;
  if (out.plan().seal() != request.seal()) {
    refuse(out, "the project has changed meanwhile: look at it again");
    return;
  }
  const text::Result<bool> done = renaming_.carry_out(*planned, request.name(), wall_time());
  if (!done) fail(out, done.error());
}

void NameOrders::undo_rename(Answer& out) {
  const text::Result<bool> done = renaming_.take_back(wall_time());
  if (!done) fail(out, done.error());
}

void NameOrders::search(const Search& request, Answer& out) {
  index_.update(texts_.all(), texts_.surroundings());
  const std::size_t most = std::clamp<std::size_t>(request.most(), 1, kMostHits);
  names::HitList& list = *out.mutable_hits();
  list.set_left_out(texts_.left_out());
  for (const assist::ProjectIndex::Hit& found : index_.find(request.query(), most)) {
    const assist::Entry& entry = *found.entry;
    const std::string path = texts_.path_of(entry.source);
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
