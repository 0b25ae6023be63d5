#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/lang/mdl/mdl.h"
#include "mlab/text/diagnostic.h"

namespace mlab::study {

/// A piece of a command line or of a study's file.
struct Written {
  std::string text;
  text::Place place;

  bool empty() const { return text.empty(); }
};
/// What an option of the command line says; messages call the option by its name.
Written written_in_option(std::string_view option, std::string_view value);

/// A setting of the mission that takes several values over a batch.
struct Dimension {
  Written name;                 ///< as mdl::Setting
  std::vector<Written> values;  ///< one after the other; empty: each run draws its own
  double low = 0.0;             ///< between these, where it is drawn
  double high = 0.0;
  text::Place drawn_place;  ///< where the two are written

  bool is_drawn() const { return values.empty(); }
};

/// A range has at most so many values, and so has a list.
inline constexpr std::size_t kMostValues = 10'000;

/// Values of a dimension:
///
/// - `1,2,5`: a list; what stands in brackets or braces is one value, commas or not
/// - `1:5:1`: from 1 to 5 in steps of 1
/// - `1..5`: drawn anew for each run, each number between as likely as any other
/// @errors  a range without end; an empty value
text::Result<Dimension> dimension_of(Written name, const Written& values);
/// `base_velocity=1,2,5`
/// @errors  likewise; `expected NAME=VALUE`
text::Result<Dimension> dimension_of(const Written& both);

/// Where lists of one length have the same values, as numbers or as texts, that they had together before; the
/// first such place. Nothing: each combination is there once.
std::optional<std::size_t> repeated_values(std::span<const Dimension* const> lists);

/// One value, whatever stands in it: `--set` of `mlab run`.
text::Result<mdl::Setting> setting_of(std::string_view both);

/// A number as short as it can be written so that reading gives it back.
std::string shortest(double value);

}  // namespace mlab::study
