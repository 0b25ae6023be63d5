#include <algorithm>
#include <memory>

#include "mlab/lang/mdl/mdl.h"
#include "mlab/lang/mdl/token.h"

namespace mlab::mdl {
namespace {

// Whoever has said nothing of himself in this much text is no mission.
constexpr std::size_t kBytesLookedAt = std::size_t{1} << 18;

// What no other language begins a statement with.
bool is_telling(const Token& token, const Token& next) {
  if (!token.first_on_line) return false;
  const bool names_something =
      next.kind == TokenKind::kName || next.kind == TokenKind::kString || next.kind == TokenKind::kFile;
  switch (token.word) {
    case Word::kOverlay:
    case Word::kNewRobot:
      return names_something;
    case Word::kUnit:
      return next.kind == TokenKind::kLess;
    default:
      return false;
  }
}

}  // namespace

bool looks_like_mdl(std::string_view text) {
  text::Diagnostics ignored;
  const auto source = std::make_shared<const text::Source>("", std::string(text.substr(0, kBytesLookedAt)));
  const std::vector<Token> tokens = lex(source, ignored).tokens;
  for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
    switch (tokens[i].kind) {
      case TokenKind::kMissionName:
      case TokenKind::kCommandList:
      case TokenKind::kImmediateCommand:
        return true;
      case TokenKind::kWord:
        if (is_telling(tokens[i], tokens[i + 1])) return true;
        break;
      case TokenKind::kName: {
        const bool is_overlay = equal_without_case(source->text(tokens[i].span), "CONTROL") &&
                                equal_without_case(source->text(tokens[i + 1].span), "MEASURES");
        if (is_overlay) return false;
        break;
      }
      default:
        break;
    }
  }
  return false;
}

}  // namespace mlab::mdl
