#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <initializer_list>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mlab/lang/cdl/print/print_items.h"
#include "mlab/lang/cdl/syntax/lexer.h"
#include "mlab/lang/cdl/syntax/pieces.h"
#include "mlab/lang/cdl/syntax/tree.h"

// The words of a changed tree, with where they stood in the text before (for `reprint`).

namespace mlab::cdl {

inline constexpr std::size_t kNoToken = static_cast<std::size_t>(-1);

inline std::uint32_t bytes_in(std::string_view text) {
  return static_cast<std::uint32_t>(text.size());
}

inline bool is_any_word(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::ranges::find(words, word) != words.end();
}

/// A word of the new text, with where it stood.
struct NewWord {
  std::string_view text;
  const Pieces* from = nullptr;  ///< null: nowhere
  std::size_t token = 0;
  int lines = 0;         ///< that begin here: 1 a line, 2 an empty one as well
  int help = -1;         ///< of what begins here
  int help_behind = -1;  ///< of the parameter that ends here

  bool follows(const NewWord& other) const {
    return from != nullptr && from == other.from && token == other.token + 1;
  }
};

struct Help {
  std::string text;
  bool is_of_parameter = false;  ///< then it stands behind that
};

/// The declarations that may have changed, and their neighbours.
struct Region {
  std::size_t first_token = 0;
  std::size_t end_token = 0;  ///< behind the last one
  text::Span bytes;           ///< with the comments
  std::vector<const Item*> items;

  bool reaches_end(const Pieces& old) const { return end_token == old.end(); }
};

inline Region region_of(const Tree& was, const std::vector<const Item*>& now, const Pieces& old) {
  const std::size_t count = was.items.size();
  const auto whole = [&](std::size_t at) {
    return std::visit([](const auto& one) { return one.whole; }, was.items[at]);
  };
  std::size_t first = 0;
  while (first < std::min(count, now.size()) && now[first] == &was.items[first]) ++first;
  std::size_t same = 0;  // at the end
  while (same < std::min(count, now.size()) - first &&
         now[now.size() - 1 - same] == &was.items[count - 1 - same])
    ++same;
  const auto is_apart = [&](std::size_t at) {  // from the one before it
    const std::uint32_t begin = old.begin_with_comments(old.token_at(whole(at).begin));
    return old.lines_before({begin, begin}) > 1;
  };
  // With one more on either side, and with those that no empty line parts from them.
  if (first > 0) --first;
  while (first > 0 && !is_apart(first)) --first;
  if (same > 0) --same;
  while (same > 0 && !is_apart(count - same)) --same;
  Region out;
  out.items.assign(now.begin() + static_cast<std::ptrdiff_t>(first),
                   now.end() - static_cast<std::ptrdiff_t>(same));
  out.first_token = first == 0 ? 0 : old.token_at(whole(first).begin);
  out.end_token = same == 0 ? old.end() : old.token_at(whole(count - same).begin);
  out.bytes = {0, bytes_in(old.text())};
  if (first > 0) out.bytes.begin = old.begin_with_comments(out.first_token);
  if (same > 0) out.bytes.end = old.end_with_comments(out.end_token - 1);
  return out;
}

/// Gathers the words that a Printer says, and finds out where they stood.
class Words {
 public:
  Words(const Tree& was, const std::vector<const Item*>& now)
      : was_(was),
        source_(was.source),
        old_(pieces_of(source_)),
        is_used_(old_.end() + 1, false),
        region_(region_of(was, now, old_)) {
    put_items(*this, region_.items);
    match();
  }

  const Pieces& old() const { return old_; }
  const Region& region() const { return region_; }
  const std::vector<NewWord>& all() const { return words_; }
  const Help& help(int at) const { return helps_[static_cast<std::size_t>(at)]; }
  /// Whether a token of the old text stands in the new one.
  bool is_used(std::size_t token) const { return is_used_[token]; }

  // ---- what the printer says

  void word(std::string_view text) {
    const std::size_t first = std::exchange(first_, kNoToken);
    const std::size_t at = words_.size();
    add_new(text);
    if (first != kNoToken && claim(first)) stood_at(at, old_, first);
  }
  void word(const Word& word) { add_chosen(word.place, word.text); }
  void quoted(const Word& word) { add_chosen(word.place, '"' + word.text + '"'); }
  void begin(const text::Place& at) {
    first_ = at.source == source_ ? old_.token_at(at.span.begin) : kNoToken;
  }
  static bool has(const text::SourcePtr& source, text::Span whole) {
    return source != nullptr && whole.end > whole.begin;
  }
  void take(const text::SourcePtr& source, text::Span whole) {
    first_ = kNoToken;
    const Pieces& from = pieces_of(source);
    for (std::size_t i = from.token_at(whole.begin); i < from.end() && from.token(i).begin < whole.end; ++i)
      add_old(from, i);
  }
  void line() { lines_ = std::max(lines_, 1); }
  void paragraph() { lines_ = 2; }
  void help(const std::string& help) { help_ = keep_help({help, false}); }
  void begin_parameter(const std::string& help) { parameter_help_ = help_ = keep_help({help, true}); }
  void end_parameter() {
    words_[words_.size() - (words_.back().text == "," ? 2 : 1)].help_behind = parameter_help_;
  }
  void separate() {}  // as its author has it
  std::optional<std::uint32_t> order(const text::Place& at) const {
    return at.source == source_ ? std::optional(at.span.begin) : std::nullopt;
  }
  std::optional<std::uint32_t> order_of_body(const Expression& body) const {
    return was_body(body) ? std::optional(body.place.span.begin) : std::nullopt;
  }
  bool wants_semicolon(const Expression& body) const {
    if (!was_body(body)) return words_.back().text != "}";
    std::size_t behind = old_.token_at(std::max(body.place.span.end, body.whole.end));
    while (old_.word(behind) == ")") ++behind;
    return old_.word(behind) == ";";
  }

 private:
  // New words between two that stood somewhere are those that stood between them, as far as they are equal
  // from either side.
  void match() {
    for (std::size_t begin = 0; begin < words_.size();) {
      if (words_[begin].from != nullptr) {
        ++begin;
        continue;
      }
      std::size_t end = begin;
      while (end < words_.size() && words_[end].from == nullptr) ++end;
      match(begin, end);
      begin = end;
    }
  }
  void match(std::size_t begin, std::size_t end) {
    const NewWord before = begin == 0 ? NewWord{{}, &old_, region_.first_token - 1} : words_[begin - 1];
    const NewWord behind = end == words_.size() ? NewWord{{}, &old_, region_.end_token} : words_[end];
    const auto is_word = [&](std::size_t at, const Pieces& from, std::size_t token) {
      return from.word(token) == words_[at].text && (&from != &old_ || claim(token));
    };
    std::size_t next = before.token + 1;
    const bool is_between = behind.from == before.from && behind.token >= next;
    const std::size_t limit = is_between ? behind.token : before.from->end();
    for (; begin < end && next < limit && is_word(begin, *before.from, next); ++begin, ++next)
      stood_at(begin, *before.from, next);
    std::size_t last = behind.token;
    const std::size_t least = is_between ? next : 0;
    for (; begin < end && last > least && is_word(end - 1, *behind.from, last - 1); --end, --last)
      stood_at(end - 1, *behind.from, last - 1);
  }

  const Pieces& pieces_of(const text::SourcePtr& source) {
    std::unique_ptr<Pieces>& known = pieces_[source.get()];
    if (!known) known = std::make_unique<Pieces>(source->text());
    return *known;
  }
  std::string_view keep(std::string_view text) { return kept_.emplace_back(text); }
  int keep_help(Help help) {
    helps_.push_back(std::move(help));
    return static_cast<int>(helps_.size()) - 1;
  }
  // A word stands in one place: what is there twice is new the second time.
  bool claim(std::size_t token) {
    const bool is_free = !is_used_[token];
    is_used_[token] = true;
    return is_free;
  }
  void add(NewWord word) {
    word.lines = std::exchange(lines_, 0);
    word.help = std::exchange(help_, -1);
    words_.push_back(word);
  }
  void add_old(const Pieces& from, std::size_t token) {
    const bool is_free = &from != &old_ || claim(token);
    add({from.word(token), is_free ? &from : nullptr, token});
  }
  void add_new(std::string_view text) {
    const std::string_view kept = keep(text);
    for (const Token& token : lex(kept).tokens) {
      if (token.kind != Token::Kind::kEnd)
        add({kept.substr(token.span.begin, token.span.end - token.span.begin)});
    }
  }
  // One that is called otherwise now still is the word that stood there.
  void add_chosen(const text::Place& place, const std::string& text) {
    first_ = kNoToken;
    if (!has(place.source, place.span)) {
      add_new(text);
      return;
    }
    const Pieces& from = pieces_of(place.source);
    if (from.text(place.span) == text) {
      take(place.source, place.span);
      return;
    }
    const std::size_t at = words_.size();
    const std::size_t token = from.token_at(place.span.begin);
    add_new(text);
    if (&from != &old_ || claim(token)) stood_at(at, from, token);
  }
  void stood_at(std::size_t word, const Pieces& from, std::size_t token) {
    words_[word].from = &from;
    words_[word].token = token;
  }

  // It may have been another expression of the text.
  bool was_body(const Expression& body) const {
    return body.place.source == source_ && std::ranges::any_of(was_.items, [&](const Item& item) {
             const auto* owner = std::get_if<Assemblage>(&item);
             return owner != nullptr && owner->body && owner->body->place.span.begin == body.place.span.begin;
           });
  }

  const Tree& was_;
  text::SourcePtr source_;
  std::map<const text::Source*, std::unique_ptr<Pieces>> pieces_;
  const Pieces& old_;
  std::vector<NewWord> words_;
  std::vector<bool> is_used_;
  Region region_;
  std::deque<std::string> kept_;
  std::deque<Help> helps_;
  // Of the next word:
  std::size_t first_ = kNoToken;  // where it stood, if it is that word
  int lines_ = 0;
  int help_ = -1;
  int parameter_help_ = -1;
};

}  // namespace mlab::cdl
