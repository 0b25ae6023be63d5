#include <algorithm>
#include <memory>

#include "mlab/lang/odl/lexer.h"
#include "mlab/lang/odl/odl.h"

namespace mlab::odl {
namespace {

// Mission files have these statements too.
bool is_shared_with_missions(Keyword k) {
  return k == Keyword::kScenario || k == Keyword::kMissionArea || k == Keyword::kLoadMap ||
         k == Keyword::kSet || k == Keyword::kObstacle || k == keyword_of(overlay::MeasureKind::kStartPoint);
}

}  // namespace

// A header decides. Without one, the file is an overlay where its first line that says which language it is,
// is one that only overlays have.
bool looks_like_odl(std::string_view text) {
  std::vector<Token> tokens;
  std::vector<Comment> comments;
  text::Diagnostics unread;
  lex(std::make_shared<const text::Source>("", std::string(text)), tokens, comments, unread);
  if (std::ranges::any_of(tokens, [](const Token& t) { return t.kind == TokenKind::kHeader; })) return true;
  const auto tells = [](const Token& t) {
    return t.starts_line && !is_shared_with_missions(t.keyword) && t.kind != TokenKind::kEnd;
  };
  const auto first = std::ranges::find_if(tokens, tells);
  return first != tokens.end() && starts_statement(first->keyword);
}

}  // namespace mlab::odl
