#include "mlab/console/published/overview.h"

#include <array>
#include <cmath>
#include <map>
#include <vector>

#include <fmt/core.h>

#include "mlab/base/angle.h"
#include "mlab/console/published/colors.h"
#include "mlab/flow/limit.h"
#include "mlab/flow/port_types.h"
#include "mlab/mission/command.h"
#include "mlab/mission/wording.h"
#include "mlab/text/shown.h"

namespace mlab::console {
namespace {

constexpr std::uint32_t kNoProgram = 0xffffffffU;

std::string clauses_of(const mission::UnitCommand& c) {
  std::string text;
  if (c.task == mission::Task::kStart && c.start_step != geom::Offset{})
    text += fmt::format(" {} {}", c.start_step.x, c.start_step.y);
  if (c.has_formation && c.formation != percept::Formation::kNone)
    text += fmt::format(" FORMATION {}", percept::name(c.formation));
  if (c.technique == mission::Technique::kTravelingOverwatch) text += " TECHNIQUE Traveling-Overwatch";
  if (c.technique == mission::Technique::kBoundingOverwatch) text += " TECHNIQUE Bounding-Overwatch";
  if (c.speed > 0.0) text += fmt::format(" SPEED {}", c.speed);
  if (c.heading) text += fmt::format(" HEADING {:.4g}", base::degrees(*c.heading));
  for (const mission::PhaseLine& line : c.phase_lines) text += " PHASE-LINE " + line.name;
  return text;
}

// The command in the words of the mission language.
std::string mdl_text(const mission::Mission& mission, const mission::Command& command) {
  const auto* c = std::get_if<mission::UnitCommand>(&command);
  if (c == nullptr) return clean(mission::command_text(mission, command));
  std::string text = "UNIT " + mission::addressee(mission, *c);
  if (c->unit == mission::kNoUnit) {
    text = c->robots.size() == 1 ? "ROBOT" : "ROBOTS";
    for (const base::RobotId id : c->robots) text += fmt::format(" {}", id.value);
  }
  text += fmt::format(" {}", mission::task_name(c->task));
  if (!c->place_name.empty()) text += " " + c->place_name;
  return clean(text + clauses_of(*c));
}

void encode_command(const mission::Mission& mission, const mission::Command& command, Plan::Command& out) {
  out.set_text(mdl_text(mission, command));
  const mission::CommandRecord record = mission::record_of(mission, command, 0.0);
  out.set_unit(clean(record.unit));
  out.set_task(record.task);
  out.set_place(clean(record.place));
  out.set_formation(record.formation);
  const auto* unit_command = std::get_if<mission::UnitCommand>(&command);
  if (unit_command == nullptr || unit_command->task == mission::Task::kStop) return;
  const geom::Point goal = mission::goal_of(*unit_command);
  out.mutable_goal()->set_x(goal.x);
  out.mutable_goal()->set_y(goal.y);
}

// By robot id, which named unit is the smallest one around it.
std::map<base::RobotId, std::size_t> smallest_units(const mission::Mission& mission) {
  std::map<base::RobotId, std::size_t> out;
  for (std::size_t i = 0; i < mission.units.size(); ++i) {
    if (mission.units[i].name.empty()) continue;
    for (const base::RobotId id : mission.units[i].members) {
      const auto [at, is_new] = out.try_emplace(id, i);
      if (!is_new && mission.units[i].members.size() < mission.units[at->second].members.size())
        at->second = i;
    }
  }
  return out;
}

// The words of a choice, in the order of their numbers.
std::vector<std::string> words_of(const flow::TypeInfo& type) {
  // Sets are typed, not chosen.
  if (type.kind == flow::TypeKind::kMask) return {};
  return {type.words.begin(), type.words.end()};
}

}  // namespace

std::string clean(std::string_view text) {
  return text::shown(text, 4000);
}

void encode_plan(const mission::Mission& mission, std::uint64_t revision, const PlaceOf& place_of,
                 Plan& out) {
  out.set_revision(revision);
  out.set_name(clean(mission.name));
  for (const mission::Step& step : mission.steps) {
    Plan::Step& told = *out.add_steps();
    told.set_label(clean(step.label));
    for (const mission::Command& command : step.commands)
      encode_command(mission, command, *told.add_commands());
    const DocumentPlace place = place_of(step.place);
    told.set_document(place.document);
    told.set_line(place.line);
  }
}

void encode_port(const flow::Program& program, const flow::Port& port, Port& out) {
  constexpr Port::Role kRoles[] = {Port::PARAMETER, Port::CONSTANT, Port::OUTPUT};
  out.set_path(clean(port.path));
  out.set_role(kRoles[static_cast<std::size_t>(port.role)]);
  out.set_type(std::string(port.type->name));
  out.set_unit(clean(port.edge_unit.empty() ? port.unit : port.edge_unit));
  out.set_help(clean(port.help));
  if (flow::is_limit(port.min)) out.set_min(port.min);
  if (flow::is_limit(port.max)) out.set_max(port.max);
  for (std::string& word : words_of(*port.type)) out.add_choices(std::move(word));
  const std::byte* const initial = program.initial_frame().data();
  out.set_is_number(flow::Program::number(initial, port).has_value());
  out.set_can_be_held(!flow::Interventions::why_never_held(program, port));
  if (port.role != flow::Port::Role::kOutput) out.set_initial(clean(flow::Program::print(initial, port)));
}

void encode_roster(const run::MissionRun& run, Roster& out) {
  const mission::Mission& mission = run.mission();
  const auto units = smallest_units(mission);
  std::map<std::string, const mission::RobotType*> types;
  for (const mission::RobotType& type : mission.types) types[type.name] = &type;
  std::map<const flow::Program*, std::uint32_t> programs;
  for (const fleet::FleetRobot& robot : run.fleet().robots()) {
    Roster::Robot& told = *out.add_robots();
    told.set_id(robot.id.value);
    told.set_type(clean(robot.type));
    const auto type = types.find(robot.type);
    told.set_color(rgb_of(type == types.end() ? "" : type->second->color));
    told.set_radius(robot.capabilities.radius);
    const double length = mission.options.robot_length;
    told.set_length(length > 0.0 ? length : 2.0 * robot.capabilities.radius);
    if (const auto unit = units.find(robot.id); unit != units.end())
      told.set_unit(clean(mission.units[unit->second].name));
    const flow::Program* const program = robot.workings().program;
    told.set_program(kNoProgram);
    if (program == nullptr) continue;
    const auto [at, is_new] = programs.try_emplace(program, static_cast<std::uint32_t>(programs.size()));
    told.set_program(at->second);
    if (!is_new) continue;
    Roster::Program& listed = *out.add_programs();
    listed.set_name(clean(robot.program->name));
    for (const flow::Port& port : program->ports()) encode_port(*program, port, *listed.add_ports());
  }
  encode_units(mission, out);
}

void encode_units(const mission::Mission& mission, Roster& out) {
  const std::size_t count = mission.units.size();
  std::vector<std::int32_t> named(count, -1);  // index among the named units
  std::int32_t names = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (!mission.units[i].name.empty()) named[i] = names++;
  }
  // The nearest named unit above each one.
  std::vector<std::int32_t> parents(count, -1);
  for (std::size_t i = 0; i < count; ++i) {
    for (const std::uint32_t part : mission.units[i].parts)
      parents[part] = named[i] >= 0 ? named[i] : parents[i];
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (named[i] < 0) continue;
    Roster::Unit& told = *out.add_units();
    told.set_name(clean(mission.units[i].name));
    for (const base::RobotId id : mission.units[i].members) told.add_members(id.value);
    told.set_parent(parents[i]);
  }
}

}  // namespace mlab::console
