#include "mlab/run/crew.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "mlab/mission/maneuver.h"
#include "mlab/run/order_check.h"
#include "mlab/run/places.h"
#include "mlab/run/vehicle.h"
#include "mlab/text/shown.h"

namespace mlab::run {
namespace {

const robot::RobotProgram* known_program(const mission::RobotType& type, const Crew* before) {
  if (before == nullptr) return nullptr;
  for (const robot::RobotProgram& program : before->programs) {
    if (program.name == type.program && program.type == type.name && program.program) return &program;
  }
  return nullptr;
}

// What is said of types that have something in common: those of a society come from one statement and one
// file, and what was set from outside was set for all of them. What is said of several is said once, and a
// parameter is unknown where none of them knows it.
class SaidOfMany {
 public:
  /// @param has_program  something answers to its name
  void add(const mission::RobotType& type, bool has_program, const text::Diagnostics& said) {
    for (const mission::RobotParameter& parameter : type.parameters) {
      const Key key = key_of(parameter.place);
      if (parameter.is_from_outside) outside_.emplace(key, parameter);
      if (has_program || !parameter.is_from_outside) ++takers_[key];
    }
    all_.insert(all_.end(), said.items().begin(), said.items().end());
  }

  void report(text::Diagnostics& sink) const {
    std::map<Key, int> refused;
    std::set<std::tuple<std::string, Key, std::string>> told;
    for (const text::Diagnostic& one : all_) {
      const Key key = key_of(one.place);
      if (one.kind == "unknown-parameter") {
        if (++refused[key] != takers_.at(key)) continue;
        text::Diagnostic last = one;
        if (outside_.contains(key)) last.severity = text::Severity::kError;
        sink.report(std::move(last));
      } else if (told.emplace(one.kind, key, one.message).second) {
        sink.report(one);
      }
    }
    const auto is_told = [&](const Key& key) {
      return std::ranges::any_of(told, [&](const auto& one) { return std::get<1>(one) == key; });
    };
    for (const auto& [key, parameter] : outside_) {
      if (!takers_.contains(key) && !is_told(key) && !is_told(key_of(parameter.value_place)))
        sink.error("unknown-parameter", parameter.place,
                   fmt::format("no robot of the mission has a parameter `{}`", text::shown(parameter.key)));
    }
  }

 private:
  using Key = std::tuple<std::string, std::uint32_t, std::uint32_t>;  // each type reads the file by itself
  static Key key_of(const text::Place& place) {
    return {place.source ? place.source->name() : "", place.span.begin, place.span.end};
  }

  std::vector<text::Diagnostic> all_;
  std::map<Key, int> takers_;  // types that are given the parameter that stands there
  std::map<Key, mission::RobotParameter> outside_;
};

std::optional<robot::RobotProgram> load_program_of(const mission::RobotType& type,
                                                   std::span<const mission::Preset> presets,
                                                   const robot::ProgramSources& sources, const Crew* before,
                                                   text::Diagnostics& sink) {
  std::vector<robot::Setting> settings;
  for (const mission::Preset& preset : presets)
    settings.push_back({std::string(preset.parameter), preset.value, type.place, type.place, true});
  for (const mission::RobotParameter& parameter : type.parameters)
    settings.push_back({parameter.key, parameter.value, parameter.place, parameter.value_place, false});
  const robot::RobotProgram* known = known_program(type, before);
  auto out = robot::load_program(type.program, type.place, settings, sources, vehicle_keys(), sink, known,
                                 type.name);
  if (!out) return out;
  out->host = type.host;
  out->is_of_vehicle = sources.is_vehicle && !type.host.empty() && sources.is_vehicle(type.host);
  if (out->native && !type.host.empty())
    sink.warning(
        "stays-with-run", type.place,
        fmt::format("`{}` is closed, or was not made by `mlab build` of this version: it is computed "
                    "where the run is, and not on `{}`",
                    text::shown(type.program), text::shown(type.host)));
  return out;
}

}  // namespace

std::vector<text::SourcePtr> texts_of(const Crew& crew) {
  std::vector<text::SourcePtr> out;
  const auto add = [&](const text::SourcePtr& source) {
    if (source && std::ranges::find(out, source) == out.end()) out.push_back(source);
  };
  add(crew.mission->source);
  std::ranges::for_each(crew.mission->texts, add);
  for (const robot::RobotProgram& program : crew.programs) {
    if (program.origin) std::ranges::for_each(program.origin->texts, add);
  }
  return out;
}

std::shared_ptr<const Crew> make_crew(std::shared_ptr<const mission::Mission> mission,
                                      const robot::ProgramSources& sources, text::Diagnostics& sink,
                                      const Crew* before) {
  auto crew = std::make_shared<Crew>();
  crew->mission = std::move(mission);
  const mission::Mission& plan = *crew->mission;
  std::vector<bool> is_used(plan.types.size(), false);
  for (const mission::Robot& robot : plan.robots) is_used[robot.type] = true;
  std::vector<bool> is_of_society(plan.types.size(), false);
  for (const mission::Society& society : plan.societies) {
    for (const mission::Society::Part& part : society.parts) is_of_society[part.type] = true;
  }
  const auto is_set_from_outside = [](const mission::RobotType& type) {
    return std::ranges::any_of(type.parameters, &mission::RobotParameter::is_from_outside);
  };
  SaidOfMany of_many;
  const std::vector<mission::Preset> presets = mission::presets(plan.options);
  const MissionPlaces places(plan);
  robot::ProgramSources with_places = sources;
  with_places.places = &places;
  const std::size_t errors_before = sink.error_count();
  for (std::size_t i = 0; i < plan.types.size(); ++i) {
    // A type that nobody uses costs nothing, but what is wrong in it is said all the same; ROBOT alone has no
    // author.
    text::Diagnostics own;
    const bool is_one_of_many = is_of_society[i] || is_set_from_outside(plan.types[i]);
    text::Diagnostics& said = is_one_of_many ? own : sink;
    std::optional<robot::RobotProgram> program;
    if (is_used[i] || plan.types[i].place.source)
      program = load_program_of(plan.types[i], presets, with_places, before, said);
    crew->bodies.push_back(
        body_of(plan.types[i], program ? program->body : std::map<std::string, double>{}, said));
    crew->programs.push_back(
        program ? std::move(*program)
                : robot::RobotProgram{.name = plan.types[i].program, .type = plan.types[i].name});
    if (is_one_of_many) of_many.add(plan.types[i], crew->programs.back().can_run(), own);
  }
  of_many.report(sink);
  if (sink.error_count() > errors_before) return nullptr;
  return crew;
}

std::shared_ptr<const Crew> check_crew(std::shared_ptr<const mission::Mission> mission,
                                       const robot::ProgramSources& sources, text::Diagnostics& sink) {
  auto crew = make_crew(std::move(mission), sources, sink);
  if (crew) check_orders(*crew, sink);
  return crew;
}

}  // namespace mlab::run
