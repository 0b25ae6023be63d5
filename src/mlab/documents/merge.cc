#include "mlab/documents/merge.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace mlab::documents {
namespace {

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

}  // namespace mlab::documents
