#include "mlab/text/escape.h"

#include <charconv>
#include <cstddef>
#include <system_error>

namespace mlab::text {

std::string markup(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '&':
        out += "&amp;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += static_cast<unsigned char>(c) < ' ' && c != '\n' && c != '\t' ? ' ' : c;
    }
  }
  return out;
}

namespace {

// Spreadsheets compute what begins so, quoted or not, unless it is a number.
bool may_be_formula(std::string_view text) {
  if (text.empty() || std::string_view("=+-@\t\r").find(text.front()) == std::string_view::npos) return false;
  double number = 0.0;
  const std::size_t sign = text.front() == '+' ? 1 : 0;
  const auto [end, error] = std::from_chars(text.data() + sign, text.data() + text.size(), number);
  return error != std::errc{} || end != text.data() + text.size();
}

}  // namespace

std::string csv_field(std::string_view text) {
  const std::string_view before = may_be_formula(text) ? "'" : "";
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(before).append(text);
  std::string out = std::string("\"").append(before);
  for (const char c : text) {
    if (c == '"') out += c;
    out += c;
  }
  return out + "\"";
}

}  // namespace mlab::text
