#include "mlab/lang/cnl/cpp_writer.h"

#include <algorithm>

#include <fmt/core.h>

namespace mlab::cnl {

std::string cpp_string(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    const auto u = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (u < 0x20 || u == 0x7f || c == '?') {
      out += fmt::format("\\{:03o}", u);  // `?`: no trigraph by accident
    } else {
      out += c;
    }
  }
  return out + '"';
}

std::string_view base_name(std::string_view path) {
  const std::size_t slash = path.rfind('/');
  return slash == std::string_view::npos ? path : path.substr(slash + 1);
}

void CppWriter::append(std::string_view text) {
  text_ += text;
  next_line_ += static_cast<std::uint32_t>(std::count(text.begin(), text.end(), '\n'));
}

void CppWriter::line(std::string_view text) {
  append(text);
  append("\n");
}

void CppWriter::here() {
  append(fmt::format("#line {} {}\n", next_line_ + 1, cpp_string(name_)));
}

void CppWriter::at(const text::Place& place, std::string_view text) {
  const text::LineColumn at = place.source->line_column(place.span.begin);
  append(fmt::format("#line {} {}\n{}{}\n", at.line, cpp_string(place.source->name()),
                     std::string(at.column - 1, ' '), text));
  here();
}

void CppWriter::user_code(const Code& code) {
  if (!code.place.source) return;
  const text::LineColumn at = code.place.source->line_column(code.place.span.begin);
  // Code that starts behind `header` on its line keeps its column.
  append(fmt::format("#line {} {}\n{}", at.line, cpp_string(code.place.source->name()),
                     std::string(at.column - 1, ' ')));
  append(code.text());
  if (!code.text().ends_with('\n')) append("\n");
  here();
}

}  // namespace mlab::cnl
