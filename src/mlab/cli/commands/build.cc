#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include <fmt/core.h>

#include "mlab/cli/commands.h"
#include "mlab/cli/commands/export.h"
#include "mlab/cli/files.h"
#include "mlab/cli/input.h"
#include "mlab/cli/other_language.h"
#include "mlab/cli/permission.h"
#include "mlab/cli/places.h"
#include "mlab/cli/terminal.h"
#include "mlab/cli/version.h"
#include "mlab/lang/cdl/emit_cnl.h"
#include "mlab/robot/executable/emit_cpp.h"
#include "mlab/robot/executable/executable.h"
#include "mlab/robot/program/configuration_file.h"
#include "mlab/robot/program/network_file.h"
#include "mlab/text/diagnostic.h"

namespace mlab::cli {
namespace {

namespace fs = std::filesystem;

// What an architecture is built to where nothing else is asked for; empty: an executable.
std::string generator_of(const std::string& architecture) {
  return architecture == "UGV" ? "sausages" : "";
}

// The architecture that a configuration names; its mistakes are told by whoever reads it next.
std::string architecture_of(const std::string& file) {
  const text::Result<text::SourcePtr> source = text::read_source(file);
  text::Diagnostics sink;
  return source ? cdl::load(*source, robot::library_environment(), sink).architecture : "";
}

robot::ProgramSources sources_of(const BuildOptions& options) {
  robot::ProgramSources out = program_sources("", permission_to_build(options));
  out.checks_code = !options.emit.empty();  // what becomes an executable is compiled anyway
  return out;
}

std::optional<robot_build::RobotSource> configured(const BuildOptions& options, text::Diagnostics& sink) {
  const std::string name = options.robot.empty() ? options.file : options.file + "#" + options.robot;
  auto robot =
      robot::load_configuration(name, fs::path(options.file).stem().string(), {}, sources_of(options), sink);
  if (!robot) return std::nullopt;
  robot_build::RobotSource out;
  out.network = std::move(robot->lowered.network);
  out.body = std::move(robot->lowered.body);
  out.procedures = robot->configuration.procedures;
  return out;
}

std::optional<robot_build::RobotSource> networked(const BuildOptions& options, text::Diagnostics& sink) {
  auto read = robot::read_network(options.file, {}, sources_of(options), sink);
  if (!read) return std::nullopt;
  robot_build::RobotSource out;
  if (read->network.nodes.empty()) {
    sink.error("no-network", {},
               fmt::format("`{}` holds procedures, and no network that uses them", options.file));
    return std::nullopt;
  }
  out.network = std::move(read->network);
  out.procedures = {read->tree};
  return out;
}

// Empty: it is not beside this program.
std::string agent_path() {
  const std::string out = prefix() + "/bin/mlab-agent";
  return ::access(out.c_str(), X_OK) == 0 ? out : "";
}

// Where progress is shown to a person; nothing in a pipe.
class ProgressLine {
 public:
  void show(std::size_t done, std::size_t total, const std::string& what) const {
    if (is_shown_) fmt::print(stderr, "\r\x1b[K[{}/{}] {}", done, total, what);
    std::fflush(stderr);
  }
  ~ProgressLine() {
    if (is_shown_) fmt::print(stderr, "\r\x1b[K");
  }

 private:
  bool is_shown_ = isatty(STDERR_FILENO) != 0;
};

int build_program(const BuildOptions& options, const robot_build::RobotSource& robot,
                  text::Diagnostics& sink) {
  const std::string output =
      target_of(options.output.empty() ? fs::path(options.file).replace_extension().string() : options.output)
          .string();
  std::error_code error;
  const bool is_no_file = fs::exists(output, error) && !fs::is_regular_file(output, error);
  const std::string why = is_no_file ? "" : why_not_writable(output);
  if (is_no_file || !why.empty() || fs::equivalent(output, options.file, error)) {
    fmt::print(stderr, "mlab build: {} can't be written{}{}; -o names another file\n", output,
               why.empty() ? "" : ": ", why);
    return kBadInput;
  }
  const auto began = std::chrono::steady_clock::now();
  std::optional<robot_build::BuildReport> report;
  {
    const ProgressLine line;
    report = robot_build::build_executable(
        robot_build::emit_cpp(robot), output, toolchain(), permission_to_build(options), sink,
        [&](std::size_t done, std::size_t total, const std::string& what) { line.show(done, total, what); });
  }
  tell(sink);
  if (!report) return kBadInput;
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
  fmt::print("{}: {} of {} files compiled, {:.1f} s\n", output, report->compiled.size(),
             report->compiled.size() + report->reused, took.count());
  return kDone;
}

}  // namespace

int build(const BuildOptions& asked) {
  BuildOptions options = asked;
  const fs::path path(options.file);
  if (is_standard_input(options.file)) {
    fmt::print(stderr, "mlab build: -: expected a file, whose name is the robot's\n");
    return kBadInput;
  }
  using assist::Language;
  if (const std::string why = other_language(options.file, {Language::kConfiguration, Language::kNetwork});
      !why.empty()) {
    fmt::print(stderr, "mlab build: {}\n", why);
    return kBadInput;
  }
  if (options.emit.empty() && path.extension() != ".cnl") {
    options.emit = generator_of(architecture_of(options.file));
    if (!options.emit.empty() && options.output.empty())
      options.output = fs::path(options.file).replace_extension("." + options.emit).string();
  }
  if (is_export(options.emit)) {
    if (path.extension() != ".cnl") return export_configuration(options);
    fmt::print(stderr, "mlab build: {} is a network; --emit {} is of a configuration (.cdl)\n", options.file,
               options.emit);
    return kBadInput;
  }
  text::Diagnostics sink;
  auto robot = path.extension() == ".cnl" ? networked(options, sink) : configured(options, sink);
  if (robot) {
    robot->name = path.stem().string();
    robot->origin = path.filename().string();
    robot->version = kVersion;
    robot->is_closed = options.closed;
  }
  const bool is_sound = robot && !sink.has_errors();
  if (is_sound && options.emit.empty()) robot->agent = agent_path();
  if (is_sound && options.emit.empty()) return build_program(options, *robot, sink);
  if (is_sound && options.emit == "cnl") cdl::check_for_cnl(robot->network, sink);
  tell(sink);
  if (!is_sound || sink.has_errors()) return kBadInput;
  return put(options.emit == "cpp" ? robot_build::joined(robot_build::emit_cpp(*robot))
                                   : cdl::cnl_text(robot->network),
             options.output);
}

}  // namespace mlab::cli
