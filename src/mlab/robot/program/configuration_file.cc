#include "mlab/robot/program/configuration_file.h"

#include <utility>

#include "mlab/lang/cdl/syntax/parser.h"
#include "mlab/library/library.h"
#include "mlab/robot/program/brought_code.h"

namespace mlab::robot {
namespace {

// `forager.cdl#Forager` as the file and the robot in it.
std::pair<std::string, std::string> split(std::string_view program) {
  const std::size_t hash = program.rfind('#');
  if (hash == std::string_view::npos) return {std::string(program), ""};
  return {std::string(program.substr(0, hash)), std::string(program.substr(hash + 1))};
}

cdl::Environment environment_of(const text::Files& files) {
  cdl::Environment out = library_environment();
  out.files = &files;
  return out;
}

std::optional<ConfiguredRobot> built(cdl::Configuration configuration, const cdl::Robot& robot,
                                     const flow::Library& library, text::Diagnostics& sink,
                                     cdl::EarlierFindings& said) {
  ConfiguredRobot out;
  const std::size_t errors_before = sink.error_count();
  out.robot = robot.name.text;
  out.lowered = cdl::lower(configuration, robot, library, sink, said);
  if (sink.error_count() > errors_before) return std::nullopt;
  out.built.program = cdl::build(out.lowered, library, sink, said);
  if (!out.built.program) return std::nullopt;
  out.configuration = std::move(configuration);
  return out;
}

}  // namespace

const cdl::Environment& library_environment() {
  // What is wrong in it is our own mistake; the library's tests read it with their own eyes.
  static const cdl::Environment kEnvironment = [] {
    cdl::Environment environment;
    text::Diagnostics sink;
    for (const library::ConfigurationText& one : library::configuration_texts()) {
      const auto source = std::make_shared<const text::Source>(std::string(one.file), std::string(one.text));
      environment.built_in.push_back(std::make_shared<const cdl::Tree>(cdl::parse(source, sink)));
    }
    return environment;
  }();
  return kEnvironment;
}

const cdl::Configuration& library_configuration() {
  static const cdl::Configuration kConfiguration = [] {
    text::Diagnostics sink;
    return cdl::configuration_of(std::make_shared<const cdl::Tree>(), library_environment(), sink);
  }();
  return kConfiguration;
}

bool names_configuration(std::string_view program) {
  return split(program).first.ends_with(".cdl");
}

SocietyReader society_reader(ProgramSources sources) {
  using Members = std::vector<std::pair<std::string, int>>;
  return [sources = std::move(sources)](const std::string& program, const text::Place& place,
                                        text::Diagnostics& sink) -> std::optional<Members> {
    const auto [path, wanted] = split(program);
    if (wanted.empty() || !names_configuration(program)) return std::nullopt;
    const std::size_t errors_before = sink.error_count();
    const text::SourcePtr source = read_program(path, place, sources, sink);
    if (!source) return std::nullopt;
    const text::Files files = files_of(sources);
    const cdl::Configuration configuration = cdl::load(source, environment_of(files), sink);
    if (sink.error_count() > errors_before) return std::nullopt;
    const cdl::Society* society = cdl::society_meant(configuration, wanted, place, sink);
    if (society == nullptr) return std::nullopt;
    const auto members = cdl::members_of(configuration, *society);
    if (!members) {
      sink.error(
          "too-many-robots", place,
          fmt::format("the society `{}` has more than {} robots, or more than {} societies in each other",
                      text::shown(wanted), cdl::kMostRobotsOfASociety, cdl::kMaxSocietyDepth));
      return std::nullopt;
    }
    Members out;
    for (const auto& [robot, count] : *members) out.emplace_back(path + "#" + robot->name.text, count);
    return out;
  };
}

std::optional<ConfiguredRobot> configure(const text::SourcePtr& source, std::string_view wanted,
                                         std::string_view type_name, const text::Place& place,
                                         const ProgramSources& sources, text::Diagnostics& sink) {
  const std::size_t errors_before = sink.error_count();
  const text::Files files = files_of(sources);
  cdl::Configuration configuration = cdl::load(source, environment_of(files), sink);
  if (sink.error_count() > errors_before) return std::nullopt;
  const cdl::Robot* robot = cdl::robot_meant(configuration, wanted, type_name, place, sink);
  if (robot == nullptr) return std::nullopt;
  auto library = describe_library(configuration.procedures);
  cdl::EarlierFindings said;
  cdl::check_declarations(configuration, library->library, sink, said);
  if (sink.error_count() > errors_before) return std::nullopt;
  auto out = built(std::move(configuration), *robot, library->library, sink, said);
  if (!out) return std::nullopt;
  if (sink.error_count() == errors_before)
    cdl::warn_of_declarations(out->configuration, library->library, sink);
  auto runnable = make_runnable(std::move(out->built.program), out->lowered.network,
                                out->configuration.procedures, std::move(library), place, sources, sink);
  if (!runnable) return std::nullopt;
  out->built = std::move(*runnable);
  return out;
}

std::optional<ConfiguredRobot> load_configuration(const std::string& name, std::string_view type_name,
                                                  const text::Place& place, const ProgramSources& sources,
                                                  text::Diagnostics& sink) {
  const auto [path, wanted] = split(name);
  const text::SourcePtr source = read_program(path, place, sources, sink);
  if (!source) return std::nullopt;
  return configure(source, wanted, type_name, place, sources, sink);
}

std::optional<ConfiguredRobot> library_robot(std::string_view name, const text::Place& place,
                                             const ProgramSources& sources, text::Diagnostics& sink) {
  const cdl::Configuration& configuration = library_configuration();
  const auto robot = configuration.robots.find(name);
  if (robot == configuration.robots.end()) return std::nullopt;
  cdl::EarlierFindings said;
  auto out = built(configuration, *robot->second, component_library(), sink, said);
  if (!out) return std::nullopt;
  auto runnable = make_runnable(std::move(out->built.program), out->lowered.network, {}, describe_library({}),
                                place, sources, sink);
  if (!runnable) return std::nullopt;
  out->built = std::move(*runnable);
  return out;
}

void check_configuration(const text::SourcePtr& source, const ProgramSources& sources,
                         text::Diagnostics& sink) {
  const std::size_t errors_before = sink.error_count();
  const text::Files files = files_of(sources);
  const cdl::Configuration configuration = cdl::load(source, environment_of(files), sink);
  if (sink.error_count() > errors_before) return;
  const auto checked = checked_library_with(configuration.procedures, sources, sink);
  cdl::check(configuration, checked->library, sink);
}

}  // namespace mlab::robot
