// Answers about one text: completion, hovering, layout, colours, diagnostics with their mends.

#include <algorithm>
#include <map>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "mlab/lsp/document.h"
#include "mlab/lsp/uri.h"

namespace mlab::lsp {

using Json = nlohmann::json;

namespace {

/// CompletionItemKind
int completion_kind(const std::string& kind) {
  static const std::map<std::string, int, std::less<>> kKinds = {
      {"keyword", 14}, {"assemblage", 3}, {"procedure", 3}, {"binding", 8},       {"class", 7},
      {"robot", 9},    {"operator", 24},  {"society", 9},   {"parameter", 6},     {"argument", 5},
      {"let", 6},      {"node", 6},       {"state", 20},    {"device", 10},       {"type", 25},
      {"unit", 11},    {"word", 12},      {"file", 17},     {"place", 18},        {"team", 9},
      {"option", 10},  {"value", 12},     {"color", 16},    {"body setting", 10}, {"overlay", 17}};
  const auto found = kKinds.find(kind);
  return found == kKinds.end() ? 1 : found->second;
}

}  // namespace

int symbol_kind(const std::string& kind) {
  static const std::map<std::string, int, std::less<>> kKinds = {
      {"assemblage", 12}, {"procedure", 12}, {"binding", 11},   {"class", 5},  {"robot", 19},
      {"operator", 25},   {"society", 2},    {"parameter", 26}, {"let", 13},   {"node", 13},
      {"state", 22},      {"device", 8},     {"type", 5},       {"place", 20}, {"team", 3},
      {"robot type", 5},  {"step", 24},      {"module", 2}};
  const auto found = kKinds.find(kind);
  return found == kKinds.end() ? 13 : found->second;
}

namespace {

std::string snippet_text(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '$' || c == '}' || c == '\\') out += '\\';
    out += c;
  }
  return out;
}

Json markdown(std::string text) {
  return {{"kind", "markdown"}, {"value", std::move(text)}};
}

}  // namespace

Json Server::completion(const Json& params) {
  const Document& in = document(params);
  const std::uint32_t at = cursor(in, params);
  const std::string_view all = in.text.source->text();
  const Json context = params.value("context", Json::object());
  const bool is_space = context.is_object() && context.value("triggerCharacter", Json()) == " ";
  const bool is_wordy =
      in.text.language == assist::Language::kConfiguration || in.text.language == assist::Language::kNetwork;
  // A space asks for something only where it is clear what follows.
  if (is_space && is_wordy) {
    constexpr std::string_view kAsking[] = {"= ",  "goto ", "by ", "is ",       "for ", "binds ", "use ",
                                            "-> ", "when ", "as ", "strength ", ": ",   "(",      ", "};
    const std::string_view before = all.substr(0, at);
    if (std::ranges::none_of(kAsking, [&](std::string_view word) { return before.ends_with(word); }))
      return nullptr;
  }
  const assist::Completions found = assist::complete(in.text, at, surroundings());
  const bool has_call = at < all.size() && all[at] == '(';
  Json items = Json::array();
  for (std::size_t i = 0; i < found.candidates.size(); ++i) {
    const assist::Candidate& one = found.candidates[i];
    std::string written = one.text;
    const bool is_call = one.is_call && !has_call && takes_snippets_;
    if (takes_snippets_) written = snippet_text(written);
    if (is_call) written += "($0)";
    if (one.has_more) written += " = ";
    Json item = {{"label", one.text},
                 {"kind", completion_kind(one.kind)},
                 {"sortText", fmt::format("{:05}", i)},
                 {"filterText", one.text},
                 {"insertTextFormat", takes_snippets_ ? 2 : 1},
                 {"textEdit", {{"range", range_json(*in.lines, found.replaced)}, {"newText", written}}}};
    item["detail"] = one.detail.empty() ? one.kind : one.detail;
    if (!one.help.empty()) item["documentation"] = markdown(one.help);
    items.push_back(std::move(item));
  }
  return {{"isIncomplete", found.is_cut}, {"items", std::move(items)}};
}

Json Server::hover(const Json& params) {
  const Document& in = document(params);
  const auto found = assist::hover(in.text, cursor(in, params), surroundings());
  if (!found) return nullptr;
  return {{"contents", markdown(found->markdown)}, {"range", range_json(*in.lines, found->span)}};
}

Json Server::signature_help(const Json& params) {
  const Document& in = document(params);
  const auto found = assist::signature(in.text, cursor(in, params), surroundings());
  if (!found) return nullptr;
  const LineIndex label(found->label);
  Json parts = Json::array();
  for (const assist::Signature::Part& part : found->parts) {
    parts.push_back(
        {{"label", {label.position(part.span.begin).character, label.position(part.span.end).character}},
         {"documentation", markdown(part.help)}});
  }
  const Json one = {
      {"label", found->label}, {"documentation", markdown(found->help)}, {"parameters", std::move(parts)}};
  return {{"signatures", Json::array({one})}, {"activeSignature", 0}, {"activeParameter", found->active}};
}

namespace {

Json symbol_json(const LineIndex& lines, const assist::Symbol& symbol) {
  // The name stands inside of the whole, as the protocol wants it.
  const text::Span whole{std::min(symbol.span.begin, symbol.name_span.begin),
                         std::max(symbol.span.end, symbol.name_span.end)};
  Json parts = Json::array();
  for (const assist::Symbol& part : symbol.parts) parts.push_back(symbol_json(lines, part));
  return {{"name", symbol.name},
          {"detail", symbol.detail},
          {"kind", symbol_kind(symbol.kind)},
          {"range", range_json(lines, whole)},
          {"selectionRange", range_json(lines, symbol.name_span)},
          {"children", std::move(parts)}};
}

}  // namespace

Json Server::document_symbols(const Json& params) {
  const Document& in = document(params);
  Json out = Json::array();
  for (const assist::Symbol& symbol : assist::symbols(in.text, surroundings()))
    out.push_back(symbol_json(*in.lines, symbol));
  return out;
}

Json Server::folding_ranges(const Json& params) {
  const Document& in = document(params);
  Json out = Json::array();
  for (const assist::Fold& one : assist::folds(in.text, surroundings())) {
    Json fold = {{"startLine", one.first - 1}, {"endLine", one.last - 1}};
    if (one.is_comment) fold["kind"] = "comment";
    out.push_back(std::move(fold));
  }
  return out;
}

Json Server::inlay_hints(const Json& params) {
  constexpr int kParameter = 2;
  const Document& in = document(params);
  const text::Span range = span_of(*in.lines, params.at("range"));
  Json out = Json::array();
  for (const assist::Hint& one : assist::hints(in.text, surroundings())) {
    if (one.at < range.begin || one.at > range.end) continue;
    const Json at = position_json(*in.lines, one.at);
    Json hint = {{"position", at}, {"label", one.text}, {one.is_unit ? "paddingLeft" : "paddingRight", true}};
    if (!one.is_unit) hint["kind"] = kParameter;
    if (!one.help.empty()) hint["tooltip"] = one.help;
    // Taking the hint over writes the unit, where the language has them.
    if (one.is_unit && in.text.language == assist::Language::kConfiguration)
      hint["textEdits"] =
          Json::array({{{"range", {{"start", at}, {"end", at}}}, {"newText", " " + one.text}}});
    out.push_back(std::move(hint));
  }
  return out;
}

Json Server::formatting(const Json& params) {
  const Document& in = document(params);
  text::Diagnostics unsaid;  // is told anyway
  const auto wanted = assist::formatted(in.text, unsaid);
  const std::string_view now = in.text.source->text();
  if (!wanted || *wanted == now) return Json::array();
  // Only what differs, by whole lines, so that the cursor stays where it is.
  std::size_t begin = 0;
  while (begin < now.size() && begin < wanted->size() && now[begin] == (*wanted)[begin]) ++begin;
  begin = begin == 0 ? 0 : now.rfind('\n', begin - 1) + 1;  // npos + 1 is 0
  std::size_t end = now.size();
  std::size_t wanted_end = wanted->size();
  while (end > begin && wanted_end > begin && now[end - 1] == (*wanted)[wanted_end - 1]) {
    --end;
    --wanted_end;
  }
  while (end < now.size() && end > 0 && now[end - 1] != '\n') {
    ++end;
    ++wanted_end;
  }
  const text::Span changed{static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
  return Json::array(
      {{{"range", range_json(*in.lines, changed)}, {"newText", wanted->substr(begin, wanted_end - begin)}}});
}

Json Server::semantic_tokens(const Json& params) {
  const Document& in = document(params);
  // By assist::Shade::Kind, into the legend of `initialize`.
  constexpr int kTypes[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
  Json data = Json::array();
  Position last;
  for (const assist::Shade& shade : assist::shades(in.text, surroundings())) {
    // A token stands on one line.
    for (std::uint32_t at = shade.span.begin; at < shade.span.end;) {
      const Position begin = in.lines->position(at);
      const std::uint32_t end = std::min(shade.span.end, in.lines->line(begin.line).end);
      const std::uint32_t length = end <= at ? 0 : in.lines->position(end).character - begin.character;
      if (length > 0) {
        const std::uint32_t from = begin.line == last.line ? last.character : 0;
        for (const std::uint32_t number :
             {begin.line - last.line, begin.character - from, length,
              static_cast<std::uint32_t>(kTypes[static_cast<std::size_t>(shade.kind)]),
              (shade.is_declaration ? 1U : 0U) | (shade.is_library ? 2U : 0U)})
          data.push_back(number);
        last = begin;
      }
      at = begin.line + 1 < in.lines->line_count() ? in.lines->line(begin.line + 1).begin : shade.span.end;
    }
  }
  return {{"data", std::move(data)}};
}

Json Server::diagnostic_json(const Document& in, const text::Diagnostic& problem, Locations& locations) {
  std::string message = problem.message;
  if (!problem.label.empty()) message += "\n" + problem.label;
  for (const std::string& hint : problem.hints) message += "\nhint: " + hint;
  const bool is_here = problem.place.source && problem.place.source->name() == in.text.source->name();
  Json related = Json::array();
  if (!is_here && problem.place.source) {
    message = fmt::format("in `{}`: {}", problem.place.source->name(), message);
    related.push_back({{"location", locations.at(problem.place)}, {"message", problem.message}});
  }
  for (const text::Note& note : problem.notes) {
    if (note.place.source)
      related.push_back({{"location", locations.at(note.place)}, {"message", note.message}});
  }
  text::Span span = is_here ? problem.place.span : text::Span{};
  // What is missing at a place is shown at the character beside it.
  if (span.begin == span.end && is_here) {
    const auto size = static_cast<std::uint32_t>(in.text.source->text().size());
    span.begin = std::min(span.begin, size);
    span.end = std::min(span.begin + 1, size);
  }
  return {{"range", range_json(*in.lines, span)},
          {"severity", static_cast<int>(problem.severity) + 1},
          {"code", problem.kind},
          {"source", "mlab"},
          {"message", message},
          {"relatedInformation", std::move(related)}};
}

Json Server::code_actions(const Json& params) {
  Document& in = document(params);
  const text::Span range = span_of(*in.lines, params.at("range"));
  const Json only = params.value("context", Json::object()).value("only", Json());
  const bool is_wanted = !only.is_array() || std::ranges::any_of(only, [](const Json& kind) {
    const auto* word = kind.get_ptr<const std::string*>();
    return word != nullptr && (word->empty() || *word == "quickfix");
  });
  if (!is_wanted) return Json::array();
  if (in.is_unchecked || in.known != in.text.source) {
    const Check check = check_of(in, false);
    tell(check, assist::problems(check.text, check.around));
  }
  const assist::Surroundings around = surroundings();
  Json out = Json::array();
  Locations locations(*this);
  for (const text::Diagnostic& problem : in.problems.items()) {
    const text::Span span = problem.place.span;
    if (problem.place.source == nullptr || span.begin > range.end ||
        range.begin > std::max(span.end, span.begin + 1))
      continue;
    for (const assist::Fix& fix : assist::fixes(in.text, problem, around)) {
      Json edits = Json::array();
      for (const assist::Splice& splice : fix.splices)
        edits.push_back({{"range", range_json(*in.lines, splice.span)}, {"newText", splice.text}});
      out.push_back({{"title", fix.title},
                     {"kind", "quickfix"},
                     {"diagnostics", Json::array({diagnostic_json(in, problem, locations)})},
                     {"edit", {{"changes", {{in.uri, std::move(edits)}}}}}});
    }
  }
  return out;
}

}  // namespace mlab::lsp
