#pragma once

#include <chrono>
#include <memory>
#include <string>

#include "mlab/preflight/preflight.h"

namespace mlab::preflight::testing {

/// A mission of three robots: of the first two the hosts are `veh-1` and `veh-2`, which START at (8, 12) and
/// (8, 18) within the fence `Field`, from (0, 0) to (40, 30).
inline std::shared_ptr<mission::Mission> yard() {
  auto out = std::make_shared<mission::Mission>();
  out->name = "Yard";
  const auto type = [](std::string name, std::string host) {
    return mission::RobotType{
        .name = std::move(name), .program = "robot", .host = std::move(host), .parameters = {}, .place = {}};
  };
  out->types = {type("ROBOT", ""), type("first", "veh-1"), type("second", "veh-2")};
  out->robots = {{{1}, 1, {}}, {{2}, 2, {}}, {{3}, 0, {}}};
  out->units = {{"team", {{1}, {2}, {3}}, {}, {}}};
  mission::UnitCommand start;
  start.task = mission::Task::kStart;
  start.goal = {8.0, 12.0};
  start.start_step = {0.0, 6.0};
  out->steps = {{.label = "0", .commands = {start}, .place = {}}};
  mission::Failsafe fence;
  fence.condition = mission::FailsafeCondition::kOutside;
  fence.action = mission::FailsafeAction::kReturn;
  fence.fence_name = "Field";
  fence.fence = {{0.0, 0.0}, {40.0, 0.0}, {40.0, 30.0}, {0.0, 30.0}};
  out->failsafes = {fence};
  out->source = std::make_shared<const text::Source>("yard.mdl", "MISSION NAME \"Yard\"\n");
  return out;
}

inline run::Crew crew(std::shared_ptr<const mission::Mission> mission = yard()) {
  return {std::move(mission), {}, {}};
}

/// A vehicle with which all is well, and known.
inline VehicleFacts well(const std::string& name, geom::Point place) {
  VehicleFacts out;
  out.name = name;
  out.is_there = true;
  out.kind = "rover at udp:14550";
  out.session = name + " started once";
  out.version = "1.0";
  out.machine = "north";
  out.limits.emplace();
  out.limits->kinematics.drive = binding::Drive::kDifferential;
  out.limits->kinematics.max_speed = 1.0;
  out.link = Link{0.002, 0.0, 0.0};
  out.arrived = vehicle::Clock::time_point(std::chrono::seconds(1000));
  out.report.emplace();
  out.report->readiness = vehicle::Readiness::kReady;
  out.report->is_global = true;
  out.report->motion = vehicle::Motion{{place, 0.0}, 0.0, 0.0, out.arrived};
  vehicle::Scan scan;
  scan.farthest = 10.0;
  scan.distances = {1.0F, 2.0F};
  scan.at = out.arrived;
  out.report->scans = {scan};
  out.report->battery = vehicle::Battery{0.9, 12.5, out.arrived};
  out.checks = {{"watchdog", CheckResult::kPass, "brakes 0.5 s after its last command", ""}};
  return out;
}

inline std::vector<VehicleFacts> both_well() {
  return {well("veh-1", {8.0, 12.0}), well("veh-2", {8.0, 18.0})};
}

inline Checklist checklist(const std::vector<VehicleFacts>& facts = both_well()) {
  return assemble(crew(), "alpha", facts, "1.0");
}

/// By somebody who confirms everything.
inline Signature signature(double at = 0.0) {
  Signature out{"Ada", at, {}, {}};
  for (const ManualItem& one : manual_items()) out.confirmed.push_back(one.id);
  return out;
}

}  // namespace mlab::preflight::testing
