#include "mlab/lang/cnl/format.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include "mlab/lang/cnl/lexer.h"
#include "mlab/lang/cnl/parser.h"

namespace mlab::cnl {
namespace {

constexpr std::size_t kLongestOneLiner = 110;
constexpr int kContinuation = 4;

std::string_view trimmed_right(std::string_view text) {
  return text.substr(0, text.find_last_not_of(" \t\r\n") + 1);
}

/// Puts the tokens of one file on lines again. What a line starts with is what the parser said.
class Formatter {
 public:
  Formatter(std::string_view text, Layout layout) : text_(text), lexer_(text), layout_(std::move(layout)) {
    std::ranges::stable_sort(layout_.lines, {}, &LineStart::offset);
    keep_one_liners();
  }

  std::string run() {
    for (;;) {
      std::vector<Comment> comments;
      Token token = lexer_.next(end_, &comments);
      for (const Comment& comment : comments) put_comment(comment, token.span.begin);
      if (token.kind == Token::Kind::kEnd) break;
      if (piece(token.span) == "[") token.span.end = unit_end(token.span);
      put_token(token);
      put_raw(token);
    }
    if (!out_.empty() && !out_.ends_with('\n')) out_ += '\n';
    return aligned();
  }

 private:
  std::string_view piece(text::Span span) const { return text_.substr(span.begin, span.end - span.begin); }

  // Units hold anything; they end at their `]`.
  std::uint32_t unit_end(text::Span bracket) const {
    const std::size_t close = text_.find(']', bracket.end);
    return close < lexer_.line_end(bracket.end) ? static_cast<std::uint32_t>(close) + 1 : bracket.end;
  }

  // A node that its author wrote on one line stays on one, where it fits and holds no comment.
  void keep_one_liners() {
    for (const text::Span span : layout_.one_liners) {
      const std::string_view node = piece(span);
      const auto inside = [&](std::uint32_t offset) { return offset > span.begin && offset < span.end; };
      const auto first = std::ranges::partition_point(
          layout_.comments, [&](const Comment& c) { return c.span.begin < span.begin; });
      const bool has_comment = first != layout_.comments.end() && inside(first->span.begin);
      if (has_comment || node.find('\n') != std::string_view::npos || one_line_size(span) > kLongestOneLiner)
        continue;
      const auto from = std::ranges::partition_point(
          layout_.lines, [&](const LineStart& l) { return l.offset <= span.begin; });
      for (auto line = from; line != layout_.lines.end() && inside(line->offset); ++line)
        line->indent = kNoLine;
    }
  }

  // How long the node is once its spaces are as they should be.
  std::size_t one_line_size(text::Span span) const {
    std::size_t size = 0;
    std::string_view before;
    for (std::uint32_t at = span.begin; at < span.end && size <= kLongestOneLiner;) {
      const Token token = lexer_.next(at);
      size += piece(token.span).size() + (!before.empty() && wants_space(before, piece(token.span)) ? 1 : 0);
      before = piece(token.span);
      at = token.span.end;
    }
    return size;
  }

  static bool wants_space(std::string_view before, std::string_view after) {
    if (after == ";" || after == "," || after == ":" || after == ">" || after == ")") return false;
    return before != "<" && before != "(";
  }

  // The indent of the line that starts at this offset; kNoLine: none does.
  int line_indent(std::uint32_t offset) {
    while (next_line_ < layout_.lines.size() && layout_.lines[next_line_].offset < offset) ++next_line_;
    int indent = kNoLine;
    for (std::size_t i = next_line_; i < layout_.lines.size() && layout_.lines[i].offset == offset; ++i) {
      if (!layout_.lines[i].is_optional || is_broken_before(offset)) indent = layout_.lines[i].indent;
    }
    return indent;
  }

  // For a line that need not start: its author broke it here, or what comes before is long enough.
  bool is_broken_before(std::uint32_t offset) const {
    constexpr std::size_t kLongEnough = 80;
    const std::string_view gap = text_.substr(end_, offset > end_ ? offset - end_ : 0);
    return gap.find('\n') != std::string_view::npos || must_break_ ||
           out_.size() - (out_.rfind('\n') + 1) > kLongEnough;
  }

  // Ends the line, and keeps one of the blank lines that stood there.
  void break_line(std::uint32_t next_begin, int indent) {
    if (out_.empty()) return;
    if (!out_.ends_with('\n')) out_ += '\n';
    const std::string_view gap = text_.substr(end_, next_begin - end_);
    if (std::count(gap.begin(), gap.end(), '\n') > 1) out_ += '\n';
    out_.append(static_cast<std::size_t>(indent), ' ');
  }

  void put_comment(const Comment& comment, std::uint32_t token_begin) {
    const bool own_line = lexer_.starts_line(comment.span.begin);
    const std::string_view words = trimmed_right(piece(comment.span));
    if (own_line) {
      const int indent = line_indent(token_begin);
      break_line(comment.span.begin,
                 indent == kNoLine ? (token_begin < text_.size() ? kContinuation : 0) : indent);
    } else if (!out_.empty() && !out_.ends_with('\n')) {
      out_ += words.starts_with("//") ? "  " : " ";
      if (words.starts_with("//")) trailing_.push_back(out_.size());
    }
    out_ += words;
    must_break_ = words.starts_with("//") || !comment.is_closed;
    before_ = "*/";
    end_ = comment.span.end;
  }

  void put_token(const Token& token) {
    const int indent = line_indent(token.span.begin);
    const std::string_view words = trimmed_right(piece(token.span));
    if (indent != kNoLine) {
      break_line(token.span.begin, indent);
    } else if (must_break_) {
      out_ += '\n';
      out_.append(kContinuation, ' ');
    } else if (before_ == "," && piece({end_, token.span.begin}).find('\n') != std::string_view::npos) {
      out_ += '\n';
      out_.append(open_column_, ' ');
    } else if (!out_.empty() && wants_space(before_, words)) {
      out_ += ' ';
    }
    out_ += words;
    if (words == "(") open_column_ = out_.size() - (out_.rfind('\n') + 1);
    must_break_ = token.kind == Token::Kind::kDirective;
    before_ = words;
    end_ = token.span.end;
  }

  // Behind a section word: its user code, line by line as it stands.
  void put_raw(const Token& word) {
    if (next_raw_ >= layout_.raw.size()) return;
    const text::Span raw = layout_.raw[next_raw_];
    if (raw.begin != word.span.end && raw.begin != lexer_.next_line(word.span.end)) return;
    const std::string_view text = piece(word.span);
    if (text != "once" && text != "header" && text != "body" && text != "init") return;
    ++next_raw_;
    std::string_view code = piece(raw);
    out_ += '\n';
    if (raw.begin == word.span.end) {  // code on the line of the word moves to its own
      code.remove_prefix(std::min(code.find_first_not_of(" \t\r\n"), code.size()));
      if (!code.empty()) out_ += "  ";
    }
    out_ += code;
    if (!out_.ends_with('\n')) out_ += '\n';
    end_ = raw.end;
    must_break_ = false;
  }

  // Comments behind the code of neighbouring lines start in one column.
  std::string aligned() const {
    std::string out;
    std::size_t done = 0;
    const auto column = [&](std::size_t at) { return at - (out_.rfind('\n', at) + 1); };
    for (std::size_t first = 0; first < trailing_.size();) {
      std::size_t last = first;
      std::size_t widest = column(trailing_[first]);
      for (; last + 1 < trailing_.size(); ++last) {
        const auto begin = out_.begin() + static_cast<std::ptrdiff_t>(trailing_[last]);
        const auto end = out_.begin() + static_cast<std::ptrdiff_t>(trailing_[last + 1]);
        const std::size_t next = column(trailing_[last + 1]);
        if (std::count(begin, end, '\n') != 1 || next > kLastCommentColumn || widest > kLastCommentColumn)
          break;
        widest = std::max(widest, next);
      }
      for (; first <= last; ++first) {
        out.append(out_, done, trailing_[first] - done);
        out.append(widest - column(trailing_[first]), ' ');
        done = trailing_[first];
      }
    }
    return out.append(out_, done);
  }

  static constexpr int kNoLine = -1;
  static constexpr std::size_t kLastCommentColumn = 80;

  std::string_view text_;
  Lexer lexer_;
  Layout layout_;
  std::string out_;
  std::size_t next_line_ = 0;
  std::size_t next_raw_ = 0;
  std::uint32_t end_ = 0;  ///< of what was put last, in the source
  std::string_view before_;
  std::vector<std::size_t> trailing_;  ///< in `out_`: comments behind code
  std::size_t open_column_ = 0;        ///< right behind the last `(`
  bool must_break_ = false;
};

}  // namespace

std::optional<std::string> format(const text::SourcePtr& source, text::Diagnostics& diagnostics) {
  Layout layout;
  const std::size_t errors_before = diagnostics.error_count();
  parse(source, diagnostics, &layout);
  if (diagnostics.error_count() > errors_before) return std::nullopt;
  return Formatter(source->text(), std::move(layout)).run();
}

}  // namespace mlab::cnl
