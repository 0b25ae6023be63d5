#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include "mlab/assist/statement_candidates.h"
#include "mlab/lang/odl/grammar.h"
#include "mlab/lang/odl/lexer.h"
#include "mlab/percept/object_classes.h"

namespace mlab::assist {
namespace {

using odl::Keyword;

/// Looks at the words of the statement that the cursor is in.
class OverlayCompleter {
 public:
  OverlayCompleter(const std::string& before, StatementCandidates& out) : out_(out) {
    text::Diagnostics unsaid;
    std::vector<odl::Comment> comments;
    odl::lex(std::make_shared<const text::Source>("", before), tokens_, comments, unsaid);
    tokens_.pop_back();  // the end
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      has_header_ |= tokens_[i].kind == odl::TokenKind::kHeader;
      const bool is_name = i > 0 && is_behind_named_keyword(i);
      const bool begins =
          odl::starts_statement(tokens_[i].keyword) || tokens_[i].kind == odl::TokenKind::kHeader;
      if (begins && (tokens_[i].starts_line || !is_name)) first_ = i;
    }
  }

  void run() {
    if (tokens_.empty()) {
      statements();
      return;
    }
    const odl::Token& keyword = tokens_[first_];
    if (keyword.kind == odl::TokenKind::kHeader) {
      statements();
      return;
    }
    const odl::Rule& rule = odl::rule_of(keyword.keyword);
    const std::size_t words = tokens_.size() - first_ - 1;
    const Keyword last = tokens_.back().keyword;
    if (rule.form == odl::Form::kSet && words == 0) {
      out_.add("ZOOM-FACTOR", "keyword", "per cent, 10 to 400");
      return;
    }
    if (last == Keyword::kUtm) {
      out_.add("LAT", "keyword", "degrees north");
      out_.add("LON", "keyword", "degrees east");
      return;
    }
    if (last == Keyword::kGeo) return;  // a place in quotes
    if (is_between(Keyword::kLat, Keyword::kLon)) {
      out_.add("LON", "keyword", "degrees east");
      return;
    }
    if (is_between(Keyword::kLon, Keyword::kLat)) {
      out_.add("LAT", "keyword", "degrees north");
      return;
    }
    if (rule.form == odl::Form::kHallway) {
      hallway(words);
      return;
    }
    if (rule.form == odl::Form::kObject) {
      object();
      return;
    }
    if (rule.form == odl::Form::kMoving) {
      if (words < 2) points();
      if (words >= 2 * rule.min_points + rule.min_numbers) route();
      return;
    }
    const bool is_named =
        rule.form == odl::Form::kName || rule.form == odl::Form::kFile || rule.form == odl::Form::kNamed;
    if (is_named && words == 0) return;  // a new name
    if (rule.max_points > 0) points();
    const std::size_t least =
        (is_named && rule.max_points > 0 ? 1U : 0U) + 2 * rule.min_points + rule.min_numbers;
    if (words >= std::max<std::size_t>(least, 1)) statements();
  }

 private:
  // A reserved word that stands where a name has to is just a name.
  bool is_behind_named_keyword(std::size_t i) const {
    if (i - 1 != first_) return false;
    const odl::Form form = odl::rule_of(tokens_[i - 1].keyword).form;
    return form == odl::Form::kName || form == odl::Form::kNamed || form == odl::Form::kHallway ||
           form == odl::Form::kFile;
  }

  // `first` and a number, and nothing of `second` before them.
  bool is_between(Keyword first, Keyword second) const {
    const std::size_t n = tokens_.size();
    if (n < 3 || tokens_[n - 1].kind != odl::TokenKind::kNumber || tokens_[n - 2].keyword != first)
      return false;
    return tokens_[n - 3].keyword == Keyword::kUtm && tokens_[n - 3].keyword != second;
  }

  bool has(Keyword keyword) const {
    return std::any_of(tokens_.begin() + static_cast<std::ptrdiff_t>(first_), tokens_.end(),
                       [&](const odl::Token& token) { return token.keyword == keyword; });
  }

  // A point that is not in metres begins with one of these.
  void points() {
    out_.add("UTM", "keyword", "LAT degrees LON degrees");
    out_.add("GEO", "keyword", "\"48.2 N 16.4 E\", or in UTM or MGRS");
  }

  void hallway(std::size_t words) {
    if (words == 0) return;
    if (!has(Keyword::kCenterline)) {
      out_.add("CENTERLINE", "keyword", "points");
      return;
    }
    points();
    if (!has(Keyword::kWidth)) {
      out_.add("WIDTH", "keyword", "metres");
      return;
    }
    if (!has(Keyword::kExtents)) {
      out_.add("EXTENTS", "keyword", "points");
      return;
    }
    statements();
  }

  // Behind all else that the statement needs.
  void route() {
    if (tokens_.back().keyword == Keyword::kSpeed) return;  // a number
    if (!has(Keyword::kRoute)) {
      out_.add("ROUTE", "keyword", "points");
      statements();
    } else if (!has(Keyword::kSpeed)) {
      points();
      out_.add("SPEED", "keyword", "m/s");
    } else {
      statements();
    }
  }

  void object() {
    const Keyword last = tokens_.back().keyword;
    const bool has_style = has(Keyword::kMovable) || has(Keyword::kFixed) || has(Keyword::kContainer);
    if (last == Keyword::kMovable || last == Keyword::kFixed || last == Keyword::kContainer) {
      for (const percept::ObjectClassInfo& one : percept::kObjectClasses)
        out_.add(std::string(one.color_word), "color", "");
    } else if (!has_style) {
      out_.add("MOVABLE", "keyword", "can be carried");
      out_.add("FIXED", "keyword", "can't be carried");
      out_.add("CONTAINER", "keyword", "holds things");
    } else {
      route();
    }
  }

  void statements() {
    for (const odl::Word& word : odl::words()) {
      const bool fits = has_header_ ? odl::is_feature(word.keyword) : odl::is_information(word.keyword);
      if (fits) out_.add(std::string(word.spelling), "keyword", odl::rule_of(word.keyword).usage);
    }
    if (!has_header_) out_.add("CONTROL MEASURES:", "keyword", "the features follow");
  }

  StatementCandidates& out_;
  std::vector<odl::Token> tokens_;
  std::size_t first_ = 0;  // word of the statement at the cursor
  bool has_header_ = false;
};

}  // namespace

void complete_overlay(const std::string& before, StatementCandidates& out) {
  OverlayCompleter(before, out).run();
}

}  // namespace mlab::assist
