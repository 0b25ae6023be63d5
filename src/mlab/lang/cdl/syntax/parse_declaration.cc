// What a file consists of: uses, assemblages, bindings, layouts. Robots and societies are in parse_robot.cc.

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

#include <fmt/core.h>

#include "mlab/lang/cdl/syntax/cursor.h"
#include "mlab/text/shown.h"

namespace mlab::cdl {
namespace {

bool parse_range(Cursor& cursor, Parameter& parameter) {
  if (!cursor.take("in")) return true;
  parameter.low = parse_quantity(cursor);
  if (!parameter.low || !cursor.expect("..", "between the least and the greatest value")) return false;
  parameter.high = parse_quantity(cursor);
  return parameter.high.has_value();
}

// `sphere: double [m] = 1 m in 0 .. 100`
bool parse_parameter(Cursor& cursor, std::vector<Parameter>& into) {
  Parameter parameter;
  const std::uint32_t begin = cursor.begin();
  parameter.help = cursor.help_above();
  if (!cursor.read_name(parameter.name, "the name of a parameter")) return false;
  bool is_whole = cursor.expect(":", "and the type of the parameter") &&
                  cursor.read_name(parameter.type, "the type of the parameter");
  if (is_whole) parameter.unit = cursor.take_unit();
  if (is_whole && cursor.take("=")) is_whole = parse_expression(cursor, parameter.initial);
  is_whole = is_whole && parse_range(cursor, parameter);
  if (const std::string behind = cursor.help_behind(); !behind.empty()) parameter.help = behind;
  parameter.whole = cursor.span_since(begin);
  if (cursor.keeps(is_whole)) into.push_back(std::move(parameter));
  return is_whole;
}

bool parse_result_type(Cursor& cursor, Word& into) {
  if (cursor.is(Token::Kind::kName) && !cursor.starts_line()) {
    cursor.expected("`->` before the type");
    return cursor.read_name(into, "the type");
  }
  return !cursor.take("->") || cursor.read_name(into, "the type behind `->`");
}

bool parse_alias(Cursor& cursor, Assemblage& into) {
  cursor.advance_word();
  Word name;
  name.place = cursor.here();
  const std::optional<std::string> text = cursor.read_text("the historic name, in quotes");
  if (!text) return false;
  name.text = *text;
  into.historic_names.push_back(std::move(name));
  return cursor.expect_semicolon("behind the alias");
}

bool parse_body(Cursor& cursor, Assemblage& into) {
  if (into.body) {
    if (text::Diagnostic* d = cursor.error("syntax", cursor.here(), "an assemblage has one body"))
      d->hints.emplace_back("`cooperate`, `compete` or `sequence` makes one of several");
    return false;
  }
  const bool is_word = cursor.is(Token::Kind::kName) && !cursor.is("not") && !at_block(cursor);
  if (is_word && (cursor.is_before("=") || cursor.is_before_name())) {
    cursor.expected("`let` or the body of the assemblage");
    return false;
  }
  const bool is_read = parse_expression(cursor, into.body);
  if (!cursor.keeps(is_read)) into.body = nullptr;
  if (!is_read) return false;
  if (cursor.is(":")) {
    if (text::Diagnostic* d = cursor.error("syntax", cursor.here(), "a member stands outside of an operator"))
      d->hints.emplace_back("members stand in `cooperate { ... }`, states in `sequence { ... }`");
    return false;
  }
  return cursor.at_close() || cursor.expect_semicolon("behind the body");
}

bool parse_assemblage_body(Cursor& cursor, Assemblage& into) {
  if (!cursor.open("the assemblage")) return false;
  into.has_braces = true;
  while (!cursor.at_close()) {
    const bool is_let = cursor.could_be({"let"}) && !cursor.is_before("(");
    const bool is_alias = !into.body && cursor.could_be({"alias"}) && !cursor.is_before("(");
    const bool is_read = is_let     ? parse_let(cursor, into.lets)
                         : is_alias ? parse_alias(cursor, into)
                                    : parse_body(cursor, into);
    if (!is_read) cursor.skip_statement();
  }
  cursor.close();
  return true;
}

bool parse_assemblage(Cursor& cursor, Tree& tree, const std::string& help) {
  Assemblage out;
  const std::uint32_t begin = cursor.begin();
  out.help = help;
  cursor.advance_word();
  bool is_whole = cursor.read_name(out.name, "the name of the assemblage") &&
                  ((parse_parameters(cursor, out.parameters) && parse_result_type(cursor, out.result_type)) ||
                   cursor.skip_to({"{", ";"}));
  if (is_whole && !cursor.take(";")) is_whole = parse_assemblage_body(cursor, out);
  return put(cursor, begin, std::move(out), is_whole, tree);
}

bool parse_binding(Cursor& cursor, Tree& tree, const std::string& help) {
  Binding out;
  const std::uint32_t begin = cursor.begin();
  out.help = help;
  cursor.advance_word();
  const bool is_read = cursor.read_name(out.name, "the name of the binding point") &&
                       parse_parameters(cursor, out.parameters) && parse_result_type(cursor, out.result_type);
  const bool is_whole = is_read && cursor.expect_semicolon("behind the binding point");
  put(cursor, begin, std::move(out), is_read, tree);
  return is_whole;
}

bool parse_use(Cursor& cursor, Tree& tree) {
  const std::uint32_t begin = cursor.begin();
  cursor.advance_word();
  Use out;
  out.path.place = cursor.here();
  std::optional<std::string> path = cursor.read_text("the name of a file, in quotes");
  if (cursor.keeps_parts() && !path && cursor.at_end()) tree.items.emplace_back(out);
  if (!path) return false;
  out.path.text = std::move(*path);
  const bool is_whole = cursor.expect_semicolon("behind the file");
  put(cursor, begin, std::move(out), true, tree);
  return is_whole;
}

bool parse_architecture(Cursor& cursor, Tree& tree) {
  const std::uint32_t begin = cursor.begin();
  cursor.advance_word();
  Architecture out;
  if (!cursor.read_name(out.name, "the name of the architecture")) {
    if (cursor.keeps_parts()) tree.items.emplace_back(std::move(out));
    return false;
  }
  const bool is_whole = cursor.expect_semicolon("behind the architecture");
  put(cursor, begin, std::move(out), true, tree);
  return is_whole;
}

// `note 40 200 "words"`, `frame 20 20 400 300 "words"`; the cursor stands behind the first two numbers.
bool parse_note(Cursor& cursor, LayoutNote note, std::uint32_t begin, Layout& layout) {
  if (cursor.is(Token::Kind::kNumber)) {
    const std::optional<double> width = cursor.read_number();
    const std::optional<double> height = width ? cursor.read_number() : std::nullopt;
    if (!height) return false;
    note.width = *width;
    note.height = *height;
  }
  while (cursor.is(Token::Kind::kText) || cursor.is(Token::Kind::kUnclosed)) {
    std::optional<std::string> line = cursor.read_text("words");
    if (!line) return false;
    note.lines.push_back(std::move(*line));
  }
  note.place = cursor.since(begin);
  const bool is_whole = cursor.expect_semicolon("behind the note");
  note.whole = cursor.span_since(begin);
  layout.notes.push_back(std::move(note));
  return is_whole;
}

// A node's place, or a note: `note` and `frame` may be names of nodes as well.
bool parse_layout_entry(Cursor& cursor, Layout& layout) {
  LayoutEntry entry;
  const std::uint32_t begin = cursor.begin();
  cursor.could_be({"note", "frame"});
  const bool has_name = read_path(cursor, entry.node, "the name of a node");
  if (!has_name && cursor.keeps_parts()) layout.entries.push_back(entry);
  if (!has_name) return false;
  const std::optional<double> x = cursor.read_number();
  const std::optional<double> y = x ? cursor.read_number() : std::nullopt;
  if (!y && cursor.keeps_parts()) layout.entries.push_back(entry);
  if (!y) return false;
  const bool is_word = entry.node.text == "note" || entry.node.text == "frame";
  if (is_word && !cursor.is(";")) {
    cursor.note_word(entry.node.place.span);
    LayoutNote note;
    note.is_frame = entry.node.text == "frame";
    note.x = *x;
    note.y = *y;
    return parse_note(cursor, std::move(note), begin, layout);
  }
  entry.x = *x;
  entry.y = *y;
  const bool is_whole = cursor.expect_semicolon("behind the place of the node");
  entry.whole = cursor.span_since(begin);
  layout.entries.push_back(std::move(entry));
  return is_whole;
}

bool parse_layout(Cursor& cursor, Tree& tree) {
  Layout out;
  const std::uint32_t begin = cursor.begin();
  cursor.advance_word();
  out.owner.place = cursor.place({cursor.begin(), cursor.begin()});
  const bool is_whole = (cursor.is("{") || read_path(cursor, out.owner, "the name of what is laid out")) &&
                        cursor.open("the layout");
  if (is_whole) {
    while (!cursor.at_close()) {
      if (!parse_layout_entry(cursor, out)) cursor.skip_statement();
    }
    cursor.close();
  }
  return put(cursor, begin, std::move(out), is_whole, tree);
}

bool refuse_item(Cursor& cursor) {
  const std::vector<std::string> words(std::begin(kDeclarationWords), std::end(kDeclarationWords));
  const std::string nearest =
      cursor.is(Token::Kind::kName) ? text::nearest_name(cursor.text(), words) : std::string();
  text::Diagnostic* d = cursor.is("}") ? cursor.error("syntax", cursor.here(), "this `}` closes nothing")
                                       : cursor.expected("a declaration");
  if (d != nullptr && !cursor.is("}")) {
    d->hints.push_back(nearest.empty()
                           ? "a declaration starts with `assemblage`, `robot`, `society`, `class`, ..."
                           : fmt::format("did you mean `{}`?", nearest));
  }
  return false;
}

}  // namespace

bool read_path(Cursor& cursor, Word& into, std::string_view what) {
  const std::uint32_t begin = cursor.begin();
  if (!cursor.read_name(into, what)) return false;
  while (cursor.take(".")) {
    Word next;
    const bool is_read = cursor.read_name(next, "a name behind `.`");
    into.text += "." + next.text;
    into.place = cursor.since(begin);
    if (!is_read) return false;
  }
  return true;
}

bool parse_let(Cursor& cursor, std::vector<Let>& into) {
  Let let;
  const std::uint32_t begin = cursor.begin();
  let.help = cursor.help_above();
  cursor.advance_word();
  if (!cursor.read_name(let.name, "a name behind `let`")) return false;
  const bool is_read =
      cursor.expect("=", "and what the name stands for") && parse_expression(cursor, let.value);
  if (!let.value) let.value = cursor.hole();
  const bool is_whole = is_read && cursor.expect_semicolon("behind what the name stands for");
  let.whole = cursor.span_since(begin);
  if (cursor.keeps(is_read)) into.push_back(std::move(let));
  return is_whole;
}

bool parse_parameters(Cursor& cursor, std::vector<Parameter>& into) {
  if (!cursor.expect("(", "before the parameters")) return false;
  if (cursor.take(")")) return true;
  do {
    if (!parse_parameter(cursor, into)) return false;
  } while (cursor.take(","));
  if (cursor.take(")")) return true;
  cursor.expected("`,` or `)` behind the parameter");
  return cursor.is("{") || cursor.is("->");
}

bool parse_item(Cursor& cursor, Tree& tree) {
  const std::string help = cursor.help_above();
  if (cursor.is("assemblage")) return parse_assemblage(cursor, tree, help);
  if (cursor.is("robot")) return parse_robot(cursor, tree, help);
  if (cursor.is("class")) return parse_class(cursor, tree, help);
  if (cursor.is("society")) return parse_society(cursor, tree, help);
  if (cursor.is("operator")) return parse_society_operator(cursor, tree, help);
  if (cursor.is("binding")) return parse_binding(cursor, tree, help);
  if (cursor.is("test")) return parse_test(cursor, tree, help);
  if (cursor.is("use")) return parse_use(cursor, tree);
  if (cursor.is("architecture")) return parse_architecture(cursor, tree);
  if (cursor.is("layout")) return parse_layout(cursor, tree);
  return refuse_item(cursor);
}

}  // namespace mlab::cdl
