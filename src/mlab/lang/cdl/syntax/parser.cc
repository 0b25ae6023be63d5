#include "mlab/lang/cdl/syntax/parser.h"

#include <algorithm>
#include <iterator>

#include "mlab/lang/cdl/syntax/cursor.h"

namespace mlab::cdl {

namespace {

Tree parse(Cursor& cursor) {
  Tree tree;
  tree.source = cursor.source();
  while (!cursor.at_end()) {
    if (!parse_item(cursor, tree)) cursor.skip_declaration();
  }
  return tree;
}

}  // namespace

Tree parse(const text::SourcePtr& source, text::Diagnostics& sink) {
  Cursor cursor(source, sink);
  return parse(cursor);
}

ExpressionPtr parse_value(const text::SourcePtr& source) {
  text::Diagnostics sink;
  Cursor cursor(source, sink);
  ExpressionPtr out;
  const bool is_whole = parse_expression(cursor, out) && cursor.at_end() && !sink.has_errors();
  return is_whole ? out : nullptr;
}

PartialFile read_as_written(const text::SourcePtr& source) {
  PartialFile out;
  text::Diagnostics unsaid;
  Cursor cursor(source, unsaid, &out);
  out.tree = parse(cursor);
  cursor.finish();
  return out;
}

bool looks_like_cdl(std::string_view text) {
  constexpr std::size_t kEnough = 1 << 16;
  const Tokens lexed = lex(text.substr(0, kEnough));
  if (lexed.tokens.size() < 3 || lexed.tokens[0].kind != Token::Kind::kName) return false;
  const auto piece = [&](std::size_t i) {
    const text::Span span = lexed.tokens[i].span;
    return text.substr(span.begin, span.end - span.begin);
  };
  const std::string_view first = piece(0);
  if (std::ranges::find(kDeclarationWords, first) == std::end(kDeclarationWords)) return false;
  if (first == "use" || first == "test") return lexed.tokens[1].kind == Token::Kind::kText;
  if (lexed.tokens[1].kind != Token::Kind::kName) return false;
  if (first == "architecture") return piece(2) == ";";
  if (first == "assemblage" || first == "binding") return piece(2) == "(";
  if (first == "society") return piece(2) == ":";
  if (first == "robot") return piece(2) == "(" || piece(2) == "{" || piece(2) == "is";
  return piece(2) == "{" || piece(2) == "(" || piece(2) == ".";
}

}  // namespace mlab::cdl
