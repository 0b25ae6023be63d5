#include "mlab/lang/cdl/formula/formula_parser.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "mlab/lang/cdl/formula/formula.h"

namespace mlab::cdl {
namespace {

// Typographic signs of the report, and what they are here.
struct Spelling {
  std::string_view written;
  char meant;
};
constexpr Spelling kSpellings[] = {{"⟨", '<'},  {"⟩", '>'},  {"‘", '\''}, {"’", '\''},
                                   {"′", '\''}, {"`", '\''}, {"−", '-'}};

class Reader {
 public:
  Reader(text::SourcePtr source, text::Diagnostics& sink) : source_(std::move(source)), sink_(sink) {
    advance(0);
  }

  std::vector<Term> run() {
    std::vector<Term> out;
    while (!failed_ && sign_ != '\0') {
      if (sign_ != '\'' && sign_ != '{') {
        expected("a society `'...'` or a robot `{...}`");
        break;
      }
      out.push_back(society());
    }
    if (out.empty() && !failed_) expected("a society `'...'` or a robot `{...}`");
    return failed_ ? std::vector<Term>{} : std::move(out);
  }

 private:
  std::string_view text() const { return source_->text(); }

  // Looks at the sign from `offset` on, past blanks and comments.
  void advance(std::uint32_t offset) {
    at_ = offset;
    if (at_ == 0 && text().starts_with("\xef\xbb\xbf")) at_ = 3;
    for (;;) {
      while (at_ < text().size() && std::string_view(" \t\r\n\f\v").contains(text()[at_])) ++at_;
      const std::string_view rest = text().substr(at_);
      std::size_t end = 0;
      if (rest.starts_with("//"))
        end = rest.find('\n');
      else if (rest.starts_with("/*"))
        end = rest.find("*/", 2) == std::string_view::npos ? std::string_view::npos : rest.find("*/", 2) + 2;
      else
        break;
      at_ = static_cast<std::uint32_t>(end == std::string_view::npos ? text().size() : at_ + end);
    }
    sign_ = at_ < text().size() ? text()[at_] : '\0';
    end_ = at_ < text().size() ? at_ + 1 : at_;
    for (const Spelling& spelling : kSpellings) {
      if (!text().substr(at_).starts_with(spelling.written)) continue;
      sign_ = spelling.meant;
      end_ = at_ + static_cast<std::uint32_t>(spelling.written.size());
    }
  }
  void next() {
    last_end_ = end_;
    advance(end_);
  }

  text::Place here() const { return {source_, {at_, end_}}; }
  text::Place since(std::uint32_t begin) const { return {source_, {begin, last_end_}}; }

  text::Diagnostic* fail(std::string kind, const text::Place& place, std::string message) {
    if (failed_) return nullptr;
    failed_ = true;
    return &sink_.error(std::move(kind), place, std::move(message));
  }

  std::string found() const {
    if (at_ >= text().size()) return "the end of the text";
    std::uint32_t end = end_;
    while (end < text().size() && (static_cast<unsigned char>(text()[end]) & 0xC0U) == 0x80U) ++end;
    while (end < text().size() && end < at_ + 40 &&
           std::isalnum(static_cast<unsigned char>(text()[end - 1])) != 0 &&
           std::isalnum(static_cast<unsigned char>(text()[end])) != 0)
      ++end;
    return fmt::format("`{}`", text().substr(at_, end - at_));
  }
  text::Diagnostic* expected(std::string_view what) {
    return fail("formula-syntax", here(), fmt::format("expected {}, found {}", what, found()));
  }

  bool enter() {
    if (++depth_ <= kMaxFormulaDepth) return true;
    fail("nested-too-deep", here(),
         fmt::format("brackets stand in each other more than {} deep", kMaxFormulaDepth));
    return false;
  }

  // The subscript behind a letter; `p_1` is `p1`.
  int number(char letter, int smallest) {
    std::uint32_t i = end_;
    if (i < text().size() && text()[i] == '_') ++i;
    const std::uint32_t begin = i;
    std::int64_t value = 0;
    while (i < text().size() && text()[i] >= '0' && text()[i] <= '9') {
      if (value < 1'000'000'000) value = value * 10 + (text()[i] - '0');
      ++i;
    }
    if (i == begin) {
      text::Diagnostic* d = fail("formula-syntax", here(), fmt::format("`{}` has no number", letter));
      if (d != nullptr) d->hints = {fmt::format("each instance has one: `{}1`", letter)};
    } else if (value < smallest || value >= 1'000'000'000) {
      text::Diagnostic* d =
          fail("number-out-of-range", {source_, {at_, i}},
               fmt::format("`{}` is no number of an instance", text().substr(begin, i - begin)));
      if (d != nullptr) d->label = fmt::format("they are counted from {} to 999999999", smallest);
    }
    end_ = i;
    next();
    return static_cast<int>(value);
  }

  Term society() {
    Term out;
    const std::uint32_t begin = at_;
    if (sign_ == '{') return robot();
    if (!enter()) return out;
    const text::Place opener = here();
    next();
    if (sign_ != '/' && sign_ != '*') {
      expected("`/` for a caste or `*` for a team");
      return out;
    }
    out.symbol = sign_ == '/' ? Symbol::kCaste : Symbol::kTeam;
    out.number = number(sign_, 1);
    while (!failed_ && (sign_ == '{' || opens_society())) out.members.push_back(society());
    close(out, '\'', opener, begin, "a society `'...'`, a robot `{...}`");
    --depth_;
    return out;
  }

  // A quote opens a society where an operator follows, and closes one elsewhere.
  bool opens_society() const {
    if (sign_ != '\'') return false;
    Reader ahead(*this);
    ahead.next();
    return ahead.sign_ == '/' || ahead.sign_ == '*';
  }

  Term robot() {
    Term out;
    out.symbol = Symbol::kRobot;
    if (!enter()) return out;
    const text::Place opener = here();
    const std::uint32_t begin = at_;
    next();
    out.members.push_back(assemblage());
    if (!failed_ && sign_ != '}') {
      text::Diagnostic* d = expected("`}` behind the robot's assemblage");
      if (d != nullptr) {
        d->notes.push_back({"the robot opens here", opener});
        if (sign_ == '[' || sign_ == '<')
          d->hints = {"a robot has one assemblage: `[@1 ... ]` or another operator makes one of several"};
      }
    }
    if (!failed_) next();
    out.place = since(begin);
    --depth_;
    return out;
  }

  Term assemblage() {
    if (sign_ == '<') return behavior();
    if (sign_ == '[')
      return group("+-%@", ']', "`+`, `-`, `%` or `@`", "an assemblage `[...]`, a behavior `<...>`");
    expected("an assemblage `[...]` or a behavior `<...>`");
    return {};
  }

  Term behavior() {
    Term out;
    out.symbol = Symbol::kBehavior;
    if (!enter()) return out;
    const text::Place opener = here();
    const std::uint32_t begin = at_;
    next();
    if (sign_ == 'a') out.members.push_back(leaf(Symbol::kActive, 1));
    if (!failed_ && sign_ == 'm') {
      text::Diagnostic* d = fail("formula-syntax", here(), "a motor process without perception");
      if (d != nullptr) d->hints = {"`p0` is the empty percept: `<p0 m1>`"};
    }
    if (!failed_) out.members.push_back(percept());
    if (!failed_ && sign_ == 'm') out.members.push_back(leaf(Symbol::kMotor, 1));
    if (!failed_ && sign_ != '>') {
      text::Diagnostic* d = expected("a motor process `m1` or `>`");
      if (d != nullptr) {
        d->notes.push_back({"the behavior opens here", opener});
        if (sign_ == 'p' || sign_ == '(') d->hints = {"several percepts are a fusion: `(#1 p1 p2)`"};
        if (sign_ == 'a') d->hints = {"the active part stands first: `<a1 p1 m1>`"};
      }
    }
    if (!failed_) next();
    out.place = since(begin);
    --depth_;
    return out;
  }

  Term percept() {
    if (sign_ == 'p') return leaf(Symbol::kPercept, 0);
    if (sign_ == '(') return group("#=", ')', "`#` or `=`", "a percept `p1`, a group `(...)`");
    expected("a percept `p1` or `(...)`");
    return {};
  }

  Term leaf(Symbol symbol, int smallest) {
    Term out;
    out.symbol = symbol;
    const std::uint32_t begin = at_;
    out.number = number(sign_, smallest);
    out.place = since(begin);
    return out;
  }

  Term group(std::string_view letters, char closer, std::string_view wanted, std::string_view members) {
    Term out;
    if (!enter()) return out;
    const text::Place opener = here();
    const std::uint32_t begin = at_;
    next();
    if (sign_ == '\0' || !letters.contains(sign_)) {
      expected(wanted);
      return out;
    }
    for (const SymbolInfo& one : kSymbols) {
      if (one.letter == sign_) out.symbol = one.symbol;
    }
    out.number = number(sign_, 1);
    const bool is_percept = closer == ')';
    while (!failed_ && (is_percept ? sign_ == 'p' || sign_ == '(' : sign_ == '<' || sign_ == '['))
      out.members.push_back(is_percept ? percept() : assemblage());
    close(out, closer, opener, begin, members);
    --depth_;
    return out;
  }

  void close(Term& out, char closer, const text::Place& opener, std::uint32_t begin,
             std::string_view members) {
    if (failed_) return;
    if (sign_ != closer) {
      text::Diagnostic* d = expected(fmt::format("{} or `{}`", members, closer));
      if (d != nullptr) d->notes.push_back({fmt::format("{} opens here", info(out.symbol).plain), opener});
      return;
    }
    next();
    out.place = since(begin);
    if (out.members.size() >= 2) return;
    text::Diagnostic* d = fail("too-few-members", out.place,
                               fmt::format("`{}{}` has {}", info(out.symbol).letter, out.number,
                                           out.members.empty() ? "no members" : "one member"));
    if (d != nullptr)
      d->hints = {fmt::format("{} is of two or more; one alone stands without it", info(out.symbol).plain)};
  }

  text::SourcePtr source_;
  text::Diagnostics& sink_;
  std::uint32_t at_ = 0;
  std::uint32_t end_ = 0;
  std::uint32_t last_end_ = 0;
  char sign_ = '\0';
  int depth_ = 0;
  bool failed_ = false;
};

}  // namespace

std::vector<Term> parse_sentences(const text::SourcePtr& source, text::Diagnostics& sink) {
  return Reader(source, sink).run();
}

bool looks_like_formula(std::string_view text) {
  // Only the start counts: `{<`, `{[`, `'/1`, `'*1`.
  std::string start;
  for (std::size_t i = text.starts_with("\xef\xbb\xbf") ? 3 : 0; i < text.size() && start.size() < 3;) {
    if (text.substr(i).starts_with("//") && start.empty()) {
      i = text.find('\n', i);
      if (i == std::string_view::npos) break;
      continue;
    }
    char c = text[i];
    std::size_t size = 1;
    for (const Spelling& spelling : kSpellings) {
      if (!text.substr(i).starts_with(spelling.written)) continue;
      c = spelling.meant;
      size = spelling.written.size();
    }
    if (!std::string_view(" \t\r\n").contains(c)) start += c;
    i += size;
  }
  if (start.starts_with("{<"))
    return start.size() == 3 && (start[2] == 'p' || start[2] == 'a' || start[2] == '(');
  if (start.starts_with("{[")) return start.size() == 3 && std::string_view("+-%@").contains(start[2]);
  return start.size() == 3 && start[0] == '\'' && (start[1] == '/' || start[1] == '*') && start[2] >= '0' &&
         start[2] <= '9';
}

}  // namespace mlab::cdl
