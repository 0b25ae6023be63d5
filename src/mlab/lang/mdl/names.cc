#include "mlab/lang/mdl/names.h"

#include <algorithm>
#include <charconv>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "mlab/lang/mdl/quoted.h"
#include "mlab/lang/mdl/token.h"
#include "mlab/percept/object_colors.h"

namespace mlab::mdl {
namespace {

constexpr std::uint32_t kMaxWishedId = 65535;
constexpr double kMaxRobotId = 4e9;  // what an id can hold

template <class Range, class Projection>
std::string nearest(std::string_view name, const Range& things, Projection name_of) {
  if (name.size() > kLongestNameForHints) return {};
  std::vector<std::string> names;
  for (const auto& thing : things) {
    if (names.size() == kNamesForHints) break;
    names.push_back(name_of(thing));
  }
  return text::nearest_name(name, names);
}

}  // namespace

PlaceIndex::PlaceIndex(const overlay::Overlay& overlay) : overlay_(overlay) {
  // The last of equal names wins.
  for (std::uint32_t i = 0; i < overlay.measures.size(); ++i) by_name_[overlay.measures[i].name] = i;
}

const overlay::ControlMeasure* PlaceIndex::find(std::string_view reference) const {
  for (const std::string& spelling : overlay::spellings(reference)) {
    if (const auto found = by_name_.find(spelling); found != by_name_.end())
      return &overlay_.measures[found->second];
  }
  return nullptr;
}

Roster::Roster(mission::Mission& mission, text::SourcePtr source, const Damage& damage,
               text::Diagnostics& diagnostics)
    : mission_(mission), source_(std::move(source)), damage_(damage), diagnostics_(diagnostics) {
  for (std::uint32_t i = 0; i < mission.types.size(); ++i) {
    types_[lower_case(mission.types[i].name)] = i;
    wished_ids_.push_back(wished_id(mission.types[i]));
  }
  for (std::uint32_t i = 0; i < mission.units.size(); ++i) {
    if (!mission.units[i].name.empty()) units_[mission.units[i].name] = i;
  }
  for (std::uint32_t i = 0; i < mission.robots.size(); ++i) {
    taken_ids_[mission.robots[i].id.value] = i;
    last_id_ = std::max(last_id_, mission.robots[i].id.value);
  }
}

void Roster::define_type(const statement::NewRobot& statement) {
  const auto [entry, is_new] =
      types_.try_emplace(lower_case(statement.name.text), static_cast<std::uint32_t>(mission_.types.size()));
  if (!is_new) {
    auto& error = diagnostics_.error(
        "duplicate-robot-type", place(statement.name.span),
        fmt::format("robot type {} is defined already", in_backticks(statement.name.text)));
    const text::Place& first = mission_.types[entry->second].place;
    if (first.source) error.notes.push_back({"it is defined here", first});
    if (!first.source) error.hints.emplace_back("`ROBOT` is the predefined type");
    return;
  }
  mission::RobotType type;
  type.name = statement.name.text;
  type.program = statement.program.text;
  if (statement.color && !statement.color->text.empty()) {
    type.color = statement.color->text;
    check_color(*statement.color);
  }
  if (statement.host) type.host = statement.host->text;
  type.place = place(statement.program.span);
  for (const Parameter& p : statement.parameters) {
    type.parameters.push_back({p.key.text, p.value, place(p.key.span)});
  }
  wished_ids_.push_back(wished_id(type));
  mission_.types.push_back(std::move(type));
}

void Roster::check_color(const Name& color) {
  if (percept::object_class_of_color(color.text)) return;
  diagnostics_
      .warning("unknown-color", place(color.span),
               fmt::format("{} marks no class of objects: other robots see these as Unknown",
                           in_backticks(color.text)))
      .hints.push_back(fmt::format("the colours are {}", percept::colors_of_classes()));
}

void Roster::announce_type(const Name& name) {
  announced_.try_emplace(lower_case(name.text), name.span);
}

std::optional<std::uint32_t> Roster::find_type(const Name& name) {
  const std::string key = lower_case(name.text);
  if (const auto found = types_.find(key); found != types_.end()) return found->second;
  if (damage_.types) return std::nullopt;
  auto& error = diagnostics_.error("unknown-robot-type", place(name.span),
                                   fmt::format("unknown robot type {}", in_backticks(name.text)));
  if (diagnostics_.error_count() > text::Diagnostics::kMaxErrors) return std::nullopt;
  if (const auto later = announced_.find(key); later != announced_.end()) {
    error.notes.push_back({fmt::format("{} is defined only here, below its use", in_backticks(name.text)),
                           place(later->second)});
    return std::nullopt;
  }
  const std::string near =
      nearest(name.text, mission_.types, [](const mission::RobotType& t) { return t.name; });
  if (near.empty()) {
    error.hints.emplace_back("`ROBOT` is predefined, others are defined with NEW-ROBOT");
    return std::nullopt;
  }
  error.hints.push_back(fmt::format("did you mean {}?", in_backticks(near)));
  const mission::RobotType& meant = mission_.types[types_.at(lower_case(near))];
  if (meant.place.source)
    error.notes.push_back({fmt::format("{} is defined here", in_backticks(near)), meant.place});
  return std::nullopt;
}

// The number that a type wants for its robots; of several the last. 0 is the historic way to have no wish.
std::optional<std::uint32_t> Roster::wished_id(const mission::RobotType& type) {
  std::optional<std::uint32_t> out;
  for (const mission::RobotParameter& p : type.parameters) {
    if (p.key != "desired_robot_id") continue;
    double value = -1.0;
    std::from_chars(p.value.data(), p.value.data() + p.value.size(), value);
    const bool is_good = value >= 0.0 && value <= kMaxWishedId && value == static_cast<std::uint32_t>(value);
    if (!is_good) {
      diagnostics_.error("number-out-of-range", p.place,
                         fmt::format("desired_robot_id takes a whole number from 0 to {}, found {}",
                                     kMaxWishedId, in_backticks(p.value)));
      continue;
    }
    out = static_cast<std::uint32_t>(value);
  }
  return out.value_or(0) > 0 ? out : std::nullopt;
}

base::RobotId Roster::create_robot(std::uint32_t type, text::Place where) {
  const std::optional<std::uint32_t> wish = wished_ids_[type];
  base::RobotId id{last_id_ + 1};
  if (wish && !taken_ids_.contains(*wish)) {
    id.value = *wish;
  } else if (wish) {
    const mission::Robot& other = mission_.robots[taken_ids_.at(*wish)];
    diagnostics_
        .warning("duplicate-robot-id", where,
                 fmt::format("there is a robot {} already, this one becomes robot {}", *wish, id.value))
        .notes.push_back({fmt::format("robot {} is this one", *wish), other.place});
  }
  last_id_ = std::max(last_id_, id.value);
  taken_ids_[id.value] = static_cast<std::uint32_t>(mission_.robots.size());
  mission_.robots.push_back({id, type, std::move(where)});
  return id;
}

void Roster::define_unit(const statement::UnitDefinition& statement) {
  const auto first = static_cast<std::uint32_t>(mission_.units.size());
  std::vector<std::uint32_t> parent(statement.groups.size(), 0);
  for (std::uint32_t g = 0; g < statement.groups.size(); ++g) {
    const Group& group = statement.groups[g];
    mission::Unit& unit = mission_.units.emplace_back();
    unit.place = place(group.name ? group.name->span : group.span);
    for (const std::uint32_t part : group.parts) {
      unit.parts.push_back(first + part);
      parent[part] = g;
    }
    if (!group.name) continue;
    unit.name = group.name->text;
    const auto [entry, is_new] = units_.try_emplace(unit.name, first + g);
    if (is_new) continue;
    diagnostics_
        .warning(
            "duplicate-unit", unit.place,
            fmt::format("unit {} is defined a second time; commands mean this one", in_backticks(unit.name)))
        .notes.push_back({"the first one is here", mission_.units[entry->second].place});
    entry->second = first + g;
  }
  // Parents stand before their parts and only the innermost groups hold robots, so this goes depth first.
  for (std::uint32_t g = 0; g < statement.groups.size(); ++g) {
    for (const Name& robot : statement.groups[g].robots) {
      const base::RobotId id = create_robot(find_type(robot).value_or(0), place(robot.span));
      for (std::uint32_t up = g;; up = parent[up]) {
        mission_.units[first + up].members.push_back(id);
        if (up == 0) break;
      }
    }
  }
}

std::optional<std::uint32_t> Roster::find_unit(const Name& name) {
  if (const auto found = units_.find(name.text); found != units_.end()) return found->second;
  if (damage_.units) return std::nullopt;
  auto& error = diagnostics_.error("unknown-unit", place(name.span),
                                   fmt::format("unknown unit {}", in_backticks(name.text)));
  if (diagnostics_.error_count() > text::Diagnostics::kMaxErrors) return std::nullopt;
  const std::string near = nearest(name.text, mission_.units, [](const mission::Unit& u) { return u.name; });
  if (near.empty()) {
    error.hints.emplace_back("units are defined with `UNIT <name> ...` before `COMMAND LIST:`");
    return std::nullopt;
  }
  error.hints.push_back(fmt::format("did you mean {}?", in_backticks(near)));
  error.notes.push_back(
      {fmt::format("{} is defined here", in_backticks(near)), mission_.units[units_.at(near)].place});
  return std::nullopt;
}

std::optional<base::RobotId> Roster::find_robot(const Number& number) {
  const bool is_whole = number.value >= 1.0 && number.value <= kMaxRobotId &&
                        number.value == static_cast<double>(static_cast<std::uint32_t>(number.value));
  if (!is_whole) {
    diagnostics_.error(
        "bad-robot-number", place(number.span),
        fmt::format("a robot's number is a whole number from 1, found {}", in_backticks(number.text)));
    return std::nullopt;
  }
  const base::RobotId id{static_cast<std::uint32_t>(number.value)};
  if (taken_ids_.contains(id.value)) return id;
  if (damage_.units) return std::nullopt;
  auto& error =
      diagnostics_.error("unknown-robot", place(number.span), fmt::format("there is no robot {}", id.value));
  std::uint32_t least = last_id_;
  for (const mission::Robot& robot : mission_.robots) least = std::min(least, robot.id.value);
  error.hints.push_back(
      mission_.robots.empty() ? "robots come with units, which are defined before `COMMAND LIST:`"
      : mission_.robots.size() == last_id_ - least + 1
          ? fmt::format("the robots of this mission have the numbers {} to {}", least, last_id_)
          : fmt::format("the {} robots of this mission have numbers from {} to {}, not all of them",
                        mission_.robots.size(), least, last_id_));
  return std::nullopt;
}

}  // namespace mlab::mdl
