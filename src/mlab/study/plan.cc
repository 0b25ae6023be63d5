#include "mlab/study/plan.h"

#include <numeric>
#include <utility>

#include "mlab/base/hash.h"
#include "mlab/base/random.h"

namespace mlab::study {
namespace {

// What a random number is for, so that two uses of one name and run differ.
enum Use : std::uint64_t { kDraw = 1, kStrata = 2 };

base::Random stream(std::uint64_t seed, std::uint64_t run, const std::string& name, Use use) {
  return base::Random::of(seed, run, base::hash_text(name), use);
}

// Each number below `count` once, in random order.
std::vector<std::uint32_t> shuffled(std::uint32_t count, base::Random random) {
  std::vector<std::uint32_t> out(count);
  std::iota(out.begin(), out.end(), 0U);
  for (std::uint32_t i = count; i > 1; --i) std::swap(out[i - 1], out[random.below(i)]);
  return out;
}

Written of_seed(Written value, std::uint64_t seed) {
  const std::string written = std::to_string(seed);
  for (std::size_t at = 0; (at = value.text.find(kSeedPlace, at)) != std::string::npos; at += written.size())
    value.text.replace(at, kSeedPlace.size(), written);
  return value;
}

mdl::Setting setting_of(const Dimension& dimension, const Written& value) {
  return {dimension.name.text, value.text, dimension.name.place, value.place};
}

}  // namespace

Plan::Plan(const Definition& definition) : definition_(definition) {
  strata_.resize(definition.dimensions.size());
  for (std::size_t i = 0; i < definition.dimensions.size(); ++i) {
    const Dimension& one = definition.dimensions[i];
    for (const Written& value : one.values)
      names_seeds_ = names_seeds_ || value.text.find(kSeedPlace) != std::string::npos;
    if (one.is_drawn()) {
      has_drawn_ = true;
      if (definition.is_latin)
        strata_[i] = shuffled(definition.runs, stream(definition.seed, 0, one.name.text, kStrata));
    } else if (definition.is_paired) {
      combinations_ = one.values.size();
    } else if (combinations_ <= kMostCombinations) {
      combinations_ *= one.values.size();
    }
  }
}

RunKey Plan::key(std::uint64_t place) const {
  const std::uint64_t cells = versions() * combinations_;
  const std::uint64_t cell = place % cells;
  return {static_cast<std::uint32_t>(cell / combinations_), static_cast<std::uint32_t>(cell % combinations_),
          static_cast<std::uint32_t>(place / cells)};
}

const Written& Plan::listed(std::size_t dimension, std::uint32_t combination) const {
  const std::vector<Dimension>& all = definition_.dimensions;
  if (definition_.is_paired) return all[dimension].values[combination];
  // The last name's values change from one combination to the next.
  std::size_t stride = 1;
  for (std::size_t i = dimension + 1; i < all.size(); ++i)
    stride *= all[i].is_drawn() ? 1 : all[i].values.size();
  return all[dimension].values[combination / stride % all[dimension].values.size()];
}

double Plan::drawn(std::size_t dimension, std::uint32_t run) const {
  const Dimension& one = definition_.dimensions[dimension];
  double share = stream(definition_.seed, run, one.name.text, kDraw).uniform();
  if (definition_.is_latin)
    share = (static_cast<double>(strata_[dimension][run]) + share) / static_cast<double>(definition_.runs);
  return std::lerp(one.low, one.high, share);
}

std::vector<mdl::Setting> Plan::settings(const RunKey& key) const {
  std::vector<mdl::Setting> out;
  for (std::size_t i = 0; i < definition_.dimensions.size(); ++i) {
    const Dimension& one = definition_.dimensions[i];
    out.push_back(setting_of(one, one.is_drawn() ? Written{shortest(drawn(i, key.run)), one.drawn_place}
                                                 : of_seed(listed(i, key.combination), seed(key.run))));
  }
  return out;
}

std::vector<mdl::Setting> Plan::settings(std::uint32_t combination) const {
  std::vector<mdl::Setting> out;
  for (std::size_t i = 0; i < definition_.dimensions.size(); ++i) {
    if (!definition_.dimensions[i].is_drawn())
      out.push_back(setting_of(definition_.dimensions[i], listed(i, combination)));
  }
  return out;
}

std::vector<mdl::Setting> Plan::extremes(std::uint32_t combination, bool highest) const {
  std::vector<mdl::Setting> out;
  for (std::size_t i = 0; i < definition_.dimensions.size(); ++i) {
    const Dimension& one = definition_.dimensions[i];
    const double end = highest ? one.high : one.low;
    out.push_back(setting_of(one, one.is_drawn() ? Written{shortest(end), one.drawn_place}
                                                 : of_seed(listed(i, combination), seed(0))));
  }
  return out;
}

std::string text_of(const std::vector<mdl::Setting>& settings) {
  std::string out;
  for (const mdl::Setting& one : settings) out += (out.empty() ? "" : ", ") + one.name + "=" + one.value;
  return out;
}

}  // namespace mlab::study
