#include "mlab/robot/program/robot_program.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <span>
#include <string_view>
#include <system_error>
#include <utility>

#include <fmt/core.h>

#include "mlab/library/library.h"
#include "mlab/robot/program/configuration_file.h"
#include "mlab/robot/program/native_program.h"
#include "mlab/robot/program/network_file.h"
#include "mlab/text/shown.h"

namespace mlab::robot {
namespace {

std::string last_part(const std::string& program) {
  return std::filesystem::path(program).filename().string();
}

bool lies_in(const std::string& path, const std::string& folder) {
  namespace fs = std::filesystem;
  std::error_code failure;
  const fs::path real = fs::weakly_canonical(fs::absolute(path, failure), failure);
  if (failure) return false;
  const fs::path root = fs::weakly_canonical(fs::absolute(folder, failure), failure);
  if (failure) return false;
  return std::ranges::mismatch(root, real).in1 == root.end();
}

// Parameters that may be named in the mission: named by the network, not the constants inside of it.
std::vector<std::string> parameter_names(const flow::Program& program) {
  std::vector<std::string> out;
  for (const flow::Port& port : program.ports()) {
    if (port.role == flow::Port::Role::kParameter) out.push_back(port.path);
  }
  return out;
}

// Nobody knows what a mission's own behaviors do.
bool has_one_of(const flow::Network& network, std::span<const std::string_view> names) {
  return std::ranges::any_of(network.nodes, [&](const flow::Node& node) {
    if (node.kind != flow::Node::Kind::kBehavior) return false;
    const flow::Behavior* known = component_library().find(node.behavior).behavior;
    return known == nullptr || std::ranges::find(names, known->name) != names.end();
  });
}

// What a program may say to the executive and to the other robots of its unit.
RobotProgram::Tells tells_of(const flow::Network& network) {
  constexpr std::string_view kTellers[] = {"ReportStatus", "ReportFlags", "ReportDone", "ReportStep",
                                           "ReportArrival"};
  constexpr std::string_view kSharers[] = {"NextErrand", "TellOfErrand", "BidOnTask"};
  return {.reports = has_one_of(network, kTellers), .shares = has_one_of(network, kSharers)};
}

// What a mission says of the values of a program.
struct MissionValues {
  std::span<const Setting> settings;
  const Places* places = nullptr;
  const text::Place& type_place;  // of the program's name
};

// Places that nobody set.
void find_places(const MissionValues& told, RobotProgram& robot, text::Diagnostics& sink) {
  const auto& [settings, places, type_place] = told;
  if (places == nullptr) return;
  for (const PlaceParameter& parameter : robot.places) {
    const flow::Port* port = robot.program->find(parameter.path);
    if (port == nullptr || std::ranges::find(settings, parameter.path, &Setting::key) != settings.end())
      continue;
    if (const std::optional<geom::Point> point = places->find(parameter.name)) {
      robot.program->set(robot.initial.data(), *port, point_words(*point));
      continue;
    }
    const text::Place& at = parameter.place.source ? parameter.place : type_place;
    text::Diagnostic& d = sink.error(
        "unknown-place", at, fmt::format("the mission has no place `{}`", text::shown(parameter.name)));
    places->explain(parameter.name, d);
    if (parameter.place.source && type_place.source)
      d.notes.push_back({"the mission has robots of this program here", type_place});
  }
}

void set_parameters(std::span<const Setting> settings, const std::vector<std::string>& known_keys,
                    const Places* places, RobotProgram& robot, text::Diagnostics& sink) {
  for (const Setting& parameter : settings) {
    // What is the body's may be the program's as well.
    const bool is_known = std::find(known_keys.begin(), known_keys.end(), parameter.key) != known_keys.end();
    const flow::Port* port = robot.program->find(parameter.key);
    if (port == nullptr || port->role == flow::Port::Role::kOutput) {
      if (parameter.is_preset || is_known) continue;
      std::vector<std::string> names = parameter_names(*robot.program);
      names.insert(names.end(), known_keys.begin(), known_keys.end());
      text::Diagnostic& d =
          sink.warning("unknown-parameter", parameter.place,
                       fmt::format("program `{}` has no parameter `{}`", robot.name, parameter.key));
      const std::string nearest = text::nearest_name(parameter.key, names);
      if (!nearest.empty()) d.hints.push_back(fmt::format("did you mean `{}`?", nearest));
      continue;
    }
    const std::string value =
        places == nullptr ? parameter.value : in_coordinates(*port, parameter.value, *places);
    if (const auto problem = robot.program->set(robot.initial.data(), *port, value)) {
      text::Diagnostic& d = sink.error("bad-parameter", parameter.value_place, *problem);
      if (places != nullptr && port->type->kind == flow::TypeKind::kPoint)
        places->explain(parameter.value, d);
    }
  }
}

}  // namespace

std::vector<PlaceParameter> places_of(const flow::Network& network) {
  std::vector<PlaceParameter> out;
  for (const flow::Parameter& parameter : network.parameters) {
    if (!parameter.place_name.text.empty())
      out.push_back({parameter.name, parameter.place_name.text, parameter.place_name.place});
  }
  return out;
}

namespace {

void set_values(const MissionValues& told, const std::vector<std::string>& known_keys, RobotProgram& robot,
                text::Diagnostics& sink) {
  robot.initial = robot.program->make_frame();
  find_places(told, robot, sink);
  set_parameters(told.settings, known_keys, told.places, robot, sink);
}

}  // namespace

std::string point_words(geom::Point point) {
  return fmt::format("{{{}, {}}}", point.x, point.y);
}

std::string in_coordinates(const flow::Port& port, const std::string& value, const Places& places) {
  const bool is_exact = value.starts_with('{') || value.starts_with('[');
  if (port.type->kind != flow::TypeKind::kPoint || is_exact) return value;
  const std::optional<geom::Point> point = places.find(value);
  return point ? point_words(*point) : value;
}

std::optional<double> RobotProgram::number(std::string_view path) const {
  if (recorded) {
    const auto known = recorded->numbers.find(path);
    return known != recorded->numbers.end() ? std::optional(known->second) : std::nullopt;
  }
  if (native) {
    const wire::Port* port = native->find(path);
    return port != nullptr && port->value().has_number() ? std::optional(port->value().number())
                                                         : std::nullopt;
  }
  const flow::Port* port = program ? program->find(path) : nullptr;
  return port != nullptr ? flow::Program::number(initial.data(), *port) : std::nullopt;
}

const flow::Library& component_library() {
  static const flow::Library kLibrary = [] {
    flow::Library library;
    library.add(mlab_library_behaviors());
    return library;
  }();
  return kLibrary;
}

text::Files files_of(const ProgramSources& sources) {
  text::Files out = sources.files != nullptr ? *sources.files : text::files_on_disk();
  if (sources.project.empty()) return out;
  out.read = [read = out.read, project = sources.project](const std::string& path) {
    if (lies_in(path, project)) return read(path);
    text::Diagnostic refused;
    refused.kind = "outside-project";
    refused.message = fmt::format("`{}` lies outside of the project folder `{}`", text::shown(path), project);
    refused.hints = {"--project names a folder that holds both"};
    return text::Result<text::SourcePtr>(std::unexpected(refused));
  };
  return out;
}

text::SourcePtr read_program(const std::string& path, const text::Place& place, const ProgramSources& sources,
                             text::Diagnostics& sink) {
  const text::Files files = files_of(sources);
  // An absolute path stays as it is.
  auto source = files.read((std::filesystem::path(sources.folder) / path).string());
  if (source) return *source;
  text::Diagnostic problem = source.error();
  problem.place = place;
  sink.report(std::move(problem));
  return nullptr;
}

namespace {

// What was built for another robot of the type.
void take_built(const RobotProgram& built, RobotProgram& robot) {
  robot.program = built.program;
  robot.hosted = built.hosted;
  robot.is_described_only = built.is_described_only;
  robot.body = built.body;
  robot.is_own = built.is_own;
  robot.tells = built.tells;
  robot.places = built.places;
  robot.origin = built.origin;
  robot.executable = built.executable;
}

// An executable outside of the project is started for nobody.
bool refuse_outside(const std::string& name, const text::Place& place, const ProgramSources& sources,
                    text::Diagnostics& sink) {
  if (sources.project.empty() ||
      lies_in((std::filesystem::path(sources.folder) / name).string(), sources.project))
    return false;
  sink.error("outside-project", place,
             fmt::format("`{}` lies outside of the project folder `{}`", text::shown(name), sources.project));
  return true;
}

// Reads as the sources say, and notes what was read.
class NotedSources {
 public:
  explicit NotedSources(const ProgramSources& sources)
      : sources_(sources), files_(files_of(sources)), origin_(std::make_shared<ProgramOrigin>()) {
    origin_->folder = sources.folder;
    files_.read = [read = files_.read, origin = origin_](const std::string& path) {
      auto out = read(path);
      if (out) origin->texts.push_back(*out);
      return out;
    };
    sources_.files = &files_;
    sources_.project.clear();  // is looked after by `files_`
  }
  const ProgramSources& sources() const { return sources_; }
  std::shared_ptr<const ProgramOrigin> origin() const { return origin_; }

 private:
  ProgramSources sources_;
  text::Files files_;
  std::shared_ptr<ProgramOrigin> origin_;
};

void warn_of_parked(std::string_view code, const text::Place& place, std::string message, std::string hint,
                    text::Diagnostics& sink) {
  text::Diagnostic& d = sink.warning(std::string(code), place, std::move(message));
  d.label = "robots of this type stand parked";
  d.hints.push_back(std::move(hint));
}

void warn_of_unknown(std::string_view name, const text::Place& place, text::Diagnostics& sink) {
  warn_of_parked("unknown-program", place,
                 fmt::format("nothing here answers to the robot program `{}`", name),
                 "`robot` is the standard robot; a network or a configuration is named by its file: "
                 "`mine.cnl`, `mine.cdl`",
                 sink);
}

void take_revealed(RevealedProgram revealed, RobotProgram& robot) {
  robot.tells = tells_of(revealed.network);
  robot.places = places_of(revealed.network);
  robot.program = std::move(revealed.built.program);
  robot.hosted = std::move(revealed.built.hosted);
  robot.body = std::move(revealed.body);
  robot.executable = {last_part(robot.name), revealed.source};
}

// What it answered is known, and no more.
RobotProgram as_recorded(RobotProgram robot) {
  robot.is_own = true;
  robot.body = robot.recorded->body;
  robot.tells.reports = robot.recorded->reports;
  return robot;
}

}  // namespace

std::optional<RobotProgram> load_program(const std::string& name, const text::Place& place,
                                         std::span<const Setting> settings, const ProgramSources& sources,
                                         const std::vector<std::string>& known_keys, text::Diagnostics& sink,
                                         const RobotProgram* built, std::string_view type) {
  const std::size_t errors_before = sink.error_count();
  RobotProgram robot;
  robot.name = name;
  robot.type = type;
  if (sources.recorded) robot.recorded = sources.recorded(name, type);
  if (robot.recorded) return as_recorded(std::move(robot));
  const auto take = [&robot](BuiltProgram program) {
    robot.program = std::move(program.program);
    robot.hosted = std::move(program.hosted);
    robot.is_described_only = program.is_described_only;
  };
  const NotedSources noted(sources);
  robot.origin = noted.origin();
  if (built != nullptr) {
    take_built(*built, robot);
  } else if (const std::string_view known = library::find_robot(last_part(name)); !known.empty()) {
    if (auto configured = library_robot(known, place, sources, sink)) {
      robot.tells = tells_of(configured->lowered.network);
      take(std::move(configured->built));
      robot.body = std::move(configured->lowered.body);
    }
  } else if (last_part(name).ends_with(".cnl")) {
    robot.is_own = true;
    if (auto network = read_network(name, place, noted.sources(), sink)) {
      robot.tells = tells_of(network->network);
      take(std::move(network->built));
    }
  } else if (names_configuration(last_part(name))) {
    robot.is_own = true;
    if (auto configured = load_configuration(name, type, place, noted.sources(), sink)) {
      robot.tells = tells_of(configured->lowered.network);
      robot.places = places_of(configured->lowered.network);
      take(std::move(configured->built));
      robot.body = std::move(configured->lowered.body);
    }
  } else if (is_executable(name, sources)) {
    robot.origin = nullptr;
    if (refuse_outside(name, place, sources, sink)) return std::nullopt;
    const auto wall = sources.permission.to_start(name);
    if (!wall) {
      warn_of_parked("native-program", place, wall.error(), "where you trust it, say `--allow-native`", sink);
      return robot;
    }
    auto revealed = load_revealed_program(name, *wall, sources);
    if (!revealed) {
      refuse_executable(name, place, revealed.error(), sink);
      return std::nullopt;
    }
    if (!*revealed)
      return load_native_program(std::move(robot), place, settings, *wall, sources, known_keys, sink);
    take_revealed(std::move(**revealed), robot);
  } else {
    warn_of_unknown(name, place, sink);
    return robot;
  }
  if (!robot.program) return std::nullopt;
  set_values({settings, sources.places, place}, known_keys, robot, sink);
  if (sink.error_count() > errors_before) return std::nullopt;
  return robot;
}

std::expected<RobotProgram, std::string> load_offered(const std::string& path,
                                                      const ProgramSources& sources) {
  RobotProgram out;
  out.name = path;
  if (!is_executable(path, sources)) return std::unexpected("is no executable file");
  const auto wall = sources.permission.to_start(path);
  if (!wall) return std::unexpected(wall.error());
  auto revealed = load_revealed_program(path, *wall, sources);
  if (!revealed) return std::unexpected("is no robot program: it " + revealed.error());
  if (!*revealed)
    return std::unexpected(fmt::format(
        "was not made by mlab build of missionlab {}, or is closed: only what shows how it is made can take "
        "part",
        sources.version));
  take_revealed(std::move(**revealed), out);
  out.initial = out.program->make_frame();
  return out;
}

}  // namespace mlab::robot
