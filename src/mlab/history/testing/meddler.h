#pragma once

#include <cstdint>
#include <random>

#include "mlab/history/testing/written_run.h"

namespace mlab::history::testing {

/// What a person might do next with Demo C, by chance.
class Meddler {
 public:
  Meddler(WrittenRun& written, std::uint32_t seed) : written_(written), random_(seed) {}

  void meddle();
  /// Evenly drawn from 0 .. n - 1.
  int below(int n) { return std::uniform_int_distribution<int>(0, n - 1)(random_); }

 private:
  void steer(run::MissionRun& run);

  WrittenRun& written_;
  std::mt19937 random_;
  int extra_ = 0;
};

}  // namespace mlab::history::testing
