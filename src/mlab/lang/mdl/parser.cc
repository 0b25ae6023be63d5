#include "mlab/lang/mdl/parser.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <system_error>
#include <utility>

#include <fmt/core.h>

#include "mlab/lang/mdl/mdl.h"
#include "mlab/lang/mdl/quoted.h"

namespace mlab::mdl {

Parser::Parser(text::SourcePtr source, text::Diagnostics& diagnostics)
    : source_(std::move(source)), diagnostics_(diagnostics), tokens_(lex(source_, diagnostics)) {}

const Token& Parser::token(std::size_t ahead) const {
  return tokens_.tokens[std::min(next_ + ahead, tokens_.tokens.size() - 1)];
}

void Parser::advance() {
  if (!stuck_ && !at_end()) ++next_;
}

bool Parser::take(TokenKind kind) {
  if (stuck_ || !at(kind)) return false;
  advance();
  return true;
}

bool Parser::take(Word word) {
  if (stuck_ || !at(word)) return false;
  advance();
  return true;
}

bool Parser::is_reserved(const Token& t) const {
  return t.kind == TokenKind::kWord || t.kind == TokenKind::kBoolean || t.kind == TokenKind::kFormation ||
         t.kind == TokenKind::kTechnique;
}

std::string Parser::describe(const Token& t) const {
  if (t.kind == TokenKind::kEnd) return "the end of the text";
  if (t.kind == TokenKind::kLabel) return "the step label " + in_backticks(written(t));
  return in_backticks(written(t));
}

text::Diagnostic& Parser::fail(std::string kind, text::Span span, std::string message) {
  if (std::exchange(stuck_, true)) return unsaid_ = {};
  return complain(std::move(kind), span, std::move(message));
}

// What is missing at the end of a line is missed there, not at whatever the next line begins with.
text::Diagnostic& Parser::fail_expected(std::string_view what) {
  const Token& t = token();
  if ((t.first_on_line || t.kind == TokenKind::kEnd) && next_ > 0) {
    const Token& before = tokens_.tokens[next_ - 1];
    return fail("unexpected-token", {before.span.end, before.span.end},
                fmt::format("expected {} behind {}", what, describe(before)));
  }
  return fail("unexpected-token", token().span,
              fmt::format("expected {}, found {}", what, describe(token())));
}

void Parser::fail_unknown(std::string kind, std::string_view what, std::span<const std::string> known) {
  if (stuck_) return;
  const Token t = token();
  const bool is_missing = t.first_on_line || t.kind == TokenKind::kEnd;
  text::Diagnostic& error = fail_expected(what);
  if (!is_missing) error.kind = std::move(kind);
  const std::string near = is_missing ? "" : text::nearest_name(written(t).substr(0, 40), known);
  error.hints.push_back(near.empty() ? "known are " + listed(known, " and ")
                                     : fmt::format("did you mean `{}`?", near));
}

text::Diagnostic& Parser::complain(std::string kind, text::Span span, std::string message) {
  return diagnostics_.error(std::move(kind), place(span), std::move(message));
}

void Parser::collect_comments(Comments* before, Comments& mine) {
  bool moved_down = false;
  while (next_comment_ < tokens_.comments.size() && tokens_.comments[next_comment_].next_token <= next_) {
    const CommentToken& comment = tokens_.comments[next_comment_++];
    std::string text(source_->text(comment.span));
    if (before != nullptr && !comment.own_line && !moved_down && before->after.empty()) {
      before->after = std::move(text);
      continue;
    }
    moved_down = true;
    if (comment.blank_line_before) mine.above.emplace_back();
    mine.above.push_back(std::move(text));
  }
  if (token().blank_line_before) mine.above.emplace_back();
}

Name Parser::take_name() {
  const Token& t = token();
  const std::string_view text = written(t);
  Name out;
  out.span = t.span;
  out.quoted = t.kind == TokenKind::kString;
  out.text =
      out.quoted ? text.substr(1, text.size() - (text.size() > 1 && text.ends_with('"') ? 2 : 1)) : text;
  advance();
  return out;
}

// A reserved word counts as a name, as in files older than the word; but not where it begins a line with
// what looks like the next statement, for then the name is missing.
Name Parser::name(std::string_view what) {
  if (stuck_) return {};
  const Token& t = token();
  if (t.kind == TokenKind::kName || t.kind == TokenKind::kString) return take_name();
  if (is_reserved(t) && !(t.first_on_line && (starts_statement(t) || at(Word::kAnd)))) return take_name();
  if (t.kind == TokenKind::kFile) {
    fail("unquoted-name", t.span,
         fmt::format("{} cannot stand as {} without quotes", in_backticks(written(t)), what))
        .hints.push_back(fmt::format("write `\"{}\"`", written(t).substr(0, 80)));
    return {};
  }
  fail_expected(what);
  return {};
}

Number Parser::number_of(const Token& t) {
  Number out{0.0, std::string(written(t)), t.span};
  const char* end = out.text.data() + out.text.size();
  if (std::from_chars(out.text.data(), end, out.value).ec != std::errc{} || !std::isfinite(out.value)) {
    fail("number-out-of-range", t.span,
         fmt::format("{} is beyond what a number can hold", in_backticks(out.text)));
    out.value = 0.0;
  }
  return out;
}

bool Parser::is_robots(const Token& t) const {
  return t.kind == TokenKind::kName && equal_without_case(written(t), "ROBOTS");
}

bool Parser::starts_command(const Token& t) const {
  static constexpr std::array kCommands = {Word::kUnit, Word::kRobot, Word::kSet, Word::kPrint, Word::kQuit};
  return is_robots(t) ||
         (t.kind == TokenKind::kWord && std::ranges::find(kCommands, t.word) != kCommands.end());
}

// `20.` where no step begins: its author meant a number.
bool Parser::at_misread_number() const {
  const Token& next = token(1);
  return at(TokenKind::kLabel) && !token().first_on_line && !starts_command(next);
}

Number Parser::number(std::string_view what) {
  if (stuck_) return {};
  const Token& t = token();
  if (t.kind == TokenKind::kNumber) {
    Number out = number_of(t);
    advance();
    return out;
  }
  if (at_misread_number()) {
    const std::string_view digits = written(t).substr(0, written(t).size() - 1);
    fail("label-as-number", t.span,
         fmt::format("expected {}, found the step label {}", what, in_backticks(written(t))))
        .hints.push_back(fmt::format("a number does not end with a point: write `{}`", digits.substr(0, 40)));
  } else if (t.kind == TokenKind::kTime && written(t).starts_with('+')) {
    fail("time-as-number", t.span,
         fmt::format("expected {}, found the time {}", what, in_backticks(written(t))))
        .hints.emplace_back("a number has no `+` before it");
  } else {
    fail_expected(what);
  }
  return {};
}

// The words that begin a statement of the preamble.
bool Parser::starts_statement(const Token& t) const {
  if (t.kind == TokenKind::kMissionName || t.kind == TokenKind::kCommandList) return true;
  static constexpr std::array kStatements = {Word::kScenario, Word::kOverlay, Word::kMissionArea,
                                             Word::kLoadMap,  Word::kSp,      Word::kUnit,
                                             Word::kNewRobot, Word::kSet,     Word::kCreateObstacles,
                                             Word::kObstacle, Word::kPrint,   Word::kFailsafe};
  return t.kind == TokenKind::kWord && std::ranges::find(kStatements, t.word) != kStatements.end();
}

// `COMMAND-LIST:`, `COMMAND LIST :` or without the colon.
bool Parser::looks_like_header() const {
  if (!at(TokenKind::kName)) return false;
  if (equal_without_case(written(token()), "COMMAND-LIST")) return true;
  return equal_without_case(written(token()), "COMMAND") && token(1).kind == TokenKind::kName &&
         equal_without_case(written(token(1)), "LIST");
}

// A misspelt statement, or one that belongs elsewhere: worth a message of its own.
bool Parser::resembles_statement() {
  const Token& t = token();
  if (t.kind == TokenKind::kWord) return is_known_elsewhere(t);
  if (t.kind != TokenKind::kName || token(1).kind == TokenKind::kEquals || comparisons_left_ <= 0)
    return false;
  --comparisons_left_;
  return is_known_elsewhere(t) || !near_statement(written(t)).empty();
}

// `first`: where the statement with the error begins; it is left behind in any case.
void Parser::recover_in_preamble(std::size_t first) {
  stuck_ = false;
  if (next_ == first) advance();
  const auto can_go_on = [&] {
    const Token& t = token();
    if (t.kind == TokenKind::kEnd || t.kind == TokenKind::kCommandList) return true;
    return t.first_on_line && (starts_statement(t) || looks_like_header() || resembles_statement());
  };
  while (!can_go_on()) advance();
}

// A label, or what was meant as one.
bool Parser::begins_step() const {
  const Token& t = token();
  if (!t.first_on_line || at_end()) return false;
  const bool is_digit_first = written(t)[0] >= '0' && written(t)[0] <= '9';
  const bool before_command =
      !token(1).first_on_line &&
      (is_robots(token(1)) ||
       (token(1).kind == TokenKind::kWord &&
        (token(1).word == Word::kUnit || token(1).word == Word::kRobot || token(1).word == Word::kQuit)));
  return t.kind == TokenKind::kLabel || (t.kind == TokenKind::kNumber && before_command) ||
         (t.kind == TokenKind::kFile && is_digit_first && written(t).contains('.'));
}

void Parser::recover_in_steps() {
  stuck_ = false;
  while (!at_end() && !at(Word::kAnd) && !begins_step()) advance();
}

// The step's first token was reported and understood as nothing.
void Parser::leave_broken_step() {
  stuck_ = false;
  do {
    advance();
  } while (!at_end() && !begins_step());
}

void Parser::recover_in_typed() {
  stuck_ = false;
  while (!at_end() && !at(Word::kAnd)) advance();
}

Comments* Parser::last_comments(Tree& tree) {
  return tree.preamble.empty() ? nullptr : &tree.preamble.back().comments;
}

Tree Parser::file() {
  Tree tree;
  tree.source = source_;
  if (at(TokenKind::kImmediateCommand)) {
    typed(tree);
    return tree;
  }
  preamble(tree);
  if (command_list_header(tree)) steps(tree);
  remaining_comments(tree);
  return tree;
}

Tree Parser::typed_line() {
  Tree tree;
  tree.source = source_;
  typed(tree);
  return tree;
}

void Parser::preamble(Tree& tree) {
  const bool is_empty = at(TokenKind::kCommandList);
  while (!at_end() && !at(TokenKind::kCommandList) && !looks_like_header() &&
         !(at(TokenKind::kLabel) && token().first_on_line)) {
    const std::size_t first = next_;
    Comments comments;
    collect_comments(last_comments(tree), comments);
    if (std::optional<Statement> parsed = parsed_statement(Section::kPreamble, tree.damage)) {
      parsed->comments = std::move(comments);
      tree.preamble.push_back(std::move(*parsed));
    }
    if (stuck_) recover_in_preamble(first);
  }
  if (is_empty) {
    complain("empty-preamble", token().span, "nothing stands before `COMMAND LIST:`")
        .hints.emplace_back("a mission begins with at least one statement, as `MISSION NAME \"...\"`");
  }
}

// True where steps may follow.
bool Parser::command_list_header(Tree& tree) {
  collect_comments(last_comments(tree), tree.header);
  if (take(TokenKind::kCommandList)) return true;
  if (looks_like_header()) {
    const bool is_hyphenated = equal_without_case(written(token()), "COMMAND-LIST");
    const text::Span first = token().span;
    advance();
    if (!is_hyphenated) advance();
    const text::Span all{first.begin, tokens_.tokens[next_ - 1].span.end};
    if (is_hyphenated && take(TokenKind::kColon)) {
      diagnostics_.warning("hyphenated-command-list", place(first),
                           "`COMMAND-LIST:` is written `COMMAND LIST:`");
    } else {
      complain("command-list-spelling", all, "expected `COMMAND LIST:`, the colon right behind the word");
      take(TokenKind::kColon);
    }
    return true;
  }
  auto& said =
      complain("missing-command-list", token().span,
               fmt::format("expected `COMMAND LIST:` before the steps, found {}", describe(token())));
  if (at(TokenKind::kLabel)) said.hints.emplace_back("put a line `COMMAND LIST:` before the first step");
  return at(TokenKind::kLabel);
}

void Parser::steps(Tree& tree) {
  if (at_end()) {
    complain("empty-command-list", token().span, "no step follows `COMMAND LIST:`");
    return;
  }
  while (!at_end()) {
    const std::size_t before = next_;
    step(tree);
    if (next_ == before) leave_broken_step();
  }
}

void Parser::step(Tree& tree) {
  LabelledStep out;
  Comments* previous = tree.steps.empty() ? &tree.header : &tree.steps.back().commands.back().comments;
  collect_comments(previous, out.comments);
  step_label(out);
  step_commands(out);
  if (!out.commands.empty()) tree.steps.push_back(std::move(out));
}

void Parser::step_label(LabelledStep& step) {
  const Token& t = token();
  const std::string_view text = written(t);
  step.label = {std::string(text), t.span};
  if (t.kind == TokenKind::kLabel) {
    step.label.text.pop_back();
    advance();
  } else if (t.kind == TokenKind::kNumber) {
    complain("label-without-point", t.span,
             fmt::format("the step label {} has no point behind it", in_backticks(text)))
        .hints.push_back(fmt::format("write `{}.`", text.substr(0, 40)));
    advance();
  } else if (t.kind == TokenKind::kFile && text[0] >= '0' && text[0] <= '9' &&
             text.find('.') != std::string_view::npos) {
    const std::size_t point = text.find('.');
    fail("label-without-blank", t.span,
         fmt::format("no blank stands behind the step label {}", in_backticks(text.substr(0, point + 1))))
        .hints.push_back(fmt::format("write `{}. {}`", text.substr(0, std::min<std::size_t>(point, 40)),
                                     text.substr(point + 1, 40)));
  } else if (starts_statement(t) && !at(Word::kUnit) && !at(Word::kSet) && !at(Word::kPrint)) {
    Damage ignored;
    refuse_statement(Section::kStep, ignored);
  } else if (starts_command(t)) {
    complain("missing-label", t.span,
             fmt::format("expected a step label, as `1.`, before {}", in_backticks(text)));
  } else {
    fail_expected("a step label, as `1.`");
  }
}

void Parser::step_commands(LabelledStep& step) {
  Damage ignored;
  while (true) {
    Comments comments;
    Comments* previous = step.commands.empty() ? nullptr : &step.commands.back().comments;
    collect_comments(previous, comments);
    if (previous == nullptr) {  // between label and command: moves above the step
      std::erase(comments.above, "");
      step.comments.above.insert(step.comments.above.end(), comments.above.begin(), comments.above.end());
      comments = {};
    }
    if (!stuck_) {
      if (std::optional<Statement> parsed = parsed_statement(Section::kStep, ignored)) {
        parsed->comments = std::move(comments);
        step.commands.push_back(std::move(*parsed));
      }
    }
    if (!stuck_ && starts_command(token())) {
      complain("missing-and", token().span,
               fmt::format("expected `AND` or a step label before {}", in_backticks(written(token()))));
      continue;
    }
    if (!stuck_ && !at_end() && !at(Word::kAnd) && !at(TokenKind::kLabel)) {
      if (looks_like_header() || starts_statement(token())) {
        refuse_statement(Section::kStep, ignored);
      } else {
        fail_expected("a clause, `AND` or the next step");
      }
    }
    if (stuck_) recover_in_steps();
    if (!take(Word::kAnd)) return;
  }
}

void Parser::typed(Tree& tree) {
  tree.is_immediate = true;
  collect_comments(nullptr, tree.header);
  take(TokenKind::kImmediateCommand);
  do {
    Comments comments;
    collect_comments(tree.typed.empty() ? nullptr : &tree.typed.back().comments, comments);
    if (std::optional<Statement> parsed = parsed_statement(Section::kTyped, tree.damage)) {
      parsed->comments = std::move(comments);
      tree.typed.push_back(std::move(*parsed));
    }
    if (!stuck_ && !at_end() && !at(Word::kAnd)) fail_expected("a clause, `AND` or the end of the command");
    if (stuck_) recover_in_typed();
  } while (take(Word::kAnd));
  remaining_comments(tree);
}

void Parser::remaining_comments(Tree& tree) {
  next_ = tokens_.tokens.size() - 1;
  Comments rest;
  Comments* previous = &tree.header;
  if (!tree.steps.empty()) previous = &tree.steps.back().commands.back().comments;
  if (!tree.typed.empty()) previous = &tree.typed.back().comments;
  collect_comments(previous, rest);
  tree.comments_below = std::move(rest.above);
}

Tree parse(const text::SourcePtr& source, text::Diagnostics& diagnostics) {
  return Parser(source, diagnostics).file();
}

}  // namespace mlab::mdl
