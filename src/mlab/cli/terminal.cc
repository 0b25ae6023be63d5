#include "mlab/cli/terminal.h"

#include <unistd.h>

#include <cstdio>
#include <string>

#include <fmt/core.h>

#include "mlab/cli/files.h"
#include "mlab/cli/input.h"
#include "mlab/text/colors.h"
#include "mlab/text/standard_input.h"

namespace mlab::cli {
bool is_colored(int descriptor) {
  const std::string terminal = environment_variable("TERM");
  return isatty(descriptor) == 1 && environment_variable("NO_COLOR").empty() && !terminal.empty() &&
         terminal != "dumb";
}

std::string colored(const std::string& text, Color color) {
  constexpr const char* kCodes[] = {"1;32", "1;33", "1;31"};
  if (!is_colored(STDOUT_FILENO)) return text;
  return fmt::format("\x1b[{}m{}\x1b[0m", kCodes[static_cast<std::size_t>(color)], text);
}

text::Result<text::SourcePtr> read_input(const std::string& file) {
  return is_standard_input(file) ? text::read_standard_input() : text::read_source(file);
}

void tell(const text::Diagnostics& diagnostics) {
  const bool in_colors = is_colored(STDERR_FILENO);
  fmt::print(stderr, "{}", in_colors ? text::render_in_colors(diagnostics) : text::render(diagnostics));
}

void tell(const text::Diagnostic& diagnostic) {
  const bool in_colors = is_colored(STDERR_FILENO);
  fmt::print(stderr, "{}", in_colors ? text::render_in_colors(diagnostic) : text::render(diagnostic));
}

}  // namespace mlab::cli
