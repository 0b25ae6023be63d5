#include "mlab/study/condition.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <memory>
#include <string_view>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "mlab/text/shown.h"

namespace mlab::study {

/// A word, number or sign of what was written.
struct Token {
  enum class Kind : std::uint8_t { kWord, kNumber, kSign, kEnd };
  Kind kind = Kind::kEnd;
  std::string_view text;
  double value = 0.0;
  std::size_t begin = 0;
};

namespace {

constexpr std::string_view kPlusMinus = "\u00b1";

// The longest first.
constexpr std::string_view kSigns[] = {"==", "!=", "<=", ">=", "+-", kPlusMinus, "<", ">", "(", ")", "@"};

// Letters beyond ASCII as well: what is no name is told as a whole.
bool begins_in_word(std::string_view rest) {
  const char c = rest.front();
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || (c >= '0' && c <= '9') ||
         ((static_cast<unsigned char>(c) & 0x80U) != 0 && !rest.starts_with(kPlusMinus));
}

}  // namespace

/// Reads them one after the other.
class Tokens {
 public:
  explicit Tokens(const Written& written) : written_(written), text_(written.text) { advance(); }

  const Token& now() const { return now_; }
  std::size_t last_end() const { return last_end_; }
  bool at(std::string_view text) const { return now_.kind != Token::Kind::kEnd && now_.text == text; }
  bool take(std::string_view text) {
    if (!at(text)) return false;
    advance();
    return true;
  }
  void advance() {
    last_end_ = now_.begin + now_.text.size();
    std::size_t at = last_end_;
    while (at < text_.size() && (text_[at] == ' ' || text_[at] == '\t' || text_[at] == '\n')) ++at;
    now_ = {Token::Kind::kEnd, {}, 0.0, at};
    if (at < text_.size()) read(at);
  }
  text::Diagnostic expected(std::string_view what) const {
    text::Diagnostic out;
    out.kind = "expected";
    out.message = now_.kind == Token::Kind::kEnd
                      ? fmt::format("expected {}, and it ends here", what)
                      : fmt::format("expected {}, found `{}`", what, text::shown(now_.text));
    out.place = written_.place;
    if (out.place.source && out.place.source->text(out.place.span) == text_) {
      out.place.span.begin += static_cast<std::uint32_t>(now_.begin);
      out.place.span.end = out.place.span.begin + static_cast<std::uint32_t>(now_.text.size());
    }
    return out;
  }

 private:
  void read(std::size_t at) {
    const std::string_view rest = text_.substr(at);
    double value = 0.0;
    const bool may_be_number = rest[0] == '.' || rest[0] == '-' || (rest[0] >= '0' && rest[0] <= '9');
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
    if (may_be_number && error == std::errc{} && std::isfinite(value)) {
      now_ = {Token::Kind::kNumber, rest.substr(0, static_cast<std::size_t>(end - rest.data())), value, at};
      return;
    }
    for (const std::string_view sign : kSigns) {
      if (!rest.starts_with(sign)) continue;
      now_ = {Token::Kind::kSign, rest.substr(0, sign.size()), 0.0, at};
      return;
    }
    std::size_t size = 0;
    while (size < rest.size() && begins_in_word(rest.substr(size))) ++size;
    now_ = {size > 0 ? Token::Kind::kWord : Token::Kind::kSign,
            rest.substr(0, std::max<std::size_t>(size, 1)), 0.0, at};
  }

  const Written& written_;
  std::string_view text_;
  Token now_;
  std::size_t last_end_ = 0;
};

namespace {

// That a run may have.
constexpr std::array<std::string_view, 4> kOutcomes = {"done", "failed", "aborted", "interrupted"};

std::vector<std::string> known_names() {
  std::vector<std::string> out = {"outcome"};
  for (const NumberInfo& info : kNumbers) out.emplace_back(info.name);
  return out;
}

}  // namespace

class ConditionParser {
 public:
  explicit ConditionParser(const Written& written) : tokens_(written) { out_.text_ = written.text; }

  text::Result<Condition> parse() {
    out_.root_ = any();
    if (!problem_ && tokens_.now().kind != Token::Kind::kEnd) fail("`and`, `or`, or the end");
    if (problem_) return std::unexpected(std::move(*problem_));
    return std::move(out_);
  }

 private:
  using Node = Condition::Node;
  static constexpr int kDeepest = 50;

  void fail(std::string_view what) {
    if (!problem_) problem_ = tokens_.expected(what);
  }
  std::size_t add(Node node, std::size_t begin) {
    node.begin = begin;
    node.end = tokens_.last_end();
    out_.nodes_.push_back(std::move(node));
    return out_.nodes_.size() - 1;
  }

  // Several of the next stronger kind, joined by a word.
  template <class Read>
  std::size_t joined(std::string_view word, Node::Kind kind, Read read) {
    const std::size_t begin = tokens_.now().begin;
    Node node;
    node.kind = kind;
    do node.parts.push_back(read());
    while (!problem_ && tokens_.take(word));
    return node.parts.size() == 1 ? node.parts.front() : add(std::move(node), begin);
  }
  std::size_t any() {
    return joined("or", Node::Kind::kOr, [this] { return all(); });
  }
  std::size_t all() {
    return joined("and", Node::Kind::kAnd, [this] { return one(); });
  }
  std::size_t one() {
    const std::size_t begin = tokens_.now().begin;
    if (problem_ || ++depth_ > kDeepest) {
      fail("fewer parentheses within each other");
      return 0;
    }
    std::size_t out = 0;
    if (tokens_.take("not")) {
      Node node;
      node.kind = Node::Kind::kNot;
      node.parts.push_back(one());
      out = add(std::move(node), begin);
    } else if (tokens_.take("(")) {
      out = any();
      if (!problem_ && !tokens_.take(")")) fail("`)`");
    } else {
      out = comparison();
    }
    --depth_;
    return out;
  }

  std::size_t comparison() {
    const std::size_t begin = tokens_.now().begin;
    Node node;
    if (!name(node)) return 0;
    if (!relation(node)) return 0;
    const Token value = tokens_.now();
    if (node.kind == Node::Kind::kNumber) {
      if (value.kind != Token::Kind::kNumber) fail("a number");
      node.value = value.value;
    } else {
      if (value.kind != Token::Kind::kWord || std::ranges::find(kOutcomes, value.text) == kOutcomes.end())
        fail(fmt::format("an outcome: {}", fmt::join(kOutcomes, ", ")));
      node.word = value.text;
    }
    if (problem_) return 0;
    tokens_.advance();
    return add(std::move(node), begin);
  }

  bool name(Node& node) {
    const Token token = tokens_.now();
    const auto number = std::ranges::find_if(kNumbers, [&](const NumberInfo& info) {
      return token.text == info.name || token.text == column(info);
    });
    if (token.kind == Token::Kind::kWord && token.text == "outcome") {
      node.kind = Node::Kind::kOutcome;
    } else if (token.kind == Token::Kind::kWord && number != kNumbers.end()) {
      node.kind = Node::Kind::kNumber;
      node.number = number->number;
    } else {
      fail("a number of the run");
      const std::vector<std::string> known = known_names();
      const std::string nearest = text::nearest_name(token.text, known);
      problem_->hints.push_back(nearest.empty()
                                    ? "`duration`, `contacts`, `outcome` and others: docs/batch.md"
                                    : fmt::format("did you mean `{}`?", nearest));
      return false;
    }
    tokens_.advance();
    return true;
  }

  bool relation(Node& node) {
    using Relation = Node::Relation;
    constexpr std::pair<std::string_view, Relation> kRelations[] = {
        {"==", Relation::kEqual},  {"!=", Relation::kUnequal}, {"<", Relation::kLess},
        {"<=", Relation::kAtMost}, {">", Relation::kMore},     {">=", Relation::kAtLeast}};
    for (const auto& [sign, relation] : kRelations) {
      const bool is_for_words = relation == Relation::kEqual || relation == Relation::kUnequal;
      if ((node.kind == Node::Kind::kNumber || is_for_words) && tokens_.take(sign)) {
        node.relation = relation;
        return true;
      }
    }
    fail(node.kind == Node::Kind::kNumber ? "`==`, `!=`, `<`, `<=`, `>` or `>=`" : "`==` or `!=`");
    return false;
  }

  Tokens tokens_;
  Condition out_;
  std::optional<text::Diagnostic> problem_;
  int depth_ = 0;
};

text::Result<Condition> Condition::parse(const Written& written) {
  return ConditionParser(written).parse();
}

bool Condition::holds(const Row& row, std::size_t index) const {
  const Node& node = nodes_[index];
  const auto holds_too = [&](std::size_t part) { return holds(row, part); };
  switch (node.kind) {
    case Node::Kind::kAnd:
      return std::ranges::all_of(node.parts, holds_too);
    case Node::Kind::kOr:
      return std::ranges::any_of(node.parts, holds_too);
    case Node::Kind::kNot:
      return !holds_too(node.parts.front());
    case Node::Kind::kOutcome:
      return (row.outcome == node.word) == (node.relation == Node::Relation::kEqual);
    case Node::Kind::kNumber:
      break;
  }
  const double found = row[node.number];
  if (std::isnan(found)) return false;
  switch (node.relation) {
    case Node::Relation::kEqual:
      return found == node.value;
    case Node::Relation::kUnequal:
      return found != node.value;
    case Node::Relation::kLess:
      return found < node.value;
    case Node::Relation::kAtMost:
      return found <= node.value;
    case Node::Relation::kMore:
      return found > node.value;
    case Node::Relation::kAtLeast:
      return found >= node.value;
  }
  return false;
}

std::string Condition::unfulfilled(const Row& row) const {
  const Node& root = nodes_[root_];
  if (root.kind != Node::Kind::kAnd) return text_;
  for (const std::size_t part : root.parts) {
    const Node& node = nodes_[part];
    if (!holds(row, part)) return text_.substr(node.begin, node.end - node.begin);
  }
  return {};
}

namespace {

// ` @ 0.99` or nothing, and then the end.
std::optional<text::Diagnostic> read_confidence(Tokens& tokens, double& confidence) {
  if (tokens.take("@")) {
    const Token value = tokens.now();
    if (value.kind != Token::Kind::kNumber || !(value.value >= 0.5) || !(value.value < 1.0))
      return tokens.expected("a confidence from 0.5 to below 1");
    confidence = value.value;
    tokens.advance();
  }
  if (tokens.now().kind == Token::Kind::kEnd) return std::nullopt;
  return tokens.expected("`@` with a confidence, or the end");
}

}  // namespace

text::Result<Requirement> Requirement::parse(const Written& written) {
  Tokens tokens(written);
  Requirement out;
  out.text = written.text;
  if (!tokens.take("success")) return std::unexpected(tokens.expected("`success`"));
  out.is_at_least = tokens.at(">=");
  if (!tokens.take(">=") && !tokens.take("<=")) return std::unexpected(tokens.expected("`>=` or `<=`"));
  const Token share = tokens.now();
  if (share.kind != Token::Kind::kNumber || !(share.value >= 0.0) || share.value > 1.0)
    return std::unexpected(tokens.expected("a share from 0 to 1"));
  out.share = share.value;
  tokens.advance();
  if (auto problem = read_confidence(tokens, out.confidence)) return std::unexpected(std::move(*problem));
  return out;
}

text::Result<Until> Until::parse(const Written& written) {
  Tokens tokens(written);
  Until out;
  out.text = written.text;
  out.is_decided = tokens.take("decided");
  if (out.is_decided) {
    if (tokens.now().kind != Token::Kind::kEnd) return std::unexpected(tokens.expected("the end"));
    return out;
  }
  if (!tokens.take("success")) return std::unexpected(tokens.expected("`decided` or `success`"));
  if (!tokens.take("+-") && !tokens.take(kPlusMinus)) return std::unexpected(tokens.expected("`+-`"));
  const Token width = tokens.now();
  if (width.kind != Token::Kind::kNumber || !(width.value > 0.0) || width.value >= 0.5)
    return std::unexpected(tokens.expected("a share above 0 and below 0.5"));
  out.half_width = width.value;
  tokens.advance();
  if (auto problem = read_confidence(tokens, out.confidence)) return std::unexpected(std::move(*problem));
  return out;
}

}  // namespace mlab::study
