#include "mlab/lang/cdl/syntax/pieces.h"

#include <algorithm>

namespace mlab::cdl {
namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

}  // namespace

std::size_t Pieces::token_at(std::uint32_t byte) const {
  const auto found =
      std::ranges::lower_bound(lexed_.tokens, byte, {}, [](const Token& token) { return token.span.begin; });
  return std::min(static_cast<std::size_t>(found - lexed_.tokens.begin()), end());
}

std::size_t Pieces::piece_of_comment(std::size_t at) const {
  const auto owner =
      std::ranges::upper_bound(lexed_.tokens, static_cast<std::uint32_t>(at), {}, &Token::comments);
  return at + static_cast<std::size_t>(owner - lexed_.tokens.begin());
}

std::size_t Pieces::end_of_line(std::size_t token) const {
  std::size_t at = lexed_.tokens[token].comments;
  const std::size_t last = token < end() ? lexed_.tokens[token + 1].comments : at;
  std::uint32_t from = this->token(token).end;
  for (; at < last; ++at) {
    if (text({from, comment(at).begin}).find('\n') != std::string_view::npos) break;
    from = comment(at).end;
  }
  return at;
}

std::vector<std::size_t> Pieces::comments_behind(std::size_t token) const {
  std::vector<std::size_t> out;
  const auto add = [&](std::size_t one) {
    const std::size_t last = end_of_line(one);
    for (std::size_t at = lexed_.tokens[one].comments; at < last; ++at) out.push_back(at);
  };
  if (word(token) != "," || token == 0) add(token);
  if (word(token) != "," && token + 1 < end() && word(token + 1) == ",") add(token + 1);
  return out;
}

std::vector<std::size_t> Pieces::comments_before(std::size_t token) const {
  std::vector<std::size_t> out;
  std::size_t at = token == 0 ? 0 : end_of_line(token - 1);
  for (; at < lexed_.tokens[token].comments; ++at) out.push_back(at);
  return out;
}

std::vector<std::size_t> Pieces::help_before(std::size_t token) const {
  const std::vector<std::size_t> all = comments_before(token);
  std::size_t first = all.size();
  for (; first > 0; --first) {
    const text::Span span = comment(all[first - 1]);
    const std::string_view words = text(span);
    if (!words.starts_with("///") || words.starts_with("///<") || lines_behind(span) != 1) break;
  }
  return {all.begin() + static_cast<std::ptrdiff_t>(first), all.end()};
}

std::vector<std::size_t> Pieces::header() const {
  const std::vector<std::size_t> all = comments_before(0);
  std::size_t last = all.size();
  while (last > 0 && lines_behind(comment(all[last - 1])) < 2) --last;
  return {all.begin(), all.begin() + static_cast<std::ptrdiff_t>(last)};
}

std::uint32_t Pieces::begin_with_comments(std::size_t at) const {
  const std::vector<std::size_t> before = comments_before(at);
  return before.empty() ? token(at).begin : comment(before.front()).begin;
}

std::uint32_t Pieces::end_with_comments(std::size_t at) const {
  const std::vector<std::size_t> behind = comments_behind(at);
  return behind.empty() ? token(at).end : comment(behind.back()).end;
}

int Pieces::lines_before(text::Span piece) const {
  int out = 0;
  for (std::uint32_t at = piece.begin; at > 0 && is_blank(text_[at - 1]); --at) out += text_[at - 1] == '\n';
  return out;
}

int Pieces::lines_behind(text::Span piece) const {
  int out = 0;
  for (std::uint32_t at = piece.end; at < text_.size() && is_blank(text_[at]); ++at) out += text_[at] == '\n';
  return out;
}

}  // namespace mlab::cdl
