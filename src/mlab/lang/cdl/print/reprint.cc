#include "mlab/lang/cdl/print/reprint.h"

#include <algorithm>
#include <deque>
#include <map>
#include <memory>
#include <set>
#include <string_view>
#include <utility>

#include "mlab/lang/cdl/print/format.h"
#include "mlab/lang/cdl/print/words.h"
#include "mlab/lang/cdl/syntax/help.h"
#include "mlab/lang/cdl/syntax/pieces.h"

namespace mlab::cdl {
namespace {

bool is_behind_help(std::string_view comment) {
  return comment.starts_with("///<");
}

std::string help_of(const Pieces& from, const std::vector<std::size_t>& comments) {
  std::vector<std::string_view> lines;
  for (const std::size_t one : comments) lines.push_back(from.text(from.comment(one)));
  return cdl::help_of(lines);
}

/// Puts comments among the words, and blanks between all of them.
class Assembly {
 public:
  explicit Assembly(const Words& words) : words_(words), old_(words.old()), region_(words.region()) {}

  Reprinted run() {
    find_orphans();
    find_moved();
    if (region_.first_token == 0) put_comments(old_, old_.header());
    for (std::size_t i = 0; i < words_.all().size(); ++i) put_word(i);
    put_comments(old_, adopted_[region_.end_token]);
    if (region_.reaches_end(old_)) put_comments(old_, old_.comments_before(old_.end()));
    return finished();
  }

 private:
  struct Put {
    std::string_view text;
    const Pieces* from = nullptr;
    text::Span span = {};   // there
    std::size_t piece = 0;  // there
    int lines = 0;
    bool is_comment = false;
    bool is_joined = false;  // stands on the line of what is before it
  };

  // ---- comments

  // What stood at words that are gone goes to the next one that is left. Help goes with what it described.
  void find_orphans() {
    std::vector<std::size_t> carried;
    for (std::size_t token = region_.first_token; token <= region_.end_token; ++token) {
      if (token == region_.end_token || words_.is_used(token)) {
        if (!carried.empty()) adopted_[token] = std::exchange(carried, {});
        continue;
      }
      std::vector<std::size_t> help =
          begins_element(token) ? old_.help_before(token) : std::vector<std::size_t>();
      for (const std::size_t one : old_.comments_before(token)) {
        if (std::ranges::find(help, one) == help.end()) carried.push_back(one);
      }
      for (const std::size_t one : old_.comments_behind(token)) {
        if (!is_behind_help(old_.text(old_.comment(one)))) carried.push_back(one);
      }
      if (!help.empty()) lost_helps_.push_back(std::move(help));
    }
  }
  bool begins_element(std::size_t token) const {
    return token == 0 || is_any_word(old_.word(token - 1), {"{", "}", ";", "(", ","});
  }

  // An expression that stands elsewhere now: its lines were broken where it stood before. Comments keep
  // theirs.
  void find_moved() {
    is_joined_.resize(words_.all().size(), false);
    std::size_t last = kNoToken;  // old token
    bool is_moved = false;
    for (std::size_t i = 0; i < words_.all().size(); ++i) {
      const NewWord& word = words_.all()[i];
      if (word.from != &old_) continue;
      const bool follows = i > 0 && word.follows(words_.all()[i - 1]);
      const bool leaves = word.token > 0 && word.token != last + 1 &&
                          is_any_word(old_.word(word.token - 1), {"=", ":", "("}) &&
                          !is_any_word(word.text, {")", "]", ","});
      is_moved = leaves || (is_moved && follows);
      if (is_any_word(word.text, {"{", "}", ";"})) is_moved = false;
      is_joined_[i] = is_moved && follows && old_.lines_before(old_.token(word.token)) == 1 &&
                      old_.piece_of_token(word.token) == old_.piece_of_token(last) + 1;
      last = word.token;
    }
  }

  /// @param lines  that begin at the first of them
  void put_comments(const Pieces& from, const std::vector<std::size_t>& comments, int lines = 0) {
    for (const std::size_t one : comments) {
      if (!put_.emplace(&from, one).second) continue;
      const text::Span span = from.comment(one);
      stream_.push_back(
          {from.text(span), &from, span, from.piece_of_comment(one), std::exchange(lines, 0), true});
    }
  }
  void forget(const Pieces& from, const std::vector<std::size_t>& comments) {
    for (const std::size_t one : comments) put_.emplace(&from, one);
  }

  // The word whose comments stand before a word: itself, or, where a line begins with new ones, the first
  // that stood somewhere.
  const NewWord* owner_of_comments(std::size_t at) const {
    const std::vector<NewWord>& all = words_.all();
    if (all[at].from != nullptr) return &all[at];
    if (all[at].lines == 0 && all[at].help < 0) return nullptr;
    for (std::size_t i = at + 1; i < all.size() && all[i].lines == 0 && all[i].help < 0; ++i) {
      if (all[i].from != nullptr) return &all[i];
    }
    return nullptr;
  }

  void put_word(std::size_t at) {
    const NewWord& word = words_.all()[at];
    Put put{word.text};
    put.is_joined = is_joined_[at];
    const std::size_t before = stream_.size();
    put_before(at);
    put.lines = stream_.size() > before ? std::min(word.lines, 1) : word.lines;
    put.from = word.from;
    if (word.from != nullptr) {
      put.span = word.from->token(word.token);
      put.piece = word.from->piece_of_token(word.token);
    }
    stream_.push_back(put);
    put_behind(at);
  }

  void put_before(std::size_t at) {
    const NewWord& word = words_.all()[at];
    const NewWord* owner = owner_of_comments(at);
    if (owner == nullptr) {
      if (word.help >= 0) put_new_help(word, 0);
      return;
    }
    const Pieces& from = *owner->from;
    const std::vector<std::size_t> help = from.help_before(owner->token);
    std::vector<std::size_t> others = from.comments_before(owner->token);
    others.resize(others.size() - help.size());
    const auto adopted = &from == &old_ ? adopted_.find(owner->token) : adopted_.end();
    if (adopted != adopted_.end()) put_comments(old_, adopted->second, word.lines);
    // Of another text comes what stands between the words that come, and their help.
    const bool is_continued = at > 0 && owner->follows(words_.all()[at - 1]);
    if (&from == &old_ || is_continued) put_comments(from, others, word.lines);
    const bool is_same =
        !help.empty() && word.help >= 0 && help_of(from, help) == words_.help(word.help).text;
    if (is_same && words_.help(word.help).is_of_parameter) said_helps_.insert(word.help);
    if (word.help < 0 || is_same) {
      put_comments(from, help, word.lines);
      return;
    }
    forget(from, help);
    put_new_help(word, from.lines_before(from.token(owner->token)));
  }

  /// @param lines  that ended before what it describes
  void put_new_help(const NewWord& word, int lines) {
    const Help& help = words_.help(word.help);
    if (help.is_of_parameter || help.text.empty()) return;
    for (const std::vector<std::size_t>& lost : lost_helps_) {
      if (put_.contains({&old_, lost.front()}) || help_of(old_, lost) != help.text) continue;
      put_comments(old_, lost, word.lines);
      return;
    }
    lines = std::max({lines, word.lines, 1});
    for (const std::string& line : help_lines(help.text)) put_new_comment(line, std::exchange(lines, 1));
  }

  void put_new_comment(const std::string& text, int lines) {
    Put put{kept_.emplace_back(text)};
    put.lines = lines;
    put.is_comment = true;
    stream_.push_back(put);
  }

  // Comments behind a word stand behind its comma or semicolon, too, unless they stood before that.
  void put_behind(std::size_t at) {
    const NewWord& word = words_.all()[at];
    if (word.from != nullptr) {
      for (const std::size_t one : word.from->comments_behind(word.token))
        behind_.emplace_back(word.from, one);
    }
    if (word.help_behind >= 0) change_help_behind(word);
    const NewWord* next = at + 1 < words_.all().size() ? &words_.all()[at + 1] : nullptr;
    const bool is_ended = next == nullptr || (next->text != "," && next->text != ";");
    std::erase_if(behind_, [&](const std::pair<const Pieces*, std::size_t>& one) {
      const bool stands_before = next != nullptr && next->follows(word) && one.first == word.from &&
                                 one.first->comment(one.second).begin < next->from->token(next->token).begin;
      if (is_ended || stands_before) put_comments(*one.first, {one.second});
      return is_ended || stands_before;
    });
    if (is_ended && !new_behind_.empty()) put_new_comment(std::exchange(new_behind_, {}), 0);
  }

  void change_help_behind(const NewWord& word) {
    const Help& help = words_.help(word.help_behind);
    if (word.from != nullptr) {
      std::vector<std::size_t> old;
      for (const auto& [from, one] : behind_) {
        if (from == word.from && is_behind_help(from->text(from->comment(one)))) old.push_back(one);
      }
      if (!old.empty() && help_of(*word.from, old) == help.text) return;
      std::erase_if(behind_, [&](const std::pair<const Pieces*, std::size_t>& one) {
        return one.first == word.from && std::ranges::find(old, one.second) != old.end();
      });
      forget(*word.from, old);
    }
    if (!help.text.empty() && !said_helps_.contains(word.help_behind)) new_behind_ = help_behind(help.text);
  }

  // ---- blanks

  static bool is_adjacent(const Put& a, const Put& b) {
    return b.from != nullptr && a.from == b.from && b.piece == a.piece + 1 && !b.is_joined;
  }
  static std::string_view between(const Put& a, const Put& b) {
    return a.from->text({a.span.end, b.span.begin});
  }
  int lines_between(const Put& a, const Put& b) const {
    if (a.is_comment && a.from == nullptr) return 1;
    int out = b.lines;
    if (b.from == &old_ && (b.lines > 0 || b.is_comment)) out = std::max(out, b.from->lines_before(b.span));
    if (b.from != nullptr && b.from == a.from)
      out = std::max(b.from->lines_before(b.span), a.from->lines_behind(a.span));
    const bool is_line = a.is_comment && a.text.starts_with("//");
    return std::min(std::max(out, is_line ? 1 : 0), 2);
  }
  std::string gap(const Put& a, const Put& b) const {
    if (is_adjacent(a, b)) return std::string(between(a, b));
    if (b.is_joined) return " ";
    const int lines = lines_between(a, b);
    return lines == 0 ? " " : std::string(static_cast<std::size_t>(lines), '\n');
  }
  // Before the first piece and behind the last one.
  std::string_view lead() const {
    const bool is_same = stream_.front().from == &old_ && stream_.front().piece == 0;
    return is_same ? old_.text({0, stream_.front().span.begin}) : std::string_view();
  }
  std::string_view tail() const {
    if (!region_.reaches_end(old_)) return {};
    const bool is_same = stream_.back().from == &old_ && stream_.back().piece + 1 == old_.size();
    return is_same ? old_.text({stream_.back().span.end, region_.bytes.end}) : std::string_view("\n");
  }

  // As it was, where that is right; new blanks are one space, or as many lines as there were.
  std::string rough() const {
    std::string out(lead());
    for (std::size_t i = 0; i < stream_.size(); ++i) {
      if (i > 0) out += gap(stream_[i - 1], stream_[i]);
      out += stream_[i].text;
    }
    return out.append(tail());
  }

  std::string laid_out_region(std::string_view text) const {
    std::string out = laid_out(text);
    if (!region_.reaches_end(old_) && out.ends_with('\n')) out.pop_back();
    return out;
  }

  Reprinted finished() const {
    std::string text;
    std::vector<text::Span> spans;
    if (!stream_.empty()) {
      text = laid_out_region(rough());
      spans = spans_in(text);
      const std::string_view before = old_.text(region_.bytes);
      if (laid_out_region(before) != before) text = mixed(text, spans);
    }
    Reprinted out;
    out.changed = region_.bytes;
    out.longer = static_cast<std::int64_t>(text.size()) - (region_.bytes.end - region_.bytes.begin);
    for (std::size_t i = 0; i < stream_.size(); ++i) {
      if (stream_[i].from == &old_ && !stream_[i].is_comment)
        out.words.emplace_back(stream_[i].span.begin, region_.bytes.begin + spans[i].begin);
    }
    std::ranges::sort(out.words);
    out.text = old_.text({0, region_.bytes.begin});
    out.text += text;
    out.text += old_.text({region_.bytes.end, bytes_in(old_.text())});
    return out;
  }

  // Of the pieces, in a text that has them in the same order.
  static std::vector<text::Span> spans_in(std::string_view text) {
    const Tokens lexed = lex(text);
    std::vector<text::Span> out;
    std::size_t comment = 0;
    for (const Token& token : lexed.tokens) {
      for (; comment < token.comments; ++comment) out.push_back(lexed.comments[comment].span);
      if (token.kind != Token::Kind::kEnd) out.push_back(token.span);
    }
    return out;
  }

  // What was adjacent stays as it was; the blanks around what is new are those of the canonical layout.
  /// @param spans  of the pieces in that; then in this
  std::string mixed(std::string_view formatted, std::vector<text::Span>& spans) const {
    std::string out(lead());
    std::uint32_t end = 0;
    for (std::size_t i = 0; i < stream_.size(); ++i) {
      const Put& put = stream_[i];
      if (i > 0 && put.from == &old_ && is_adjacent(stream_[i - 1], put))
        out += between(stream_[i - 1], put);
      else if (i > 0)
        out += formatted.substr(end, spans[i].begin - end);
      end = spans[i].end;
      spans[i].begin = bytes_in(out);
      out += put.text;
      spans[i].end = bytes_in(out);
    }
    return out.append(tail());
  }

  const Words& words_;
  const Pieces& old_;
  const Region& region_;
  std::vector<Put> stream_;
  std::vector<bool> is_joined_;                              // of each word
  std::map<std::size_t, std::vector<std::size_t>> adopted_;  // by the token before which they stand now
  std::vector<std::vector<std::size_t>> lost_helps_;
  std::set<std::pair<const Pieces*, std::size_t>> put_;  // comments
  std::set<int> said_helps_;                             // of parameters, above them
  std::vector<std::pair<const Pieces*, std::size_t>> behind_;
  std::string new_behind_;
  std::deque<std::string> kept_;
};

}  // namespace

std::optional<std::uint32_t> Reprinted::now(std::uint32_t old) const {
  if (old < changed.begin) return old;
  if (old >= changed.end) return static_cast<std::uint32_t>(old + longer);
  const auto found =
      std::ranges::lower_bound(words, old, {}, &std::pair<std::uint32_t, std::uint32_t>::first);
  return found != words.end() && found->first == old ? std::optional(found->second) : std::nullopt;
}

Reprinted reprint(const Tree& was, const std::vector<const Item*>& now) {
  return Assembly(Words(was, now)).run();
}

Reprinted reprint(const Tree& was, const Tree& now) {
  std::vector<const Item*> items;
  for (const Item& item : now.items) items.push_back(&item);
  return reprint(was, items);
}

}  // namespace mlab::cdl
