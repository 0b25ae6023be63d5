#include <cstdio>
#include <optional>
#include <string>

#include <fmt/core.h>

#include "mlab/cli/commands.h"
#include "mlab/cli/files.h"
#include "mlab/cli/language.h"
#include "mlab/lang/cdl/format.h"
#include "mlab/lang/cdl/formula.h"
#include "mlab/lang/cnl/format.h"
#include "mlab/lang/mdl/mdl.h"
#include "mlab/lang/mdl/tree.h"
#include "mlab/lang/odl/odl.h"
#include "mlab/text/diagnostic.h"

namespace mlab::cli {
namespace {

// The canonical layout; nothing where the file has errors, which are then in the sink.
std::optional<std::string> canonical(const text::SourcePtr& source, text::Diagnostics& sink) {
  const std::optional<Language> language = language_of(*source);
  if (!language) {
    sink.error("unknown-language", {source, {0, 0}}, "this is no mission, overlay, network or configuration")
        .hints = {"the name may say it: .mdl, .odl, .cnl, .cdl"};
    return std::nullopt;
  }
  switch (*language) {
    case Language::kMission: {
      const mdl::Tree tree = mdl::parse(source, sink);
      return sink.has_errors() ? std::nullopt : std::optional(mdl::print(tree));
    }
    case Language::kOverlay: {
      const odl::Tree tree = odl::parse(source, sink);
      return sink.has_errors() ? std::nullopt : std::optional(odl::print(tree));
    }
    case Language::kNetwork:
      return cnl::format(source, sink);
    case Language::kConfiguration:
      if (source->name().ends_with(".formula") || cdl::looks_like_formula(source->text()))
        return std::string(source->text());  // a sentence has no layout of its own
      return cdl::format(source, sink);
    case Language::kEnvironment:
      return std::string(source->text());  // has no layout of its own
  }
  return std::nullopt;
}

}  // namespace

int format(const FormatOptions& options) {
  int status = kDone;
  for (const std::string& file : options.files) {
    text::Diagnostics sink;
    text::Result<text::SourcePtr> source = text::read_source(file);
    if (!source) sink.report(source.error());
    const std::optional<std::string> wanted = source ? canonical(*source, sink) : std::nullopt;
    if (!wanted) {
      fmt::print(stderr, "{}{}: left as it is\n", text::render(sink), file);
      status = kBadInput;
      continue;
    }
    if (*wanted == (*source)->text()) continue;
    if (options.check_only) {
      fmt::print("{}: not in the canonical layout\n", file);
      if (status == kDone) status = kFailed;
    } else if (write_file(file, *wanted)) {
      fmt::print("{}: rewritten\n", file);
    } else {
      fmt::print(stderr, "mlab fmt: {} can't be written\n", file);
      status = kBadInput;
    }
  }
  return status;
}

}  // namespace mlab::cli
