#include "mlab/geography/place_text.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "mlab/geography/notation.h"
#include "mlab/text/shown.h"

namespace mlab::geography {
namespace {

constexpr std::size_t kMostCharacters = 100;

std::unexpected<text::Diagnostic> failure(std::string kind, std::string message, std::string label) {
  text::Diagnostic out;
  out.kind = std::move(kind);
  out.message = std::move(message);
  out.label = std::move(label);
  return std::unexpected(std::move(out));
}

std::unexpected<text::Diagnostic> not_understood(std::string_view text, std::string label) {
  return failure("place-not-understood", fmt::format("`{}` is no place on the Earth", text::shown(text)),
                 std::move(label));
}
std::unexpected<text::Diagnostic> out_of_range(std::string_view seen, std::string label) {
  return failure("place-out-of-range", fmt::format("`{}` is out of range", text::shown(seen)),
                 std::move(label));
}

constexpr std::string_view kExpected =
    "expected degrees (`48.2 N 16.4 E`), UTM (`33N 602065 5340353`) or MGRS (`33UXP0206540353`)";

bool is_digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}
bool is_letter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

// What a text is made of: a number, or one letter or mark.
struct Piece {
  std::string_view text;
  std::optional<double> number;
  char mark = 0;  // a letter is a capital; degree, minute and second marks are `d`, `'` and `"`
};

// Typographic marks as the plain ones, commas as blanks, letters as capitals.
std::string plain(std::string_view text) {
  constexpr std::pair<std::string_view, std::string_view> kMarks[] = {{"°", "D"},   {"º", "D"},  {"′", "'"},
                                                                      {"’", "'"},   {"″", "\""}, {"”", "\""},
                                                                      {"''", "\""}, {"−", "-"},  {",", " "}};
  std::string out;
  while (!text.empty()) {
    const auto* mark = std::ranges::find_if(kMarks, [&](const auto& m) { return text.starts_with(m.first); });
    if (mark != std::end(kMarks)) {
      out += mark->second;
      text.remove_prefix(mark->first.size());
    } else {
      out += static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
      text.remove_prefix(1);
    }
  }
  return out;
}

// How many characters at the start are a number; a sign belongs to it, an exponent does not.
std::size_t number_length(std::string_view text) {
  std::size_t n = text.starts_with('-') || text.starts_with('+') ? 1 : 0;
  std::size_t digits = 0;
  bool has_point = false;
  for (; n < text.size() && (is_digit(text[n]) || (text[n] == '.' && !has_point)); ++n) {
    has_point |= text[n] == '.';
    digits += is_digit(text[n]) ? 1 : 0;
  }
  return digits > 0 ? n : 0;
}

// Nothing where a character belongs to no place.
std::optional<std::vector<Piece>> pieces_of(std::string_view text) {
  std::vector<Piece> out;
  while (!text.empty()) {
    if (std::isspace(static_cast<unsigned char>(text[0])) != 0) {
      text.remove_prefix(1);
      continue;
    }
    Piece piece;
    std::size_t length = number_length(text);
    if (length > 0) {
      const std::size_t sign = text[0] == '+' ? 1 : 0;
      double value = 0.0;
      std::from_chars(text.data() + sign, text.data() + length, value);
      piece.number = value;
    } else if (is_letter(text[0]) || text[0] == '\'' || text[0] == '"') {
      length = 1;
      piece.mark = text[0];
    } else {
      return std::nullopt;
    }
    piece.text = text.substr(0, length);
    text.remove_prefix(length);
    out.push_back(piece);
  }
  return out;
}

// --- MGRS and UTM ---

// Digits, three letters, digits, and nothing else; blanks may stand between them.
std::optional<std::string> mgrs_square(std::string_view text) {
  std::string out;
  std::ranges::copy_if(text, std::back_inserter(out),
                       [](char c) { return std::isspace(static_cast<unsigned char>(c)) == 0; });
  const auto zone = std::ranges::find_if_not(out, is_digit);
  const auto letters = std::find_if_not(zone, out.end(), is_letter);
  const bool fits = zone != out.begin() && letters - zone == 3 && std::all_of(letters, out.end(), is_digit);
  return fits ? std::optional(out) : std::nullopt;
}

text::Result<GeoPoint> read_mgrs(const std::string& square) {
  if (const std::optional<GeoPoint> place = place_of_mgrs(square)) return *place;
  return not_understood(
      square,
      "MGRS is a zone (1 to 60), its band (C to X), two letters that this zone has for a square of 100 "
      "km, and as many digits for the easting as for the northing, 1 to 7 each");
}

// A zone and a letter, easting and northing.
bool looks_like_utm(const std::vector<Piece>& pieces) {
  return pieces.size() == 4 && pieces[0].number && is_letter(pieces[1].mark) && pieces[2].number &&
         pieces[3].number && pieces[1].mark != 'D' && pieces[1].mark != 'E' && pieces[1].mark != 'W' &&
         std::abs(*pieces[2].number) > 360.0;
}

text::Result<GeoPoint> read_utm(const std::vector<Piece>& pieces) {
  const double zone = *pieces[0].number;
  if (zone != std::floor(zone) || zone < 1.0 || zone > 60.0)
    return out_of_range(pieces[0].text, "a zone of UTM is 1 to 60");
  const char hemisphere = pieces[1].mark;
  if (hemisphere != 'N' && hemisphere != 'S') {
    return not_understood(pieces[1].text,
                          "behind the zone of UTM stands the hemisphere, `N` or `S`, not the latitude band");
  }
  const Utm utm{static_cast<int>(zone), hemisphere == 'N', *pieces[2].number, *pieces[3].number};
  if (utm.easting < 0.0 || utm.easting > 1e6)
    return out_of_range(pieces[2].text, "an easting of UTM is 0 to 1000000 m");
  const std::optional<GeoPoint> place = place_of(utm);
  if (!place) return out_of_range(pieces[3].text, "a northing of UTM is 0 to 10000000 m");
  return *place;
}

// --- latitude and longitude ---

struct Angle {
  std::vector<Piece> numbers;  // degrees, minutes, seconds
  char hemisphere = 0;         // N, S, E, W; 0: none said
};

bool is_hemisphere(char mark) {
  return mark == 'N' || mark == 'S' || mark == 'E' || mark == 'W';
}

// Whether a mark may stand behind the first, second, third number of an angle.
bool is_mark_of(std::size_t number, char mark) {
  return (number == 1 && mark == 'D') || (number == 2 && mark == '\'') || (number == 3 && mark == '"');
}

// Two angles with letters: before both of them, or behind.
std::optional<std::vector<Angle>> with_letters(const std::vector<Piece>& pieces) {
  const bool is_before = is_hemisphere(pieces.front().mark);
  std::vector<Angle> out(is_before ? 0 : 1);
  for (const Piece& piece : pieces) {
    if (is_hemisphere(piece.mark)) {
      if (is_before) out.emplace_back();
      if (out.back().hemisphere != 0) return std::nullopt;
      out.back().hemisphere = piece.mark;
    } else {
      if (!is_before && out.back().hemisphere != 0) out.emplace_back();
      if (piece.number)
        out.back().numbers.push_back(piece);
      else if (!is_mark_of(out.back().numbers.size(), piece.mark))
        return std::nullopt;
    }
  }
  const auto is_whole = [](const Angle& a) { return a.hemisphere != 0 && !a.numbers.empty(); };
  return out.size() == 2 && std::ranges::all_of(out, is_whole) ? std::optional(out) : std::nullopt;
}

// Two angles without letters: the first half of the numbers is the latitude.
std::optional<std::vector<Angle>> without_letters(const std::vector<Piece>& pieces) {
  const auto count = static_cast<std::size_t>(
      std::ranges::count_if(pieces, [](const Piece& p) { return p.number.has_value(); }));
  if (count == 0 || count % 2 != 0) return std::nullopt;
  std::vector<Angle> out(1);
  for (const Piece& piece : pieces) {
    if (piece.number && out.back().numbers.size() == count / 2) out.emplace_back();
    if (piece.number)
      out.back().numbers.push_back(piece);
    else if (!is_mark_of(out.back().numbers.size(), piece.mark))
      return std::nullopt;
  }
  return out.size() == 2 ? std::optional(out) : std::nullopt;
}

text::Result<double> degrees_of(const Angle& angle, double most, std::string_view what) {
  if (angle.numbers.size() > 3)
    return not_understood(angle.numbers[3].text, "an angle is degrees, minutes and seconds, nothing more");
  const bool has_sign = angle.numbers[0].text.front() == '-' || angle.numbers[0].text.front() == '+';
  if (has_sign && angle.hemisphere != 0)
    return not_understood(angle.numbers[0].text,
                          "an angle has a sign or one of `N`, `S`, `E`, `W`, not both");
  double out = std::abs(*angle.numbers[0].number);
  double unit = 1.0;
  for (std::size_t i = 1; i < angle.numbers.size(); ++i) {
    const Piece& part = angle.numbers[i];
    unit /= 60.0;
    if (*part.number < 0.0 || *part.number >= 60.0 || std::signbit(*part.number))
      return out_of_range(part.text, "minutes and seconds are 0 or more and less than 60");
    if (angle.numbers[i - 1].text.find('.') != std::string_view::npos)
      return not_understood(angle.numbers[i - 1].text, "only the last number of an angle has a fraction");
    out += *part.number * unit;
  }
  if (out > most)
    return out_of_range(angle.numbers[0].text,
                        fmt::format("a {} is at most {:g} degrees from 0", what, most));
  const bool is_negative =
      angle.hemisphere == 'S' || angle.hemisphere == 'W' || angle.numbers[0].text.front() == '-';
  return is_negative ? -out : out;
}

text::Result<GeoPoint> read_degrees(std::string_view text, const std::vector<Piece>& pieces) {
  const bool has_letters = std::ranges::any_of(pieces, [](const Piece& p) { return is_hemisphere(p.mark); });
  std::optional<std::vector<Angle>> angles = has_letters ? with_letters(pieces) : without_letters(pieces);
  if (!angles) return not_understood(text, std::string(kExpected));
  const auto is_longitude = [](const Angle& a) { return a.hemisphere == 'E' || a.hemisphere == 'W'; };
  if (has_letters) {
    if (is_longitude((*angles)[0]) == is_longitude((*angles)[1]))
      return not_understood(text, "a place is one latitude, `N` or `S`, and one longitude, `E` or `W`");
    if (is_longitude((*angles)[0])) std::swap((*angles)[0], (*angles)[1]);
  }
  const text::Result<double> latitude = degrees_of((*angles)[0], 90.0, "latitude");
  if (!latitude) return std::unexpected(latitude.error());
  const text::Result<double> longitude = degrees_of((*angles)[1], 180.0, "longitude");
  if (!longitude) return std::unexpected(longitude.error());
  return GeoPoint{*latitude, *longitude};
}

text::Result<GeoPoint> read_any(std::string_view text) {
  if (text.size() > kMostCharacters)
    return not_understood(text, fmt::format("a place has at most {} characters", kMostCharacters));
  const std::string words = plain(text);
  if (const std::optional<std::string> square = mgrs_square(words)) return read_mgrs(*square);
  const std::optional<std::vector<Piece>> pieces = pieces_of(words);
  if (!pieces || pieces->empty()) return not_understood(text, std::string(kExpected));
  return looks_like_utm(*pieces) ? read_utm(*pieces) : read_degrees(text, *pieces);
}

}  // namespace

text::Result<GeoPoint> read_place(std::string_view text) {
  text::Result<GeoPoint> place = read_any(text);
  if (place && !is_between_the_caps(*place)) {
    return failure("place-polar", fmt::format("`{}` is too near to a pole", text::shown(text)),
                   "places lie between 80 degrees south and 84 degrees north");
  }
  return place;
}

}  // namespace mlab::geography
