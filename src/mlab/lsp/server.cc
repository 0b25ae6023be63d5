// Messages: who is asked what, and when.

#include "mlab/lsp/server.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <system_error>
#include <utility>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "mlab/documents/store.h"
#include "mlab/lsp/document.h"
#include "mlab/lsp/edited_text.h"
#include "mlab/lsp/uri.h"

namespace mlab::lsp {

namespace fs = std::filesystem;

namespace {

std::vector<std::string> files_in(const std::string& folder) {
  std::vector<std::string> out;
  std::error_code failure;
  for (fs::directory_iterator it(folder.empty() ? "." : folder, failure), end; !failure && it != end;
       it.increment(failure)) {
    if (it->is_regular_file(failure)) out.push_back(it->path().filename().string());
    if (out.size() == Workspace::kMostFiles) break;
  }
  std::ranges::sort(out);
  return out;
}

std::optional<assist::Language> language_named(const std::string& id) {
  if (id == "mdl") return assist::Language::kMission;
  if (id == "odl") return assist::Language::kOverlay;
  if (id == "cnl") return assist::Language::kNetwork;
  if (id == "cdl") return assist::Language::kConfiguration;
  return std::nullopt;
}

}  // namespace

Position position_of(const nlohmann::json& json) {
  Position out;
  if (!json.is_object()) return out;
  const auto number = [&](const char* name) {
    const auto found = json.find(name);
    const bool is_number = found != json.end() && found->is_number_integer() && *found >= 0;
    return is_number
               ? static_cast<std::uint32_t>(std::min<std::uint64_t>(found->get<std::uint64_t>(), 0xffffffffU))
               : 0U;
  };
  out.line = number("line");
  out.character = number("character");
  return out;
}

std::pair<Position, Position> positions_of(const nlohmann::json& range) {
  if (!range.is_object()) return {};
  return {position_of(range.value("start", nlohmann::json())),
          position_of(range.value("end", nlohmann::json()))};
}

text::Span span_of(const LineIndex& lines, const nlohmann::json& range) {
  const auto [first, last] = positions_of(range);
  const std::uint32_t begin = lines.offset(first);
  return {begin, std::max(begin, lines.offset(last))};
}

Server::Server(Options options, Send send) : options_(std::move(options)), send_(std::move(send)) {}
Server::~Server() = default;

void Server::send(const Json& message) {
  send_(message.dump(-1, ' ', false, Json::error_handler_t::replace));
}

void Server::respond_error(const Json& id, int code, const std::string& message) {
  send({{"jsonrpc", "2.0"}, {"id", id}, {"error", {{"code", code}, {"message", message}}}});
}

void Server::refuse(const std::string& why) {
  respond_error(nullptr, kParseError, why);
}

void Server::receive(std::string_view message) {
  const Json parsed = Json::parse(message, nullptr, false);
  if (parsed.is_discarded()) {
    refuse("this is no JSON");
    return;
  }
  dispatch(parsed);
}

void Server::dispatch(const Json& message) {
  const bool is_object = message.is_object();
  const auto id = is_object && message.contains("id") ? message["id"] : Json(nullptr);
  const bool has_id = id.is_string() || id.is_number_integer();
  const bool has_method = is_object && message.contains("method") && message["method"].is_string();
  if (!has_method) {
    // What answers a request of ours would have a result; we ask nothing.
    const bool is_response = is_object && (message.contains("result") || message.contains("error"));
    if (!is_response) respond_error(has_id ? id : Json(nullptr), kInvalidRequest, "a message has a method");
    return;
  }
  const std::string method = message["method"];
  const Json params = message.contains("params") ? message["params"] : Json::object();
  if (!has_id) {
    if (message.contains("id")) {
      respond_error(nullptr, kInvalidRequest, "an id is a number or a text");
      return;
    }
    // Nobody waits for an answer to a notification; the editor's log is where people look.
    const auto log = [&](const std::string& why) {
      constexpr int kWarning = 2;
      send({{"jsonrpc", "2.0"},
            {"method", "window/logMessage"},
            {"params", {{"type", kWarning}, {"message", method + " was ignored: " + why}}}});
    };
    try {
      notice(method, params);
    } catch (const Failure& failure) {
      log(failure.message);
    } catch (const Json::exception& wrong) {
      log(wrong.what());
    }
    return;
  }
  answering_ = id.dump();
  was_cancelled_ = false;
  try {
    if (is_cancelled()) throw Failure{kRequestCancelled, "nobody waits for it any more"};
    Json result = answer(method, params);
    if (was_cancelled_) throw Failure{kRequestCancelled, "nobody waits for it any more"};
    send({{"jsonrpc", "2.0"}, {"id", id}, {"result", std::move(result)}});
  } catch (const Failure& failure) {
    respond_error(id, failure.code, failure.message);
  } catch (const Json::exception& wrong) {
    respond_error(id, kInvalidParams, wrong.what());
  }
}

Server::Json Server::answer(const std::string& method, const Json& params) {
  if (method == "initialize") {
    if (is_initialized_) throw Failure{kInvalidRequest, "it is initialized already"};
    return initialize(params);
  }
  if (!is_initialized_) throw Failure{kServerNotInitialized, "`initialize` comes first"};
  if (was_shut_down_) throw Failure{kInvalidRequest, "nothing but `exit` comes behind `shutdown`"};
  if (method == "shutdown") {
    was_shut_down_ = true;
    return nullptr;
  }
  using Handler = Json (Server::*)(const Json&);
  static const std::map<std::string, Handler, std::less<>> kHandlers = {
      {"textDocument/completion", &Server::completion},
      {"textDocument/hover", &Server::hover},
      {"textDocument/signatureHelp", &Server::signature_help},
      {"textDocument/definition", &Server::definition},
      {"textDocument/references", &Server::references},
      {"textDocument/prepareRename", &Server::prepare_rename},
      {"textDocument/rename", &Server::rename},
      {"textDocument/documentSymbol", &Server::document_symbols},
      {"textDocument/foldingRange", &Server::folding_ranges},
      {"textDocument/formatting", &Server::formatting},
      {"textDocument/codeAction", &Server::code_actions},
      {"textDocument/inlayHint", &Server::inlay_hints},
      {"textDocument/semanticTokens/full", &Server::semantic_tokens},
      {"workspace/symbol", &Server::workspace_symbols},
  };
  const auto found = kHandlers.find(method);
  if (found == kHandlers.end()) throw Failure{kMethodNotFound, fmt::format("there is no `{}` here", method)};
  return (this->*found->second)(params);
}

void Server::notice(const std::string& method, const Json& params) {
  if (method == "exit") {
    is_over_ = true;
    return;
  }
  if (!is_initialized_ || was_shut_down_) return;
  if (method == "textDocument/didOpen") open(params);
  if (method == "textDocument/didChange") change(params);
  if (method == "textDocument/didSave") save(params);
  if (method == "textDocument/didClose") close(params);
  if (method == "workspace/didChangeWatchedFiles") files_changed();
}

Server::Json Server::initialize(const Json& params) {
  if (!params.is_object()) throw Failure{kInvalidParams, "`initialize` takes an object"};
  is_initialized_ = true;
  const Json folders = params.value("workspaceFolders", Json());
  for (const Json& folder : folders.is_array() ? folders : Json::array()) {
    if (folder.is_object() && folder.contains("uri") && folder["uri"].is_string())
      workspace_.add_folder(path_of(folder["uri"].get<std::string>()));
  }
  const Json root = params.value("rootUri", Json());
  const bool has_folder = folders.is_array() && !folders.empty();
  if (!has_folder && root.is_string()) workspace_.add_folder(path_of(root.get<std::string>()));
  // Editors without such a question say nothing: who opens a folder in them trusts it to be read.
  const Json trusted = params.value(Json::json_pointer("/initializationOptions/trusted"), Json(true));
  if (options_.permission)
    options_.around.programs.permission = options_.permission(!trusted.is_boolean() || trusted.get<bool>());
  const Json snippets = params.value(
      Json::json_pointer("/capabilities/textDocument/completion/completionItem/snippetSupport"), Json(false));
  takes_snippets_ = snippets.is_boolean() && snippets.get<bool>();
  const Json edits =
      params.value(Json::json_pointer("/capabilities/workspace/workspaceEdit"), Json::object());
  takes_versions_ = edits.is_object() && edits.value("documentChanges", Json()) == true;
  takes_annotations_ = takes_versions_ && edits.contains("changeAnnotationSupport");
  const Json types = {"comment",   "keyword",  "number",     "string", "operator", "type", "function",
                      "parameter", "variable", "enumMember", "class",  "property", "macro"};
  return {{"capabilities",
           {{"positionEncoding", "utf-16"},
            {"textDocumentSync", {{"openClose", true}, {"change", 2}, {"save", {{"includeText", false}}}}},
            {"completionProvider",
             {{"triggerCharacters", {"(", "\"", "[", "=", " ", "<"}}, {"resolveProvider", false}}},
            {"signatureHelpProvider", {{"triggerCharacters", {"(", ","}}}},
            {"hoverProvider", true},
            {"definitionProvider", true},
            {"referencesProvider", true},
            {"renameProvider", {{"prepareProvider", true}}},
            {"documentSymbolProvider", true},
            {"workspaceSymbolProvider", true},
            {"foldingRangeProvider", true},
            {"inlayHintProvider", true},
            {"documentFormattingProvider", true},
            {"codeActionProvider", {{"codeActionKinds", {"quickfix"}}}},
            {"semanticTokensProvider",
             {{"legend", {{"tokenTypes", types}, {"tokenModifiers", {"declaration", "defaultLibrary"}}}},
              {"full", true},
              {"range", false}}}}},
          {"serverInfo", {{"name", "mlab"}, {"version", options_.version}}}};
}

void Server::open(const Json& params) {
  const Json& item = params.at("textDocument");
  const std::string uri = item.at("uri");
  auto made = std::make_unique<Document>();
  made->uri = uri;
  made->version = item.value("version", std::int64_t{0});
  made->text.source = std::make_shared<const text::Source>(path_of(uri), "");
  made->set(item.at("text").get<std::string>());
  const auto told = assist::language_of(*made->text.source);
  const auto named = language_named(item.value("languageId", std::string()));
  made->text.language = named ? *named : told.value_or(assist::Language::kConfiguration);
  documents_[uri] = std::move(made);
  files_changed();
}

// Each change is made to what the one before it left; all of them, or none.
void Server::change(const Json& params) {
  Document& in = document(params);
  const std::int64_t version = params.at("textDocument").value("version", in.version);
  EditedText now(in.text.source->text());
  for (const Json& one : params.at("contentChanges")) {
    const auto with = one.at("text").get<std::string>();
    if (one.contains("range")) {
      const auto [begin, end] = positions_of(one["range"]);
      now.replace(begin, end, with);
    } else {
      now = EditedText(with);
    }
    if (now.size() > text::Source::kMaxBytes) throw Failure{kInvalidParams, "the text is too long"};
  }
  in.set(now.text());
  in.version = version;
  files_changed();
}

void Server::save(const Json& params) {
  document(params).has_unchecked_code = true;
  files_changed();
}

void Server::close(const Json& params) {
  const std::string uri = params.at("textDocument").at("uri");
  if (documents_.erase(uri) == 0) return;
  send({{"jsonrpc", "2.0"},
        {"method", "textDocument/publishDiagnostics"},
        {"params", {{"uri", uri}, {"diagnostics", Json::array()}}}});
  files_changed();
}

// Any text may use any other.
void Server::files_changed() {
  for (const auto& [uri, one] : documents_) one->is_unchecked = true;
}

Server::Document& Server::document(const Json& params) {
  const std::string uri = params.at("textDocument").at("uri");
  const auto found = documents_.find(uri);
  if (found == documents_.end()) throw Failure{kInvalidParams, "this text is not open"};
  return *found->second;
}

std::uint32_t Server::cursor(const Document& in, const Json& params) const {
  return in.lines->offset(position_of(params.at("position")));
}

// The open texts as they stand now, above the files on disk: they may be read from any thread.
assist::Surroundings Server::surroundings() const {
  std::vector<text::SourcePtr> texts;
  for (const auto& [uri, one] : documents_) texts.push_back(one->text.source);
  assist::Surroundings out = options_.around;
  out.files = documents::with_texts(texts, options_.around.files, normal);
  out.list = [texts](const std::string& folder) {
    std::vector<std::string> names = files_in(folder);
    for (const text::SourcePtr& one : texts) {
      const fs::path path = one->name();
      if (normal(path.parent_path().string()) == normal(folder)) names.push_back(path.filename().string());
    }
    std::ranges::sort(names);
    const auto [first, last] = std::ranges::unique(names);
    names.erase(first, last);
    return names;
  };
  return out;
}

// All open texts, and those of the project's folders.
std::vector<assist::Text> Server::all_texts() {
  std::vector<assist::Text> out;
  std::set<std::string> open;
  for (const auto& [uri, one] : documents_) {
    out.push_back(one->text);
    open.insert(normal(one->text.source->name()));
  }
  for (assist::Text& one : workspace_.texts(open, options_.around.files)) out.push_back(std::move(one));
  return out;
}

assist::Surroundings Server::project() {
  assist::Surroundings out = surroundings();
  out.project = [this] { return all_texts(); };
  out.fixed = why_fixed;
  out.given_up = [this] { return is_cancelled(); };
  return out;
}

// Once it is, it stays so: what was found then is not the whole.
bool Server::is_cancelled() {
  if (!was_cancelled_ && options_.is_cancelled) was_cancelled_ = options_.is_cancelled(answering_);
  return was_cancelled_;
}

bool Server::has_work() const {
  return std::ranges::any_of(
      documents_, [](const auto& one) { return one.second->is_unchecked || one.second->has_unchecked_code; });
}

std::optional<Server::Check> Server::next_check() {
  // First what shows at once for all texts, then what takes the compiler.
  for (const bool checks_code : {false, true}) {
    for (const auto& [uri, one] : documents_) {
      if (checks_code ? one->has_unchecked_code : one->is_unchecked) return check_of(*one, checks_code);
    }
  }
  return std::nullopt;
}

Server::Check Server::check_of(Document& one, bool checks_code) const {
  one.is_unchecked = false;
  if (checks_code) one.has_unchecked_code = false;
  Check out{one.uri, one.text, surroundings()};
  out.around.checks_code = checks_code;
  return out;
}

void Server::tell(const Check& check, text::Diagnostics problems) {
  const auto found = documents_.find(check.uri);
  if (found == documents_.end() || found->second->text.source != check.text.source) return;
  Document& one = *found->second;
  one.problems = std::move(problems);
  one.known = check.text.source;
  Json diagnostics = Json::array();
  Locations locations(*this);
  for (const text::Diagnostic& problem : one.problems.items())
    diagnostics.push_back(diagnostic_json(one, problem, locations));
  send({{"jsonrpc", "2.0"},
        {"method", "textDocument/publishDiagnostics"},
        {"params", {{"uri", one.uri}, {"version", one.version}, {"diagnostics", std::move(diagnostics)}}}});
}

}  // namespace mlab::lsp
