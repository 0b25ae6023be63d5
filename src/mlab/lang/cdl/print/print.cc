#include "mlab/lang/cdl/print/print.h"

#include <string_view>

#include "mlab/lang/cdl/print/format.h"
#include "mlab/lang/cdl/print/print_items.h"
#include "mlab/lang/cdl/syntax/help.h"

namespace mlab::cdl {
namespace {

/// Words and their lines; where lines end inside of a statement is the formatter's business.
class Lines {
 public:
  std::string laid_out() const { return cdl::laid_out(out_); }

  void word(std::string_view text) {
    if (!out_.empty() && !out_.ends_with('\n')) out_ += ' ';
    out_ += text;
  }
  void word(const Word& word) { this->word(word.text); }
  void quoted(const Word& word) { this->word('"' + word.text + '"'); }
  void line() {
    if (!out_.empty() && !out_.ends_with('\n')) out_ += '\n';
  }
  void paragraph() {
    line();
    if (!out_.empty()) out_ += '\n';
  }
  void help(const std::string& help) {
    for (const std::string& one : help_lines(help)) {
      line();
      out_ += one;
      line();
    }
  }
  void begin_parameter(const std::string& help) { help_ = help; }
  void end_parameter() {
    if (help_.empty()) return;
    word(help_behind(help_));
    line();
  }
  void separate() { line(); }
  bool wants_semicolon(const Expression& /*it ends what was said last*/) const {
    return !out_.ends_with('}');
  }

  // Nothing is taken over from anywhere, and everything is in its canonical order.
  void begin(const text::Place& /*of no matter*/) {}
  bool has(const text::SourcePtr& /*of no matter*/, text::Span /*of no matter*/) const { return false; }
  void take(const text::SourcePtr& /*of no matter*/, text::Span /*of no matter*/) {}
  std::optional<std::uint32_t> order(const text::Place& /*of no matter*/) const { return std::nullopt; }

  std::optional<std::uint32_t> order_of_body(const Expression& /*of no matter*/) const {
    return std::nullopt;
  }

 private:
  std::string out_;
  std::string help_;
};

}  // namespace

std::string print(const Tree& tree) {
  Lines lines;
  put_items(lines, tree.items);
  return lines.laid_out();
}

std::string print(const Expression& expression) {
  Lines lines;
  Printer(lines).put(expression);
  std::string text = lines.laid_out();
  while (text.ends_with('\n')) text.pop_back();
  return text;
}

}  // namespace mlab::cdl
