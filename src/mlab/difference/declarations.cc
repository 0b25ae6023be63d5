#include "mlab/difference/declarations.h"

#include <algorithm>
#include <string_view>
#include <unordered_map>

#include <fmt/core.h>

#include "mlab/lang/cdl/lower/node_names.h"
#include "mlab/lang/cdl/syntax/lexer.h"

namespace mlab::difference {
namespace {

// More names that went and came than this are not compared word by word, each with each.
constexpr std::size_t kMostLikely = 4'000;
constexpr double kAlike = 0.6;  // of the words, so many are the same

template <class Kind>
Declaration declaration(const cdl::Item& item, const char* word, const Kind& one) {
  Declaration out{&item, word, &one.name, &one.help, nullptr, one.whole};
  if constexpr (requires { one.parameters; }) out.parameters = &one.parameters;
  return out;
}

const char* kind_of(const cdl::Assemblage& /*one*/) {
  return "assemblage";
}
const char* kind_of(const cdl::Binding& /*one*/) {
  return "binding point";
}
const char* kind_of(const cdl::RobotClass& /*one*/) {
  return "class";
}
const char* kind_of(const cdl::Robot& /*one*/) {
  return "robot";
}
const char* kind_of(const cdl::SocietyOperator& /*one*/) {
  return "operator";
}
const char* kind_of(const cdl::Test& /*one*/) {
  return "test";
}
const char* kind_of(const cdl::Society& /*one*/) {
  return "society";
}

using Words = std::vector<std::uint64_t>;  // sorted

// The words of a declaration but its name.
Words words_in(const Declaration& one, const cdl::Tree& tree) {
  Words out;
  if (!tree.source) return out;
  const std::string_view text = tree.source->text(one.whole);
  for (const cdl::Token& token : cdl::lex(text).tokens) {
    const std::string_view word = text.substr(token.span.begin, token.span.end - token.span.begin);
    const bool says_something = token.kind != cdl::Token::Kind::kPunctuation && word != one.name->text;
    if (says_something && !word.empty()) out.push_back(base::hash_text(word));
  }
  std::ranges::sort(out);
  return out;
}

double likeness(const Words& one, const Words& other) {
  std::size_t common = 0;
  std::size_t i = 0;
  std::size_t k = 0;
  while (i < one.size() && k < other.size()) {
    if (one[i] == other[k]) {
      ++common, ++i, ++k;
    } else if (one[i] < other[k]) {
      ++i;
    } else {
      ++k;
    }
  }
  const std::size_t most = std::max(one.size(), other.size());
  return most == 0 ? 0.0 : static_cast<double>(common) / static_cast<double>(most);
}

// What nothing else told: the most alike first.
void pair_alike(Pairs& pairs, const std::vector<Declaration>& before, const std::vector<Declaration>& after,
                const cdl::Tree& before_tree, const cdl::Tree& after_tree) {
  std::vector<std::size_t> olds;
  std::vector<std::size_t> news;
  for (std::size_t i = 0; i < before.size(); ++i)
    if (pairs.to_after[i] < 0) olds.push_back(i);
  for (std::size_t k = 0; k < after.size(); ++k)
    if (pairs.to_before[k] < 0) news.push_back(k);
  if (olds.size() * news.size() > kMostLikely) return;
  std::vector<Words> new_words;
  for (const std::size_t k : news) new_words.push_back(words_in(after[k], after_tree));
  struct Likely {
    double likeness = 0.0;
    std::size_t before = 0;
    std::size_t after = 0;
  };
  std::vector<Likely> likely;
  for (const std::size_t i : olds) {
    const Words old_words = words_in(before[i], before_tree);
    for (std::size_t n = 0; n < news.size(); ++n) {
      if (std::string_view(before[i].kind) != after[news[n]].kind) continue;
      const double found = likeness(old_words, new_words[n]);
      if (found >= kAlike) likely.push_back({found, i, news[n]});
    }
  }
  std::ranges::stable_sort(likely, std::greater(), &Likely::likeness);
  for (const Likely& one : likely)
    if (pairs.are_free(one.before, one.after)) pairs.put(one.before, one.after);
}

// All that it says but what it is called.
std::uint64_t nameless(const Declaration& one, Fingerprints& prints) {
  return std::visit(
      [&](const auto& what) {
        std::uint64_t out = base::hash_text(one.kind);
        if constexpr (requires { what.name; }) {
          auto copy = what;
          copy.name.text.clear();
          out = base::combine_bits(out, prints.of(copy));
        }
        return out;
      },
      *one.item);
}

std::uint64_t nameless(const cdl::Parameter& one, Fingerprints& prints) {
  cdl::Parameter copy = one;
  copy.name.text.clear();
  return prints.of(copy);
}

}  // namespace

std::vector<Declaration> declarations_of(const cdl::Tree& tree) {
  std::vector<Declaration> out;
  for (const cdl::Item& item : tree.items) {
    std::visit(
        [&](const auto& one) {
          if constexpr (requires { kind_of(one); }) out.push_back(declaration(item, kind_of(one), one));
        },
        item);
  }
  return out;
}

Pairs match_declarations(const std::vector<Declaration>& before, const std::vector<Declaration>& after,
                         const cdl::Tree& before_tree, const cdl::Tree& after_tree) {
  Pairs out(before.size(), after.size());
  const auto key = [](const Declaration& one) { return fmt::format("{} {}", one.kind, one.name->text); };
  pair_by(out, [&](std::size_t i) { return key(before[i]); }, [&](std::size_t i) { return key(after[i]); });
  const Renames none;
  Prints prints(none);
  pair_by(
      out, [&](std::size_t i) { return nameless(before[i], prints.before); },
      [&](std::size_t i) { return nameless(after[i], prints.after); });
  pair_alike(out, before, after, before_tree, after_tree);
  return out;
}

Pairs match_parameters(const std::vector<cdl::Parameter>& before, const std::vector<cdl::Parameter>& after) {
  Pairs out(before.size(), after.size());
  pair_by(
      out, [&](std::size_t i) { return before[i].name.text; },
      [&](std::size_t i) { return after[i].name.text; });
  const Renames none;
  Prints prints(none);
  pair_by(
      out, [&](std::size_t i) { return nameless(before[i], prints.before); },
      [&](std::size_t i) { return nameless(after[i], prints.after); });
  pair_by_unique(
      out, [&](std::size_t i) { return before[i].type.text; },
      [&](std::size_t i) { return after[i].type.text; });
  return out;
}

Renames::Names renamed_lets(const std::vector<cdl::Let>& before, const std::vector<cdl::Let>& after,
                            const Renames& renames) {
  Pairs pairs(before.size(), after.size());
  pair_by(
      pairs, [&](std::size_t i) { return before[i].name.text; },
      [&](std::size_t i) { return after[i].name.text; });
  Prints prints(renames);
  pair_by(
      pairs, [&](std::size_t i) { return prints.before.of(before[i].value); },
      [&](std::size_t i) { return prints.after.of(after[i].value); });
  const auto component = [](const cdl::Let& let) { return let.value ? cdl::default_name(*let.value) : ""; };
  pair_by_unique(
      pairs, [&](std::size_t i) { return renames.declaration(component(before[i])); },
      [&](std::size_t i) { return component(after[i]); });
  Renames::Names out;
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (pairs.to_after[i] < 0) continue;
    const std::string& name = after[static_cast<std::size_t>(pairs.to_after[i])].name.text;
    if (name != before[i].name.text) out.emplace(before[i].name.text, name);
  }
  return out;
}

}  // namespace mlab::difference
