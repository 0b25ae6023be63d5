#include "mlab/project/project_names.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "mlab/text/shown.h"
#include "mlab/text/utf8.h"

namespace mlab::project {
namespace {

constexpr std::size_t kLongestPart = 120;  // of a line beside a name [bytes]

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

std::unexpected<NoAnswer> no_answer(std::string why) {
  return std::unexpected(NoAnswer{std::move(why), "", {}});
}

}  // namespace

ProjectNames::ProjectNames(ProjectTexts& texts, std::function<bool(const std::string& path)> can_show)
    : texts_(texts), renaming_(texts), can_show_(std::move(can_show)) {}

std::string ProjectNames::path_of(const text::SourcePtr& source) const {
  std::string out = texts_.path_of(source->name());
  return out.empty() ? source->name() : out;
}

names::File& ProjectNames::file_message(const text::SourcePtr& source,
                                        google::protobuf::RepeatedPtrField<names::File>& files) {
  const std::string path = path_of(source);
  if (files.empty() || files.rbegin()->path() != path) {
    names::File& file = *files.Add();
    file.set_path(text::as_utf8(path));
    file.set_can_open(can_show_(path));
    const documents::Document* document = texts_.open().store().find(path);
    file.set_is_unsaved(document != nullptr && (document->is_dirty() || !document->saved));
  }
  return *files.rbegin();
}

names::TextPlace ProjectNames::place_message(const text::Place& place) const {
  names::TextPlace out;
  const std::string path = path_of(place.source);
  out.set_path(text::as_utf8(path));
  out.set_can_open(can_show_(path));
  out.set_begin(place.span.begin);
  out.set_end(place.span.end);
  out.set_line(place.source->line_column(place.span.begin).line);
  return out;
}

Answer<text::Place> ProjectNames::definition(const assist::Text& text, std::uint32_t cursor) {
  const std::optional<text::Place> found = assist::definition(text, cursor, texts_.surroundings());
  if (!found || !found->source) return no_answer("this is declared in no text that could be shown");
  if (can_show_(texts_.path_of(found->source->name()))) return *found;
  return no_answer(fmt::format("it is declared in `{}`, line {}", text::shown(path_of(found->source), 200),
                               found->source->line_column(found->span.begin).line));
}

Answer<names::UseList> ProjectNames::uses(const assist::Text& text, std::uint32_t cursor) {
  const assist::Uses found = assist::uses(text, cursor, texts_.surroundings());
  if (found.name.empty()) return no_answer("there is no name here");
  names::UseList list;
  list.set_name(text::as_utf8(found.name));
  list.set_kind(found.kind);
  list.set_is_library(found.is_library);
  list.set_left_out(texts_.left_out());
  for (const assist::Use& use : found.places) {
    names::Use& message = *file_message(use.place.source, *list.mutable_files()).add_uses();
    message = use_message(use.place);
    message.set_kind(use.kind);
    message.set_within(text::as_utf8(use.within));
    message.set_is_declaration(use.is_declaration);
  }
  return list;
}

NoAnswer ProjectNames::refused(const assist::Refusal& refusal) const {
  NoAnswer out{text::as_utf8(refusal.message), "", refusal.place.span};
  if (!refusal.place.source) return out;
  const std::string path = texts_.path_of(refusal.place.source->name());
  out.path = can_show_(path) ? path : "";
  out.why = fmt::format("{} ({}, line {})", out.why, path,
                        refusal.place.source->line_column(refusal.place.span.begin).line);
  return out;
}

// Files by the names that people know them by.
void ProjectNames::add_notes(assist::Renaming& renaming, names::Plan& plan) const {
  for (std::string& note : renaming.notes) {
    for (const assist::Change& change : renaming.changes)
      replace_all(note, change.source->name(), path_of(change.source));
    for (const assist::Renaming::UnchangedFile& kept : renaming.kept)
      replace_all(note, kept.source->name(), path_of(kept.source));
    plan.add_notes(text::as_utf8(note));
  }
  if (std::string left_out = texts_.left_out(); !left_out.empty()) plan.add_notes(std::move(left_out));
}

Answer<ProjectNames::Planned> ProjectNames::planned(const assist::Text& text, std::uint32_t cursor,
                                                    const std::string& name) {
  auto found = assist::rename(text, cursor, name, texts_.surroundings());
  if (!found) return std::unexpected(refused(found.error()));
  Planned out{std::move(*found), {}};
  names::Plan& plan = out.message;
  plan.set_from(text::as_utf8(out.renaming.from));
  plan.set_kind(out.renaming.kind);
  plan.set_to(name);
  std::string sealed = name;
  for (const assist::Change& change : out.renaming.changes) {
    names::File& file = file_message(change.source, *plan.mutable_files());
    sealed += fmt::format("\n{}\n{}", file.path(), change.source->text());
    for (const assist::Splice& splice : change.splices) {
      names::Use& use = *file.add_uses();
      use = use_message({change.source, splice.span});
      use.set_becomes(splice.text);
    }
  }
  for (const assist::Renaming::UnchangedFile& kept : out.renaming.kept)
    file_message(kept.source, *plan.mutable_files()).set_kept(kept.why);
  add_notes(out.renaming, plan);
  plan.set_seal(documents::Drafts::digest(sealed));
  return out;
}

Answer<names::Plan> ProjectNames::plan(const assist::Text& text, std::uint32_t cursor,
                                       const std::string& name) {
  Answer<Planned> found = planned(text, cursor, name);
  if (!found) return std::unexpected(found.error());
  return std::move(found->message);
}

Answer<names::Plan> ProjectNames::rename(const assist::Text& text, std::uint32_t cursor,
                                         const std::string& name, const std::string& seal, double now) {
  Answer<Planned> found = planned(text, cursor, name);
  if (!found) return std::unexpected(found.error());
  if (found->message.seal() != seal) return no_answer("the project has changed meanwhile: look at it again");
  if (const text::Result<bool> done = renaming_.carry_out(found->renaming, name, now); !done)
    return no_answer(done.error().message);
  return std::move(found->message);
}

Answer<bool> ProjectNames::take_back(double now) {
  const text::Result<bool> done = renaming_.take_back(now);
  if (!done) return no_answer(done.error().message);
  return true;
}

}  // namespace mlab::project
