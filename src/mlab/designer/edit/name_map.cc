#include "mlab/designer/edit/name_map.h"

#include <algorithm>
#include <utility>

namespace mlab::designer {
namespace {

constexpr std::size_t kMostCells = 4'000'000;  // of the table by which two texts are compared

}  // namespace

NameMap::NameMap(std::shared_ptr<const Model> before, std::shared_ptr<const Model> after)
    : before_(std::move(before)), after_(std::move(after)), old_(before_->text()), new_(after_->text()) {
  compare();
}

// The longest common sequence of words; between what is common, as many words as before are the same in other
// words. Where too much has changed for that, only what is common at both ends is known.
void NameMap::compare() {
  const std::size_t olds = old_.tokens().size();
  const std::size_t news = new_.tokens().size();
  went_.resize(olds);
  const auto same = [&](std::size_t i, std::size_t j) { return old_.word(i) == new_.word(j); };
  const auto put = [&](std::size_t i, std::size_t j, Match match) {
    went_[i] = {static_cast<std::uint32_t>(j), match};
  };
  std::size_t begin = 0;
  while (begin < std::min(olds, news) && same(begin, begin)) put(begin, begin, Match::kSame), ++begin;
  std::size_t end = 0;
  while (end < std::min(olds, news) - begin && same(olds - 1 - end, news - 1 - end))
    put(olds - 1 - end, news - 1 - end, Match::kSame), ++end;
  const std::size_t rows = olds - begin - end;
  const std::size_t columns = news - begin - end;
  const auto put_gap = [&](std::size_t i, std::size_t i_end, std::size_t j, std::size_t j_end) {
    if (i_end - i != j_end - j) return;
    for (; i < i_end; ++i, ++j) put(i, j, Match::kChanged);
  };
  if (rows == columns) {
    // The usual case, a word for a word, needs no table.
    std::size_t changed = 0;
    for (std::size_t k = 0; k < rows; ++k) changed += same(begin + k, begin + k) ? 0 : 1;
    if (changed * 2 <= rows || (rows + 1) * (columns + 1) > kMostCells) {
      for (std::size_t k = begin; k < begin + rows; ++k)
        put(k, k, same(k, k) ? Match::kSame : Match::kChanged);
      return;
    }
  }
  if ((rows + 1) * (columns + 1) > kMostCells) return;
  std::vector<std::uint32_t> length((rows + 1) * (columns + 1));
  const auto at = [&](std::size_t i, std::size_t j) -> std::uint32_t& {
    return length[i * (columns + 1) + j];
  };
  for (std::size_t i = rows; i-- > 0;) {
    for (std::size_t j = columns; j-- > 0;)
      at(i, j) = same(begin + i, begin + j) ? at(i + 1, j + 1) + 1 : std::max(at(i + 1, j), at(i, j + 1));
  }
  std::size_t i = 0;
  std::size_t j = 0;
  std::size_t gap_i = 0;
  std::size_t gap_j = 0;
  while (i < rows && j < columns) {
    if (same(begin + i, begin + j)) {
      put_gap(begin + gap_i, begin + i, begin + gap_j, begin + j);
      put(begin + i, begin + j, Match::kSame);
      gap_i = ++i;
      gap_j = ++j;
    } else if (at(i + 1, j) >= at(i, j + 1)) {
      ++i;
    } else {
      ++j;
    }
  }
  put_gap(begin + gap_i, begin + rows, begin + gap_j, begin + columns);
}

std::optional<Anchor> NameMap::now(Anchor anchor, Match least) const {
  const std::size_t token = old_.at(anchor);
  if (token >= went_.size() || went_[token].match < least) return std::nullopt;
  return new_.tokens()[went_[token].token].span.begin;
}

const std::map<std::string, Anchor>& NameMap::anchors(const Model& model, const TokenMap& tokens,
                                                      const std::string& page) const {
  const auto [known, is_new] = anchors_.try_emplace({&model, page});
  if (is_new) known->second = anchors_of(model, page, tokens);
  return known->second;
}

std::optional<std::string> NameMap::page_by(const std::string& path, Match least) const {
  for (const PageAnchor& was : page_anchors(*before_, old_)) {
    if (was.path != path) continue;
    const std::optional<Anchor> owner = now(was.owner, least);
    const std::optional<Anchor> sequence = was.sequence ? now(*was.sequence, least) : std::nullopt;
    for (const PageAnchor& is : page_anchors(*after_, new_)) {
      const bool is_owner =
          owner && is.owner == *owner && is.sequence.has_value() == was.sequence.has_value();
      if (is_owner || (sequence && is.sequence == sequence)) return is.path;
    }
  }
  return std::nullopt;
}

std::optional<std::string> NameMap::page(const std::string& path) const {
  if (path.empty()) return path;
  if (std::optional<std::string> same = page_by(path, Match::kSame)) return same;
  if (after_->page(path).graph != nullptr) return path;
  return page_by(path, Match::kChanged);
}

std::optional<std::string> NameMap::node(const std::string& page, const std::string& name) const {
  const std::optional<std::string> there = this->page(page);
  if (!there) return std::nullopt;
  const auto& were = anchors(*before_, old_, page);
  const auto& are = anchors(*after_, new_, *there);
  const auto was = were.find(name);
  const auto found_by = [&](Match least) -> std::optional<std::string> {
    const std::optional<Anchor> anchor = was == were.end() ? std::nullopt : now(was->second, least);
    const auto found = std::ranges::find_if(are, [&](const auto& one) { return anchor == one.second; });
    if (found == are.end()) return std::nullopt;
    return found->first;
  };
  if (std::optional<std::string> same = found_by(Match::kSame)) return same;
  if (are.contains(name)) return name;
  return found_by(Match::kChanged);
}

}  // namespace mlab::designer
