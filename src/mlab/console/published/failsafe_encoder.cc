#include "mlab/console/published/failsafe_encoder.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

#include "mlab/console/published/overview.h"

namespace mlab::console {
namespace {

using State = fleet::RowStanding::State;
using What = fleet::WhatIfEvent::What;

FailsafeStandings::State told(State state) {
  switch (state) {
    case State::kOthers:
      return FailsafeStandings::OTHERS;
    case State::kOff:
      return FailsafeStandings::OFF;
    case State::kArmed:
      return FailsafeStandings::ARMED;
    case State::kNear:
      return FailsafeStandings::NEAR;
    case State::kWaiting:
      return FailsafeStandings::WAITING;
    case State::kActive:
      return FailsafeStandings::ACTIVE;
    case State::kOverruled:
      return FailsafeStandings::OVERRULED;
  }
  return FailsafeStandings::OTHERS;
}

FailsafeTrial::What told(What what) {
  switch (what) {
    case What::kMet:
      return FailsafeTrial::MET;
    case What::kNotMet:
      return FailsafeTrial::NOT_MET;
    case What::kActs:
      return FailsafeTrial::ACTS;
    case What::kGivesWay:
      return FailsafeTrial::GIVES_WAY;
    case What::kIsOver:
      return FailsafeTrial::IS_OVER;
    case What::kLetsIn:
      return FailsafeTrial::LETS_IN;
  }
  return FailsafeTrial::MET;
}

Failsafes::Row::Watch told_watch(mission::FailsafeWatch watch) {
  switch (watch) {
    case mission::FailsafeWatch::kRunning:
      return Failsafes::Row::RUNNING;
    case mission::FailsafeWatch::kRealTime:
      return Failsafes::Row::REAL_TIME;
    case mission::FailsafeWatch::kTeleoperated:
      return Failsafes::Row::TELEOPERATED;
    case mission::FailsafeWatch::kVehicle:
      return Failsafes::Row::VEHICLE;
  }
  return Failsafes::Row::RUNNING;
}

// @param unit  of its measure, in which it goes to browsers
void encode_standing(const fleet::RowStanding& row, double unit, FailsafeStandings::Standing& out) {
  constexpr double kMostTenths = 1e9;
  out.set_state(told(row.state));
  out.set_used(static_cast<std::uint32_t>(std::floor(100.0 * row.used)));
  out.set_measure(static_cast<std::int32_t>(
      std::clamp(std::floor(row.measure / unit + 1e-6), -kMostTenths, kMostTenths)));
}

double unit_of(const mission::Failsafe& row) {
  return mission::info(row.condition).has_share ? 0.001 : 0.1;
}

}  // namespace

void encode_failsafes(const mission::Mission& mission, const PlaceOf& place_of, Failsafes& out) {
  for (const mission::Failsafe& row : mission.failsafes) {
    const mission::FailsafeConditionInfo& condition = mission::info(row.condition);
    Failsafes::Row& told = *out.add_rows();
    told.set_statement(clean(mission::words_of(row)));
    told.set_robots(clean(row.type_name));
    told.set_condition(std::string(condition.word));
    told.set_fence(clean(row.fence_name));
    told.set_may_last(condition.may_last);
    told.set_seconds(row.seconds);
    told.set_share(row.share);
    told.set_action(std::string(mission::info(row.action).word));
    told.set_means(std::string(condition.help));
    told.set_does(std::string(mission::info(row.action).help));
    const DocumentPlace place = place_of(row.place);
    told.set_document(place.document);
    told.set_line(place.line);
    told.set_watch(told_watch(condition.watch));
  }
  Failsafes::Bounds& bounds = *out.mutable_bounds();
  bounds.set_seconds(fleet::WhatIf::kMostSeconds);
  bounds.set_speed(fleet::WhatIf::kMostSpeed);
  bounds.set_depth(fleet::WhatIf::kMostDepth);
  bounds.set_bearing(fleet::WhatIf::kMostBearing);
}

void encode_standings(const run::MissionRun& run, const fleet::FleetRobot& robot, FailsafeStandings& out) {
  out.set_robot(robot.id.value);
  const std::vector<mission::Failsafe>& table = run.fleet().failsafes().rows();
  const std::vector<fleet::RowStanding> rows = run.fleet().standings(robot, run.cycle_duration());
  for (std::size_t i = 0; i < rows.size(); ++i) encode_standing(rows[i], unit_of(table[i]), *out.add_rows());
}

void encode_trial(const fleet::Failsafes& failsafes, const fleet::WhatIfOutcome& outcome, bool has_fence,
                  FailsafeTrial& out) {
  for (const fleet::WhatIfEvent& event : outcome.events) {
    FailsafeTrial::Event& one = *out.add_events();
    one.set_time(event.time);
    one.set_row(static_cast<std::uint32_t>(event.row));
    one.set_what(told(event.what));
  }
  for (std::size_t i = 0; i < outcome.rows.size(); ++i) {
    fleet::RowStanding row = outcome.rows[i];
    row.used = outcome.most_used[i];
    encode_standing(row, unit_of(failsafes.rows()[i]), *out.add_rows());
  }
  out.set_seconds(outcome.seconds);
  out.set_is_cut(outcome.is_cut);
  out.set_x(outcome.to.position.x);
  out.set_y(outcome.to.position.y);
  out.set_driven_to(geom::distance(outcome.from.position, outcome.to.position));
  out.set_speed(outcome.speed);
  if (outcome.stood) out.set_stood(*outcome.stood);
  out.set_has_stopped(outcome.has_stopped);
  if (!has_fence) return;
  out.set_least_room(outcome.least_room);
  out.set_last_room(outcome.last_room);
}

}  // namespace mlab::console
