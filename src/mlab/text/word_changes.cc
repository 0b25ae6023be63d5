#include "mlab/text/word_changes.h"

#include <algorithm>
#include <utility>

namespace mlab::text {

WordChanges::WordChanges(SourcePtr source, std::vector<Span> words)
    : source_(std::move(source)),
      text_(source_->text()),
      words_(std::move(words)),
      line_end_(text_.find("\r\n") == std::string_view::npos ? "\n" : "\r\n") {}

bool WordChanges::is_blank(std::size_t at) const {
  return at < text_.size() && (text_[at] == ' ' || text_[at] == '\t');
}

// The end of the text separates words, too.
bool WordChanges::is_space(std::size_t at) const {
  return at >= text_.size() || is_blank(at) || text_[at] == '\n' || text_[at] == '\r';
}

bool WordChanges::starts_line(std::size_t at) const {
  return at == 0 || text_[at - 1] == '\n';
}

std::uint32_t WordChanges::next_word(std::uint32_t from) const {
  const auto next = std::ranges::lower_bound(words_, from, {}, &Span::begin);
  return next == words_.end() ? static_cast<std::uint32_t>(text_.size()) : next->begin;
}

std::string WordChanges::line(std::string_view text) const {
  return std::string(text) + line_end_;
}

void WordChanges::replace(Span word, std::string_view by) {
  if (source_->text(word) == by) return;
  std::string text(by);
  if (word.begin > 0 && !is_space(word.begin - 1)) text.insert(0, 1, ' ');
  if (!is_space(word.end)) text += ' ';
  splices_.push_back({{word.begin, word.end}, std::move(text)});
}

void WordChanges::reword(Span range, const std::vector<Word>& now) {
  auto old = std::ranges::lower_bound(words_, range.begin, {}, &Span::begin);
  const auto end = std::ranges::lower_bound(words_, range.end, {}, &Span::begin);
  Span before{range.begin, range.begin};
  for (auto next = now.begin();; ++next) {
    const auto kept = std::find_if(next, now.end(), [](const Word& one) { return one.from.has_value(); });
    const auto gap_end =
        kept == now.end() ? end : std::ranges::lower_bound(old, end, kept->from->begin, {}, &Span::begin);
    for (; old != gap_end && next != kept; ++old, ++next) {
      replace(*old, next->text);
      before = *old;
    }
    std::string more;
    for (; next != kept; ++next) more += (more.empty() ? "" : " ") + next->text;
    if (!more.empty()) insert_behind(before, more);
    if (old != gap_end) erase({old->begin, std::prev(gap_end)->end});
    if (kept == now.end()) return;
    before = *kept->from;
    old = std::next(gap_end);
  }
}

// Words with nothing but white space between them go together; what stands between others stays.
void WordChanges::erase(Span range) {
  auto word = std::ranges::lower_bound(words_, range.begin, {}, &Span::begin);
  while (word != words_.end() && word->begin < range.end) {
    const std::uint32_t begin = word->begin;
    std::uint32_t end = word->end;
    for (++word; word != words_.end() && word->begin < range.end; ++word) {
      const std::string_view between = text_.substr(end, word->begin - end);
      if (between.find_first_not_of(" \t\r\n") != std::string_view::npos) break;
      end = word->end;
    }
    erase_run(begin, end);
  }
}

void WordChanges::erase_run(std::uint32_t begin, std::uint32_t end) {
  std::uint32_t left = begin;
  while (left > 0 && is_blank(left - 1)) --left;
  std::uint32_t right = end;
  while (is_blank(right)) ++right;
  if (!starts_line(left)) {
    const bool would_touch = !is_space(end);
    splices_.push_back({{left, end}, would_touch ? " " : ""});
    return;
  }
  const bool is_whole_line =
      right >= text_.size() || text_[right] == '\n' || text_.substr(right).starts_with("\r\n");
  if (!is_whole_line) {
    splices_.push_back({{begin, right}, ""});
    return;
  }
  if (right < text_.size()) right += text_[right] == '\n' ? 1 : 2;
  splices_.push_back({{left, right}, ""});
}

void WordChanges::insert_behind(Span word, std::string_view what) {
  std::string text = ' ' + std::string(what);
  if (!is_space(word.end)) text += ' ';
  splices_.push_back({{word.end, word.end}, std::move(text)});
}

void WordChanges::add_line_behind(Span word, std::string_view what) {
  const std::uint32_t next = next_word(word.end);
  const std::size_t line_feed = text_.find('\n', word.end);
  if (line_feed == std::string_view::npos && next == text_.size()) {
    add_line_at_end(what);
  } else if (line_feed < next) {
    const auto at = static_cast<std::uint32_t>(line_feed + 1);
    splices_.push_back({{at, at}, line(what)});
  } else {
    splices_.push_back({{next, next}, line_end_ + line(what)});
  }
}

void WordChanges::add_line_before(Span word, std::string_view what) {
  std::uint32_t left = word.begin;
  while (left > 0 && is_blank(left - 1)) --left;
  const std::uint32_t at = starts_line(left) ? left : word.begin;
  splices_.push_back({{at, at}, (starts_line(at) ? "" : line_end_) + line(what)});
}

void WordChanges::add_line_at_end(std::string_view what) {
  lines_at_end_ += line(what);
}

std::optional<Splice> WordChanges::joined() const {
  std::vector<Splice> all = splices_;
  if (!lines_at_end_.empty()) {
    const auto end = static_cast<std::uint32_t>(text_.size());
    all.push_back({{end, end}, (text_.empty() || text_.ends_with('\n') ? "" : line_end_) + lines_at_end_});
  }
  std::ranges::stable_sort(all, [](const Splice& a, const Splice& b) {
    return std::pair(a.span.begin, a.span.end) < std::pair(b.span.begin, b.span.end);
  });
  if (all.empty()) return Splice{};
  const std::uint32_t begin = all.front().span.begin;
  Splice out{{begin, begin}, ""};
  const Splice* before = nullptr;
  for (const Splice& each : all) {
    const bool is_repeated = before != nullptr && each == *before && each.span.begin != each.span.end;
    if (is_repeated) continue;
    if (each.span.begin < out.span.end) return std::nullopt;
    out.text += text_.substr(out.span.end, each.span.begin - out.span.end);
    out.text += each.text;
    out.span.end = each.span.end;
    before = &each;
  }
  return out;
}

}  // namespace mlab::text
