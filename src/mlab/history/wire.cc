#include "mlab/history/wire.h"

#include <utility>
#include <variant>

#include "mlab/base/overloaded.h"

namespace mlab::history {
namespace {

namespace event = mission::event;
using Posted = wire::HistoryPosted;

// An order to steer comes from a button, not from a typed line.
void encode(const event::Typed& typed, Posted& out) {
  const auto* order = typed.line.empty() && typed.commands.size() == 1
                          ? std::get_if<mission::UnitCommand>(typed.commands.data())
                          : nullptr;
  out.set_kind(order != nullptr ? Posted::TELEOPERATE : Posted::TYPED);
  out.set_line(typed.line);
  if (order == nullptr) return;
  out.set_unit(order->unit);
  for (const base::RobotId robot : order->robots) out.add_robots(robot.value);
  out.set_x(order->goal.x);
  out.set_y(order->goal.y);
}

void encode(const mission::Event& posted, Posted& out) {
  std::visit(base::Overloaded{
                 [&](const event::Execute&) { out.set_kind(Posted::EXECUTE); },
                 [&](const event::Pause&) { out.set_kind(Posted::PAUSE); },
                 [&](const event::Resume&) { out.set_kind(Posted::RESUME); },
                 [&](const event::SingleStep&) { out.set_kind(Posted::SINGLE_STEP); },
                 [&](const event::StopAfterStep&) { out.set_kind(Posted::STOP_AFTER_STEP); },
                 [&](const event::Rewind&) { out.set_kind(Posted::REWIND); },
                 [&](const event::Abort&) { out.set_kind(Posted::ABORT); },
                 [&](const event::Jump& jump) {
                   out.set_kind(Posted::JUMP);
                   out.set_number(jump.step);
                 },
                 [&](const event::Answer& answer) {
                   out.set_kind(Posted::ANSWER);
                   out.set_number(answer.question);
                   out.set_proceed(answer.proceed);
                 },
                 [&](const event::TeleoperationComplete& over) {
                   out.set_kind(Posted::TELEOPERATION_COMPLETE);
                   out.set_number(over.command);
                 },
                 [&](const event::Typed& typed) { encode(typed, out); },
                 // The run says these to its executive by itself.
                 [](const event::Cycle&) {},
                 [](const event::RobotAsks&) {},
                 [](const event::Edited&) {},
             },
             posted);
}

event::Typed steer(const Posted& posted) {
  mission::UnitCommand order;
  order.task = mission::Task::kTeleoperate;
  order.unit = posted.unit();
  for (const std::uint32_t robot : posted.robots()) order.robots.push_back({robot});
  order.goal = {posted.x(), posted.y()};
  return {{order}};
}

std::optional<mission::Event> decode(const Posted& posted) {
  switch (posted.kind()) {
    case Posted::EXECUTE:
      return event::Execute{};
    case Posted::PAUSE:
      return event::Pause{};
    case Posted::RESUME:
      return event::Resume{};
    case Posted::SINGLE_STEP:
      return event::SingleStep{};
    case Posted::STOP_AFTER_STEP:
      return event::StopAfterStep{};
    case Posted::JUMP:
      return event::Jump{posted.number()};
    case Posted::REWIND:
      return event::Rewind{};
    case Posted::ABORT:
      return event::Abort{};
    case Posted::ANSWER:
      return event::Answer{posted.number(), posted.proceed()};
    case Posted::TELEOPERATE:
      return steer(posted);
    case Posted::TELEOPERATION_COMPLETE:
      return event::TeleoperationComplete{posted.number()};
    default:
      return std::nullopt;
  }
}

void encode(const run::input::Intervened& one, wire::HistoryIntervention& out) {
  out.set_robot(one.robot.value);
  out.set_kind(static_cast<wire::HistoryIntervention::Kind>(one.kind));
  out.set_path(one.path);
  out.set_value(one.value);
}

}  // namespace

wire::HistoryExecutive to_wire(const mission::ExecutiveOptions& options) {
  wire::HistoryExecutive out;
  out.set_proceed_all(options.proceed_all);
  out.set_patience(options.patience);
  out.set_epoch_seconds(options.epoch_seconds);
  out.set_zone_offset(options.zone_offset);
  out.set_bound_length(options.bound_length);
  out.set_spacing(options.spacing);
  out.set_phase_line_ahead(options.phase_line_ahead);
  return out;
}

mission::ExecutiveOptions from_wire(const wire::HistoryExecutive& options) {
  mission::ExecutiveOptions out;
  out.proceed_all = options.proceed_all();
  out.patience = options.patience();
  out.epoch_seconds = options.epoch_seconds();
  out.zone_offset = options.zone_offset();
  out.bound_length = options.bound_length();
  out.spacing = options.spacing();
  out.phase_line_ahead = options.phase_line_ahead();
  return out;
}

void encode(const run::Input& from, wire::HistoryInput& out) {
  std::visit(base::Overloaded{
                 [&](const run::input::Posted& posted) { encode(posted.event, *out.mutable_posted()); },
                 [&](const run::input::Exchanged&) {},
                 [&](const run::input::EmergencyStop& stop) { out.set_emergency_stop(stop.is_engaged); },
                 [&](const run::input::StandStill& still) { out.set_stands_still(still.stands_still); },
                 [&](const run::input::Steered& steered) {
                   wire::HistoryStick& stick = *out.mutable_stick();
                   stick.set_robot(steered.robot.value);
                   stick.set_x(steered.stick.x);
                   stick.set_y(steered.stick.y);
                   stick.set_magnitude(steered.stick.magnitude);
                   stick.set_is_robot_frame(steered.stick.is_robot_frame);
                   stick.set_complete(steered.stick.complete);
                   stick.set_is_let_go(!steered.is_held);
                 },
                 [&](const run::input::ParameterSet& set) {
                   wire::HistoryParameter& parameter = *out.mutable_parameter();
                   parameter.set_robot(set.robot.value);
                   parameter.set_port(set.port);
                   parameter.set_value(set.value);
                 },
                 [&](const run::input::Intervened& one) { encode(one, *out.mutable_intervention()); },
                 [&](const run::input::Heard& one) {
                   out.mutable_heard()->set_vehicle(one.heard.vehicle);
                   out.mutable_heard()->set_said(one.heard.said);
                 },
             },
             from);
}

std::optional<run::Input> decode(const wire::HistoryInput& from) {
  using Body = wire::HistoryInput;
  switch (from.body_case()) {
    case Body::kPosted: {
      std::optional<mission::Event> event = decode(from.posted());
      if (!event) return std::nullopt;
      return run::input::Posted{std::move(*event)};
    }
    case Body::kEmergencyStop:
      return run::input::EmergencyStop{from.emergency_stop()};
    case Body::kStandsStill:
      return run::input::StandStill{from.stands_still()};
    case Body::kStick: {
      const wire::HistoryStick& stick = from.stick();
      return run::input::Steered{
          {stick.robot()},
          {stick.x(), stick.y(), stick.magnitude(), stick.is_robot_frame(), stick.complete()},
          !stick.is_let_go()};
    }
    case Body::kParameter:
      return run::input::ParameterSet{
          {from.parameter().robot()}, from.parameter().port(), from.parameter().value()};
    case Body::kIntervention: {
      const wire::HistoryIntervention& one = from.intervention();
      if (!wire::HistoryIntervention::Kind_IsValid(one.kind())) return std::nullopt;
      return run::input::Intervened{
          {one.robot()}, static_cast<run::InterventionRecord::Kind>(one.kind()), one.path(), one.value()};
    }
    case Body::kHeard:
      return run::input::Heard{{from.heard().vehicle(), from.heard().said()}};
    case Body::kExchanged:
    case Body::BODY_NOT_SET:
      break;
  }
  return std::nullopt;
}

}  // namespace mlab::history
