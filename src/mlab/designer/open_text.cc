#include "mlab/designer/open_text.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "mlab/text/shown.h"

namespace mlab::designer {
namespace {

constexpr double kMergeWithin = 1.0;  // [s]

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> out;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
    out.push_back(text.substr(0, end));
    text.remove_prefix(end);
  }
  return out;
}

// For each line of `base` the line of `other` that it is still, or -1: a longest common subsequence by Myers'
// method, which is quick where little differs.
std::vector<int> kept_lines(const std::vector<std::string_view>& base,
                            const std::vector<std::string_view>& other) {
  const int n = static_cast<int>(base.size());
  const int m = static_cast<int>(other.size());
  constexpr int kMostChangedLines = 1000;  // then all counts as changed
  std::vector<int> out(base.size(), -1);
  const int most = std::min(n + m, kMostChangedLines);
  const std::ptrdiff_t middle = std::ptrdiff_t{most} + 1;
  const auto at = [middle](int k) { return static_cast<std::size_t>(middle + k); };
  std::vector<int> reach(static_cast<std::size_t>(2 * most + 3), 0);
  std::vector<std::vector<int>> history;
  for (int d = 0; d <= most; ++d) {
    history.push_back(reach);
    for (int k = -d; k <= d; k += 2) {
      const bool goes_down = k == -d || (k != d && reach[at(k - 1)] < reach[at(k + 1)]);
      int x = goes_down ? reach[at(k + 1)] : reach[at(k - 1)] + 1;
      int y = x - k;
      while (x < n && y < m && base[static_cast<std::size_t>(x)] == other[static_cast<std::size_t>(y)])
        ++x, ++y;
      reach[at(k)] = x;
      if (x < n || y < m) continue;
      // Back along the way that led here.
      for (int back = d; back >= 0; --back) {
        const std::vector<int>& before = history[static_cast<std::size_t>(back)];
        const int diagonal = x - y;
        const bool came_down =
            diagonal == -back || (diagonal != back && before[at(diagonal - 1)] < before[at(diagonal + 1)]);
        const int from = back == 0 ? 0 : came_down ? diagonal + 1 : diagonal - 1;
        const int from_x = back == 0 ? 0 : before[at(from)];
        const int from_y = from_x - from;
        while (x > from_x && y > from_y && x > 0 && y > 0) out[static_cast<std::size_t>(--x)] = --y;
        if (back == 0) break;
        x = from_x;
        y = from_y;
      }
      return out;
    }
  }
  return out;
}

std::string joined(const std::vector<std::string_view>& lines, std::size_t begin, std::size_t end) {
  std::string out;
  for (std::size_t i = begin; i < end; ++i) out += lines[i];
  return out;
}

}  // namespace

void OpenText::change(std::string text, std::string name, double now, bool may_merge) {
  if (text == text_) return;
  std::size_t begin = 0;
  const std::size_t shorter = std::min(text.size(), text_.size());
  while (begin < shorter && text[begin] == text_[begin]) ++begin;
  std::size_t same = 0;
  while (same < shorter - begin && text[text.size() - 1 - same] == text_[text_.size() - 1 - same]) ++same;
  Splice splice{begin, text_.substr(begin, text_.size() - same - begin),
                text.substr(begin, text.size() - same - begin)};
  steps_.resize(done_);
  const bool joins = may_merge && may_merge_ && !steps_.empty() && steps_.back().name == name &&
                     now - steps_.back().time < kMergeWithin;
  if (!joins) steps_.push_back({std::move(name), now, {}});
  steps_.back().time = now;
  steps_.back().splices.push_back(std::move(splice));
  done_ = steps_.size();
  may_merge_ = may_merge;
  text_ = std::move(text);
  ++revision_;
}

bool OpenText::undo() {
  if (done_ == 0) return false;
  const Step& step = steps_[--done_];
  for (auto it = step.splices.rbegin(); it != step.splices.rend(); ++it)
    text_.replace(it->begin, it->inserted.size(), it->removed);
  may_merge_ = false;
  ++revision_;
  return true;
}

bool OpenText::redo() {
  if (done_ == steps_.size()) return false;
  for (const Splice& splice : steps_[done_++].splices)
    text_.replace(splice.begin, splice.removed.size(), splice.inserted);
  may_merge_ = false;
  ++revision_;
  return true;
}

std::optional<std::string> merged(std::string_view base, std::string_view ours, std::string_view theirs) {
  const std::vector<std::string_view> b = lines_of(base);
  const std::vector<std::string_view> o = lines_of(ours);
  const std::vector<std::string_view> t = lines_of(theirs);
  const std::vector<int> in_ours = kept_lines(b, o);
  const std::vector<int> in_theirs = kept_lines(b, t);
  std::string out;
  std::size_t at = 0;
  std::size_t at_ours = 0;
  std::size_t at_theirs = 0;
  for (std::size_t i = 0; i <= b.size(); ++i) {
    const bool is_end = i == b.size();
    if (!is_end && (in_ours[i] < 0 || in_theirs[i] < 0)) continue;
    // Between two lines that both kept: what each of them made of it.
    const std::size_t ours_end = is_end ? o.size() : static_cast<std::size_t>(in_ours[i]);
    const std::size_t theirs_end = is_end ? t.size() : static_cast<std::size_t>(in_theirs[i]);
    const std::string was = joined(b, at, i);
    const std::string mine = joined(o, at_ours, ours_end);
    const std::string other = joined(t, at_theirs, theirs_end);
    if (mine != other && mine != was && other != was) return std::nullopt;
    out += mine == was ? other : mine;
    if (is_end) break;
    out += b[i];
    at = i + 1;
    at_ours = ours_end + 1;
    at_theirs = theirs_end + 1;
  }
  return out;
}

std::string unsaved_title(std::string_view text) {
  constexpr std::string_view kImported = "// From `";
  constexpr std::string_view kNothing = "New configuration";
  constexpr std::size_t kMost = 3;  // names in a title
  if (text.starts_with(kImported)) {
    std::string_view path = text.substr(kImported.size());
    path = path.substr(0, path.find_first_of("`\r\n"));
    const std::string_view name = path.substr(path.rfind('/') + 1);
    return name.empty() ? std::string(kNothing) : text::shown(name);
  }
  std::string out;
  std::size_t names = 0;
  for (std::size_t at = 0; at < text.size(); at = std::min(text.find('\n', at), text.size() - 1) + 1) {
    const std::string_view line = text.substr(at, text.find('\n', at) - at);
    for (const std::string_view kind : {"assemblage ", "robot ", "society "}) {
      if (!line.starts_with(kind)) continue;
      const std::string_view rest = line.substr(kind.size());
      const std::string_view name = rest.substr(0, rest.find_first_of(" (:{;\r"));
      if (++names <= kMost) out += (out.empty() ? "" : ", ") + text::shown(name);
    }
  }
  if (names == 0) return std::string(kNothing);
  return names > kMost ? out + " …" : out;
}

std::string said_of(std::string_view text) {
  constexpr std::size_t kMost = 140;  // bytes
  constexpr std::string_view kWhite = " \t\r";
  std::string all;
  while (!text.empty()) {
    std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(text.size(), line.size() + 1));
    line.remove_prefix(std::min(line.size(), line.find_first_not_of(kWhite)));
    if (line.empty() && all.empty()) continue;
    if (!line.starts_with("//")) break;
    line.remove_prefix(std::min(line.size(), line.find_first_not_of('/')));
    line.remove_prefix(std::min(line.size(), line.find_first_not_of(kWhite)));
    line = line.substr(0, line.find_last_not_of(kWhite) + 1);
    if (line.empty() && !all.empty()) break;
    if (!all.empty()) all += ' ';
    all += line;
    if (all.size() > kMost || all.find(". ") != std::string::npos) break;
  }
  if (const std::size_t end = all.find(". "); end != std::string::npos) all.resize(end + 1);
  if (all.size() > kMost) {
    const std::size_t blank = all.rfind(' ', kMost);
    return text::shown(all.substr(0, blank == std::string::npos ? kMost : blank), kMost + 1) + " …";
  }
  return text::shown(all, kMost + 1);
}

}  // namespace mlab::designer
