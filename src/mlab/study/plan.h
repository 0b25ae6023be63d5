#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "mlab/lang/mdl/mdl.h"
#include "mlab/study/definition.h"
#include "mlab/study/row.h"

namespace mlab::study {

/// Which runs a batch consists of. The same for whoever asks, in any order: what is drawn hangs on the first
/// seed, the name of what is set, and the number of the run alone; so each combination has the same seeds and
/// draws, and differences between combinations are those of the same chances.
class Plan {
 public:
  /// @param definition  without problems; outlives it
  explicit Plan(const Definition& definition);

  std::uint32_t versions() const { return definition_.against.empty() ? 1 : 2; }
  /// Of listed values; at least one. More than `kMostCombinations`: too many.
  std::uint64_t combinations() const { return combinations_; }
  std::uint32_t runs() const { return definition_.runs; }
  std::uint64_t all() const { return std::uint64_t{versions()} * combinations_ * runs(); }

  /// The runs in the order in which they are begun: all that share a seed, then those of the next one.
  RunKey key(std::uint64_t place) const;
  std::uint64_t seed(std::uint32_t run) const { return definition_.seed + run; }

  /// What is set in a run, in the order of the definition's dimensions.
  std::vector<mdl::Setting> settings(const RunKey& key) const;
  /// What is set in all runs of a combination: without what is drawn, and with `{seed}` where each run has
  /// its own.
  std::vector<mdl::Setting> settings(std::uint32_t combination) const;
  /// With the lowest or the highest value of what is drawn, for the first seed.
  std::vector<mdl::Setting> extremes(std::uint32_t combination, bool highest) const;
  bool draws() const { return has_drawn_; }
  /// Whether a listed value has the run's seed in it, so that its runs don't share what is set.
  bool names_seeds() const { return names_seeds_; }
  /// @param dimension  one that is drawn
  double drawn(std::size_t dimension, std::uint32_t run) const;

  static constexpr std::uint64_t kMostCombinations = 100'000;

 private:
  const Written& listed(std::size_t dimension, std::uint32_t combination) const;

  const Definition& definition_;
  std::uint64_t combinations_ = 1;
  bool has_drawn_ = false;
  bool names_seeds_ = false;
  std::vector<std::vector<std::uint32_t>> strata_;  // by dimension, where a Latin hypercube is drawn
};

/// Stands for the run's seed in a value.
inline constexpr std::string_view kSeedPlace = "{seed}";

/// `base_velocity=2, robot_radius=0.3`; empty where nothing is set.
std::string text_of(const std::vector<mdl::Setting>& settings);

}  // namespace mlab::study
