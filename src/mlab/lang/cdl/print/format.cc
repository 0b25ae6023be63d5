#include "mlab/lang/cdl/print/format.h"

#include <algorithm>
#include <vector>

#include "mlab/lang/cdl/syntax/lexer.h"
#include "mlab/lang/cdl/syntax/parser.h"
#include "mlab/lang/cdl/types/units.h"

namespace mlab::cdl {
namespace {

constexpr std::size_t kLineWidth = 110;
constexpr std::size_t kLastOpenColumn = 60;  // what is set in farther starts near the left again
constexpr std::size_t kLastCommentColumn = 90;

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::ranges::find(words, word) != words.end();
}

/// Puts the tokens of one file on lines again.
class Formatter {
 public:
  explicit Formatter(std::string_view text) : text_(text), lexed_(lex(text)) { pair_braces(); }

  std::string run() {
    for (at_ = 0; at_ < lexed_.tokens.size(); ++at_) {
      const std::uint32_t first = at_ == 0 ? 0 : lexed_.tokens[at_ - 1].comments;
      for (std::uint32_t i = first; i < lexed_.tokens[at_].comments; ++i) put_comment(lexed_.comments[i]);
      if (lexed_.tokens[at_].kind != Token::Kind::kEnd) put_token();
    }
    if (!out_.empty() && !out_.ends_with('\n')) out_ += '\n';
    return aligned();
  }

 private:
  struct Open {
    char bracket = '{';
    bool is_flat = false;    // a block on one line
    std::size_t indent = 0;  // of the lines inside
    std::size_t outer = 0;   // of the line that holds the bracket
    std::size_t column = 0;  // right behind the bracket
  };

  std::string_view word(std::size_t i) const {
    const text::Span span = lexed_.tokens[i].span;
    return text_.substr(span.begin, span.end - span.begin);
  }
  std::string_view gap(std::uint32_t begin, std::uint32_t end) const {
    return text_.substr(begin, end - begin);
  }
  std::size_t column() const { return out_.size() - (out_.rfind('\n') + 1); }
  bool in_parentheses() const { return !open_.empty() && open_.back().bracket != '{'; }

  void pair_braces() {
    closers_.assign(lexed_.tokens.size(), 0);
    std::vector<std::size_t> openers;
    for (std::size_t i = 0; i < lexed_.tokens.size(); ++i) {
      if (word(i) == "{") openers.push_back(i);
      if (word(i) == "}" && !openers.empty()) {
        closers_[openers.back()] = i;
        openers.pop_back();
      }
    }
  }

  bool wants_space(std::size_t i) const {
    if (i == 0) return false;
    const std::string_view before = word(i - 1);
    const std::string_view here = word(i);
    if (is_one_of(here, {";", ",", ")", "]", ":", "."})) return false;
    if (is_one_of(before, {"(", "[", "."})) return false;
    if (here == "/" && is_in_unit(i)) return false;
    if (before == "/" && is_in_unit(i - 1)) return false;
    // `- 5` takes a number's opposite, `-5` is a number.
    if (before == "-" && is_sign(i - 1)) return lexed_.tokens[i].kind == Token::Kind::kNumber;
    if (here == "(" && lexed_.tokens[i - 1].kind == Token::Kind::kName)
      return is_one_of(before, {"not", "and", "or", "when", "by", "active", "in", "as", "of", "expect"});
    return true;
  }

  // Whether this `/` stands in the unit of a number or of a parameter: what the parser would take for one.
  bool is_in_unit(std::size_t i) const {
    const auto is = [&](std::size_t at, Token::Kind kind) {
      return at < lexed_.tokens.size() && lexed_.tokens[at].kind == kind;
    };
    if (i < 2 || !is(i - 1, Token::Kind::kName) || !is(i + 1, Token::Kind::kName)) return false;
    // `double [m/s]`; a list stands behind no name.
    if (word(i - 2) == "[")
      return i > 2 && is(i - 3, Token::Kind::kName) && !lexed_.tokens[i - 3].is_before_value;
    if (!is(i - 2, Token::Kind::kNumber)) return false;
    const bool is_glued = lexed_.tokens[i - 1].span.end == lexed_.tokens[i].span.begin &&
                          lexed_.tokens[i].span.end == lexed_.tokens[i + 1].span.begin;
    if (is(i + 2, Token::Kind::kPunctuation) && word(i + 2) == "(") return false;
    return is_glued || unit_named(std::string(word(i - 1)) + "/" + std::string(word(i + 1))).has_value();
  }

  // Whether this `-` stands before a value, and not between two.
  bool is_sign(std::size_t i) const {
    if (i == 0) return true;
    const Token::Kind before = lexed_.tokens[i - 1].kind;
    if (before == Token::Kind::kName) return lexed_.tokens[i - 1].is_before_value;
    return before == Token::Kind::kPunctuation && !is_one_of(word(i - 1), {")", "]", "}"});
  }

  // Places inside of a statement where a line may end before token i.
  bool may_break_before(std::size_t i) const {
    if (i == 0) return false;
    const bool is_operation =
        is_one_of(word(i), {"+", "*", "<", "<=", ">", ">=", "==", "!="}) || (word(i) == "-" && !is_sign(i));
    return word(i - 1) == "," || is_operation || is_one_of(word(i), {"and", "or", "active", "binds"});
  }

  // How wide the tokens are up to the next place where the line may end.
  std::size_t width_of_piece(std::size_t i) const {
    std::size_t width = 0;
    for (std::size_t k = i; k < lexed_.tokens.size() && width <= kLineWidth; ++k) {
      if (k > i && may_break_before(k)) break;
      width += word(k).size() + (k > i && wants_space(k) ? 1 : 0);
      if (is_one_of(word(k), {";", "{", "}"})) break;
    }
    return width;
  }

  // A block that its author wrote on one line stays there, where it fits and holds no comment.
  bool fits_on_one_line(std::size_t opener) const {
    const std::size_t closer = closers_[opener];
    if (closer == 0 || lexed_.tokens[opener].comments != lexed_.tokens[closer].comments) return false;
    const std::uint32_t begin = lexed_.tokens[opener].span.begin;
    if (gap(begin, lexed_.tokens[closer].span.end).find('\n') != std::string_view::npos) return false;
    std::size_t width = column();
    for (std::size_t k = opener; k <= closer && width <= kLineWidth; ++k)
      width += word(k).size() + (wants_space(k) ? 1 : 0);
    return width + 1 <= kLineWidth;  // and a `;` behind it
  }

  std::size_t block_indent() const {
    for (auto it = open_.rbegin(); it != open_.rend(); ++it) {
      if (it->bracket == '{') return it->indent;
    }
    return 0;
  }

  // Where a line starts whose first token is `i`, and which goes on with a statement.
  std::size_t continuation() const {
    if (in_parentheses() && open_.back().column <= kLastOpenColumn) return open_.back().column;
    return statement_indent_ + 4;
  }

  // Whether a statement, or the end of a block, starts at token i.
  bool starts_statement(std::size_t i) const {
    if (i == 0) return true;
    if (!open_.empty() && open_.back().is_flat) return false;
    if (in_parentheses()) return false;
    const std::string_view before = word(i - 1);
    if (before == "{" || before == ";" || word(i) == "}") return true;
    if (before != "}") return false;
    return !is_one_of(word(i),
                      {";", ",", ":", ")", "]", "{", "as", "active", "by", "and", "or", "in", "goto", "on"});
  }

  std::size_t statement_indent(std::size_t i) const {
    if (word(i) == "}" && !open_.empty()) return open_.back().outer;
    return block_indent() + (word(i) == "when" && !open_.empty() ? 2 : 0);
  }

  void break_line(std::size_t indent, std::uint32_t next_begin, bool may_be_blank) {
    if (out_.empty()) return;
    if (!out_.ends_with('\n')) out_ += '\n';
    const std::string_view between = gap(end_, next_begin);
    if (may_be_blank && std::ranges::count(between, '\n') > 1 && !out_.ends_with("\n\n")) out_ += '\n';
    out_.append(indent, ' ');
  }

  bool is_after_opener() const {
    return at_ > 0 && word(at_ - 1) == "{" && end_ == lexed_.tokens[at_ - 1].span.end;
  }

  void put_comment(const Comment& comment) {
    std::string_view words = gap(comment.span.begin, comment.span.end);
    words = words.substr(0, words.find_last_not_of(" \t\r\n") + 1);
    const bool is_line = words.starts_with("//");
    const bool own_line = out_.empty() || gap(end_, comment.span.begin).find('\n') != std::string_view::npos;
    if (own_line) {
      const bool is_end = lexed_.tokens[at_].kind == Token::Kind::kEnd;
      const bool is_statement = is_end || starts_statement(at_);
      std::size_t indent = is_statement ? statement_indent(at_) : continuation();
      if (word(at_) == "}" && is_statement) indent = block_indent();
      break_line(indent, comment.span.begin, !is_after_opener());
    } else if (!out_.ends_with('\n')) {
      out_ += is_line ? "  " : " ";
      if (is_line) trailing_.push_back(out_.size());
    }
    out_ += words;
    must_break_ = is_line || !comment.is_closed;
    follows_comment_ = true;
    end_ = comment.span.end;
  }

  void put_token() {
    const Token& token = lexed_.tokens[at_];
    const std::string_view here = word(at_);
    const bool was_broken = gap(end_, token.span.begin).find('\n') != std::string_view::npos;
    if (starts_statement(at_) && !(follows_comment_ && !must_break_ && !was_broken)) {
      break_line(statement_indent(at_), token.span.begin, here != "}" && !is_after_opener());
      statement_indent_ = statement_indent(at_);
    } else if (must_break_ ||
               (may_break_before(at_) && (was_broken || column() + 1 + width_of_piece(at_) > kLineWidth))) {
      break_line(is_one_of(here, {")", "]"}) ? statement_indent_ : continuation(), token.span.begin, false);
    } else if (wants_space(at_) || follows_comment_) {
      out_ += ' ';
    }
    track_brackets(here);
    out_ += here;
    if (is_one_of(here, {"(", "["})) open_.back().column = column();
    must_break_ = false;
    follows_comment_ = false;
    end_ = token.span.end;
  }

  void track_brackets(std::string_view here) {
    if (here == "{") {
      const std::size_t line = line_indent();
      open_.push_back({'{', fits_on_one_line(at_), line + 2, line, 0});
    } else if (here == "(" || here == "[") {
      open_.push_back({here[0], !open_.empty() && open_.back().is_flat, 0, 0, 0});
    } else if (is_one_of(here, {"}", ")", "]"}) && !open_.empty()) {
      open_.pop_back();
    }
  }

  // Of the line that is being written.
  std::size_t line_indent() const {
    const std::size_t start = out_.rfind('\n') + 1;
    const std::size_t first = out_.find_first_not_of(' ', start);
    return first == std::string::npos ? 0 : std::min(first - start, statement_indent_);
  }

  // Comments behind the code of neighbouring lines start in one column.
  std::string aligned() const {
    std::string out;
    std::size_t done = 0;
    const auto column_of = [&](std::size_t at) { return at - (out_.rfind('\n', at) + 1); };
    for (std::size_t first = 0; first < trailing_.size();) {
      std::size_t last = first;
      std::size_t widest = column_of(trailing_[first]);
      const bool is_opener = trailing_[first] > 2 && out_[trailing_[first] - 3] == '{';
      for (; !is_opener && last + 1 < trailing_.size(); ++last) {
        const std::string_view between =
            std::string_view(out_).substr(trailing_[last], trailing_[last + 1] - trailing_[last]);
        const std::size_t next = column_of(trailing_[last + 1]);
        if (std::ranges::count(between, '\n') != 1 || std::max(next, widest) > kLastCommentColumn) break;
        widest = std::max(widest, next);
      }
      for (; first <= last; ++first) {
        out.append(out_, done, trailing_[first] - done);
        out.append(widest - column_of(trailing_[first]), ' ');
        done = trailing_[first];
      }
    }
    return out.append(out_, done);
  }

  std::string_view text_;
  Tokens lexed_;
  std::vector<std::size_t> closers_;  // per `{`: index of its `}`
  std::string out_;
  std::size_t at_ = 0;
  std::uint32_t end_ = 0;  // of what was put last, in the source
  std::vector<Open> open_;
  std::size_t statement_indent_ = 0;
  std::vector<std::size_t> trailing_;  // in `out_`: comments behind code
  bool must_break_ = false;
  bool follows_comment_ = false;
};

}  // namespace

std::string laid_out(std::string_view text) {
  return Formatter(text).run();
}

std::optional<std::string> format(const text::SourcePtr& source, text::Diagnostics& sink) {
  const std::size_t errors_before = sink.error_count();
  parse(source, sink);
  if (sink.error_count() > errors_before) return std::nullopt;
  return laid_out(source->text());
}

}  // namespace mlab::cdl
