#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include <fmt/core.h>

#include "mlab/lang/envchange/envchange.h"
#include "mlab/lang/envchange/lexer.h"
#include "mlab/overlay/limits.h"
#include "mlab/text/shown.h"

namespace mlab::envchange {
namespace {

using overlay::kMaxCoordinate;
constexpr double kMaxCycle = 1e9;  // thirty years of seconds

class Parser {
 public:
  Parser(const text::SourcePtr& source, geom::Offset origin, text::Diagnostics& sink)
      : source_(source), origin_(origin), sink_(sink), tokens_(lex(source, sink)) {}

  overlay::EnvironmentChanges run() && {
    while (peek().kind != TokenKind::kEnd) parse_event();
    return std::move(out_);
  }

 private:
  // --- tokens and errors ---

  const Token& peek() const { return tokens_[at_]; }
  bool take(TokenKind kind) {
    if (peek().kind != kind) return false;
    ++at_;
    return true;
  }
  std::string_view text_of(const Token& token) const { return source_->text(token.span); }

  bool fail_expected(const char* kind, std::string_view what) {
    const bool is_end = peek().kind == TokenKind::kEnd;
    const std::uint32_t behind = at_ > 0 ? tokens_[at_ - 1].span.end : 0;
    const text::Span span = is_end || peek().starts_line ? text::Span{behind, behind} : peek().span;
    const std::string found =
        is_end ? "the end of the file" : fmt::format("`{}`", text::shown(text_of(peek())));
    sink_.error(kind, {source_, span}, fmt::format("expected {}, found {}", what, found));
    return false;
  }

  bool fail_unknown() {
    sink_.error("expected-keyword", {source_, peek().span},
                fmt::format("expected `STEP_COUNT`, found `{}`", text::shown(text_of(peek()))));
    return false;
  }

  // A number within [low, high]; it is reported and taken as broken where not.
  bool number(std::string_view what, double low, double high, double& out) {
    if (peek().kind != TokenKind::kNumber) return fail_expected("expected-number", what);
    const std::string_view written = text_of(peek());
    const auto [end, error] = std::from_chars(written.data(), written.data() + written.size(), out);
    if (error != std::errc{}) out = std::numeric_limits<double>::infinity();
    if (!(out >= low && out <= high)) {
      sink_
          .error("number-out-of-range", {source_, peek().span},
                 fmt::format("`{}` is out of range", text::shown(written)))
          .label = fmt::format("{} is between {:g} and {:g}", what, low, high);
      return false;
    }
    ++at_;
    return true;
  }

  bool position(geom::Point& out) {
    if (!number("an x coordinate", -kMaxCoordinate, kMaxCoordinate, out.x)) return false;
    if (!number("a y coordinate", -kMaxCoordinate, kMaxCoordinate, out.y)) return false;
    out = out + origin_;
    return true;
  }

  bool radius(double& out) {
    constexpr double kSmallest = 1e-3;  // [m]
    return number("a radius in metres", kSmallest, kMaxCoordinate, out);
  }

  // --- the file ---

  void parse_event() {
    overlay::EnvironmentEvent event;
    event.place = {source_, peek().span};
    const bool has_head = parse_head(event);
    if (!has_head) resume();
    bool has_command = false;
    while (starts_command()) {
      has_command = true;
      if (!parse_command(event)) resume();
    }
    if (has_head && !has_command) {
      fail_expected("expected-keyword", "`ADD`, `REMOVE` or `REGION`");
      resume();
    }
    out_.events.push_back(std::move(event));
  }

  bool parse_head(overlay::EnvironmentEvent& event) {
    if (peek().kind != TokenKind::kStepCount) return fail_unknown();
    ++at_;
    if (!number("a cycle", 0.0, kMaxCycle, event.start)) return false;
    event.start = std::round(event.start);
    if (peek().kind != TokenKind::kNumber) return true;
    if (!number("a period in cycles", 0.0, kMaxCycle, event.period)) return false;
    event.period = std::round(event.period);
    return true;
  }

  bool starts_command() const {
    return peek().kind == TokenKind::kAdd || peek().kind == TokenKind::kRemove ||
           peek().kind == TokenKind::kRegion;
  }

  // Goes on at the next event, or at a command on a line of its own.
  void resume() {
    while (peek().kind != TokenKind::kEnd && peek().kind != TokenKind::kStepCount &&
           peek().kind != TokenKind::kRegion && !(starts_command() && peek().starts_line)) {
      ++at_;
    }
  }

  bool parse_command(overlay::EnvironmentEvent& event) {
    if (take(TokenKind::kAdd)) {
      overlay::AddObstacle add;
      return obstacle() && position(add.center) && radius(add.radius) && push(event, add);
    }
    if (take(TokenKind::kRemove)) {
      overlay::RemoveObstacle remove;
      return obstacle() && position(remove.center) && push(event, remove);
    }
    ++at_;
    return parse_region(event);
  }

  bool obstacle() { return take(TokenKind::kObstacle) || fail_expected("expected-keyword", "`OBSTACLE`"); }

  static bool push(overlay::EnvironmentEvent& event, const overlay::EnvironmentChange& change) {
    event.changes.push_back(change);
    return true;
  }

  bool parse_region(overlay::EnvironmentEvent& event) {
    geom::Point a;
    geom::Point b;
    if (!position(a) || !position(b)) return false;
    const overlay::Region region{{std::min(a.x, b.x), std::min(a.y, b.y)},
                                 {std::max(a.x, b.x), std::max(a.y, b.y)}};
    if (take(TokenKind::kRemove)) return obstacle() && push(event, overlay::ClearRegion{region});
    if (!take(TokenKind::kAdd)) return fail_expected("expected-keyword", "`ADD` or `REMOVE`");
    overlay::FillRegion fill;
    fill.region = region;
    return obstacle() && number("the coverage in per cent", 0.0, 100.0, fill.field.coverage_percent) &&
           radius(fill.field.min_radius) && radius(fill.field.max_radius) && parse_seed(fill) &&
           push(event, fill);
  }

  // [seed [, increment]]; a negative seed stands for none.
  bool parse_seed(overlay::FillRegion& fill) {
    if (peek().kind != TokenKind::kNumber) return true;
    double seed = 0.0;
    if (!number("a seed", -kMaxSeed, kMaxSeed, seed)) return false;
    if (seed >= 0.0) fill.seed = seed;
    return !take(TokenKind::kComma) || number("a seed increment", -kMaxSeed, kMaxSeed, fill.seed_increment);
  }

  static constexpr double kMaxSeed = 4294967295.0;

  text::SourcePtr source_;
  geom::Offset origin_;
  text::Diagnostics& sink_;
  std::vector<Token> tokens_;
  std::size_t at_ = 0;
  overlay::EnvironmentChanges out_;
};

}  // namespace

std::optional<overlay::EnvironmentChanges> parse(const text::SourcePtr& source, geom::Offset origin,
                                                 text::Diagnostics& sink) {
  const std::size_t errors_before = sink.error_count();
  overlay::EnvironmentChanges changes = Parser(source, origin, sink).run();
  changes.source = source;
  if (sink.error_count() > errors_before) return std::nullopt;
  return changes;
}

std::optional<overlay::EnvironmentChanges> load(const std::string& path, geom::Offset origin,
                                                text::Diagnostics& sink) {
  text::Result<text::SourcePtr> source = text::read_source(path);
  if (source) return parse(*source, origin, sink);
  sink.report(std::move(source.error()));
  return std::nullopt;
}

bool looks_like_envchange(std::string_view text) {
  text::Diagnostics unread;
  const auto tokens = lex(std::make_shared<const text::Source>("", std::string(text)), unread);
  return tokens.front().kind == TokenKind::kStepCount;
}

}  // namespace mlab::envchange
