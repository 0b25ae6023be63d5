// Answers about names: where they are declared and used, and other names for them.

#include <filesystem>
#include <system_error>
#include <utility>

#include <fmt/core.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "mlab/lsp/document.h"
#include "mlab/lsp/uri.h"

namespace mlab::lsp {

using Json = nlohmann::json;

// What the library declares stands in files of the installation.
std::string Server::file_of(const text::SourcePtr& source) const {
  constexpr std::string_view kLibrary = "library/";
  const std::string& name = source->name();
  if (!name.starts_with(kLibrary)) return name;
  if (options_.library_folder.empty()) return "";
  const std::string path = options_.library_folder + "/" + name.substr(kLibrary.size());
  std::error_code failure;
  return std::filesystem::is_regular_file(path, failure) ? path : "";
}

Json Server::Locations::at(const text::Place& place) {
  auto found = known_.find(place.source.get());
  if (found == known_.end()) {
    const text::SourcePtr& source = place.source;
    KnownSource known{source, server_.uri_for(source), LineIndex(source->text())};
    found = known_.emplace(source.get(), std::move(known)).first;
  }
  return {{"uri", found->second.uri}, {"range", range_json(found->second.lines, place.span)}};
}

std::string Server::uri_for(const text::SourcePtr& source) const {
  for (const auto& [uri, one] : documents_) {
    if (one->text.source->name() == source->name()) return uri;
  }
  return uri_of(file_of(source));
}

Json Server::definition(const Json& params) {
  const Document& in = document(params);
  const auto found = assist::definition(in.text, cursor(in, params), project());
  if (!found || file_of(found->source).empty()) return nullptr;
  return Locations(*this).at(*found);
}

Json Server::references(const Json& params) {
  const Document& in = document(params);
  const bool wants_declaration = params.value("context", Json::object()).value("includeDeclaration", true);
  Json out = Json::array();
  Locations locations(*this);
  for (const assist::Use& use : assist::uses(in.text, cursor(in, params), project()).places) {
    if (wants_declaration || !use.is_declaration) out.push_back(locations.at(use.place));
  }
  return out;
}

Json Server::prepare_rename(const Json& params) {
  const Document& in = document(params);
  const auto found = assist::renamable(in.text, cursor(in, params), project());
  if (!found) return nullptr;
  return {{"range", range_json(*in.lines, *found)},
          {"placeholder", std::string(in.text.source->text(*found))}};
}

void Server::show(const std::string& message) {
  constexpr int kInfo = 3;
  send({{"jsonrpc", "2.0"},
        {"method", "window/showMessage"},
        {"params", {{"type", kInfo}, {"message", message}}}});
}

// Of a text that is open, for the version that it was computed of.
Json Server::document_edit(const assist::Change& change, const std::string& annotation) const {
  const LineIndex lines(change.source->text());
  Json edits = Json::array();
  for (const assist::Splice& splice : change.splices) {
    Json edit = {{"range", range_json(lines, splice.span)}, {"newText", splice.text}};
    if (!annotation.empty()) edit["annotationId"] = annotation;
    edits.push_back(std::move(edit));
  }
  Json version = nullptr;
  for (const auto& [uri, one] : documents_) {
    if (one->text.source == change.source) version = one->version;
  }
  return {{"textDocument", {{"uri", uri_for(change.source)}, {"version", version}}},
          {"edits", std::move(edits)}};
}

Json Server::rename(const Json& params) {
  constexpr const char* kAnnotation = "rename";
  const Document& in = document(params);
  const std::string name = params.at("newName");
  const auto done = assist::rename(in.text, cursor(in, params), name, project());
  if (!done) {
    std::string why = done.error().message;
    if (const text::Place& place = done.error().place; place.source)
      why += fmt::format(" ({}:{})", place.source->name(), place.source->line_column(place.span.begin).line);
    throw Failure{kRequestFailed, std::move(why)};
  }
  std::string notes = fmt::format("{}", fmt::join(done->notes, "\n"));
  if (workspace_.is_cut())
    notes += fmt::format("{}files more than {} folders deep, or beyond the first {}, were not looked at",
                         notes.empty() ? "" : "\n", Workspace::kMostDepth, Workspace::kMostFiles);
  // Where other files change, or more follows from it, the editor is asked to show it first.
  const bool is_wide = done->changes.size() > 1 || !notes.empty();
  if (!notes.empty() && !takes_annotations_) show(notes);
  if (!takes_versions_) {
    Json changes = Json::object();
    for (const assist::Change& change : done->changes) {
      const Json edit = document_edit(change, "");
      changes[edit["textDocument"]["uri"].get<std::string>()] = edit["edits"];
    }
    return {{"changes", std::move(changes)}};
  }
  Json out = {{"documentChanges", Json::array()}};
  const bool is_annotated = takes_annotations_ && is_wide;
  for (const assist::Change& change : done->changes)
    out["documentChanges"].push_back(document_edit(change, is_annotated ? kAnnotation : ""));
  if (is_annotated) {
    out["changeAnnotations"][kAnnotation] = {
        {"label", fmt::format("Rename the {} `{}`", done->kind, done->from)},
        {"needsConfirmation", true},
        {"description", notes}};
  }
  return out;
}

Json Server::workspace_symbols(const Json& params) {
  constexpr std::size_t kMost = 200;
  const std::string query = params.at("query");
  index_.update(all_texts(), surroundings());
  Json out = Json::array();
  Locations locations(*this);
  const auto add = [&](const assist::Entry& one) {
    if (one.kind == "call" || one.kind == "file" || out.size() == kMost) return;
    Json symbol = {{"name", one.name},
                   {"kind", symbol_kind(one.kind)},
                   {"location", locations.at({one.source, one.span})}};
    if (!one.within.empty()) symbol["containerName"] = one.within;
    out.push_back(std::move(symbol));
  };
  if (query.empty()) {
    for (const assist::Entry* one : index_.all()) add(*one);
  } else {
    for (const assist::ProjectIndex::Hit& hit : index_.find(query, kMost * 2)) add(*hit.entry);
  }
  return out;
}

}  // namespace mlab::lsp
