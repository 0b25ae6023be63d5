#include "mlab/lang/mdl/testing/check_print.h"

#include <algorithm>
#include <memory>
#include <vector>

#include <fmt/core.h>

#include "mlab/lang/mdl/mdl.h"
#include "mlab/lang/mdl/token.h"
#include "mlab/lang/mdl/tree.h"

namespace mlab::mdl {
namespace {

text::SourcePtr source_of(std::string_view name, std::string_view text) {
  return std::make_shared<const text::Source>(std::string(name), std::string(text));
}

// One spelling for all that mean the same; empty for what may be left out.
std::string canonical(const std::vector<Token>& tokens, std::size_t i, const text::Source& source) {
  const Token& t = tokens[i];
  const Token& next = tokens[std::min(i + 1, tokens.size() - 1)];
  const Token& after = tokens[std::min(i + 2, tokens.size() - 1)];
  const auto introduces = [&](TokenKind kind) {
    return next.kind == kind || (next.kind == TokenKind::kEquals && after.kind == kind);
  };
  if (t.word == Word::kFormation && introduces(TokenKind::kFormation)) return "";
  if (t.word == Word::kTechnique && introduces(TokenKind::kTechnique)) return "";
  if (t.kind == TokenKind::kEquals) return "";
  if (t.kind == TokenKind::kWord) return std::string(spelling(t.word));
  if (t.kind == TokenKind::kString || t.kind == TokenKind::kName) return std::string(source.text(t.span));
  return lower_case(source.text(t.span));
}

std::vector<std::string> words(const text::SourcePtr& source) {
  text::Diagnostics ignored;
  const std::vector<Token> tokens = lex(source, ignored).tokens;
  std::vector<std::string> out;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const bool is_boolean = tokens[i].kind == TokenKind::kBoolean;
    std::string word = is_boolean ? (tokens[i].value == 1 ? "on" : "off") : canonical(tokens, i, *source);
    const bool is_time_after_date =
        tokens[i].kind == TokenKind::kTime && i > 0 && tokens[i - 1].kind == TokenKind::kDate && !out.empty();
    if (is_time_after_date) {
      out.insert(out.end() - 1, std::move(word));
    } else if (!word.empty()) {
      out.push_back(std::move(word));
    }
  }
  return out;
}

std::vector<std::string> comments(const text::SourcePtr& source) {
  text::Diagnostics ignored;
  std::vector<std::string> out;
  for (const CommentToken& comment : lex(source, ignored).comments)
    out.emplace_back(source->text(comment.span));
  std::ranges::sort(out);
  return out;
}

}  // namespace

std::string what_print_changes(std::string_view text, bool& had_errors) {
  text::Diagnostics sink;
  const text::SourcePtr before = source_of("before", text);
  const Tree tree = parse(before, sink);
  had_errors = sink.has_errors();
  if (had_errors) return "";
  const text::SourcePtr after = source_of("after", print(tree));
  const Tree again = parse(after, sink);
  if (sink.has_errors())
    return fmt::format("what was printed has errors:\n{}{}", after->text(), text::render(sink));
  if (print(again) != after->text())
    return fmt::format("printed twice:\n{}--- and\n{}", after->text(), print(again));
  if (comments(before) != comments(after)) return fmt::format("comments differ in\n{}", after->text());
  const std::vector<std::string> old_words = words(before);
  const std::vector<std::string> new_words = words(after);
  const auto [old_at, new_at] = std::ranges::mismatch(old_words, new_words);
  if (old_at == old_words.end() && new_at == new_words.end()) return "";
  return fmt::format("{} became {} in\n{}", old_at == old_words.end() ? "nothing" : *old_at,
                     new_at == new_words.end() ? "nothing" : *new_at, after->text());
}

}  // namespace mlab::mdl
