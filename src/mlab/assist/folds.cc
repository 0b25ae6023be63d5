// What of a text can be folded away.

#include <algorithm>
#include <map>

#include "mlab/assist/languages.h"

namespace mlab::assist {
namespace {

class FoldFinder {
 public:
  FoldFinder(const Text& text, const Surroundings& around) : text_(text), around_(around) {}

  std::vector<Fold> run() {
    shades_ = shades(text_, around_);
    comments();
    if (text_.language == Language::kConfiguration) {
      braces();
    } else {
      for (const Symbol& one : symbols(text_, around_)) symbol(one);
    }
    std::vector<Fold> out;
    for (const auto& [first, fold] : by_line_) out.push_back(fold);
    return out;
  }

 private:
  std::uint32_t line(std::uint32_t at) const { return text_.source->line_column(at).line; }

  // Of two that begin in the same line the larger one counts.
  void add(Fold fold) {
    if (fold.last <= fold.first) return;
    Fold& known = by_line_.try_emplace(fold.first, fold).first->second;
    if (fold.last > known.last) known = fold;
  }

  void comments() {
    Fold run{0, 0, true};
    for (const Shade& one : shades_) {
      if (one.kind != Shade::Kind::kComment) continue;
      const std::uint32_t first = line(one.span.begin);
      const std::uint32_t last = line(std::max(one.span.end, one.span.begin + 1) - 1);
      const std::string_view whole = text_.source->line(first);
      const std::size_t begin = whole.find_first_not_of(" \t");
      const bool has_own_line =
          begin != std::string_view::npos && &whole[begin] == &text_.source->text()[one.span.begin];
      if (has_own_line && first == run.last + 1 && run.first > 0) {
        run.last = last;
        continue;
      }
      if (run.first > 0) add(run);
      run = has_own_line ? Fold{first, last, true} : Fold{0, 0, true};
    }
    if (run.first > 0) add(run);
  }

  // The line with the closing brace stays.
  void braces() {
    std::vector<std::uint32_t> open;
    std::size_t next = 0;
    const std::string_view all = text_.source->text();
    for (std::uint32_t at = 0; at < all.size(); ++at) {
      while (next < shades_.size() && shades_[next].span.end <= at) ++next;
      if (next < shades_.size() && shades_[next].span.begin <= at) {
        at = shades_[next].span.end - 1;
        continue;
      }
      if (all[at] == '{') open.push_back(line(at));
      if (all[at] != '}' || open.empty()) continue;
      add({open.back(), line(at) - 1});
      open.pop_back();
    }
  }

  void symbol(const Symbol& one) {
    if (one.span.end > one.span.begin) add({line(one.span.begin), line(one.span.end - 1)});
    for (const Symbol& part : one.parts) symbol(part);
  }

  const Text& text_;
  const Surroundings& around_;
  std::vector<Shade> shades_;
  std::map<std::uint32_t, Fold> by_line_;
};

}  // namespace

std::vector<Fold> folds(const Text& text, const Surroundings& around) {
  return FoldFinder(text, around).run();
}

}  // namespace mlab::assist
