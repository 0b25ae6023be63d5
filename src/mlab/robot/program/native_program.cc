#include "mlab/robot/program/native_program.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <system_error>
#include <utility>

#include <fmt/core.h>

#include "mlab/robot/program/brought_code.h"
#include "mlab/robot/wire/network_wire.h"
#include "mlab/text/shown.h"

namespace mlab::robot {
namespace {

namespace fs = std::filesystem;

fs::path path_of(const std::string& name, const ProgramSources& sources) {
  std::error_code failure;
  return fs::weakly_canonical(fs::absolute(fs::path(sources.folder) / name, failure), failure);
}

// An executable may be anybody's, in any language: it gets the libraries of the system beside itself, and a
// script the programs that read scripts.
robot_host::Launch launch_of_any(const std::string& executable, cell::Wall wall,
                                 const robot_host::Limits& limits) {
  robot_host::Launch out = robot_host::launch_of(executable, wall, limits);
  for (const char* folder : {"/usr/lib", "/usr/local/lib", "/lib", "/lib64"})
    out.policy.readable.emplace_back(folder);
  std::string begin(2, '\0');
  std::ifstream(executable, std::ios::binary).read(begin.data(), 2);
  if (begin == "#!") {
    for (const char* folder : {"/usr/bin", "/bin", "/usr/local/bin"})
      out.policy.executable.emplace_back(folder);
    for (const char* folder : {"/usr/share", "/etc/alternatives"}) out.policy.readable.emplace_back(folder);
  }
  return out;
}

// Whatever an executable is asked has the time that people set.
robot_host::Limits limits_of(const ProgramSources& sources) {
  robot_host::Limits out = sources.limits;
  out.start = out.answer = out.cycle_wall;
  out.ends = sources.ends;
  return out;
}

void say_results(const NativeProgram& native, std::span<const Setting> asked, const std::string& program,
                 const std::vector<std::string>& known_keys, text::Diagnostics& sink) {
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const wire::SettingResult& result = native.description.results(static_cast<int>(i));
    if (!result.problem().empty())
      sink.error("bad-parameter", asked[i].value_place, text::shown(result.problem(), 200));
    if (!result.is_unknown() || asked[i].is_preset) continue;
    if (std::ranges::find(known_keys, asked[i].key) != known_keys.end()) continue;  // the body's
    std::vector<std::string> names = known_keys;
    for (const wire::Port& port : native.description.ports()) {
      if (port.role() == wire::Port::PARAMETER) names.push_back(port.path());
    }
    text::Diagnostic& d =
        sink.warning("unknown-parameter", asked[i].place,
                     fmt::format("program `{}` has no parameter `{}`", program, asked[i].key));
    const std::string nearest = text::nearest_name(asked[i].key, names);
    if (!nearest.empty() && nearest != asked[i].key)
      d.hints.push_back(fmt::format("did you mean `{}`?", nearest));
  }
}

// Those that the program did not know would be refused at every start.
void drop_unknown(NativeProgram& native) {
  robot_host::Settings known;
  for (std::size_t i = 0; i < native.settings.size(); ++i) {
    if (!native.description.results(static_cast<int>(i)).is_unknown())
      known.push_back(std::move(native.settings[i]));
  }
  native.settings = std::move(known);
}

}  // namespace

const wire::Port* NativeProgram::find(std::string_view path) const {
  const auto at =
      std::ranges::find_if(description.ports(), [&](const wire::Port& port) { return port.path() == path; });
  return at == description.ports().end() ? nullptr : &*at;
}

bool is_executable(const std::string& name, const ProgramSources& sources) {
  std::error_code failure;
  const fs::path path = path_of(name, sources);
  return fs::is_regular_file(path, failure) && access(path.c_str(), X_OK) == 0;
}

void refuse_executable(const std::string& name, const text::Place& place, const std::string& what,
                       text::Diagnostics& sink) {
  sink.error("bad-robot-program", place, fmt::format("`{}` is no robot program: it {}", name, what))
      .hints.emplace_back("`mlab build` makes robot programs out of configurations");
}

std::expected<std::optional<RevealedProgram>, std::string> load_revealed_program(
    const std::string& name, cell::Wall wall, const ProgramSources& sources) {
  robot_host::HostedProgram hosted;
  hosted.limits = limits_of(sources);
  hosted.is_for_one_robot = sources.in_own_processes;
  hosted.launch = launch_of_any(path_of(name, sources).string(), wall, hosted.limits);
  const auto revealed = robot_host::reveal(hosted.launch, hosted.limits);
  if (!revealed) return std::unexpected(revealed.error());
  if (!*revealed) return std::nullopt;
  const auto& [how, source] = **revealed;
  hosted.source = source;
  auto built = host_revealed(how, std::move(hosted));
  if (!built) return std::unexpected(built.error());
  return RevealedProgram{
      std::move(*built), robot_wire::decode(how.network()), {how.body().begin(), how.body().end()}, source};
}

std::optional<RobotProgram> load_native_program(RobotProgram robot, const text::Place& place,
                                                std::span<const Setting> settings, cell::Wall wall,
                                                const ProgramSources& sources,
                                                const std::vector<std::string>& known_keys,
                                                text::Diagnostics& sink) {
  const std::size_t errors_before = sink.error_count();
  auto native = std::make_shared<NativeProgram>();
  native->limits = limits_of(sources);
  native->is_for_one_robot = sources.in_own_processes;
  native->executable = path_of(robot.name, sources).string();
  native->launch = launch_of_any(native->executable, wall, native->limits);
  for (const Setting& setting : settings) native->settings.emplace_back(setting.key, setting.value);
  auto description = robot_host::describe(native->launch, native->settings, native->limits);
  if (!description) {
    refuse_executable(robot.name, place, description.error(), sink);
    return std::nullopt;
  }
  native->description = std::move(*description);
  say_results(*native, settings, robot.name, known_keys, sink);
  drop_unknown(*native);
  if (sink.error_count() > errors_before) return std::nullopt;
  robot.body.insert(native->description.body().begin(), native->description.body().end());
  robot.native = std::move(native);
  return robot;
}

}  // namespace mlab::robot
