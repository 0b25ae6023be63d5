#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>

#include <fmt/core.h>

#include "mlab/cli/commands.h"
#include "mlab/cli/files.h"
#include "mlab/export/format.h"
#include "mlab/lang/cdl/emit_cnl.h"
#include "mlab/lang/cdl/formula.h"
#include "mlab/robot/configuration_file.h"
#include "mlab/robot/native_library.h"
#include "mlab/text/diagnostic.h"

namespace mlab::cli {
namespace {

// To the file that was asked for, or to standard output.
int put(const std::string& text, const std::string& file) {
  if (file.empty()) {
    fmt::print("{}", text);
    return kDone;
  }
  if (write_file(file, text)) return kDone;
  fmt::print(stderr, "mlab build: {} can't be written\n", file);
  return kBadInput;
}

// What the formats of other tools say of a robot.
int emit(const robot::ConfiguredRobot& robot, const BuildOptions& options) {
  text::Diagnostics sink;
  const auto library = robot::library_with(robot.configuration.procedures, program_sources(""), sink);
  std::optional<std::string> text;
  if (library) {
    const exports::Subject subject{robot.configuration, *robot.configuration.robots.at(robot.robot),
                                   robot.lowered.network, *library};
    text = exports::find_format(options.emit)->write(subject, sink);
  }
  fmt::print(stderr, "{}", text::render(sink));
  return text ? put(*text, options.output) : kBadInput;
}

std::string sentences(const text::SourcePtr& source, text::Diagnostics& sink) {
  const cdl::Configuration configuration = cdl::load(source, robot::library_environment(), sink);
  const auto library = robot::library_with(configuration.procedures, program_sources(""), sink);
  return library ? cdl::print(cdl::formula(configuration, *library, sink)) : "";
}

// The sentences of a file: of all its robots and societies, so none has to be chosen.
int build_formula(const BuildOptions& options) {
  text::Diagnostics sink;
  std::string out;
  if (const text::Result<text::SourcePtr> source = text::read_source(options.file)) {
    robot::check_configuration(*source, program_sources(""), sink);
    if (!sink.has_errors()) out = sentences(*source, sink);
  } else {
    sink.report(source.error());
  }
  fmt::print(stderr, "{}", text::render(sink));
  return sink.has_errors() ? kBadInput : put(out, options.output);
}

}  // namespace

int build(const BuildOptions& options) {
  if (options.emit == "formula") return build_formula(options);
  text::Diagnostics sink;
  const std::filesystem::path path(options.file);
  const std::string name = options.robot.empty() ? path.string() : path.string() + "#" + options.robot;
  const std::string type = path.stem().string();
  const auto robot = robot::load_configuration(name, type, {}, program_sources(""), sink);
  fmt::print(stderr, "{}", text::render(sink));
  if (!robot) return kBadInput;
  if (options.emit == "cnl") return put(cdl::cnl_text(robot->lowered.network), options.output);
  return emit(*robot, options);
}

}  // namespace mlab::cli
