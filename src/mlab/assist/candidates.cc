#include "mlab/assist/candidates.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <tuple>

namespace mlab::assist {
namespace {

constexpr int kBehindAll = 100;

char folded(char c) {
  return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}

bool is_same_letter(char a, char b) {
  return folded(a) == folded(b);
}

bool is_word_part(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

}  // namespace

bool CandidateList::matches(std::string_view text) const {
  return written_.empty() || !std::ranges::search(text, written_, is_same_letter).empty();
}

void CandidateList::add(Candidate one, int rank) {
  if (one.text.empty()) return;  // a name that is still to be written
  const auto at = std::ranges::search(one.text, written_, is_same_letter);
  if (at.empty() && !written_.empty()) return;
  if (at.begin() != one.text.begin()) rank += kBehindAll;
  found_.push_back({rank, std::move(one)});
}

void CandidateList::add(std::string_view text, std::string_view kind, std::string_view help, int rank) {
  add({.text = std::string(text), .kind = std::string(kind), .detail = "", .help = std::string(help)}, rank);
}

Completions CandidateList::take(text::Span replaced) {
  std::ranges::stable_sort(found_, [](const Ranked& a, const Ranked& b) {
    return std::tie(a.rank, a.one.text) < std::tie(b.rank, b.one.text);
  });
  Completions out;
  out.replaced = replaced;
  std::set<std::pair<std::string, std::string>> seen;
  for (Ranked& each : found_) {
    if (!seen.emplace(each.one.text, each.one.kind).second) continue;
    if (out.candidates.size() == kMostCandidates) {
      out.is_cut = true;
      break;
    }
    out.candidates.push_back(std::move(each.one));
  }
  return out;
}

std::uint32_t word_begin(std::string_view text, std::uint32_t cursor) {
  std::uint32_t begin = cursor;
  while (begin > 0 && is_word_part(text[begin - 1])) --begin;
  // A number, and perhaps its unit: `10s`.
  while (begin < cursor && std::isdigit(static_cast<unsigned char>(text[begin])) != 0) ++begin;
  return begin;
}

}  // namespace mlab::assist
