#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mlab::vehicle {

// Text over a serial line that loses bytes: each line ends with `*`, the checksum of what stands in front of
// it
// (`checksum_of`, four hexadecimal digits), and a line feed.

/// The line of a text, with its end: `V 1200 0.2 0.1*F00D` and a line feed.
std::string line_of(std::string_view text);

/// Finds whole lines in bytes as they come. What is damaged or longer than kLongest is left out.
class LineReader {
 public:
  static constexpr std::size_t kLongest = 512;  ///< bytes, with its end

  void add(std::string_view bytes);
  /// The next line's text, without its end. Valid until the next call.
  std::optional<std::string_view> next();
  /// What has come so far is no begin of what comes.
  void begin_anew();

 private:
  std::string bytes_;
  std::size_t read_ = 0;  // of bytes_
};

/// What stands in a line: a word of one letter, `A` to `Z`, and numbers.
struct Words {
  char word = ' ';
  std::vector<double> numbers;  ///< finite; `-` is an infinite one
};

/// Takes `P 1200 3.5 -0.25 1.57` apart: one blank between two words.
/// @errors  nothing: it does not begin with one letter, or something is no number
std::optional<Words> words_of(std::string_view text);

}  // namespace mlab::vehicle
