#include "mlab/lang/mdl/names.h"

#include <algorithm>
#include <charconv>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "mlab/lang/mdl/quoted.h"
#include "mlab/lang/mdl/token.h"
#include "mlab/percept/object_colors.h"
#include "mlab/text/member_name.h"

namespace mlab::mdl {
namespace {

constexpr std::uint32_t kMaxWishedId = 65535;
constexpr double kMaxRobotId = 4e9;  // what an id can hold
constexpr int kMostRobotsOfSocieties = 10'000;

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

void tell_of_host(text::Diagnostics& diagnostics, const std::string& host, text::Place place) {
  if (text::is_member_name(host))
    diagnostics.note(
        "host-needs-fleet", std::move(place),
        "with `--robots fleet` robots of this type have the vehicle of this name as body, or are "
        "carried by the agent of this name; else they are computed here");
  else
    diagnostics.warning("unknowable-host", std::move(place),
                        fmt::format("no agent and no vehicle can have the name {}, so with `--robots fleet` "
                                    "robots of this type stand; a name has {}",
                                    in_backticks(host), text::kMemberNameRule));
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
               text::Diagnostics& diagnostics, SocietyReader societies)
    : mission_(mission),
      source_(std::move(source)),
      damage_(damage),
      diagnostics_(diagnostics),
      read_society_(std::move(societies)) {
  for (std::uint32_t i = 0; i < mission.types.size(); ++i) {
    types_[lower_case(mission.types[i].name)] = i;
    wished_ids_.push_back(wished_id(mission.types[i]));
  }
  for (std::uint32_t i = 0; i < mission.societies.size(); ++i)
    societies_[lower_case(mission.societies[i].name)] = i;
  is_in_unit_.resize(mission.societies.size(), true);
  for (std::uint32_t i = 0; i < mission.units.size(); ++i) {
    if (!mission.units[i].name.empty()) units_[mission.units[i].name] = i;
  }
  for (std::uint32_t i = 0; i < mission.robots.size(); ++i) {
    taken_ids_[mission.robots[i].id.value] = i;
    last_id_ = std::max(last_id_, mission.robots[i].id.value);
  }
}

bool Roster::define_type(const statement::NewRobot& statement) {
  if (refuse_second_type(statement.name)) return true;
  mission::RobotType type;
  type.name = statement.name.text;
  type.program = statement.program.text;
  if (statement.color && !statement.color->text.empty()) {
    type.color = statement.color->text;
    check_color(*statement.color);
  }
  if (statement.host && !statement.host->text.empty()) {
    type.host = statement.host->text;
    tell_of_host(diagnostics_, type.host, place(statement.host->span));
  }
  type.place = place(statement.program.span);
  for (const Parameter& p : statement.parameters) {
    type.parameters.push_back({p.key.text, p.value, place(p.key.span), place(p.value_span)});
  }
  if (read_society_) {
    const std::size_t errors = diagnostics_.error_count();
    const auto members = read_society_(type.program, type.place, diagnostics_);
    if (members) return define_society(statement.name, type, *members);
    if (diagnostics_.error_count() > errors) {
      add_type(std::move(type));
      return false;
    }
  }
  add_type(std::move(type));
  return true;
}

bool Roster::refuse_second_type(const Name& name) {
  const std::string key = lower_case(name.text);
  const auto type = types_.find(key);
  const auto society = societies_.find(key);
  if (type == types_.end() && society == societies_.end()) return false;
  auto& error = diagnostics_.error("duplicate-robot-type", place(name.span),
                                   fmt::format("robot type {} is defined already", in_backticks(name.text)));
  const text::Place& first = society != societies_.end() ? mission_.societies[society->second].place
                                                         : mission_.types[type->second].place;
  if (first.source) error.notes.push_back({"it is defined here", first});
  if (!first.source) error.hints.emplace_back("`ROBOT` is the predefined type");
  return true;
}

void Roster::add_type(mission::RobotType type) {
  types_.try_emplace(lower_case(type.name), static_cast<std::uint32_t>(mission_.types.size()));
  wished_ids_.push_back(wished_id(type));
  mission_.types.push_back(std::move(type));
}

// Its robots get types of their own: that of the robot `Scout` is `f#Scout`.
bool Roster::define_society(const Name& name, const mission::RobotType& type,
                            const std::vector<std::pair<std::string, int>>& members) {
  if (members.empty()) {
    diagnostics_.error("empty-society", type.place,
                       fmt::format("the society {} has no robots", in_backticks(type.program)));
    return false;
  }
  mission::Society society{name.text, {}, place(name.span)};
  const std::optional<std::uint32_t> wish = wished_id(type);
  std::unordered_map<std::string_view, std::uint32_t> known;
  for (const auto& [program, count] : members) {
    const auto [entry, is_new] =
        known.try_emplace(program, static_cast<std::uint32_t>(mission_.types.size()));
    society.parts.push_back({entry->second, count});
    if (!is_new) continue;
    mission::RobotType member = type;
    member.name += program.substr(std::min(program.rfind('#'), program.size()));
    member.program = program;
    types_.try_emplace(lower_case(member.name), entry->second);
    wished_ids_.push_back(wish);
    mission_.types.push_back(std::move(member));
  }
  societies_.emplace(lower_case(society.name), static_cast<std::uint32_t>(mission_.societies.size()));
  is_in_unit_.push_back(false);
  mission_.societies.push_back(std::move(society));
  return true;
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
  if (!damage_.types) report_unknown_type(name);
  return std::nullopt;
}

std::optional<std::vector<std::string>> Roster::types_named(const Name& name) {
  std::vector<std::string> out;
  if (const auto society = societies_.find(lower_case(name.text)); society != societies_.end()) {
    for (const mission::Society::Part& part : mission_.societies[society->second].parts)
      out.push_back(mission_.types[part.type].name);
    return out;
  }
  const std::optional<std::uint32_t> type = find_type(name);
  if (!type) return std::nullopt;
  out.push_back(mission_.types[*type].name);
  return out;
}

void Roster::report_unknown_type(const Name& name) {
  auto& error = diagnostics_.error("unknown-robot-type", place(name.span),
                                   fmt::format("unknown robot type {}", in_backticks(name.text)));
  if (diagnostics_.error_count() > text::Diagnostics::kMaxErrors) return;
  if (const auto later = announced_.find(lower_case(name.text)); later != announced_.end()) {
    error.notes.push_back({fmt::format("{} is defined only here, below its use", in_backticks(name.text)),
                           place(later->second)});
    return;
  }
  struct KnownName {
    std::string name;
    text::Place place;
  };
  std::vector<KnownName> known;
  const auto know = [&known](const auto& things) {
    for (const auto& thing : things) {
      if (known.size() < kNamesForHints) known.push_back({thing.name, thing.place});
    }
  };
  know(mission_.societies);
  know(mission_.types);
  const std::string near = nearest(name.text, known, [](const KnownName& one) { return one.name; });
  if (near.empty()) {
    error.hints.emplace_back("`ROBOT` is predefined, others are defined with NEW-ROBOT");
    return;
  }
  error.hints.push_back(fmt::format("did you mean {}?", in_backticks(near)));
  const auto meant = std::ranges::find(known, near, &KnownName::name);
  if (meant->place.source)
    error.notes.push_back({fmt::format("{} is defined here", in_backticks(near)), meant->place});
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
      diagnostics_.error("number-out-of-range", p.value_place,
                         fmt::format("desired_robot_id takes a whole number from 0 to {}, found {}",
                                     kMaxWishedId, in_backticks(p.value)));
      continue;
    }
    out = static_cast<std::uint32_t>(value);
  }
  return out.value_or(0) > 0 ? out : std::nullopt;
}

std::vector<base::RobotId> Roster::create_robots(const Name& name) {
  if (const auto society = societies_.find(lower_case(name.text)); society != societies_.end())
    return create_society(society->second, place(name.span));
  return {create_robot(find_type(name).value_or(0), place(name.span))};
}

std::vector<base::RobotId> Roster::create_society(std::uint32_t society, const text::Place& where) {
  is_in_unit_[society] = true;
  std::vector<base::RobotId> out;
  for (const mission::Society::Part& part : mission_.societies[society].parts) {
    if (part.count > kMostRobotsOfSocieties - robots_of_societies_) {
      diagnostics_.error("too-many-robots", where,
                         fmt::format("the societies of a mission have {} robots at most, all together",
                                     kMostRobotsOfSocieties));
      break;
    }
    robots_of_societies_ += part.count;
    for (int i = 0; i < part.count; ++i) out.push_back(create_robot(part.type, where, out.empty()));
  }
  return out;
}

base::RobotId Roster::create_robot(std::uint32_t type, text::Place where, bool has_wish) {
  const std::optional<std::uint32_t> wish = has_wish ? wished_ids_[type] : std::nullopt;
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
    for (const Name& name : statement.groups[g].robots) {
      const std::vector<base::RobotId> robots = create_robots(name);
      for (std::uint32_t up = g;; up = parent[up]) {
        std::vector<base::RobotId>& members = mission_.units[first + up].members;
        members.insert(members.end(), robots.begin(), robots.end());
        if (up == 0) break;
      }
    }
  }
}

void Roster::define_units_of_societies() {
  for (std::uint32_t i = 0; i < mission_.societies.size(); ++i) {
    const mission::Society& society = mission_.societies[i];
    if (is_in_unit_[i]) continue;
    if (const auto other = units_.find(society.name); other != units_.end()) {
      diagnostics_
          .warning("unused-society", society.place,
                   fmt::format("the robots of the society {} are in no unit: they take no part",
                               in_backticks(society.name)))
          .notes.push_back({"a unit of this name has others", mission_.units[other->second].place});
      continue;
    }
    units_[society.name] = static_cast<std::uint32_t>(mission_.units.size());
    mission_.units.push_back({society.name, create_society(i, society.place), {}, society.place});
  }
}

std::optional<std::uint32_t> Roster::find_unit(const Name& name) {
  if (const auto found = units_.find(name.text); found != units_.end()) return found->second;
  if (damage_.units) return std::nullopt;
  auto& error = diagnostics_.error("unknown-unit", place(name.span),
                                   fmt::format("unknown unit {}", in_backticks(name.text)));
  if (diagnostics_.error_count() > text::Diagnostics::kMaxErrors) return std::nullopt;
  const std::string near = nearest(name.text, mission_.units, [](const mission::Unit& u) { return u.name; });
  if (societies_.contains(lower_case(name.text))) {
    error.hints.push_back(fmt::format("{} is a society, whose robots stand in the units that name it",
                                      in_backticks(name.text)));
    return std::nullopt;
  }
  if (const auto type = types_.find(lower_case(name.text)); type != types_.end()) {
    error.hints.push_back(fmt::format("`{0}` is a type of one robot; `UNIT <{0}> {0}` makes a unit of it",
                                      text::shown(name.text)));
    const text::Place& defined = mission_.types[type->second].place;
    if (defined.source) error.notes.push_back({"the type is defined here", defined});
    return std::nullopt;
  }
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
