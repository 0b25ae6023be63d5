#include <cstdio>
#include <optional>
#include <string>

#include <fmt/core.h>

#include "mlab/assist/service.h"
#include "mlab/cli/commands.h"
#include "mlab/cli/files.h"
#include "mlab/cli/input.h"
#include "mlab/cli/terminal.h"
#include "mlab/text/diagnostic.h"

namespace mlab::cli {

using assist::Language;
using assist::language_of;
namespace {

// The canonical layout; nothing where the file has errors, which are then in the sink.
std::optional<std::string> canonical(const text::SourcePtr& source, text::Diagnostics& sink) {
  const std::optional<Language> language = language_of(*source);
  if (!language) {
    sink.error("unknown-language", {source, {0, 0}}, "this is no mission, overlay, network or configuration")
        .hints = {"the name may say it: .mdl, .odl, .cnl, .cdl"};
    return std::nullopt;
  }
  return assist::formatted({source, *language}, sink);
}

}  // namespace

int format(const FormatOptions& options) {
  int status = kDone;
  for (const std::string& file : options.files) {
    text::Diagnostics sink;
    text::Result<text::SourcePtr> source = read_input(file);
    if (!source) sink.report(source.error());
    const std::optional<std::string> wanted = source ? canonical(*source, sink) : std::nullopt;
    if (!wanted) {
      tell(sink);
      fmt::print(stderr, "{}: left as it is\n", file);
      status = kBadInput;
      continue;
    }
    if (is_standard_input(file) && !options.check_only) {
      fmt::print("{}", *wanted);
      continue;
    }
    if (*wanted == (*source)->text()) continue;
    if (options.check_only) {
      fmt::print("{}: not in the canonical layout\n", file);
      if (status == kDone) status = kFailed;
    } else if (write_file(file, *wanted)) {
      fmt::print("{}: rewritten\n", file);
    } else {
      fmt::print(stderr, "mlab fmt: {} can't be written{}\n", file, why_not_written());
      status = kBadInput;
    }
  }
  return status;
}

}  // namespace mlab::cli
