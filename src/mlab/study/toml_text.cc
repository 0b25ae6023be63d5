#include "mlab/study/toml_text.h"

#include <cstdint>

namespace mlab::study {
namespace {

constexpr std::string_view kQuotes = R"(""")";

enum class In : std::uint8_t { kNothing, kComment, kText, kLiteral, kLines, kLiteralLines };

class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  std::optional<Unfit> run() {
    if (is_here("\xef\xbb\xbf")) at_ = 3;  // that it is UTF-8
    while (at_ < text_.size()) {
      const bool is_ascii = static_cast<unsigned char>(text_[at_]) < 0x80;
      if (!is_ascii && (in_ == In::kNothing || (in_ == In::kLines && is_behind_slash_)))
        return Unfit{at_, "characters beyond ASCII are in comments and in quotes only"};
      if (in_ == In::kNothing && is_quote(text_[at_]) && at_ > 0 && !may_stand_before_quotes(text_[at_ - 1]))
        return Unfit{at_, "quotes begin where a key or a value does"};
      if (const auto head = head_without_key()) return Unfit{*head, "a table's head has a key behind `[`"};
      step(text_[at_]);
    }
    return std::nullopt;
  }

 private:
  bool is_here(std::string_view words) const { return text_.substr(at_).starts_with(words); }
  void go_on(In in, std::size_t bytes) {
    in_ = in;
    at_ += bytes;
  }

  // The place behind a `[` at the begin of a line, where no key stands.
  std::optional<std::size_t> head_without_key() {
    if (in_ != In::kNothing) return std::nullopt;
    const char c = text_[at_];
    const bool is_first = is_line_fresh_;
    is_line_fresh_ = ends_line(c) || (is_first && (c == ' ' || c == '\t'));
    if (c != '[' || !is_first) return std::nullopt;
    std::size_t behind = at_ + (is_here("[[") ? 2 : 1);
    while (behind < text_.size() && (text_[behind] == ' ' || text_[behind] == '\t')) ++behind;
    if (behind >= text_.size() || begins_key(text_[behind])) return std::nullopt;
    return behind;
  }

  static bool begins_key(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_' || c == '"' || c == '\'';
  }

  static bool is_quote(char c) { return c == '"' || c == '\''; }
  // Quotes right behind anything else open nothing for toml++, which reads on behind them as if they were not
  // there.
  static bool may_stand_before_quotes(char c) {
    return std::string_view(" \t\n\v\f\r=[{,.\xbf\x85\xa8\xa9").contains(c);
  }

  void step(char c) {
    switch (in_) {
      case In::kNothing:
        begin(c);
        return;
      case In::kComment:
        is_line_fresh_ = ends_line(c);
        go_on(ends_line(c) ? In::kNothing : In::kComment, 1);
        return;
      case In::kText:
        end_of_one_line(c, '"');
        return;
      case In::kLiteral:
        end_of_one_line(c, '\'');
        return;
      case In::kLines:
        end_of_lines(c, kQuotes);
        return;
      case In::kLiteralLines:
        end_of_lines(c, "'''");
        return;
    }
  }

  void begin(char c) {
    is_behind_slash_ = false;
    if (c == '#')
      go_on(In::kComment, 1);
    else if (is_here(kQuotes))
      go_on(In::kLines, 3);
    else if (is_here("'''"))
      go_on(In::kLiteralLines, 3);
    else
      go_on(c == '"' ? In::kText : c == '\'' ? In::kLiteral : In::kNothing, 1);
  }

  // Some take more than `\n` for the end of a line.
  bool ends_line(char c) const {
    return (c >= '\n' && c <= '\r') || is_here("\xc2\x85") || is_here("\xe2\x80\xa8") ||
           is_here("\xe2\x80\xa9");
  }

  // What is not closed at the end of its line is an error, and nothing behind it is read.
  void end_of_one_line(char c, char quote) {
    if (c == '\\' && in_ == In::kText)
      go_on(in_, 2);
    else {
      is_line_fresh_ = c == '\n';
      go_on(c == quote || c == '\n' ? In::kNothing : in_, 1);
    }
  }

  void end_of_lines(char c, std::string_view quotes) {
    if (in_ == In::kLines && is_behind_slash_ && c != ' ' && c != '\t' && (c < '\n' || c > '\r')) {
      is_behind_slash_ = false;  // it is what the `\` stands before
      go_on(in_, 1);
    } else if (in_ == In::kLines && c == '\\') {
      is_behind_slash_ = true;
      go_on(in_, 1);
    } else if (is_here(quotes)) {
      std::size_t bytes = 3;  // and two that belong to the text
      while (bytes < 5 && at_ + bytes < text_.size() && text_[at_ + bytes] == quotes.front()) ++bytes;
      go_on(In::kNothing, bytes);
    } else {
      go_on(in_, 1);
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
  In in_ = In::kNothing;
  bool is_behind_slash_ = false;
  bool is_line_fresh_ = true;  // nothing but white space stands in it yet
};

}  // namespace

std::optional<Unfit> unfit_place(std::string_view text) {
  return Scanner(text).run();
}

}  // namespace mlab::study
