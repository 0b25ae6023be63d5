#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include <fmt/core.h>

#include "mlab/lang/odl/grammar.h"
#include "mlab/lang/odl/lexer.h"
#include "mlab/lang/odl/odl.h"
#include "mlab/lang/odl/parser.h"
#include "mlab/text/shown.h"

namespace mlab::odl {
namespace {

// All words that a statement can begin with, for hints.
std::vector<std::string> statement_words() {
  std::vector<std::string> out;
  for (const Word& word : words()) {
    if (starts_statement(word.keyword)) out.emplace_back(word.spelling);
  }
  return out;
}

constexpr int kMaxLookUps = 1000;  // of the nearest keyword, for hints: they take time

class Parser {
 public:
  Parser(const text::SourcePtr& source, text::Diagnostics& sink) : sink_(sink) {
    tree_.source = source;
    lex(source, tree_.tokens, tree_.comments, sink);
  }

  Tree parse_overlay() && {
    parse_all();
    if (!has_header_ && !said_header_is_missing_) {
      fail("missing-control-measures", behind_last(),
           "an overlay has a line `CONTROL MEASURES:`, this has none");
      report();
    }
    return std::move(tree_);
  }

  // Features alone, as a waypoint file has them.
  Tree parse_features() && {
    has_header_ = true;
    parse_all();
    return std::move(tree_);
  }

 private:
  void parse_all() {
    while (peek().kind != TokenKind::kEnd) parse_next();
  }

  // --- tokens ---

  const Token& peek(std::size_t ahead = 0) const {
    return tree_.tokens[std::min(at_ + ahead, tree_.tokens.size() - 1)];
  }
  std::string_view text_of(const Token& token) const { return tree_.source->text(token.span); }
  bool is_value(const Token& t) const {
    return t.kind == TokenKind::kNumber || t.keyword == Keyword::kUtm || t.keyword == Keyword::kGeo;
  }
  text::Place place_of(text::Span span) const { return {tree_.source, span}; }

  // Just behind the last token that was taken: where something is missing.
  text::Place behind_last() const {
    const std::uint32_t end = at_ > 0 ? tree_.tokens[at_ - 1].span.end : 0;
    return place_of({end, end});
  }

  std::string what_stands_here() const {
    if (peek().kind == TokenKind::kEnd) return "the end of the file";
    return fmt::format("`{}`", text::shown(text_of(peek())));
  }

  // --- errors: noted by `fail`, said by `report`, so that a caller who knows better may say something else
  // ---

  bool fail(std::string kind, text::Place place, std::string message, std::string hint = "") {
    failure_ = text::Diagnostic{
        text::Severity::kError, std::move(kind), std::move(message), std::move(place), {}, {}, {}};
    if (!hint.empty()) add_hint(std::move(hint));
    return false;
  }

  void add_hint(std::string hint) {
    if (failure_) failure_->hints.push_back(std::move(hint));
  }

  // `what` is missing; it should stand where the next token is.
  bool fail_expected(std::string kind, std::string_view what) {
    if (is_full()) return fail(std::move(kind), {}, "");
    const bool is_elsewhere = peek().starts_line || peek().kind == TokenKind::kEnd;
    const text::Place place = is_elsewhere ? behind_last() : place_of(peek().span);
    return fail(std::move(kind), place, fmt::format("expected {}, found {}", what, what_stands_here()),
                usage());
  }

  // More errors are only counted, so nobody needs their text: it would take most of the time of a file full
  // of them.
  bool is_full() const { return sink_.error_count() >= text::Diagnostics::kMaxErrors; }

  std::string usage() const { return rule_ ? fmt::format("the whole is `{}`", rule_->usage) : ""; }

  void report() {
    if (failure_) sink_.report(std::move(*failure_));
    failure_.reset();
  }

  // --- the file ---

  void parse_next() {
    const std::size_t begin = at_;
    Statement statement;
    statement.first_token = static_cast<std::uint32_t>(begin);
    const Keyword keyword = peek().keyword;
    bool is_whole = false;
    if (keyword == Keyword::kControlMeasures) {
      is_whole = parse_header();
    } else if (starts_statement(keyword)) {
      check_section(keyword);
      is_whole = parse_statement(keyword, statement);
    } else {
      is_whole = fail_unknown_statement();
    }
    if (is_whole) {
      statement.keyword = keyword;
    } else {
      resume_after_failure(begin);
    }
    statement.end_token = static_cast<std::uint32_t>(at_);
    statement.span = {tree_.tokens[begin].span.begin, tree_.tokens[at_ - 1].span.end};
    tree_.statements.push_back(std::move(statement));
  }

  bool parse_header() {
    ++at_;
    if (!has_header_) return has_header_ = true;
    return fail("repeated-header", place_of(tree_.tokens[at_ - 1].span), "a second `CONTROL MEASURES:`",
                "it stands once, between what describes the map and the features");
  }

  void check_section(Keyword keyword) {
    const bool is_late = has_header_ && is_information(keyword);
    const bool is_early = !has_header_ && is_feature(keyword) && !said_header_is_missing_;
    if (is_late) {
      fail("misplaced-statement", place_of(peek().span),
           fmt::format("`{}` after `CONTROL MEASURES:`", spelling(keyword)),
           "what describes the map stands before the features");
    } else if (is_early) {
      said_header_is_missing_ = true;
      fail("missing-control-measures", place_of(peek().span),
           fmt::format("`{}` before `CONTROL MEASURES:`", spelling(keyword)),
           "features stand after a line `CONTROL MEASURES:`");
    }
    report();
  }

  bool fail_unknown_statement() {
    rule_ = nullptr;
    if (is_full()) return fail("unknown-statement", {}, "");
    const Token token = peek();
    const bool is_header = token.kind == TokenKind::kWord && is_broken_header(token);
    fail("unknown-statement", place_of(token.span),
         fmt::format("expected a statement, found `{}`", text::shown(text_of(token))));
    if (is_header) {
      add_hint("the header is `CONTROL MEASURES:`, the colon attached");
      said_header_is_missing_ = true;
    } else if (token.starts_line) {
      const std::string near = nearest_statement(token);
      if (!near.empty()) add_hint(fmt::format("did you mean `{}`?", near));
    } else if (!tree_.statements.empty() && tree_.statements.back().keyword != Keyword::kNone) {
      const Rule& before = rule_of(tree_.statements.back().keyword);
      if (!before.usage.empty()) {
        add_hint(fmt::format("the statement before it is `{}`", before.usage));
      }
    }
    return false;
  }

  // The keyword that somebody may have meant; empty where none is near, or where so many words were looked up
  // already that the file is something else.
  std::string nearest_statement(const Token& token) {
    if (token.kind != TokenKind::kWord || looked_up_ == kMaxLookUps) return "";
    ++looked_up_;
    static const std::vector<std::string> kWords = statement_words();
    return text::nearest_name(text_of(token), kWords);
  }

  // `CONTROL MEASURES` without its colon, or `CONTROL-MEASURES:`.
  bool is_broken_header(const Token& token) const {
    const auto is = [&](const Token& t, std::string_view word) {
      return std::ranges::equal(text_of(t), word, [](char a, char b) { return (a & ~0x20) == (b & ~0x20); });
    };
    return is(token, "CONTROL-MEASURES") || (is(token, "CONTROL") && is(peek(1), "MEASURES"));
  }

  // Goes on at the next statement. A reserved word that was taken as a name, but stands at the start of a
  // later line, was rather a statement, and the name before it is missing.
  void resume_after_failure(std::size_t begin) {
    const Token& name = tree_.tokens[std::min(begin + 1, tree_.tokens.size() - 1)];
    const Keyword swallowed = find_keyword(text_of(name));
    if (at_ > begin + 1 && name.starts_line && name.kind == TokenKind::kWord && starts_statement(swallowed)) {
      tree_.tokens[begin + 1].keyword = swallowed;
      at_ = begin + 1;
      fail_expected("expected-name", "a name");
    }
    at_ = std::max(at_, begin + 1);
    while (!looks_like_statement()) ++at_;
    if (has_open_string(begin)) failure_.reset();  // the lexer has said what is wrong
    report();
  }

  bool has_open_string(std::size_t begin) const {
    const auto is_open = [&](const Token& t) {
      return t.kind == TokenKind::kString && (t.span.end - t.span.begin == 1 || !text_of(t).ends_with('"'));
    };
    return std::any_of(tree_.tokens.begin() + static_cast<std::ptrdiff_t>(begin),
                       tree_.tokens.begin() + static_cast<std::ptrdiff_t>(at_), is_open);
  }

  // Where the next statement may begin after a broken one: also at a misspelt keyword, if it begins a line.
  bool looks_like_statement() {
    const Token& token = peek();
    if (token.kind == TokenKind::kEnd || token.kind == TokenKind::kHeader) return true;
    if (token.keyword == Keyword::kNone && token.starts_line) return !nearest_statement(token).empty();
    if (!starts_statement(token.keyword)) return false;
    if (token.starts_line) return true;
    const Form form = rule_of(token.keyword).form;
    if (form == Form::kValues || form == Form::kObject || form == Form::kMoving) return is_value(peek(1));
    if (form == Form::kNamed) return is_name(peek(1)) && is_value(peek(2));
    return form == Form::kHallway ? peek(2).keyword == Keyword::kCenterline : is_name(peek(1));
  }

  // --- one statement ---

  static bool is_name(const Token& t) { return t.kind == TokenKind::kWord || t.kind == TokenKind::kString; }

  bool parse_statement(Keyword keyword, Statement& out) {
    rule_ = &rule_of(keyword);
    ++at_;
    switch (rule_->form) {
      case Form::kName:
        return parse_name(out.name, is_file_statement(keyword)) && !swallowed_statement();
      case Form::kFile:
        return parse_name(out.name, true) && parse_values(out);
      case Form::kValues:
        return parse_values(out);
      case Form::kNamed:
        return parse_name(out.name, false) && parse_values(out);
      case Form::kSet:
        return expect(Keyword::kZoomFactor) && parse_values(out);
      case Form::kObject:
        return parse_values(out) && parse_style(out) && parse_name(out.name, false) && parse_route(out);
      case Form::kMoving:
        return parse_values(out) && parse_route(out);
      case Form::kHallway:
        return parse_hallway(out);
    }
    return false;
  }

  static bool is_file_statement(Keyword k) { return k == Keyword::kLoadMap || k == Keyword::kWaypointFile; }

  // The name just taken is a reserved word on a line of its own statement: `SITE` of `SCENARIO\nSITE "x"`.
  bool swallowed_statement() {
    const Token& name = tree_.tokens[at_ - 1];
    const bool goes_on =
        !peek().starts_line && peek().kind != TokenKind::kEnd && !starts_statement(peek().keyword);
    if (!goes_on || !name.starts_line || name.kind != TokenKind::kWord) return false;
    if (!starts_statement(find_keyword(text_of(name)))) return false;
    return !fail_expected("expected-name", "a name");
  }

  bool parse_name(NameSyntax& out, bool may_be_file) {
    Token& token = tree_.tokens[at_];
    if (!is_name(token) && !(may_be_file && token.kind == TokenKind::kFile)) {
      fail_expected("expected-name", may_be_file ? "the name of a file" : "a name");
      if (is_full()) return false;
      const bool is_odd_name = token.kind == TokenKind::kFile || token.kind == TokenKind::kNumber;
      if (is_odd_name && !token.starts_line) add_hint("a name that is no plain word stands in quotes");
      return false;
    }
    token.keyword = Keyword::kNone;
    std::string_view text = text_of(token);
    if (text.starts_with('"')) {
      text.remove_prefix(1);
      if (text.ends_with('"')) text.remove_suffix(1);
    }
    if (is_feature(rule_->keyword) && rule_->form != Form::kObject && text.ends_with('*')) {
      out.has_star = true;
      text.remove_suffix(1);
    }
    out.text = text;
    out.span = token.span;
    ++at_;
    return true;
  }

  bool expect(Keyword keyword) {
    if (peek().keyword != keyword)
      return fail_expected("expected-keyword", fmt::format("`{}`", spelling(keyword)));
    ++at_;
    return true;
  }

  bool parse_style(Statement& out) {
    switch (peek().keyword) {
      case Keyword::kMovable:
        out.style = overlay::ObjectStyle::kMovable;
        break;
      case Keyword::kFixed:
        out.style = overlay::ObjectStyle::kFixed;
        break;
      case Keyword::kContainer:
        out.style = overlay::ObjectStyle::kContainer;
        break;
      default:
        return fail_expected("expected-keyword", "`MOVABLE`, `FIXED` or `CONTAINER`");
    }
    ++at_;
    return true;
  }

  bool parse_hallway(Statement& out) {
    return parse_name(out.name, false) && expect(Keyword::kCenterline) && parse_points(out.centerline) &&
           expect(Keyword::kWidth) && parse_number("the width", out) && expect(Keyword::kExtents) &&
           parse_points(out.points);
  }

  bool parse_route(Statement& out) {
    if (peek().keyword != Keyword::kRoute) return true;
    ++at_;
    if (!parse_points(out.route) || !expect(Keyword::kSpeed)) return false;
    if (peek().kind != TokenKind::kNumber) return fail_expected("expected-number", "the speed");
    out.speed = number();
    return !is_value(peek()) || fail_too_many();
  }

  bool parse_points(std::vector<PointSyntax>& out) {
    do {
      if (!parse_point(out)) return false;
    } while (is_value(peek()));
    return true;
  }

  // The points and numbers of a rule. Where the rule takes any number of points, an odd number at the end is
  // no coordinate but the feature's size.
  bool parse_values(Statement& out) {
    while (out.points.size() < rule_->max_points) {
      const bool may_stop = out.points.size() >= rule_->min_points;
      if (may_stop && (!is_value(peek()) || is_last_number())) break;
      if (!parse_point(out.points)) return false;
    }
    while (peek().kind == TokenKind::kNumber && out.numbers.size() < rule_->max_numbers) take_number(out);
    if (out.numbers.size() < rule_->min_numbers) {
      return fail_expected("expected-number", out.numbers.empty() ? rule_->number : "another number");
    }
    return !is_value(peek()) || fail_too_many();
  }

  // The next token is a number that no second one follows, and the rule has a use for it.
  bool is_last_number() const {
    return rule_->max_numbers > 0 && peek().kind == TokenKind::kNumber && peek(1).kind != TokenKind::kNumber;
  }

  bool fail_too_many() {
    return fail("too-many-numbers", place_of(peek().span),
                fmt::format("{} is more than `{}` takes", what_stands_here(), spelling(rule_->keyword)),
                usage());
  }

  bool parse_number(std::string_view what, Statement& out) {
    if (peek().kind != TokenKind::kNumber) return fail_expected("expected-number", what);
    take_number(out);
    return true;
  }

  void take_number(Statement& out) { out.numbers.push_back(number()); }

  NumberSyntax number() {
    const Token& token = tree_.tokens[at_++];
    return {number_value(text_of(token)), token.span};
  }

  bool parse_point(std::vector<PointSyntax>& out) {
    PointSyntax point;
    point.first_token = static_cast<std::uint32_t>(at_);
    if (peek().keyword == Keyword::kUtm) {
      point.form = PointForm::kUtm;
      if (!parse_degrees(point)) return false;
    } else if (peek().keyword == Keyword::kGeo) {
      point.form = PointForm::kGeo;
      if (!parse_place(point)) return false;
    } else {
      if (peek().kind != TokenKind::kNumber)
        return fail_expected("expected-number", "the x coordinate of a point");
      point.x = number();
      if (peek().kind != TokenKind::kNumber)
        return fail_expected("expected-number", "the y coordinate of a point");
      point.y = number();
    }
    out.push_back(point);
    return true;
  }

  // GEO "place". What the place says is looked at when the tree is applied.
  bool parse_place(PointSyntax& out) {
    ++at_;
    if (peek().kind != TokenKind::kString) {
      fail_expected("expected-place", "a place in quotes");
      add_hint("a place is `GEO \"48.2 N 16.4 E\"`, or UTM or MGRS in the quotes");
      return false;
    }
    out.x.span = out.y.span = tree_.tokens[at_++].span;
    return true;
  }

  // UTM LAT y LON x, in either order.
  bool parse_degrees(PointSyntax& out) {
    ++at_;
    bool has_lat = false;
    bool has_lon = false;
    while (!has_lat || !has_lon) {
      const bool is_lat = !has_lat && peek().keyword == Keyword::kLat;
      if (!is_lat && (has_lon || peek().keyword != Keyword::kLon)) {
        return fail_expected("expected-keyword", has_lat ? "`LON`" : has_lon ? "`LAT`" : "`LAT` or `LON`");
      }
      ++at_;
      if (peek().kind != TokenKind::kNumber) {
        return fail_expected("expected-number",
                             is_lat ? "the latitude in degrees" : "the longitude in degrees");
      }
      (is_lat ? out.y : out.x) = number();
      (is_lat ? has_lat : has_lon) = true;
    }
    return true;
  }

  text::Diagnostics& sink_;
  Tree tree_;
  std::size_t at_ = 0;
  const Rule* rule_ = nullptr;
  std::optional<text::Diagnostic> failure_;
  bool has_header_ = false;
  bool said_header_is_missing_ = false;
  int looked_up_ = 0;
};

}  // namespace

Tree parse(const text::SourcePtr& source, text::Diagnostics& sink) {
  return Parser(source, sink).parse_overlay();
}

Tree parse_features(const text::SourcePtr& source, text::Diagnostics& sink) {
  return Parser(source, sink).parse_features();
}

}  // namespace mlab::odl
