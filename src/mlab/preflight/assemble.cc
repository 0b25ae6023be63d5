#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "mlab/base/counted.h"
#include "mlab/base/hash.h"
#include "mlab/mission/command.h"
#include "mlab/preflight/preflight.h"
#include "mlab/preflight/vehicle_items.h"

namespace mlab::preflight {
namespace {

using enum vehicle::CheckResult;

constexpr std::string_view kSpeeds[] = {"max_velocity", "base_velocity"};  // parameters of programs [m/s]

// The more, the sooner somebody has to look at it.
int concern_of(const Item& item) {
  constexpr int kConcerns[] = {0, 2, 3, 1};  // of pass, warn, fail, unknown
  return kConcerns[static_cast<std::size_t>(item.result)];
}

const std::string& host_of(const mission::Mission& mission, const mission::Robot& robot) {
  return mission.types[robot.type].host;
}

/// What a mission wants of each of its hosts.
class AllWants {
 public:
  explicit AllWants(const run::Crew& crew) : crew_(crew), mission_(*crew.mission) {
    for (const mission::Robot& robot : mission_.robots) {
      const std::string& host = host_of(mission_, robot);
      if (host.empty()) continue;
      hosts_[robot.id] = host;
      Wants& wants = wants_[host];
      wants.robots.push_back(robot.id.value);
      wants.speed = std::max(wants.speed, speed_of(robot));
      add_rows(robot, wants);
    }
    for (const mission::Step& step : mission_.steps) {
      for (const mission::Command& one : step.commands) {
        if (const auto* command = std::get_if<mission::UnitCommand>(&one)) take(*command);
      }
    }
  }
  const Wants& of(const std::string& host) { return wants_[host]; }

 private:
  double speed_of(const mission::Robot& robot) const {
    double out = 0.0;
    if (robot.type >= crew_.programs.size()) return out;
    for (const std::string_view path : kSpeeds)
      out = std::max(out, crew_.programs[robot.type].number(path).value_or(0.0));
    return out;
  }

  void add_rows(const mission::Robot& robot, Wants& wants) const {
    for (const mission::Failsafe& row : mission_.failsafes) {
      const bool is_known = std::ranges::find(wants.rows, &row) != wants.rows.end();
      if (!is_known && row.is_of(mission_.types[robot.type].name)) wants.rows.push_back(&row);
    }
  }

  void take(const mission::UnitCommand& command) {
    std::size_t rank = 0;
    for (const base::RobotId id : mission::members_of(mission_, command)) {
      const std::size_t place = rank++;
      const auto host = hosts_.find(id);
      if (host == hosts_.end()) continue;
      Wants& wants = wants_[host->second];
      wants.speed = std::max(wants.speed, command.speed);
      if (command.task == mission::Task::kStart && !wants.start && wants.robots.front() == id.value)
        wants.start = mission::start_pose(mission_, command, place);
    }
  }

  const run::Crew& crew_;
  const mission::Mission& mission_;
  std::map<base::RobotId, std::string> hosts_;
  std::map<std::string, Wants> wants_;
};

Item failsafe_item(const mission::Mission& mission) {
  Item out{"mission/failsafes", "", "failsafes", kPass, "", ""};
  std::vector<std::string> rows;
  for (const mission::Failsafe& one : mission.failsafes) rows.push_back(mission::words_of(one));
  out.is = rows.empty() ? "the mission states none" : fmt::format("{}", fmt::join(rows, "; "));
  if (!rows.empty()) return out;
  out.result = kWarn;
  out.expected = "rows that say what becomes of a robot that leaves its area, is stuck or touches something";
  return out;
}

Item battery_item(const mission::Mission& mission) {
  const auto is_of_battery = [](const mission::Failsafe& one) {
    return mission::info(one.condition).word.find("BATTERY") != std::string_view::npos;
  };
  const bool is_stated = std::ranges::any_of(mission.failsafes, is_of_battery);
  return {"mission/battery-failsafe",
          "",
          "battery failsafe",
          is_stated ? kPass : kWarn,
          is_stated ? "the mission states one" : "the mission states none",
          is_stated ? "" : "a failsafe of the vehicle's own, or somebody who watches the battery"};
}

Item robots_item(const mission::Mission& mission, const std::vector<CheckedVehicle>& vehicles) {
  std::size_t on_vehicles = 0;
  for (const CheckedVehicle& one : vehicles) on_vehicles += one.robots.size();
  return {"mission/robots",
          "",
          "robots",
          vehicles.empty() ? kUnknown : kPass,
          fmt::format("{}, {} on vehicles", base::counted(mission.robots.size(), "robot"), on_vehicles),
          ""};
}

}  // namespace

bool Checklist::is_needed() const {
  return std::ranges::any_of(
      vehicles, [](const CheckedVehicle& one) { return !one.session.empty() && !one.is_simulated; });
}

CheckResult Checklist::worst() const {
  const auto worst = std::ranges::max_element(items, {}, concern_of);
  return worst == items.end() ? kPass : worst->result;
}

std::vector<std::string> hosts_of(const mission::Mission& mission) {
  std::set<std::string> out;
  for (const mission::Robot& robot : mission.robots) {
    if (!host_of(mission, robot).empty()) out.insert(host_of(mission, robot));
  }
  return {out.begin(), out.end()};
}

std::string digest_of(const run::Crew& crew) {
  const mission::Mission& mission = *crew.mission;
  std::set<std::uint64_t> parts;  // however they were come upon
  const auto add = [&](std::string_view what, std::string_view text) {
    parts.insert(base::combine_bits(base::hash_text(what), base::hash_text(text)));
  };
  const auto add_text = [&](const text::SourcePtr& source) {
    if (source) add("text", source->text());
  };
  add_text(mission.source);
  std::ranges::for_each(mission.texts, add_text);
  for (const robot::RobotProgram& program : crew.programs) {
    add("program", fmt::format("{} {}", program.type, program.name));
    if (program.executable) add("executable", std::to_string(program.executable->source));
    if (program.origin) std::ranges::for_each(program.origin->texts, add_text);
  }
  std::uint64_t out = 0;
  for (const std::uint64_t part : parts) out = base::combine_bits(out, part);
  // Of these the order counts.
  for (const auto& [name, value] : mission.set)
    out = base::combine_bits(out, base::hash_text(fmt::format("{}={}", name, value)));
  for (const std::string& line : mission.typed) out = base::combine_bits(out, base::hash_text(line));
  return fmt::format("{:016x}", out);
}

Checklist assemble(const run::Crew& crew, const std::string& fleet, std::span<const VehicleFacts> vehicles,
                   const std::string& version) {
  const mission::Mission& mission = *crew.mission;
  Checklist out;
  out.mission = mission.name;
  out.fleet = fleet;
  out.digest = digest_of(crew);
  out.manual = manual_items();
  AllWants wants(crew);
  std::vector<const VehicleFacts*> sorted;
  for (const VehicleFacts& one : vehicles) sorted.push_back(&one);
  std::ranges::sort(sorted, {}, [](const VehicleFacts* one) { return one->name; });
  for (const VehicleFacts* one : sorted)
    out.vehicles.push_back(
        {one->name, one->kind, one->session, one->version, one->is_simulated, wants.of(one->name).robots});
  const auto add = [&](std::vector<Item> items) {
    std::ranges::stable_sort(items, std::greater(), concern_of);
    std::ranges::move(items, std::back_inserter(out.items));
  };
  add({robots_item(mission, out.vehicles), failsafe_item(mission), battery_item(mission)});
  for (const VehicleFacts* one : sorted) add(items_of(*one, wants.of(one->name), version));
  return out;
}

const std::vector<ManualItem>& manual_items() {
  static const std::vector<ManualItem> kItems = {
      {"area-clear", "Nobody is where the vehicles will drive, and nothing that must not be hit."},
      {"people-told", "Everybody near knows that the vehicles will move by themselves."},
      {"stop-tried",
       "The emergency stop was tried with these vehicles today: the console's and each vehicle's own. They "
       "stood."},
      {"pilot-ready",
       "For each vehicle somebody stands ready to take it over, with its remote control or its switch at "
       "hand."},
      {"place-right", "Each vehicle stands where the mission starts it, and looks there."},
      {"hardware-sound",
       "Wheels, batteries and what is mounted are fixed, and nothing hides the sensors' view."},
  };
  return kItems;
}

}  // namespace mlab::preflight
