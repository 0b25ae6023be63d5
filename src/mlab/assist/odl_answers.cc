// What is answered about overlays.

#include <algorithm>

#include <fmt/core.h>

#include "mlab/assist/languages.h"
#include "mlab/assist/statement_candidates.h"
#include "mlab/assist/statement_names.h"
#include "mlab/assist/words.h"
#include "mlab/lang/odl/grammar.h"
#include "mlab/lang/odl/odl.h"

namespace mlab::assist {
namespace {

bool names_place(const odl::Statement& statement) {
  const odl::Form form = odl::rule_of(statement.keyword).form;
  return odl::is_feature(statement.keyword) && (form == odl::Form::kNamed || form == odl::Form::kHallway);
}

bool names_file(odl::Keyword keyword) {
  return keyword == odl::Keyword::kLoadMap || keyword == odl::Keyword::kHeightmap ||
         keyword == odl::Keyword::kWaypointFile;
}

odl::Tree parsed(const Text& text) {
  text::Diagnostics unsaid;
  return odl::parse(text.source, unsaid);
}

}  // namespace

Completions complete_odl(const Text& text, std::uint32_t cursor, const Surroundings&) {
  return complete_statement(text.source->text().substr(0, cursor), StatementKind::kOverlay, {});
}

std::vector<Name> names_odl(const Text& text, const Surroundings&) {
  std::vector<Name> out;
  for (const odl::Statement& one : parsed(text).statements) {
    const bool is_place = names_place(one);
    if (one.name.text.empty() || (!is_place && !names_file(one.keyword))) continue;
    Name name;
    name.span = bare_name(text.source, one.name.span);
    name.kind = is_place ? NameKind::kPlace : NameKind::kFile;
    name.is_declaration = is_place;
    name.text = text.source->text(name.span);
    if (is_place) name.target = {text.source, name.span};
    out.push_back(std::move(name));
  }
  return out;
}

std::optional<Hover> hover_odl(const Text& text, std::uint32_t cursor, const Surroundings&) {
  const odl::Tree tree = parsed(text);
  for (const odl::Token& token : tree.tokens) {
    if (token.kind == odl::TokenKind::kEnd || token.span.begin > cursor || cursor > token.span.end) continue;
    const std::string_view help = odl_word_help(text.source->text(token.span));
    if (!help.empty() && token.keyword != odl::Keyword::kNone) return Hover{std::string(help), token.span};
  }
  for (const odl::Statement& one : tree.statements) {
    if (one.keyword == odl::Keyword::kNone || one.span.begin > cursor || cursor > one.span.end) continue;
    return Hover{fmt::format("```odl\n{}\n```\n\n{}", odl::rule_of(one.keyword).usage,
                             odl_word_help(odl::spelling(one.keyword))),
                 one.span};
  }
  return std::nullopt;
}

std::vector<Symbol> symbols_odl(const Text& text, const Surroundings&) {
  std::vector<Symbol> out;
  for (const odl::Statement& one : parsed(text).statements) {
    if (!names_place(one) || one.name.text.empty()) continue;
    out.push_back({one.name.text,
                   "place",
                   std::string(odl::spelling(one.keyword)),
                   one.span,
                   bare_name(text.source, one.name.span),
                   {}});
  }
  return out;
}

std::vector<Shade> tokens_odl(const Text& text) {
  const odl::Tree tree = parsed(text);
  std::vector<Shade> out;
  for (const odl::Comment& comment : tree.comments) out.push_back({comment.span, Shade::Kind::kComment});
  for (const odl::Token& token : tree.tokens) {
    if (token.keyword != odl::Keyword::kNone || token.kind == odl::TokenKind::kHeader) {
      out.push_back({token.span, Shade::Kind::kKeyword});
    } else if (token.kind == odl::TokenKind::kNumber) {
      out.push_back({token.span, Shade::Kind::kNumber});
    } else if (token.kind == odl::TokenKind::kString || token.kind == odl::TokenKind::kFile) {
      out.push_back({token.span, Shade::Kind::kText});
    }
  }
  return out;
}

}  // namespace mlab::assist
