#include "mlab/statistics/pairs.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "mlab/statistics/distributions.h"

namespace mlab::statistics {
namespace {

struct Ranked {
  std::vector<std::uint32_t> doubled;  // ranks times two, of all pairs: the middle of two ranks is whole so
  double positive = 0.0;               // sum of ranks
  double ties = 0.0;                   // sum of t^3 - t over groups of t equal differences
};

struct Difference {
  double value = 0.0;
  double rounding = 0.0;  // so much may be none

  explicit Difference(const Pair& pair)
      : value(pair.first - pair.second),
        rounding(kRounding * std::max(std::abs(pair.first), std::abs(pair.second))) {}
  double size() const { return std::abs(value); }
};

bool are_equal(const Difference& a, const Difference& b) {
  return std::abs(a.size() - b.size()) <= std::max(a.rounding, b.rounding);
}

Ranked rank(std::vector<Difference> differences) {
  std::ranges::sort(differences, {}, &Difference::size);
  Ranked out;
  for (std::size_t begin = 0; begin < differences.size();) {
    std::size_t end = begin + 1;
    while (end < differences.size() && are_equal(differences[begin], differences[end])) ++end;
    const std::size_t doubled = begin + 1 + end;  // the first rank and the last one
    for (std::size_t i = begin; i < end; ++i) {
      out.doubled.push_back(static_cast<std::uint32_t>(doubled));
      if (differences[i].value > 0.0) out.positive += 0.5 * static_cast<double>(doubled);
    }
    const auto t = static_cast<double>(end - begin);
    out.ties += t * t * t - t;
    begin = end;
  }
  return out;
}

// Over all signs, equally likely, by how many of them the sum of positive ranks becomes what.
double exact_p(const Ranked& ranked, double smaller) {
  std::size_t all = 0;
  for (const std::uint32_t doubled : ranked.doubled) all += doubled;
  std::vector<double> share(all + 1, 0.0);
  share[0] = 1.0;
  std::size_t reached = 0;
  for (const std::uint32_t doubled : ranked.doubled) {
    reached += doubled;
    for (std::size_t sum = reached + 1; sum-- > 0;)
      share[sum] = 0.5 * (share[sum] + (sum >= doubled ? share[sum - doubled] : 0.0));
  }
  double below = 0.0;
  for (std::size_t sum = 0; sum <= static_cast<std::size_t>(std::lround(2.0 * smaller)); ++sum)
    below += share[sum];
  return std::min(1.0, 2.0 * below);
}

double normal_p(double n, double ties, double smaller) {
  const double mean = n * (n + 1.0) / 4.0;
  const double variance = n * (n + 1.0) * (2.0 * n + 1.0) / 24.0 - ties / 48.0;
  const double away = std::max(0.0, mean - smaller - 0.5);
  return variance > 0.0 ? std::min(1.0, 2.0 * normal_below(-away / std::sqrt(variance))) : 1.0;
}

}  // namespace

double mcnemar(Discordant pairs) {
  const std::uint64_t smaller = std::min(pairs.only_first, pairs.only_second);
  return std::min(1.0, 2.0 * binomial_at_most(smaller, pairs.only_first + pairs.only_second, 0.5));
}

SignedRanks signed_ranks(std::span<const Pair> pairs) {
  std::vector<Difference> different;
  for (const Pair& pair : pairs) {
    const Difference one(pair);
    if (one.size() > one.rounding) different.push_back(one);  // not a number is no more than anything
  }
  SignedRanks out;
  out.pairs = different.size();
  if (different.empty()) return out;
  const Ranked ranked = rank(std::move(different));
  const auto n = static_cast<double>(out.pairs);
  out.positive = ranked.positive;
  out.negative = n * (n + 1.0) / 2.0 - ranked.positive;
  const double smaller = std::min(out.positive, out.negative);
  out.is_exact = out.pairs <= kMostExactPairs;
  out.p = out.is_exact ? exact_p(ranked, smaller) : normal_p(n, ranked.ties, smaller);
  return out;
}

}  // namespace mlab::statistics
