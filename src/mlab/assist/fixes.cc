// Offered mends. What a diagnostic says of itself gives candidates; each is tried before it is offered.

#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>
#include <tuple>

#include <fmt/core.h>

#include "mlab/assist/service.h"
#include "mlab/lang/cdl/syntax/parser.h"
#include "mlab/lang/cnl/parser.h"
#include "mlab/lang/mdl/mdl.h"
#include "mlab/lang/mdl/tree.h"
#include "mlab/lang/odl/odl.h"

namespace mlab::assist {
namespace {

constexpr std::size_t kMostCandidatesTried = 8;

using text::Span;

/// What stands in backticks, in order.
std::vector<std::string> quoted_words(std::string_view message) {
  std::vector<std::string> out;
  for (;;) {
    const std::size_t open = message.find('`');
    const std::size_t close = open == std::string_view::npos ? open : message.find('`', open + 1);
    if (close == std::string_view::npos) return out;
    out.emplace_back(message.substr(open + 1, close - open - 1));
    message.remove_prefix(close + 1);
  }
}

bool has_any(std::string_view text, std::initializer_list<std::string_view> pieces) {
  return std::ranges::any_of(pieces, [&](std::string_view piece) { return text.contains(piece); });
}

/// Gathers candidates for one diagnostic.
class Candidates {
 public:
  Candidates(const Text& text, const text::Diagnostic& problem)
      : text_(text), problem_(problem), span_(problem.place.span), all_(text.source->text()) {
    span_.end = std::min(span_.end, static_cast<std::uint32_t>(all_.size()));
    span_.begin = std::min(span_.begin, span_.end);
    here_ = all_.substr(span_.begin, span_.end - span_.begin);
  }

  std::vector<Fix> run() {
    from_hints();
    from_kind();
    from_expectation();
    from_ranges_and_units();
    if (out_.size() > kMostCandidatesTried) out_.resize(kMostCandidatesTried);
    return std::move(out_);
  }

 private:
  void offer(std::string title, std::vector<Splice> splices) {
    const bool is_known = std::ranges::any_of(out_, [&](const Fix& fix) { return fix.title == title; });
    if (!is_known) out_.push_back({std::move(title), std::move(splices)});
  }
  void replace(Span span, const std::string& with) { offer(fmt::format("write `{}`", with), {{span, with}}); }
  void insert(std::uint32_t at, const std::string& what, const std::string& shown) {
    offer(fmt::format("insert `{}`", shown), {{{at, at}, what}});
  }
  void remove(Span span, const std::string& shown) { offer(fmt::format("remove `{}`", shown), {{span, ""}}); }

  std::uint32_t line_begin(std::uint32_t at) const {
    const std::size_t newline = at == 0 ? std::string_view::npos : all_.rfind('\n', at - 1);
    return newline == std::string_view::npos ? 0 : static_cast<std::uint32_t>(newline) + 1;
  }
  std::uint32_t line_end(std::uint32_t at) const {
    std::size_t end = std::min(all_.find('\n', at), all_.size());
    while (end > at && (all_[end - 1] == '\r' || all_[end - 1] == ' ')) --end;
    return static_cast<std::uint32_t>(end);
  }

  // `did you mean X?`: the wrong word stands at the place, or in it.
  void from_hints() {
    for (const std::string& hint : problem_.hints) {
      const std::vector<std::string> words = quoted_words(hint);
      if (words.empty()) continue;
      if (hint.starts_with("did you mean")) {
        instead(words[0]);
      } else if (has_any(hint, {"a line `", "the header is `"})) {
        const std::uint32_t at = line_begin(span_.begin);
        insert(at, words[0] + "\n", words[0]);
        replace(span_, words[0]);
      } else if (hint.starts_with("write `") || hint.starts_with("say what it is") ||
                 hint.ends_with("makes one") || hint.contains(": write `")) {
        for (const std::string& word : words) {
          if (!word.contains("...")) replace(span_, word);
        }
      }
    }
  }

  void instead(const std::string& meant) {
    Span span = span_;
    for (const std::string& wrong : quoted_words(problem_.message)) {
      const std::size_t at = here_.find(wrong);
      if (wrong.empty() || at == std::string_view::npos) continue;
      span.begin = span_.begin + static_cast<std::uint32_t>(at);
      span.end = span.begin + static_cast<std::uint32_t>(wrong.size());
      break;
    }
    const std::string_view written = all_.substr(span.begin, span.end - span.begin);
    const bool is_quoted = written.size() > 1 && written.starts_with('"') && !meant.starts_with('"');
    replace(span, is_quoted ? '"' + meant + '"' : meant);
    if (span != span_) replace(span_, meant);
  }

  void from_kind() {
    const std::string& kind = problem_.kind;
    const std::string shown(here_.substr(0, std::min(here_.size(), here_.find('\n'))));
    if (has_any(kind, {"unclosed-text", "unterminated-string", "unclosed-string"})) {
      const std::uint32_t end = line_end(span_.begin);
      if (end > span_.begin && all_[end - 1] == ';') insert(end - 1, "\"", "\"");
      offer("insert `\"` at the end", {{{end, end}, "\""}});
    }
    if (kind == "unclosed-comment" || kind == "unterminated-comment") {
      insert(line_end(span_.begin), " */", "*/");
      insert(static_cast<std::uint32_t>(all_.size()), "*/\n", "*/");
    }
    if (kind == "unclosed-block") insert(span_.end, "\n}", "}");
    if (has_any(kind, {"stray-character", "skipped-characters", "unknown-character", "ignored-directive",
                       "freeze", "too-many-numbers", "nested-waypoint-file", "repeated-waypoint-file"}) ||
        problem_.message.contains("closes nothing")) {
      remove(span_, shown);
    }
    if (kind == "clause-not-allowed" || kind == "repeated-clause") remove_clause();
    if (kind == "unused-let" || kind == "unused-parameter") remove_declaration();
    if (kind == "no-way-out") insert(span_.begin, "final ", "final");
    if (kind == "no-start-state") start_state();
    if (kind == "missing-and") insert(span_.begin, "AND ", "AND");
    if (kind == "two-start-states") remove_word_before("start");
    if (kind == "same-trigger") remove_transition();
  }

  // A keyword with what belongs to it: up to the next word in capitals or the end of the line.
  void remove_clause() {
    std::uint32_t end = span_.end;
    const std::uint32_t last = line_end(span_.begin);
    while (end < last) {
      const std::size_t word = all_.find_first_not_of(" \t", end);
      if (word == std::string_view::npos || word >= last) break;
      std::size_t word_end = word;
      while (word_end < last && all_[word_end] != ' ' && all_[word_end] != '\t') ++word_end;
      const std::string_view text = all_.substr(word, word_end - word);
      const bool is_keyword = text.size() > 2 && std::ranges::all_of(text, [](unsigned char c) {
                                return std::isupper(c) != 0 || c == '-';
                              });
      if (is_keyword && end > span_.end) break;
      if (is_keyword && text != "MESSAGE" && text != "TIMEOUT" && !has_any(text, {"TRAVELING", "BOUNDING"}))
        break;
      end = static_cast<std::uint32_t>(word_end);
    }
    std::uint32_t begin = span_.begin;
    while (begin > 0 && all_[begin - 1] == ' ') --begin;
    remove({begin, end}, std::string(all_.substr(span_.begin, end - span_.begin)));
  }

  void remove_declaration() {
    const std::string name(here_);
    if (problem_.kind == "unused-let") {
      const std::uint32_t begin = line_begin(span_.begin);
      const std::size_t end = all_.find(';', span_.end);
      if (end == std::string_view::npos) return;
      std::size_t next = end + 1;
      while (next < all_.size() && (all_[next] == ' ' || all_[next] == '\t')) ++next;
      const bool is_own_line = next >= all_.size() || all_[next] == '\n';
      const bool is_at_start = all_.substr(begin, span_.begin - begin).find_first_not_of(" \t") ==
                               all_.substr(begin, span_.begin - begin).find("let");
      if (!is_at_start) return;
      remove({begin, static_cast<std::uint32_t>(is_own_line ? std::min(next + 1, all_.size()) : end + 1)},
             "let " + name);
      return;
    }
    // `, name: type = default` or `name: type = default, `
    int depth = 0;
    std::size_t end = span_.end;
    for (; end < all_.size(); ++end) {
      const char c = all_[end];
      if (depth == 0 && (c == ',' || c == ')')) break;
      if (c == '(' || c == '[') ++depth;
      if (c == ')' || c == ']') --depth;
    }
    if (end >= all_.size()) return;
    std::uint32_t begin = span_.begin;
    if (all_[end] == ',') {
      ++end;
      while (end < all_.size() && all_[end] == ' ') ++end;
    } else {
      while (begin > 0 && std::isspace(static_cast<unsigned char>(all_[begin - 1])) != 0) --begin;
      if (begin > 0 && all_[begin - 1] == ',') --begin;
    }
    remove({begin, static_cast<std::uint32_t>(end)}, name);
  }

  void start_state() {
    for (const std::string& hint : problem_.hints) {
      for (const std::string& word : quoted_words(hint)) {
        if (!word.starts_with("start ")) continue;
        const std::string name = word.substr(6, word.find(':') - 6);
        const std::size_t at = all_.find(name + ":", span_.begin);
        if (at != std::string_view::npos) insert(static_cast<std::uint32_t>(at), "start ", "start");
      }
    }
  }

  void remove_word_before(std::string_view word) {
    const std::string_view before =
        all_.substr(line_begin(span_.begin), span_.begin - line_begin(span_.begin));
    const std::size_t at = before.rfind(word);
    if (at == std::string_view::npos) return;
    const auto begin = static_cast<std::uint32_t>(line_begin(span_.begin) + at);
    remove({begin, span_.begin}, std::string(word));
  }

  void remove_transition() {
    const std::uint32_t begin = line_begin(span_.begin);
    const std::size_t end = all_.find(';', span_.end);
    const std::string_view head = all_.substr(begin, span_.begin - begin);
    if (end == std::string_view::npos || head.find_first_not_of(" \t") != head.find("when")) return;
    remove({begin, static_cast<std::uint32_t>(std::min(end + 2, all_.size()))}, "when");
  }

  // "expected `;` behind the member", "expected `goto` behind the trigger, found `got`"
  void from_expectation() {
    const std::string& message = problem_.message;
    if (!message.starts_with("expected")) return;
    const std::size_t found = message.find(", found");
    const bool is_behind = problem_.label == "behind this" || found == std::string::npos;
    if (here_.empty() && found != std::string::npos) next_word_instead(message, found);
    for (const std::string& word : quoted_words(message.substr(0, found))) {
      if (word.empty() || word.contains("...")) continue;
      const bool is_punctuation = std::ispunct(static_cast<unsigned char>(word[0])) != 0;
      const std::string spaced = is_punctuation ? word : word + " ";
      if (is_behind) {
        insert(span_.end, is_punctuation ? word : " " + word, word);
        continue;
      }
      if (found != std::string::npos && !is_punctuation && !here_.empty()) replace(span_, word);
      if (is_punctuation) insert(end_before(), word, word);
      insert(span_.begin, spaced, word);
      if (word.ends_with(':')) insert(line_begin(span_.begin), word + "\n", word);
    }
  }

  // The place is where the word should stand; what was found comes next, perhaps on the next line.
  void next_word_instead(const std::string& message, std::size_t found) {
    const std::vector<std::string> wrong = quoted_words(std::string_view(message).substr(found));
    const std::size_t at = all_.find_first_not_of(" \t\r\n", span_.end);
    if (wrong.empty() || wrong[0].empty() || at == std::string_view::npos ||
        !all_.substr(at).starts_with(wrong[0]))
      return;
    const auto begin = static_cast<std::uint32_t>(at);
    const Span span{begin, begin + static_cast<std::uint32_t>(wrong[0].size())};
    for (const std::string& word : quoted_words(std::string_view(message).substr(0, found))) {
      if (!word.empty() && word[0] == wrong[0][0]) replace(span, word);
    }
  }

  // Where what comes before the place ends.
  std::uint32_t end_before() const {
    std::uint32_t at = span_.begin;
    while (at > 0 && std::isspace(static_cast<unsigned char>(all_[at - 1])) != 0) --at;
    return at;
  }

  void from_ranges_and_units() {
    if (problem_.kind == "out-of-range") clamp();
    if (problem_.kind == "number-out-of-range") {
      nearest_of(problem_.label, " between ", " and ");
      nearest_of(problem_.message, " from ", " to ");
    }
    if (problem_.kind != "wrong-unit") return;
    const std::size_t blank = here_.find(' ');
    if (problem_.message.contains("a plain number is expected") && blank != std::string_view::npos)
      replace(span_, std::string(here_.substr(0, blank)));
    constexpr std::string_view kStands = " stands where ";
    const std::size_t at = problem_.message.find(kStands);
    const std::size_t end = problem_.message.find(" is expected", at);
    if (at == std::string::npos || end == std::string::npos || blank == std::string_view::npos) return;
    // "a duration [s]"
    const std::string wanted = problem_.message.substr(at + kStands.size(), end - at - kStands.size());
    const std::size_t bracket = wanted.find(" [");
    if (bracket == std::string::npos || !wanted.ends_with(']')) return;
    const std::string unit = wanted.substr(bracket + 2, wanted.size() - bracket - 3);
    if (!unit.contains(' ')) replace(span_, fmt::format("{} {}", here_.substr(0, blank), unit));
  }

  // The label says "`x` takes 0 .. 5 [m]".
  void clamp() {
    const std::size_t takes = problem_.label.find(" takes ");
    if (takes == std::string::npos) return;
    const std::string_view range = std::string_view(problem_.label).substr(takes + 7);
    const std::size_t dots = range.find(" .. ");
    if (dots == std::string_view::npos) return;
    std::string_view unit;
    std::string_view high = range.substr(dots + 4);
    if (const std::size_t bracket = high.find(" ["); bracket != std::string_view::npos) {
      unit = high.substr(bracket + 2, high.size() - bracket - 3);
      high = high.substr(0, bracket);
    }
    for (const std::string_view bound : {range.substr(0, dots), high}) {
      if (bound.contains("e+")) continue;  // no bound at all
      replace(span_, unit.empty() ? std::string(bound) : fmt::format("{} {}", bound, unit));
    }
  }

  // "heading goes from 0 to 360 degrees, found `400`", "rain is between 0 and 1".
  void nearest_of(const std::string& said, std::string_view before, std::string_view between) {
    const std::size_t from = said.find(before);
    const std::size_t to = from == std::string::npos ? from : said.find(between, from + before.size());
    if (to == std::string::npos) return;
    const std::size_t begin = from + before.size();
    const std::string low = said.substr(begin, to - begin);
    const std::size_t last = to + between.size();
    const std::string high = said.substr(last, said.find_first_of(" ,", last) - last);
    const auto value = [](std::string_view word) {
      double out = 0.0;
      const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), out);
      return error == std::errc{} && end == word.data() + word.size() ? std::optional(out) : std::nullopt;
    };
    const auto [bottom, top, here] = std::tuple(value(low), value(high), value(here_));
    if (!bottom || !top || *bottom >= *top) return;
    replace(span_, here && *here < *bottom ? low : high);
  }

  const Text& text_;
  const text::Diagnostic& problem_;
  Span span_;
  std::string_view all_;
  std::string_view here_;
  std::vector<Fix> out_;
};

std::size_t syntax_errors(const Text& text) {
  text::Diagnostics sink;
  switch (text.language) {
    case Language::kConfiguration:
      cdl::parse(text.source, sink);
      break;
    case Language::kNetwork:
      cnl::parse(text.source, sink);
      break;
    case Language::kMission:
      mdl::parse(text.source, sink);
      break;
    case Language::kOverlay:
      odl::parse(text.source, sink);
      break;
    case Language::kEnvironment:
      break;
  }
  return sink.error_count();
}

Text mended(const Text& text, const Fix& fix) {
  std::string out;
  std::uint32_t at = 0;
  for (const Splice& splice : fix.splices) {
    out += text.source->text({at, splice.span.begin});
    out += splice.text;
    at = splice.span.end;
  }
  out += text.source->text().substr(at);
  return {std::make_shared<const text::Source>(text.source->name(), std::move(out)), text.language};
}

/// Where an offset stands after the mend.
std::uint32_t moved(std::uint32_t offset, const Fix& fix) {
  std::int64_t out = offset;
  for (const Splice& splice : fix.splices) {
    if (splice.span.begin >= offset) break;
    out += static_cast<std::int64_t>(splice.text.size()) - (splice.span.end - splice.span.begin);
  }
  return static_cast<std::uint32_t>(std::max<std::int64_t>(out, 0));
}

bool is_same(const text::Diagnostic& a, const text::Diagnostic& b, std::uint32_t at) {
  return a.kind == b.kind && a.message == b.message && a.place.span.begin == at &&
         (a.place.source == nullptr) == (b.place.source == nullptr);
}

/// What is wrong with a text, counted.
struct Count {
  std::size_t syntax = 0;
  std::size_t errors = 0;
  std::size_t alike = 0;  ///< of one kind
};

Count counted(const Text& text, const text::Diagnostics& all, const std::string& kind) {
  Count out;
  out.syntax = syntax_errors(text);
  out.errors = all.error_count();
  out.alike = static_cast<std::size_t>(std::ranges::count(all.items(), kind, &text::Diagnostic::kind));
  return out;
}

}  // namespace

std::vector<Fix> fixes(const Text& text, const text::Diagnostic& problem, const Surroundings& around) {
  if (problem.place.source == nullptr || problem.place.source->name() != text.source->name()) return {};
  std::vector<Fix> candidates = Candidates(text, problem).run();
  if (candidates.empty()) return {};
  Surroundings quick = around;
  quick.checks_code = false;
  const Count before = counted(text, problems(text, quick), problem.kind);
  std::vector<Fix> out;
  for (Fix& fix : candidates) {
    const Text with = mended(text, fix);
    const text::Diagnostics rest = problems(with, quick);
    const std::uint32_t at = moved(problem.place.span.begin, fix);
    const bool is_gone = std::ranges::none_of(
        rest.items(), [&](const text::Diagnostic& other) { return is_same(other, problem, at); });
    const Count after = counted(with, rest, problem.kind);
    // Once a text can be read, more is looked at: then what is found may be more than before.
    const bool is_better =
        after.syntax < before.syntax || (after.syntax == before.syntax &&
                                         (problem.severity == text::Severity::kError
                                              ? after.errors < before.errors
                                              : after.errors <= before.errors && after.alike < before.alike));
    if (is_gone && is_better) out.push_back(std::move(fix));
  }
  return out;
}

}  // namespace mlab::assist
