#include <algorithm>
#include <array>
#include <string>

#include "mlab/lang/odl/odl.h"

namespace mlab::odl {
namespace {

constexpr std::size_t kLineWidth = 100;  // a line is broken between points where it would grow past this
constexpr std::string_view kIndent = "    ";

class Printer {
 public:
  explicit Printer(const Tree& tree) : tree_(tree) {}

  std::string run() && {
    for (const Statement& statement : tree_.statements) print_statement(statement);
    print_leading_comments(tree_.tokens.back());
    end_line();
    return std::move(out_);
  }

 private:
  bool is_at_line_start() const { return out_.size() == line_begin_; }
  void end_line() {
    if (!is_at_line_start()) start_line();
  }
  void start_line() {
    out_ += '\n';
    line_begin_ = out_.size();
  }
  void blank_line() {
    end_line();
    if (!out_.empty() && !out_.ends_with("\n\n")) start_line();
  }

  void print_statement(const Statement& statement) {
    const Token& first = tree_.tokens[statement.first_token];
    const bool is_header = first.kind == TokenKind::kHeader;
    print_trailing_comment(first);
    if (is_header || after_header_) blank_line();
    after_header_ = is_header;
    print_leading_comments(first);
    if (statement.keyword == Keyword::kNone) {
      out_ += tree_.source->text(statement.span);
      line_begin_ = out_.rfind('\n') + 1;  // npos + 1 is 0
    } else {
      print_tokens(statement);
    }
  }

  // A comment on the line of the statement before stays there.
  void print_trailing_comment(const Token& next) {
    if (next.comments_begin == next.comments_end) return;
    const Comment& comment = tree_.comments[next.comments_begin];
    if (comment.starts_line || out_.empty()) return;
    out_ += "  ";
    out_ += tree_.source->text(comment.span);
  }

  void print_leading_comments(const Token& token) {
    if (token.kind == TokenKind::kEnd) print_trailing_comment(token);
    for (auto i = token.comments_begin; i < token.comments_end; ++i) {
      const Comment& comment = tree_.comments[i];
      if (!comment.starts_line) continue;
      if (comment.after_blank_line) blank_line();
      end_line();
      out_ += tree_.source->text(comment.span);
    }
    if (token.kind == TokenKind::kEnd) return;
    if (token.after_blank_line) blank_line();
    end_line();
  }

  void print_tokens(const Statement& statement) {
    const std::array lists = {&statement.centerline, &statement.points, &statement.route};
    std::array<std::size_t, lists.size()> next{};
    for (auto i = statement.first_token; i < statement.end_token; ++i) {
      if (i > statement.first_token) print_inner_comments(tree_.tokens[i]);
      std::size_t group = text_of(i).size();
      for (std::size_t list = 0; list < lists.size(); ++list) {
        if (next[list] == lists[list]->size() || (*lists[list])[next[list]].first_token != i) continue;
        group = point_length(i, (*lists[list])[next[list]++]);
        if (tree_.tokens[i].starts_line) continue_line();
      }
      if (out_.size() - line_begin_ + 1 + group > kLineWidth && i > statement.first_token) continue_line();
      separate();
      out_ += text_of(i);
      // What follows a string that was never closed would become part of it.
      if (tree_.tokens[i].kind == TokenKind::kString && (out_.back() != '"' || text_of(i).size() == 1))
        continue_line();
    }
  }

  std::size_t point_length(std::uint32_t first, const PointSyntax& point) const {
    const std::uint32_t count = token_count(point.form);
    std::size_t length = count - 1;
    for (std::uint32_t i = first; i < first + count; ++i) length += text_of(i).size();
    return length;
  }

  void continue_line() {
    if (is_at_line_start() || std::string_view(out_).substr(line_begin_) == kIndent) return;
    start_line();
    out_ += kIndent;
  }

  void separate() {
    if (!is_at_line_start() && out_.back() != ' ') out_ += ' ';
  }

  // Comments in the middle of a statement.
  void print_inner_comments(const Token& token) {
    for (auto i = token.comments_begin; i < token.comments_end; ++i) {
      const Comment& comment = tree_.comments[i];
      if (comment.starts_line) {
        continue_line();
      } else {
        out_ += "  ";
      }
      out_ += tree_.source->text(comment.span);
      start_line();
      out_ += kIndent;
    }
  }

  std::string_view text_of(std::uint32_t i) const {
    const Token& token = tree_.tokens[i];
    return token.keyword != Keyword::kNone ? spelling(token.keyword) : tree_.source->text(token.span);
  }

  const Tree& tree_;
  std::string out_;
  std::size_t line_begin_ = 0;
  bool after_header_ = false;
};

}  // namespace

std::string print(const Tree& tree) {
  return Printer(tree).run();
}

}  // namespace mlab::odl
