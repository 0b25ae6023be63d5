// Answers about names: where they are declared and used, and other names for them.

#include <algorithm>
#include <filesystem>
#include <map>
#include <system_error>

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

Json Server::location(const text::Place& place) const {
  for (const auto& [uri, one] : documents_) {
    if (one->text.source->name() == place.source->name())
      return {{"uri", uri}, {"range", range_json(LineIndex(place.source->text()), place.span)}};
  }
  return {{"uri", uri_of(file_of(place.source))},
          {"range", range_json(LineIndex(place.source->text()), place.span)}};
}

Json Server::definition(const Json& params) {
  const Document& in = document(params);
  const auto found = language::definition(in.text, cursor(in, params), surroundings());
  if (!found || file_of(found->source).empty()) return nullptr;
  return location(*found);
}

Json Server::references(const Json& params) {
  const Document& in = document(params);
  const std::uint32_t at = cursor(in, params);
  const language::Surroundings around = surroundings();
  const bool wants_declaration = params.value("context", Json::object()).value("includeDeclaration", true);
  const auto declared = language::definition(in.text, at, around);
  Json out = Json::array();
  for (const text::Place& place : language::references(in.text, at, all_texts(), around)) {
    const bool is_declaration =
        declared && declared->span == place.span && file_of(declared->source) == file_of(place.source);
    if (wants_declaration || !is_declaration) out.push_back(location(place));
  }
  return out;
}

Json Server::prepare_rename(const Json& params) {
  const Document& in = document(params);
  const auto found = language::renamable(in.text, cursor(in, params), surroundings());
  if (!found) return nullptr;
  return {{"range", range_json(*in.lines, *found)},
          {"placeholder", std::string(in.text.source->text(*found))}};
}

Json Server::rename(const Json& params) {
  const Document& in = document(params);
  const std::string name = params.at("newName");
  const auto changes = language::rename(in.text, cursor(in, params), name, all_texts(), surroundings());
  if (!changes) throw Failure{kRequestFailed, changes.error()};
  Json edits = Json::object();
  for (const language::Change& change : *changes) {
    const LineIndex lines(change.source->text());
    Json list = Json::array();
    for (const language::Splice& splice : change.splices)
      list.push_back({{"range", range_json(lines, splice.span)}, {"newText", splice.text}});
    const Json where = location({change.source, {0, 0}});
    edits[where["uri"].get<std::string>()] = std::move(list);
  }
  return {{"changes", std::move(edits)}};
}

}  // namespace mlab::lsp
