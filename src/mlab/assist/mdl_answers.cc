// What is answered about missions.

#include <algorithm>
#include <map>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "mlab/assist/candidates.h"
#include "mlab/assist/component.h"
#include "mlab/assist/languages.h"
#include "mlab/assist/statement_candidates.h"
#include "mlab/assist/statement_names.h"
#include "mlab/assist/words.h"
#include "mlab/base/counted.h"
#include "mlab/lang/mdl/mdl.h"
#include "mlab/lang/mdl/names.h"
#include "mlab/lang/mdl/token.h"
#include "mlab/lang/mdl/tree.h"
#include "mlab/robot/program/configuration_file.h"
#include "mlab/run/vehicle.h"

namespace mlab::assist {
namespace {

mdl::LoadOptions options_of(const Surroundings& around) {
  return {1, around.overlay_folders, around.files};
}

/// A mission that may be half written: what it defines, and the map that it means.
class MdlWorld {
 public:
  MdlWorld(const Text& text, const Surroundings& around) : text_(text), around_(around) {
    text::Diagnostics unsaid;
    tree_ = mdl::parse(text.source, unsaid);
    map_ = mdl::check_map(text.source, folder_of(text), unsaid, options_of(around));
    // Of equal names in the overlays and in the mission, those of the mission come later and hold.
    for (const mdl::Statement& one : tree_.preamble) {
      if (const auto* type = std::get_if<mdl::statement::NewRobot>(&one.what))
        types_.try_emplace(mdl::lower_case(type->name.text), type);
    }
    draw_sketch();
    for (const mission::Unit& unit : sketch_.units) {
      if (!unit.name.empty())
        teams_.try_emplace(unit.name, Team{bare_name(text.source, unit.place.span), unit.members.size()});
    }
  }

  const mdl::Tree& tree() const { return tree_; }
  const overlay::Overlay& map() const { return map_; }
  const Text& text() const { return text_; }
  const Surroundings& around() const { return around_; }

  struct Team {
    text::Span span;
    std::size_t robots = 0;
  };
  const std::map<std::string, Team>& teams() const { return teams_; }
  const std::map<std::string, const mdl::statement::NewRobot*>& types() const { return types_; }

  const mdl::statement::NewRobot* type(const std::string& name) const {
    const auto found = types_.find(mdl::lower_case(name));
    return found == types_.end() ? nullptr : found->second;
  }

  /// The society that a type of this name stands for; null: none.
  const mission::Society* society(const std::string& name) const {
    const auto found = std::ranges::find_if(sketch_.societies, [&](const mission::Society& one) {
      return mdl::equal_without_case(one.name, name);
    });
    return found == sketch_.societies.end() ? nullptr : &*found;
  }

  /// Types, robots and units, as far as the mission can be understood.
  const mission::Mission& sketch() const { return sketch_; }

 private:
  void draw_sketch() {
    mission::RobotType& standard = sketch_.types.emplace_back();
    standard.name = "ROBOT";
    standard.program = "robot";
    robot::ProgramSources sources = around_.programs;
    sources.folder = folder_of(text_);
    sources.files = &around_.files;
    text::Diagnostics unsaid;
    mdl::Roster roster(sketch_, text_.source, tree_.damage, unsaid, robot::society_reader(sources));
    for (const mdl::Statement& one : tree_.preamble) {
      if (const auto* type = std::get_if<mdl::statement::NewRobot>(&one.what)) roster.define_type(*type);
      if (const auto* unit = std::get_if<mdl::statement::UnitDefinition>(&one.what))
        roster.define_unit(*unit);
    }
    roster.define_units_of_societies();
    std::ranges::sort(sketch_.robots, {}, &mission::Robot::id);
  }

  Text text_;
  const Surroundings& around_;
  mdl::Tree tree_;
  overlay::Overlay map_;
  mission::Mission sketch_;
  std::map<std::string, Team> teams_;
  std::map<std::string, const mdl::statement::NewRobot*> types_;
};

/// Goes through a mission and gathers its names.
class MdlNames {
 public:
  explicit MdlNames(const MdlWorld& world) : world_(world), places_(world.map()) {}

  std::vector<Name> run() {
    for (const mdl::Statement& one : world_.tree().preamble) statement(one);
    for (const mdl::LabelledStep& step : world_.tree().steps) {
      for (const mdl::Statement& one : step.commands) statement(one);
    }
    for (const mdl::Statement& one : world_.tree().typed) statement(one);
    std::ranges::sort(out_, {}, [](const Name& name) { return name.span.begin; });
    return std::move(out_);
  }

 private:
  const text::SourcePtr& source() const { return world_.text().source; }

  Name& add(NameKind kind, text::Span written, bool is_declaration = false) {
    Name name;
    name.span = bare_name(source(), written);
    name.kind = kind;
    name.is_declaration = is_declaration;
    name.text = source()->text(name.span);
    if (is_declaration) name.target = {source(), name.span};
    return out_.emplace_back(std::move(name));
  }

  void statement(const mdl::Statement& one) {
    if (const auto* overlay = std::get_if<mdl::statement::OverlayFile>(&one.what)) file(overlay->file);
    if (const auto* start = std::get_if<mdl::statement::StartPlace>(&one.what))
      add(NameKind::kPlace, start->name.span, true);
    if (const auto* robot = std::get_if<mdl::statement::NewRobot>(&one.what)) new_robot(*robot);
    if (const auto* unit = std::get_if<mdl::statement::UnitDefinition>(&one.what)) unit_definition(*unit);
    if (const auto* failsafe = std::get_if<mdl::statement::Failsafe>(&one.what)) {
      if (failsafe->type) robot_type(*failsafe->type);
      if (failsafe->fence) place(*failsafe->fence);
    }
    if (const auto* action = std::get_if<mdl::statement::UnitAction>(&one.what)) unit_action(*action);
  }

  void file(const mdl::Name& written) {
    Name& name = add(NameKind::kFile, written.span);
    const auto path = mdl::find_overlay(written.text, folder_of(world_.text()), options_of(world_.around()));
    if (!path) return;
    if (const auto read = world_.around().files.read(*path)) name.target = {*read, {0, 0}};
  }

  void new_robot(const mdl::statement::NewRobot& robot) {
    add(NameKind::kRobotType, robot.name.span, true);
    const auto meant =
        robot_meant(robot.program.text, robot.name.text, folder_of(world_.text()), world_.around());
    add_program(robot, meant);
    for (const mdl::Parameter& parameter : robot.parameters) {
      Name& key = add(NameKind::kArgument, parameter.key.span);
      if (!meant) continue;
      if (const CdlParameter* const one = find_parameter(*meant, key.text))
        key.target = {meant->scan.source, one->span};
    }
  }

  // `forager.cdl#Forager`: the file, and what of it is meant.
  void add_program(const mdl::statement::NewRobot& robot, const std::optional<MeantRobot>& meant) {
    text::Place target;
    if (meant) target = {meant->scan.source, meant->declaration_span()};
    Name& file = add(NameKind::kFile, robot.program.span);
    file.target = target;
    const std::size_t hash = meant ? file.text.rfind('#') : std::string::npos;
    const text::Span whole = file.span;
    if (hash != std::string::npos) {
      file.span.end = whole.begin + static_cast<std::uint32_t>(hash);
      file.text.resize(hash);
    }
    if (!meant || (meant->robot == nullptr && meant->society == nullptr)) return;
    Name part = file;
    part.kind = meant->robot != nullptr ? NameKind::kRobot : NameKind::kSociety;
    part.span = {hash == std::string::npos ? whole.end : file.span.end + 1, whole.end};
    part.text = source()->text(part.span);
    part.is_unsaid = hash == std::string::npos;
    // The only robot of a file needs no name.
    if (part.is_unsaid && !mdl::equal_without_case(meant->robot->name, robot.name.text)) return;
    out_.push_back(std::move(part));
  }

  void unit_definition(const mdl::statement::UnitDefinition& unit) {
    for (const mdl::Group& group : unit.groups) {
      if (group.name) add(NameKind::kTeam, group.name->span, true);
      for (const mdl::Name& robot : group.robots) robot_type(robot);
    }
  }

  void robot_type(const mdl::Name& written) {
    Name& name = add(NameKind::kRobotType, written.span);
    if (const auto* type = world_.type(written.text))
      name.target = {source(), bare_name(source(), type->name.span)};
  }

  void unit_action(const mdl::statement::UnitAction& action) {
    if (action.robots.empty()) {
      Name& unit = add(NameKind::kTeam, action.unit.span);
      const auto team = world_.teams().find(unit.text);
      if (team != world_.teams().end()) unit.target = {source(), team->second.span};
    }
    if (action.location && action.location->name) place(*action.location->name);
    for (const mdl::Clause& clause : action.clauses) {
      if (const auto* line = std::get_if<mdl::clause::PhaseLine>(&clause.what)) place(line->line);
    }
  }

  void place(const mdl::Name& written) {
    Name& name = add(NameKind::kPlace, written.span);
    const overlay::ControlMeasure* const measure = places_.find(name.text);
    if (measure == nullptr) return;
    name.span = own_part(source(), written.span, *measure);
    name.text = source()->text(name.span);
    if (measure->place.source)
      name.target = {measure->place.source, bare_name(measure->place.source, measure->place.span)};
  }

  const MdlWorld& world_;
  mdl::PlaceIndex places_;
  std::vector<Name> out_;
};

// `3 f#Scout, 1 f#Carrier`
std::string robots_of(const MdlWorld& world, const mission::Society& society) {
  std::vector<std::string> out;
  for (const mission::Society::Part& part : society.parts)
    out.push_back(fmt::format("{} `{}`", part.count, world.sketch().types[part.type].name));
  return fmt::format("{}", fmt::join(out, ", "));
}

std::string hover_of(const MdlWorld& world, const Name& name) {
  switch (name.kind) {
    case NameKind::kTeam: {
      const auto team = world.teams().find(name.text);
      if (team == world.teams().end()) return "";
      return fmt::format("unit `{}` of {}", name.text, base::counted(team->second.robots, "robot"));
    }
    case NameKind::kRobotType: {
      if (mdl::equal_without_case(name.text, "ROBOT")) return "`ROBOT`: the standard robot";
      const auto* type = world.type(name.text);
      if (type == nullptr) return "";
      const std::string of = fmt::format("`{}`: program `{}`", name.text, type->program.text);
      const mission::Society* society = world.society(name.text);
      return society == nullptr ? "robot type " + of
                                : fmt::format("society {}, {}", of, robots_of(world, *society));
    }
    case NameKind::kPlace: {
      const overlay::ControlMeasure* const measure = overlay::find_measure(world.map(), name.text);
      if (measure == nullptr) return "";
      const geom::Point at = measure->center();
      std::string out =
          fmt::format("`{}-{}` at {:g} {:g}", overlay::keyword(measure->kind), measure->name, at.x, at.y);
      if (measure->points.size() > 1) out += fmt::format(", {} points", measure->points.size());
      if (measure->place.source) out += fmt::format("\n\n{}", measure->place.source->name());
      return out;
    }
    case NameKind::kArgument: {
      if (!name.target.source) return "";
      for (const CdlDeclaration& one : scan_cdl(name.target.source).declarations) {
        for (const CdlParameter& parameter : one.parameters) {
          if (parameter.span == name.target.span) return markdown_of(parameter.input);
        }
      }
      return "";
    }
    default:
      return "";
  }
}

// `robot 3`, with its type and the innermost unit with a name that it is in.
std::string robot_text(const mission::Mission& mission, std::uint32_t number) {
  const auto robot = std::ranges::find(mission.robots, base::RobotId{number}, &mission::Robot::id);
  if (robot == mission.robots.end()) return "";
  const mission::Unit* home = nullptr;
  for (const mission::Unit& unit : mission.units) {
    const bool is_in = std::ranges::find(unit.members, robot->id) != unit.members.end();
    if (is_in && !unit.name.empty() && (home == nullptr || unit.members.size() < home->members.size()))
      home = &unit;
  }
  return fmt::format("robot {}, a `{}`{}", number, mission.types[robot->type].name,
                     home == nullptr ? "" : fmt::format(" of unit `{}`", home->name));
}

// The number of a robot that a command names.
std::optional<Hover> hover_robot(const MdlWorld& world, std::uint32_t cursor) {
  const auto in = [&](const mdl::Statement& one) -> std::optional<Hover> {
    const auto* action = std::get_if<mdl::statement::UnitAction>(&one.what);
    if (action == nullptr) return std::nullopt;
    for (const mdl::Number& robot : action->robots) {
      if (cursor < robot.span.begin || cursor > robot.span.end) continue;
      std::string text =
          robot_text(world.sketch(), static_cast<std::uint32_t>(std::clamp(robot.value, 0.0, 4e9)));
      return text.empty() ? std::nullopt : std::optional(Hover{std::move(text), robot.span});
    }
    return std::nullopt;
  };
  for (const mdl::LabelledStep& step : world.tree().steps) {
    for (const mdl::Statement& one : step.commands) {
      if (auto found = in(one)) return found;
    }
  }
  for (const mdl::Statement& one : world.tree().typed) {
    if (auto found = in(one)) return found;
  }
  return std::nullopt;
}

/// The NEW-ROBOT whose parentheses are open at the end of the text, as far as it is written.
struct OpenRobot {
  std::string name;
  std::string program;
  bool wants_key = false;
};

std::optional<OpenRobot> open_robot(const text::SourcePtr& before) {
  text::Diagnostics unsaid;
  const std::vector<mdl::Token> tokens = mdl::lex(before, unsaid).tokens;
  std::optional<std::size_t> open;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (tokens[i].kind == mdl::TokenKind::kWord && tokens[i].word == mdl::Word::kNewRobot) open = i;
    if (tokens[i].kind == mdl::TokenKind::kClose || tokens[i].kind == mdl::TokenKind::kCommandList)
      open.reset();
  }
  if (!open || *open + 3 >= tokens.size()) return std::nullopt;
  OpenRobot out;
  const auto text_of = [&](std::size_t i) {
    return std::string(before->text(bare_name(before, tokens[i].span)));
  };
  out.name = text_of(*open + 1);
  out.program = text_of(*open + 2);
  std::size_t parenthesis = *open + 3;
  while (parenthesis < tokens.size() && tokens[parenthesis].kind != mdl::TokenKind::kOpen) ++parenthesis;
  if (parenthesis >= tokens.size() || parenthesis > *open + 5) return std::nullopt;
  const mdl::TokenKind last = tokens[tokens.size() - 2].kind;
  const bool is_behind_value = tokens.size() >= parenthesis + 4 && last != mdl::TokenKind::kEquals &&
                               tokens[tokens.size() - 3].kind == mdl::TokenKind::kEquals;
  out.wants_key = last == mdl::TokenKind::kOpen || last == mdl::TokenKind::kComma || is_behind_value;
  return out;
}

void add_keys(const std::vector<CdlParameter>& parameters, CandidateList& out) {
  for (const CdlParameter& one : parameters)
    out.add({.text = one.input.name,
             .kind = "argument",
             .detail = shown_input(one.input).substr(one.input.name.size() + 2),
             .help = first_sentence(one.input.help),
             .is_call = false,
             .has_more = true},
            0);
}

Completions complete_parameters(const OpenRobot& robot, const Text& text, std::uint32_t cursor,
                                const Surroundings& around) {
  const std::string_view all = text.source->text();
  const std::uint32_t begin = word_begin(all, cursor);
  CandidateList out(std::string(all.substr(begin, cursor - begin)));
  if (!robot.wants_key) return out.take({begin, cursor});
  if (const auto meant = robot_meant(robot.program, robot.name, folder_of(text), around)) {
    if (meant->robot != nullptr) add_keys(meant->robot->parameters, out);
    if (meant->robot_class != nullptr) add_keys(meant->robot_class->parameters, out);
  }
  for (const std::string& key : run::vehicle_keys())
    out.add({.text = key,
             .kind = "argument",
             .detail = "of the vehicle",
             .help = "",
             .is_call = false,
             .has_more = true},
            2);
  return out.take({begin, cursor});
}

}  // namespace

Completions complete_mdl(const Text& text, std::uint32_t cursor, const Surroundings& around) {
  const std::string_view before = text.source->text().substr(0, cursor);
  const std::string_view line = before.substr(before.rfind('\n') + 1);
  const bool is_plain = line.find("--") == std::string_view::npos && std::ranges::count(line, '"') % 2 == 0;
  if (is_plain) {
    const std::uint32_t begin = word_begin(before, cursor);
    const auto source =
        std::make_shared<const text::Source>(text.source->name(), std::string(before.substr(0, begin)));
    if (const auto robot = open_robot(source)) return complete_parameters(*robot, text, cursor, around);
  }
  const MdlWorld world(text, around);
  KnownNames names{&world.sketch(), &world.map(), {}};
  if (around.list) {
    for (const std::string& file : around.list(folder_of(text))) {
      if (file.ends_with(".odl") || file.ends_with(".ovl")) names.overlay_files.push_back(file);
    }
  }
  return complete_statement(before, StatementKind::kMission, names);
}

std::vector<Name> names_mdl(const Text& text, const Surroundings& around) {
  return MdlNames(MdlWorld(text, around)).run();
}

std::optional<Hover> hover_mdl(const Text& text, std::uint32_t cursor, const Surroundings& around) {
  const MdlWorld world(text, around);
  const std::vector<Name> names = MdlNames(world).run();
  if (const Name* name = name_at(names, cursor)) {
    std::string markdown = hover_of(world, *name);
    if (!markdown.empty()) return Hover{std::move(markdown), name->span};
  }
  if (auto robot = hover_robot(world, cursor)) return robot;
  text::Diagnostics unsaid;
  for (const mdl::Token& token : mdl::lex(text.source, unsaid).tokens) {
    if (token.kind == mdl::TokenKind::kEnd || token.span.begin > cursor || cursor > token.span.end) continue;
    const std::string help = mdl_word_help(text.source->text(token.span));
    if (!help.empty()) return Hover{std::string(help), token.span};
  }
  return std::nullopt;
}

std::vector<Symbol> symbols_mdl(const Text& text, const Surroundings& around) {
  const MdlWorld world(text, around);
  std::vector<Symbol> out;
  for (const Name& name : MdlNames(world).run()) {
    if (!name.is_declaration) continue;
    std::string detail;
    if (name.kind == NameKind::kTeam) detail = base::counted(world.teams().at(name.text).robots, "robot");
    if (const auto* type = name.kind == NameKind::kRobotType ? world.type(name.text) : nullptr)
      detail = type->program.text;
    out.push_back({name.text, std::string(name_of(name.kind)), detail, name.span, name.span, {}});
  }
  for (const mdl::LabelledStep& step : world.tree().steps) {
    text::Span whole = step.label.span;
    for (const mdl::Statement& one : step.commands) whole.end = std::max(whole.end, one.span.end);
    const std::string_view rest = text.source->text().substr(step.label.span.end);
    const std::string_view first = rest.substr(0, rest.find('\n'));
    const std::size_t begin = first.find_first_not_of(" \t");
    out.push_back({step.label.text,
                   "step",
                   begin == std::string_view::npos ? "" : std::string(first.substr(begin)),
                   whole,
                   step.label.span,
                   {}});
  }
  std::ranges::stable_sort(out, {}, [](const Symbol& one) { return one.span.begin; });
  return out;
}

std::vector<Hint> hints_mdl(const Text& text, const Surroundings& around) {
  text::Diagnostics unsaid;
  const mdl::Tree tree = mdl::parse(text.source, unsaid);
  std::vector<Hint> out;
  for (const mdl::Statement& one : tree.preamble) {
    const auto* robot = std::get_if<mdl::statement::NewRobot>(&one.what);
    if (robot == nullptr || robot->parameters.empty()) continue;
    const auto meant = robot_meant(robot->program.text, robot->name.text, folder_of(text), around);
    if (!meant) continue;
    for (const mdl::Parameter& given : robot->parameters) {
      const CdlParameter* const found = find_parameter(*meant, given.key.text);
      if (found == nullptr || found->input.value.unit.empty()) continue;
      out.push_back({given.value_span.end, found->input.value.unit, true, first_sentence(found->input.help)});
    }
  }
  return out;
}

std::vector<Shade> tokens_mdl(const Text& text) {
  text::Diagnostics unsaid;
  const mdl::Tokens lexed = mdl::lex(text.source, unsaid);
  std::vector<Shade> out;
  for (const mdl::CommentToken& comment : lexed.comments)
    out.push_back({comment.span, Shade::Kind::kComment});
  for (const mdl::Token& token : lexed.tokens) {
    const mdl::Token& next = *(&token + (token.kind == mdl::TokenKind::kEnd ? 0 : 1));
    switch (token.kind) {
      case mdl::TokenKind::kName:  // not a reserved word
        if (next.kind == mdl::TokenKind::kNumber &&
            mdl::equal_without_case(text.source->text(token.span), "ROBOTS"))
          out.push_back({token.span, Shade::Kind::kKeyword});
        break;
      case mdl::TokenKind::kMissionName:
      case mdl::TokenKind::kCommandList:
      case mdl::TokenKind::kImmediateCommand:
      case mdl::TokenKind::kWord:
        out.push_back({token.span, Shade::Kind::kKeyword});
        break;
      case mdl::TokenKind::kBoolean:
      case mdl::TokenKind::kFormation:
      case mdl::TokenKind::kTechnique:
        out.push_back({token.span, Shade::Kind::kMember});
        break;
      case mdl::TokenKind::kString:
      case mdl::TokenKind::kFile:
        out.push_back({token.span, Shade::Kind::kText});
        break;
      case mdl::TokenKind::kNumber:
      case mdl::TokenKind::kTime:
      case mdl::TokenKind::kDate:
      case mdl::TokenKind::kLabel:
        out.push_back({token.span, Shade::Kind::kNumber});
        break;
      default:
        break;
    }
  }
  return out;
}

}  // namespace mlab::assist
