#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "mlab/lang/cnl/cursor.h"
#include "mlab/percept/sensors.h"

namespace mlab::cnl {
namespace {

const std::initializer_list<std::string_view> kSectionWords = {"once", "header", "body", "pend"};

bool parse_alias_port(Cursor& cursor, AliasDecl& alias) {
  AliasPort port;
  const auto name = cursor.expect_name("the historic name of an input");
  if (!name) return false;
  port.name = *name;
  port.unit = cursor.take_unit();
  if (!cursor.expect("=", "between the historic name and the input that it means")) return false;
  const auto input = cursor.expect_name("the input that the historic name means, or `none`");
  if (!input) return false;
  port.input = *input;
  alias.ports.push_back(std::move(port));
  return true;
}

// Behind `alias`: `NAME [unit] (HIST [unit] = input, ...)`.
bool parse_alias(Cursor& cursor, Procedure& procedure) {
  const auto name = cursor.expect_name("the historic name of the procedure");
  if (!name) return false;
  AliasDecl alias{*name, cursor.take_unit(), {}};
  if (cursor.take("(")) {
    do {
      if (cursor.is(")")) break;
      if (!parse_alias_port(cursor, alias)) return false;
    } while (cursor.take(","));
    if (!cursor.expect(")", "after the inputs of the alias")) return false;
  }
  procedure.aliases.push_back(std::move(alias));
  return true;
}

std::string sensor_names() {
  std::string out;
  for (std::size_t i = 0; i < percept::kSensors.size(); ++i) {
    const std::string_view before = i == 0 ? "" : i + 1 == percept::kSensors.size() ? " or " : ", ";
    out += fmt::format("{}`{}`", before, percept::kSensors[i].name);
  }
  return out;
}

// Behind `senses`: `SENSOR`, or `SENSOR within NUMBER_OR_INPUT`.
bool parse_need(Cursor& cursor, Procedure& procedure) {
  NeedDecl need;
  const auto name = cursor.expect_name(sensor_names());
  if (!name) return false;
  need.sensor = *name;
  const percept::SensorInfo* const sensor = percept::sensor_named(name->text);
  if (sensor == nullptr || !sensor->has_own_reach) {
    if (!cursor.expect("within", "and the range of the sensor")) return false;
    need.range = {std::string(cursor.text()), cursor.here()};
    if (cursor.is(Token::Kind::kNumber)) need.range.text = canonical_number(cursor.text());
    if (!cursor.is(Token::Kind::kNumber) && !cursor.is(Token::Kind::kName)) {
      cursor.expected("a range in metres, or the input that holds it");
      return false;
    }
    cursor.advance();
  }
  procedure.needs.push_back(std::move(need));
  return true;
}

bool parse_latency(Cursor& cursor, Procedure& procedure) {
  const text::Place at = cursor.here();
  const auto cycles = cursor.expect_number("the latency in cycles");
  if (!cycles) return false;
  procedure.latency = 1;
  if (*cycles >= 1 && *cycles <= 1e6 && *cycles == static_cast<int>(*cycles)) {
    procedure.latency = static_cast<int>(*cycles);
  } else {
    cursor.error("bad-latency", at, "a latency is a whole number of cycles, 1 or more");
  }
  return true;
}

// Everything between the name and `with`.
bool parse_attributes(Cursor& cursor, Procedure& procedure) {
  while (!cursor.at_end() && !cursor.is("with")) {
    cursor.line(2);
    if (cursor.is("pure")) {
      procedure.is_pure = true;
      procedure.pure = {"pure", cursor.here()};
      cursor.advance();
    } else if (cursor.take("latency")) {
      if (!parse_latency(cursor, procedure)) return false;
    } else if (cursor.take("senses")) {
      if (!parse_need(cursor, procedure)) return false;
    } else if (cursor.take("alias")) {
      if (!parse_alias(cursor, procedure)) return false;
    } else {
      cursor.expected("`with`, or one of `pure`, `latency`, `senses`, `alias`");
      return false;
    }
  }
  return true;
}

std::optional<InputDecl> parse_input(Cursor& cursor) {
  InputDecl input;
  cursor.line(2);
  const std::string help = cursor.doc_above().help;
  input.is_list = cursor.take("list");
  const auto type = cursor.expect_name("the type of an input");
  if (!type) return std::nullopt;
  input.type = *type;
  input.unit = cursor.take_unit();
  const auto name = cursor.expect_name("the name of the input");
  if (!name) return std::nullopt;
  input.name = *name;
  if (cursor.take("=")) {
    input.initial = cursor.expect_source("the value that the input has when nothing is linked to it");
    if (!input.initial) return std::nullopt;
  }
  if (!parse_range(cursor, input.low, input.high, input.range_place)) return std::nullopt;
  if (!cursor.expect(";", "after the input")) return input;
  input.help = cursor.doc_behind();
  if (input.help.empty()) input.help = help;
  return input;
}

void parse_inputs(Cursor& cursor, Procedure& procedure) {
  while (!cursor.at_end() && !cursor.is_any(kSectionWords) && !cursor.is_any(kDeclarationWords)) {
    if (auto input = parse_input(cursor)) {
      procedure.inputs.push_back(std::move(*input));
    } else {
      cursor.skip_past_semicolon_or_to(kSectionWords);
    }
  }
}

// A section word with something else on its line is C++; say so where the word is then missing.
void hint_at_lost_word(text::Diagnostic& diagnostic, std::string_view code, std::string_view word) {
  std::size_t at = 0;
  while (at < code.size()) {
    const std::size_t end = std::min(code.find('\n', at), code.size());
    std::string_view line = code.substr(at, end - at);
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    if (line.starts_with(word) && (line.size() == word.size() || !is_name(line.substr(0, word.size() + 1)))) {
      diagnostic.hints.push_back(fmt::format("`{}` counts only when it is alone on its line", word));
      return;
    }
    at = end + 1;
  }
}

struct SectionReader {
  Cursor& cursor;
  Procedure& procedure;

  std::optional<Code>& slot(std::string_view word) {
    return word == "once" ? procedure.once : word == "header" ? procedure.header : procedure.body;
  }
  static int rank(std::string_view word) { return word == "once" ? 0 : word == "header" ? 1 : 2; }

  bool said_missing = false;

  void missing(std::string_view word, text::Place at, std::string_view code) {
    if (std::exchange(said_missing, true)) return;
    auto& diagnostic =
        cursor.error("missing-section", std::move(at),
                     fmt::format("the procedure `{}` has no `{}` section", procedure.name.text, word));
    diagnostic.label = fmt::format("`{}` has to come before this", word);
    hint_at_lost_word(diagnostic, code, word);
  }

  // From the token `word` on. The place of the user code is known by lines alone: no word of C++ counts.
  void read(std::string word, text::Span word_span, std::uint32_t code_begin) {
    int last = -1;
    std::string_view last_code;
    for (;;) {
      const auto lines = cursor.raw_lines(code_begin, {"header", "body", "pend"});
      if (rank(word) == 1 && last > 1) {
        cursor.error("section-order", cursor.place(word_span), "`header` comes before `body`");
      } else if (rank(word) == 2 && !procedure.header) {
        missing("header", cursor.place(word_span), last_code);
      }
      if (slot(word)) {
        cursor.error("section-order", cursor.place(word_span), fmt::format("a second `{}` section", word))
            .hints.emplace_back("C++ code must not have this word alone on a line");
      } else {
        slot(word) = lines.code;
      }
      cursor.layout().lines.push_back({word_span.begin, 0, false});
      cursor.layout().raw.push_back(lines.code.place.span);
      last = rank(word);
      last_code = lines.code.text();
      if (lines.end_word.empty()) {
        auto& diagnostic = cursor.error("unclosed-procedure", procedure.name.place,
                                        fmt::format("the procedure `{}` has no `pend`", procedure.name.text));
        hint_at_lost_word(diagnostic, last_code, "pend");
        cursor.resume(lines.end_span.end);
        return;
      }
      if (lines.end_word == "pend") {
        if (!procedure.header) {
          missing("header", cursor.place(lines.end_span), last_code);
        } else if (!procedure.body) {
          missing("body", cursor.place(lines.end_span), last_code);
        }
        cursor.layout().lines.push_back({lines.end_span.begin, 0, false});
        cursor.resume(lines.end_span.end);
        return;
      }
      word = lines.end_word;
      word_span = lines.end_span;
      cursor.resume(word_span.begin);
      code_begin = cursor.code_start();
    }
  }
};

void parse_sections(Cursor& cursor, Procedure& procedure) {
  if (cursor.is("pend") || !cursor.is_any(kSectionWords)) {
    if (cursor.is("pend")) {
      cursor.error("missing-section", cursor.here(),
                   fmt::format("the procedure `{}` has neither `header` nor `body`", procedure.name.text));
      cursor.line(0);
      cursor.advance();
    } else {
      cursor.expected("an input, or `once`, `header`, `body`");
    }
    return;
  }
  SectionReader sections{cursor, procedure};
  sections.read(std::string(cursor.text()), cursor.token().span, cursor.code_start());
}

// After an error in the head of a procedure: to its `with`, or past its end.
bool find_with(Cursor& cursor) {
  cursor.skip_to({"with", "once", "header", "body", "pend", "procedure", "node"});
  return cursor.is_any({"with", "once", "header", "body", "pend"});
}

bool parse_head(Cursor& cursor, Procedure& procedure) {
  const auto type = cursor.expect_name("the type of the output");
  if (!type) return false;
  procedure.output_type = *type;
  procedure.output_unit = cursor.take_unit();
  const auto name = cursor.expect_name("the name of the procedure");
  if (!name) return false;
  procedure.name = *name;
  if (!parse_attributes(cursor, procedure)) return false;
  if (procedure.is_pure || procedure.latency || !procedure.needs.empty() || !procedure.aliases.empty())
    cursor.line(0);
  return cursor.expect("with", "before the inputs");
}

}  // namespace

bool parse_range(Cursor& cursor, std::optional<double>& low, std::optional<double>& high,
                 text::Place& place) {
  if (!cursor.is("in")) return true;
  const text::Span begin = cursor.token().span;
  cursor.advance();
  low = cursor.expect_number("the lowest value");
  if (!low || !cursor.expect("..", "between the lowest and the highest value")) return false;
  high = cursor.expect_number("the highest value");
  place = cursor.place({begin.begin, cursor.last_end()});
  return high.has_value();
}

void parse_procedure(Cursor& cursor, Tree& tree) {
  Procedure procedure;
  const Cursor::Doc doc = cursor.doc_above();
  procedure.help = doc.help;
  procedure.source = doc.source;
  cursor.line(0);
  procedure.is_external = cursor.take("external");
  procedure.is_new_style = cursor.is("nprocedure");
  if (procedure.is_external && procedure.is_new_style) {
    cursor.error("syntax", cursor.here(), "an `external` procedure is a `procedure`");
  }
  if (!cursor.take("procedure") && !cursor.take("nprocedure")) {
    cursor.expected("`procedure` after `external`");
    cursor.skip_to(kDeclarationWords);
    return;
  }
  const bool has_head = parse_head(cursor, procedure);
  if (!has_head && find_with(cursor)) cursor.take("with");
  parse_inputs(cursor, procedure);
  if (procedure.is_external) {
    cursor.line(0);
    if (!cursor.expect("pend", "after the inputs of an external procedure"))
      cursor.skip_to(kDeclarationWords);
  } else if (!has_head) {
    Procedure ignored = procedure;
    if (cursor.is_any(kSectionWords)) parse_sections(cursor, ignored);
  } else {
    parse_sections(cursor, procedure);
  }
  if (has_head) tree.items.emplace_back(std::move(procedure));
}

void parse_init(Cursor& cursor, Tree& tree) {
  cursor.line(0);
  const text::Place word = cursor.here();
  const auto lines = cursor.raw_lines(cursor.code_start(), {"iend"});
  if (lines.end_word.empty()) {
    cursor.error("unclosed-init", word, "`init` has no `iend`")
        .hints.emplace_back("`iend` counts only when it is alone on its line");
  }
  cursor.layout().raw.push_back(lines.code.place.span);
  cursor.layout().lines.push_back({lines.end_span.begin, 0, false});
  tree.items.emplace_back(Init{lines.code});
  cursor.resume(lines.end_span.end);
}

// `type <NAME, "format">;`
void parse_type(Cursor& cursor, Tree& tree) {
  cursor.line(0);
  cursor.advance();
  TypeDecl type;
  if (cursor.expect("<", "after `type`") && cursor.read_name(type.name, "the name of the type")) {
    if (cursor.take(",")) {
      if (!cursor.is(Token::Kind::kString)) {
        cursor.expected("the format of the type, a text in quotes");
        cursor.skip_past_semicolon_or_to(kDeclarationWords);
        return;
      }
      type.format = std::string(cursor.text().substr(1, cursor.text().size() - 2));
      cursor.advance();
    }
    if (cursor.expect(">", "after the type")) {
      cursor.expect(";", "after the type");
      tree.items.emplace_back(std::move(type));
      return;
    }
  }
  cursor.skip_past_semicolon_or_to(kDeclarationWords);
}

// `modulename = NAME;`, `module NAME;`
void parse_module(Cursor& cursor, Tree& tree) {
  cursor.line(0);
  ModuleDecl module;
  module.is_own = cursor.is("modulename");
  cursor.advance();
  if (module.is_own && !cursor.expect("=", "after `modulename`")) {
    cursor.skip_past_semicolon_or_to(kDeclarationWords);
    return;
  }
  if (const auto name = cursor.expect_name("the name of a module")) {
    module.name = *name;
    cursor.expect(";", "after the module");
    tree.items.emplace_back(std::move(module));
  } else {
    cursor.skip_past_semicolon_or_to(kDeclarationWords);
  }
}

}  // namespace mlab::cnl
