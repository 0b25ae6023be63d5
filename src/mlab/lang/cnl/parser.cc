#include "mlab/lang/cnl/parser.h"

#include <algorithm>

#include <fmt/core.h>

#include "mlab/lang/cnl/cursor.h"

namespace mlab::cnl {
namespace {

bool is_network_item(const Cursor& cursor) {
  return cursor.is_any({"node", "public", "remote", "parameter", "sequence", "select", "delay"});
}

// `#include "file"`
void parse_include(Cursor& cursor, Tree& tree) {
  cursor.line(0);
  const std::string_view line = cursor.text();
  const std::size_t open = line.find('"');
  const std::size_t close = open == std::string_view::npos ? open : line.find('"', open + 1);
  if (close == std::string_view::npos) {
    auto& diagnostic = cursor.error("syntax", cursor.here(), "expected `#include \"file\"`");
    if (line.find('<') != std::string_view::npos) {
      diagnostic.hints.emplace_back("headers of C++ are included within `init`");
    }
  } else {
    const std::uint32_t begin = cursor.token().span.begin;
    const text::Span span{begin + static_cast<std::uint32_t>(open) + 1,
                          begin + static_cast<std::uint32_t>(close)};
    tree.items.emplace_back(
        Include{{std::string(line.substr(open + 1, close - open - 1)), cursor.place(span)}, nullptr});
  }
  cursor.advance();
}

void parse_declaration(Cursor& cursor, Tree& tree) {
  if (cursor.is_any({"procedure", "nprocedure", "external"})) {
    parse_procedure(cursor, tree);
  } else if (cursor.is("init")) {
    parse_init(cursor, tree);
  } else if (cursor.is("type")) {
    parse_type(cursor, tree);
  } else {
    parse_module(cursor, tree);
  }
}

void parse_network_item(Cursor& cursor, Tree& tree) {
  if (cursor.is_any({"node", "public", "remote"})) {
    parse_node(cursor, tree);
  } else if (cursor.is("parameter")) {
    parse_parameter(cursor, tree);
  } else {
    parse_operator(cursor, tree);
  }
}

}  // namespace

Tree parse(const text::SourcePtr& source, text::Diagnostics& diagnostics, Layout* layout) {
  Layout own_layout;
  Layout& found = layout ? *layout : own_layout;
  Tree tree{source, {}};
  Cursor cursor(source, diagnostics, found);
  while (!cursor.at_end()) {
    if (cursor.is(Token::Kind::kDirective)) {
      parse_include(cursor, tree);
      continue;
    }
    const std::uint32_t before = cursor.token().span.begin;
    if (is_network_item(cursor)) {
      parse_network_item(cursor, tree);
    } else if (cursor.is_any(kDeclarationWords)) {
      parse_declaration(cursor, tree);
    } else {
      cursor.expected("a declaration or a node")
          .hints.emplace_back(
              "declarations start with `procedure`, `external`, `init`, `type`, `module`; nodes with `node`, "
              "`parameter`, "
              "`sequence`, `select`, `delay`");
      cursor.advance();
      cursor.skip_to(kDeclarationWords);
    }
    if (cursor.token().span.begin == before) cursor.advance();
  }
  const auto unclosed = std::ranges::find_if(found.comments, [](const Comment& c) { return !c.is_closed; });
  if (unclosed != found.comments.end()) {
    diagnostics.warning("unclosed-comment", {source, {unclosed->span.begin, unclosed->span.begin + 2}},
                        "the comment is not closed; everything after it is left out");
  }
  return tree;
}

}  // namespace mlab::cnl
