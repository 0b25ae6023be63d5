#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/assist/service.h"

namespace mlab::assist {

/// Gathers what fits what is written before the cursor: what begins with it first, then what has it inside;
/// letter case aside.
class CandidateList {
 public:
  /// @param written  the word before the cursor, without a quote
  explicit CandidateList(std::string written) : written_(std::move(written)) {}

  /// Whether a candidate of this text would be taken: ask before making one takes long.
  bool matches(std::string_view text) const;
  /// @param rank  0: the most likely; of equal rank in the order of their names
  void add(Candidate one, int rank = 1);
  void add(std::string_view text, std::string_view kind, std::string_view help = "", int rank = 1);

  /// At most `kMostCandidates`, without repetitions.
  Completions take(text::Span replaced);

 private:
  struct Ranked {
    int rank;
    Candidate one;
  };
  std::string written_;
  std::vector<Ranked> found_;
};

/// Where the word of letters, digits and `_` that ends at the cursor begins. Right behind a number it is
/// empty.
std::uint32_t word_begin(std::string_view text, std::uint32_t cursor);

}  // namespace mlab::assist
