#include "mlab/cli/commands/export.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "mlab/cli/commands.h"
#include "mlab/cli/files.h"
#include "mlab/cli/permission.h"
#include "mlab/cli/terminal.h"
#include "mlab/export/format.h"
#include "mlab/lang/cdl/formula/formula.h"
#include "mlab/robot/program/brought_code.h"
#include "mlab/robot/program/configuration_file.h"
#include "mlab/text/diagnostic.h"

namespace mlab::cli {
namespace {

constexpr const char* kFormula = "formula";

// What the formats of other tools say of a robot.
std::optional<std::string> exported(const robot::ConfiguredRobot& robot, const std::string& format,
                                    text::Diagnostics& sink) {
  const auto library = robot::describe_library(robot.configuration.procedures);
  const exports::Subject subject{robot.configuration, *robot.configuration.robots.at(robot.robot),
                                 robot.lowered.network, library->library};
  return exports::find_format(format)->write(subject, sink);
}

std::string sentences(const text::SourcePtr& source, text::Diagnostics& sink) {
  const cdl::Configuration configuration = cdl::load(source, robot::library_environment(), sink);
  const auto library = robot::describe_library(configuration.procedures);
  return cdl::print(cdl::formula(configuration, library->library, sink));
}

// The sentences of a file: of all its robots and societies, so none has to be chosen.
int write_formula(const BuildOptions& options) {
  text::Diagnostics sink;
  std::string out;
  if (const text::Result<text::SourcePtr> source = text::read_source(options.file)) {
    robot::check_configuration(*source, program_sources("", permission_to_build(options)), sink);
    if (!sink.has_errors()) out = sentences(*source, sink);
  } else {
    sink.report(source.error());
  }
  tell(sink);
  return sink.has_errors() ? kBadInput : put(out, options.output);
}

}  // namespace

std::vector<std::string> export_formats() {
  std::vector<std::string> out;
  for (const exports::Format& format : exports::formats()) out.emplace_back(format.name);
  std::sort(out.begin(), out.end());
  return out;
}

bool is_export(const std::string& format) {
  return format == kFormula || exports::find_format(format) != nullptr;
}

int export_configuration(const BuildOptions& options) {
  if (options.emit == kFormula) return write_formula(options);
  text::Diagnostics sink;
  const std::string name = options.robot.empty() ? options.file : options.file + "#" + options.robot;
  const auto robot = robot::load_configuration(name, std::filesystem::path(options.file).stem().string(), {},
                                               program_sources("", permission_to_build(options)), sink);
  std::optional<std::string> text;
  if (robot) text = exported(*robot, options.emit, sink);
  tell(sink);
  return text ? put(*text, options.output) : kBadInput;
}

int put(const std::string& text, const std::string& file) {
  if (file.empty()) {
    fmt::print("{}", text);
    return kDone;
  }
  if (write_file(file, text)) return kDone;
  fmt::print(stderr, "mlab build: {} can't be written{}\n", file, why_not_written());
  return kBadInput;
}

}  // namespace mlab::cli
