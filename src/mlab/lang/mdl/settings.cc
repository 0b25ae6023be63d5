#include "mlab/lang/mdl/settings.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <system_error>

#include <fmt/core.h>

#include "mlab/lang/mdl/options.h"
#include "mlab/lang/mdl/quoted.h"
#include "mlab/percept/formation_names.h"

namespace mlab::mdl {
namespace {

bool are_same(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  return std::ranges::equal(a, b, {}, lower, lower);
}

std::optional<double> number_in(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

// The types that go by a name: one, or those of a society.
std::vector<mission::RobotType*> types_of(mission::Mission& mission, std::string_view name) {
  std::vector<mission::RobotType*> out;
  for (mission::RobotType& type : mission.types) {
    if (name.empty() || are_same(type.name, name)) out.push_back(&type);
  }
  for (const mission::Society& society : mission.societies) {
    if (name.empty() || !are_same(society.name, name)) continue;
    for (const mission::Society::Part& part : society.parts) out.push_back(&mission.types[part.type]);
  }
  return out;
}

}  // namespace

Settings::Settings(const std::vector<Setting>& all, text::Diagnostics& diagnostics)
    : diagnostics_(diagnostics) {
  for (const Setting& setting : all) {
    Kept kept;
    kept.setting = &setting;
    kept.number = number_option(setting.name);
    const auto* const maneuver =
        std::ranges::find_if(mission::kManeuvers, [&](const mission::ManeuverInfo& one) {
          return !one.on.empty() && are_same(one.word, setting.name);
        });
    if (maneuver != std::end(mission::kManeuvers)) kept.maneuver = maneuver;
    kept.name = setting.name;
    if (const std::size_t colon = kept.name.find(':'); colon != std::string_view::npos) {
      kept.of = kept.name.substr(0, colon);
      kept.name = kept.name.substr(colon + 1);
    }
    kept.is_formation = kept.of.empty() && are_same(kept.name, "FORMATION");
    kept.is_overlay = are_same(kept.of.empty() ? kept.name : kept.of, "OVERLAY");
    std::erase_if(all_, [&](const Kept& before) { return are_same(before.setting->name, setting.name); });
    all_.push_back(kept);
  }
}

void Settings::check_overlays(std::size_t count) {
  for (Kept& kept : all_) {
    if (!kept.is_overlay || !kept.of.empty() || count == 1) continue;
    kept.was_used = true;
    auto& error =
        diagnostics_.error("which-overlay", kept.setting->name_place,
                           count == 0 ? "the mission names no overlay that another could stand in for"
                                      : fmt::format("the mission names {} overlays", count));
    if (count > 1) error.hints.emplace_back("`OVERLAY:NAME=...` says in place of which");
  }
}

const Setting* Settings::in_place_of_overlay(std::string_view file) {
  for (Kept& kept : all_) {
    if (!kept.is_overlay || (kept.of.empty() ? kept.was_used : kept.name != file)) continue;
    kept.was_used = true;
    return kept.setting;
  }
  return nullptr;
}

bool Settings::replaces(const std::variant<mission::BooleanOption, mission::NumberOption>& option) const {
  return std::ranges::any_of(all_, [&](const Kept& kept) {
    const auto* const number = std::get_if<mission::NumberOption>(&option);
    if (number != nullptr) return kept.number == *number;
    return kept.maneuver != nullptr && kept.maneuver->option == option;
  });
}

void Settings::set_options(mission::Options& options, overlay::Area area) {
  for (Kept& kept : all_) {
    if (!kept.number && kept.maneuver == nullptr) continue;
    if (kept.number)
      set_number(kept, options, area);
    else
      set_maneuver(kept, options);
    kept.was_used = true;
  }
}

void Settings::set_number(Kept& kept, mission::Options& options, overlay::Area area) {
  const std::optional<double> value = number_in(kept.setting->value);
  if (value) {
    statement::Set set;
    set.option = *kept.number;
    set.option_span = kept.setting->name_place.span;
    set.number = Number{*value, kept.setting->value, kept.setting->value_place.span};
    text::Diagnostics said;
    if (const auto command = read_set(set, options, area, kept.setting->name_place.source, said)) {
      apply_set(*command, options);
    } else if (!kept.was_used) {
      for (text::Diagnostic one : said.items()) {
        one.place = kept.setting->value_place;
        diagnostics_.report(std::move(one));
      }
    }
  } else if (!kept.was_used) {
    diagnostics_.error(
        "not-a-number", kept.setting->value_place,
        fmt::format("{} takes a number, found {}", kept.setting->name, in_backticks(kept.setting->value)));
  }
}

void Settings::set_maneuver(Kept& kept, mission::Options& options) {
  const mission::ManeuverInfo& maneuver = *kept.maneuver;
  const bool is_on = are_same(kept.setting->value, maneuver.on);
  if (is_on || are_same(kept.setting->value, maneuver.off))
    apply_set(mission::SetBoolean{std::get<mission::BooleanOption>(maneuver.option), is_on}, options);
  else if (!kept.was_used)
    diagnostics_.error("unknown-word", kept.setting->value_place,
                       fmt::format("{} takes {} or {}, found {}", maneuver.word, maneuver.on, maneuver.off,
                                   in_backticks(kept.setting->value)));
}

void Settings::set_options(mission::Step& step, const mission::Options& options) const {
  for (mission::Command& command : step.commands) {
    auto* number = std::get_if<mission::SetNumber>(&command);
    // Of the numbers only this one can be set in a step.
    if (number != nullptr && replaces(number->option) &&
        number->option == mission::NumberOption::kCycleDuration && options.cycle_duration)
      number->value = *options.cycle_duration;
  }
}

void Settings::set_formations(std::vector<mission::Step>& steps) {
  for (const Kept& kept : all_) {
    if (!kept.is_formation) continue;
    const auto formation = percept::formation_named(kept.setting->value);
    if (!formation) {
      std::vector<std::string> known;
      for (const percept::FormationInfo& one : percept::kFormations) known.emplace_back(one.name);
      diagnostics_.error("unknown-formation", kept.setting->value_place,
                         fmt::format("expected a formation ({}), found {}", listed(known, " or "),
                                     in_backticks(kept.setting->value)));
      continue;
    }
    bool was_used = false;
    for (mission::Step& step : steps) {
      for (mission::Command& one : step.commands) {
        auto* const command = std::get_if<mission::UnitCommand>(&one);
        if (command == nullptr || !command->has_formation || command->formation == percept::Formation::kNone)
          continue;
        command->formation = *formation;
        was_used = true;
      }
    }
    if (!was_used)
      diagnostics_.error("no-formation", kept.setting->name_place,
                         "no command of the mission names a formation that another could stand in for");
  }
}

void Settings::set_parameters(mission::Mission& mission, bool is_damaged) {
  for (const Kept& kept : all_) {
    if (kept.was_used || kept.number || kept.maneuver != nullptr || kept.is_formation) continue;
    const Setting& setting = *kept.setting;
    if (kept.is_overlay) {
      diagnostics_.error("unknown-overlay", setting.name_place,
                         fmt::format("the mission names no overlay {}", in_backticks(kept.name)));
      continue;
    }
    const std::vector<mission::RobotType*> types = types_of(mission, kept.of);
    if (types.empty() && !is_damaged) {
      std::vector<std::string> known;
      for (const mission::RobotType& type : mission.types) known.push_back(type.name);
      auto& error = diagnostics_.error("unknown-robot-type", setting.name_place,
                                       fmt::format("unknown robot type {}", in_backticks(kept.of)));
      error.label = fmt::format("the mission has {}", listed(known, " and "));
    }
    for (mission::RobotType* type : types)
      type->parameters.push_back(
          {std::string(kept.name), setting.value, setting.name_place, setting.value_place, true});
  }
}

}  // namespace mlab::mdl
