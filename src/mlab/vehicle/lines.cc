#include "mlab/vehicle/lines.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>

#include <fmt/format.h>

#include "mlab/vehicle/checksum.h"

namespace mlab::vehicle {
namespace {

constexpr char kMark = '*';
constexpr std::size_t kDigits = 4;

/// The text of a line without its line feed; nothing: it was damaged.
std::optional<std::string_view> text_of(std::string_view line) {
  if (line.ends_with('\r')) line.remove_suffix(1);
  if (line.size() < 1 + kDigits || line[line.size() - kDigits - 1] != kMark) return std::nullopt;
  const std::string_view digits = line.substr(line.size() - kDigits);
  const std::string_view text = line.substr(0, line.size() - kDigits - 1);
  std::uint16_t told = 0;
  const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), told, 16);
  if (read.ec != std::errc{} || read.ptr != digits.data() + digits.size()) return std::nullopt;
  return told == checksum_of(text) ? std::optional(text) : std::nullopt;
}

std::optional<double> finite_number(std::string_view word) {
  if (word == "-") return std::numeric_limits<double>::infinity();
  double number = 0.0;
  const auto read = std::from_chars(word.data(), word.data() + word.size(), number);
  if (read.ec != std::errc{} || read.ptr != word.data() + word.size()) return std::nullopt;
  return std::isfinite(number) ? std::optional(number) : std::nullopt;
}

}  // namespace

std::string line_of(std::string_view text) {
  return fmt::format("{}{}{:04X}\n", text, kMark, checksum_of(text));
}

void LineReader::add(std::string_view bytes) {
  bytes_.erase(0, read_);
  read_ = 0;
  bytes_ += bytes;
}

std::optional<std::string_view> LineReader::next() {
  while (true) {
    const std::string_view rest = std::string_view(bytes_).substr(read_);
    const std::size_t end = rest.find('\n');
    if (end == std::string_view::npos) {
      // The rest of a line that is too long is no line either: it lacks the begin of what was summed up.
      if (rest.size() > kLongest) read_ = bytes_.size();
      return std::nullopt;
    }
    read_ += end + 1;
    if (end >= kLongest) continue;
    if (const auto text = text_of(rest.substr(0, end))) return text;
  }
}

void LineReader::begin_anew() {
  bytes_.clear();
  read_ = 0;
}

std::optional<Words> words_of(std::string_view text) {
  const bool begins_well = !text.empty() && text[0] >= 'A' && text[0] <= 'Z';
  if (!begins_well || (text.size() > 1 && text[1] != ' ')) return std::nullopt;
  Words words{text[0], {}};
  text.remove_prefix(1);
  while (!text.empty()) {
    text.remove_prefix(1);  // the blank
    const std::size_t end = std::min(text.find(' '), text.size());
    const auto number = finite_number(text.substr(0, end));
    if (!number.has_value()) return std::nullopt;
    words.numbers.push_back(*number);
    text.remove_prefix(end);
  }
  return words;
}

}  // namespace mlab::vehicle
