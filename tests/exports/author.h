#pragma once

#include <cstdint>
#include <string>

#include "mlab/base/hash.h"

namespace mlab::exports_test {

/// Makes up configurations of sequences in sequences, whose triggers are made of four notifications, a to d:
/// what decides is known and can be told to other interpreters.
class Author {
 public:
  /// @param is_parallel  sequences also run beside each other, under cooperation
  Author(std::uint64_t seed, bool is_parallel) : state_(base::mix_bits(seed)), is_parallel_(is_parallel) {}

  /// The text of a configuration with one robot.
  std::string configuration();
  bool flag() { return pick(3) == 0; }

 private:
  int pick(int below);
  std::string trigger(int depth);
  std::string member(int depth);
  std::string sequence(int depth);

  std::uint64_t state_;
  bool is_parallel_;
};

}  // namespace mlab::exports_test
