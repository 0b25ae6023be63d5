#pragma once

#include <cstdint>
#include <string_view>

namespace mlab::base {

/// FNV-1a, 64 bits: the same on every machine, so names may key random streams and cache files.
/// @source G. Fowler, L. C. Noll, P. Vo, "The FNV Non-Cryptographic Hash Algorithm", draft-eastlake-fnv
constexpr std::uint64_t hash_text(std::string_view text, std::uint64_t seed = 14695981039346656037ULL) {
  std::uint64_t h = seed;
  for (const char c : text) h = (h ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  return h;
}

/// Spreads every input bit over all output bits (the finalizer of splitmix64).
/// @source G. L. Steele, D. Lea, C. H. Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014
constexpr std::uint64_t mix_bits(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ULL;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

/// One key out of two, in order: `combine_bits(a, b) != combine_bits(b, a)`.
constexpr std::uint64_t combine_bits(std::uint64_t a, std::uint64_t b) {
  return mix_bits(mix_bits(a) ^ b);
}

}  // namespace mlab::base
