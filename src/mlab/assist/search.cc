#include "mlab/assist/search.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>

#include "mlab/assist/languages.h"

namespace mlab::assist {
namespace {

char small(char c) {
  return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}

bool is_same(char a, char b) {
  return small(a) == small(b);
}

bool begins_word(std::string_view text, std::size_t at) {
  if (at == 0) return true;
  const auto before = static_cast<unsigned char>(text[at - 1]);
  const auto here = static_cast<unsigned char>(text[at]);
  return std::isalnum(before) == 0 || (std::islower(before) != 0 && std::isupper(here) != 0);
}

void add_symbols(const std::vector<Symbol>& symbols, const std::string& within, const text::SourcePtr& source,
                 std::vector<Entry>& out) {
  for (const Symbol& one : symbols) {
    out.push_back({source, one.name_span, one.name, one.kind, one.detail, within, one.help});
    add_symbols(one.parts, one.name, source, out);
  }
}

bool is_call(const Name& name) {
  return !name.is_declaration && (name.kind == NameKind::kAssemblage || name.kind == NameKind::kProcedure ||
                                  name.kind == NameKind::kBinding);
}

std::vector<Entry> entries_of(const Text& text, const Surroundings& around) {
  std::vector<Entry> out;
  const text::SourcePtr& source = text.source;
  out.push_back(
      {source, {0, 0}, std::filesystem::path(source->name()).filename().string(), "file", "", "", ""});
  const std::vector<Symbol> declared = symbols(text, around);
  add_symbols(declared, "", source, out);
  for (const Name& name : names_in(text, around)) {
    if (!is_call(name) && !(name.is_declaration && name.kind == NameKind::kNode)) continue;
    const auto in = std::ranges::find_if(declared, [&](const Symbol& one) {
      return one.span.begin <= name.span.begin && name.span.end <= one.span.end;
    });
    if (in == declared.end() || in->name_span == name.span) continue;  // in a layout
    const bool is_node = name.is_declaration;
    out.push_back({source, name.span, name.text, is_node ? "node" : "call", "", in->name, ""});
  }
  return out;
}

constexpr int kInHelp = 1;
bool has_in_help(std::string_view query, std::string_view help) {
  constexpr std::size_t kFewest = 3;  // letters that say something
  return query.size() >= kFewest && !std::ranges::search(help, query, is_same).empty();
}

// What is declared is looked for more often than where it is used.
int rank_of(const Entry& one) {
  return one.kind == "call" ? 0 : one.within.empty() ? 8 : 4;
}

}  // namespace

int match(std::string_view query, std::string_view text) {
  constexpr int kWhole = 4000;
  constexpr int kBeginning = 3000;
  constexpr int kWord = 2000;
  constexpr int kRun = 1000;
  if (query.empty() || query.size() > text.size()) return 0;
  const auto length = static_cast<int>(std::min<std::size_t>(text.size(), 200));
  for (const bool words_only : {true, false}) {
    for (std::size_t at = 0; at + query.size() <= text.size(); ++at) {
      if (words_only && !begins_word(text, at)) continue;
      if (!std::ranges::equal(query, text.substr(at, query.size()), is_same)) continue;
      const int points = query.size() == text.size() ? kWhole
                         : at == 0                   ? kBeginning
                         : words_only                ? kWord
                                                     : kRun;
      return points - length;
    }
  }
  // Its letters in their order, each at the beginning of a word or behind the one before it.
  std::size_t next = 0;
  bool is_run = false;
  for (std::size_t at = 0; at < text.size() && next < query.size(); ++at) {
    is_run = is_same(text[at], query[next]) && (is_run || begins_word(text, at));
    if (is_run) ++next;
  }
  return next == query.size() ? kRun / 2 - length : 0;
}

void ProjectIndex::update(const std::vector<Text>& texts, const Surroundings& around) {
  order_.clear();
  for (const Text& text : texts) {
    const std::string& name = text.source->name();
    IndexedText& known = known_[name];
    order_.push_back(name);
    const bool is_same = known.source && known.language == text.language &&
                         (known.source == text.source || known.source->text() == text.source->text());
    if (!is_same) known = {text.source, text.language, entries_of(text, around)};
  }
  const std::set<std::string> names(order_.begin(), order_.end());
  std::erase_if(known_, [&](const auto& one) { return !names.contains(one.first); });
}

std::vector<const Entry*> ProjectIndex::all() const {
  std::vector<const Entry*> out;
  for (const std::string& name : order_) {
    for (const Entry& one : known_.at(name).entries) out.push_back(&one);
  }
  return out;
}

std::vector<ProjectIndex::Hit> ProjectIndex::find(std::string_view query, std::size_t most) const {
  std::vector<Hit> out;
  for (const std::string& name : order_) {
    for (const Entry& one : known_.at(name).entries) {
      int score = match(query, one.name);
      if (score == 0 && has_in_help(query, one.help)) score = kInHelp;
      if (score > 0) out.push_back({&one, score + rank_of(one)});
    }
  }
  std::ranges::stable_sort(out, std::ranges::greater(), &Hit::score);
  if (out.size() > most) out.resize(most);
  return out;
}

}  // namespace mlab::assist
