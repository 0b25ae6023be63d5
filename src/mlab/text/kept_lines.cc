#include "mlab/text/kept_lines.h"

#include <algorithm>
#include <cstddef>

namespace mlab::text {

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> out;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
    out.push_back(text.substr(0, end));
    text.remove_prefix(end);
  }
  return out;
}

// A longest common subsequence by Myers' method, which is quick where little differs.
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

}  // namespace mlab::text
