#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "mlab/cli/commands.h"
#include "mlab/cli/files.h"
#include "mlab/cli/input.h"
#include "mlab/cli/terminal.h"
#include "mlab/designer/edit/spread.h"
#include "mlab/lang/cdl/syntax/parser.h"
#include "mlab/lang/cdl_historic/import.h"
#include "mlab/lang/cdl_historic/standing.h"
#include "mlab/robot/program/configuration_file.h"
#include "mlab/robot/program/robot_program.h"
#include "mlab/text/diagnostic.h"

namespace mlab::cli {

int import(const ImportOptions& options) {
  text::Diagnostics sink;
  const text::Result<text::SourcePtr> source = read_input(options.file);
  if (!source) {
    tell(source.error());
    return kBadInput;
  }
  const cdl_historic::Vocabulary vocabulary(robot::component_library(),
                                            robot::library_environment().built_in);
  const std::string out = designer::spread_out(cdl_historic::import_as_text(*source, vocabulary, sink),
                                               robot::library_environment());
  tell(sink);
  if (sink.has_errors()) {
    fmt::print(stderr, "mlab import: {} has errors; nothing is written\n", options.file);
    return kBadInput;
  }
  if (options.output.empty()) {
    fmt::print("{}", out);
  } else if (!write_file(options.output, out)) {
    fmt::print(stderr, "mlab import: {} can't be written{}\n", options.output, why_not_written());
    return kBadInput;
  }
  // Last, so that it is what a person sees: a robot that stands looks like one that works.
  text::Diagnostics ours;
  const std::vector<cdl_historic::Standing> standing = cdl_historic::standing_robots(
      cdl::parse(std::make_shared<const text::Source>(options.file, out), ours));
  if (!standing.empty()) {
    fmt::print(stderr, "mlab import: {} stand{} still, for nothing here moves {}: {}\n",
               standing.size() == 1 ? "a robot" : fmt::format("{} robots", standing.size()),
               standing.size() == 1 ? "s" : "", standing.size() == 1 ? "it" : "them",
               cdl_historic::said_of(standing));
  }
  return options.strict && (sink.warning_count() > 0 || !standing.empty()) ? kFailed : kDone;
}

}  // namespace mlab::cli
