#include "mlab/documents/merge.h"

#include <cstddef>
#include <vector>

#include "mlab/text/kept_lines.h"

namespace mlab::documents {
namespace {

std::string joined(const std::vector<std::string_view>& lines, std::size_t begin, std::size_t end) {
  std::string out;
  for (std::size_t i = begin; i < end; ++i) out += lines[i];
  return out;
}

}  // namespace

std::optional<std::string> merged(std::string_view base, std::string_view ours, std::string_view theirs) {
  const std::vector<std::string_view> b = text::lines_of(base);
  const std::vector<std::string_view> o = text::lines_of(ours);
  const std::vector<std::string_view> t = text::lines_of(theirs);
  const std::vector<int> in_ours = text::kept_lines(b, o);
  const std::vector<int> in_theirs = text::kept_lines(b, t);
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
