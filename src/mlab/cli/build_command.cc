#include <cstdio>
#include <filesystem>
#include <string>

#include <fmt/core.h>

#include "mlab/cli/commands.h"
#include "mlab/cli/files.h"
#include "mlab/lang/cdl/emit_cnl.h"
#include "mlab/robot/configuration_file.h"
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

}  // namespace

int build(const BuildOptions& options) {
  text::Diagnostics sink;
  const std::filesystem::path path(options.file);
  const std::string name = options.robot.empty() ? path.string() : path.string() + "#" + options.robot;
  const std::string type = path.stem().string();
  const auto robot = robot::load_configuration(name, type, {}, program_sources(""), sink);
  fmt::print(stderr, "{}", text::render(sink));
  if (!robot) return kBadInput;
  return put(cdl::cnl_text(robot->lowered.network), options.output);
}

}  // namespace mlab::cli
