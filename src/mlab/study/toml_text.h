#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace mlab::study {

/// What toml++ 3.3 must not be given: what it does with it is undefined.
struct Unfit {
  std::size_t at = 0;  ///< place in the text [bytes]
  std::string_view why;
};

/// The first place of a text where TOML can't have what stands there: a character beyond ASCII that is
/// neither in a comment nor in quotes, or that follows a `\` and white space in a text of several lines; or a
/// table's head without a key.
/// @return nothing where there is none; toml++ knows the rest
std::optional<Unfit> unfit_place(std::string_view text);

}  // namespace mlab::study
