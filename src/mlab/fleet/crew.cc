#include "mlab/fleet/crew.h"

#include <optional>
#include <utility>

#include "mlab/fleet/vehicle.h"

namespace mlab::fleet {
namespace {

const robot::RobotProgram* known_program(const mission::RobotType& type, const Crew* before) {
  if (before == nullptr) return nullptr;
  for (const robot::RobotProgram& program : before->programs) {
    if (program.name == type.program && program.type == type.name && program.program) return &program;
  }
  return nullptr;
}

std::optional<robot::RobotProgram> load_program_of(const mission::RobotType& type,
                                                   const robot::ProgramSources& sources, const Crew* before,
                                                   text::Diagnostics& sink) {
  std::vector<robot::Setting> settings;
  for (const mission::RobotParameter& parameter : type.parameters)
    settings.push_back({parameter.key, parameter.value, parameter.place});
  const robot::RobotProgram* known = known_program(type, before);
  auto out = robot::load_program(type.program, type.place, settings, sources, vehicle_keys(), sink, known,
                                 type.name);
  return out;
}

}  // namespace

std::shared_ptr<const Crew> make_crew(std::shared_ptr<const mission::Mission> mission,
                                      const robot::ProgramSources& sources, text::Diagnostics& sink,
                                      const Crew* before) {
  auto crew = std::make_shared<Crew>();
  crew->mission = std::move(mission);
  const mission::Mission& plan = *crew->mission;
  std::vector<bool> is_used(plan.types.size(), false);
  for (const mission::Robot& robot : plan.robots) is_used[robot.type] = true;
  const std::size_t errors_before = sink.error_count();
  for (std::size_t i = 0; i < plan.types.size(); ++i) {
    // A type that nobody uses costs nothing, but what is wrong in it is said all the same; ROBOT alone has no
    // author.
    std::optional<robot::RobotProgram> program;
    if (is_used[i] || plan.types[i].place.source)
      program = load_program_of(plan.types[i], sources, before, sink);
    crew->bodies.push_back(
        body_of(plan.types[i], program ? program->body : std::map<std::string, double>{}, sink));
    crew->programs.push_back(
        program ? std::move(*program)
                : robot::RobotProgram{.name = plan.types[i].program, .type = plan.types[i].name});
  }
  if (sink.error_count() > errors_before) return nullptr;
  return crew;
}

}  // namespace mlab::fleet
