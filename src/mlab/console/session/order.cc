#include "mlab/console/session/order.h"

#include <functional>
#include <type_traits>

namespace mlab::console {
namespace {

// Hands a message to a function that wants to know what is left out here: who sent it, what it says, what it
// is answered.
template <class Part, class Take, class Message>
Answered handed(Part& part, Take take, const Sender& sender, const Message& message, Reply& reply) {
  const auto call = [&](const auto&... what) -> Answered {
    if constexpr (std::is_void_v<std::invoke_result_t<Take, Part&, decltype(what)...>>) {
      std::invoke(take, part, what...);
      return std::nullopt;
    } else {
      return std::invoke(take, part, what...);
    }
  };
  if constexpr (std::is_invocable_v<Take, Part&, const Sender&, const Message&, Reply&>)
    return std::invoke(take, part, sender, message, reply);
  else if constexpr (std::is_invocable_v<Take, Part&, const Message&, Reply&>)
    return std::invoke(take, part, message, reply);
  else if constexpr (std::is_invocable_v<Take, Part&, const Sender&, const Message&>)
    return call(sender, message);
  else if constexpr (std::is_invocable_v<Take, Part&, const Message&>)
    return call(message);
  else
    return call(sender);
}

// A part of the core takes the message.
template <auto kTake, auto kMessage, auto kPart>
Answered taken(SessionCore& core, const Sender& sender, const ToServer& message, Reply& reply) {
  return handed(core.*kPart, kTake, sender, (message.*kMessage)(), reply);
}

// The core itself does.
template <auto kTake, auto kMessage>
Answered taken_whole(SessionCore& core, const Sender& sender, const ToServer& message, Reply& reply) {
  return handed(core, kTake, sender, (message.*kMessage)(), reply);
}

// It has done what it is for before it was read.
Answered taken_before(SessionCore& /*core*/, const Sender& /*anybody*/, const ToServer& /*no more is said*/,
                      Reply& /*says nothing*/) {
  return std::nullopt;
}

}  // namespace

// Longer than a function should be: it is a table. It has no `default:`, so a message without a line doesn't
// compile.
// NOLINTNEXTLINE(readability-function-size): a row for each message
Order Order::of(ToServer::BodyCase body) {
  using Core = SessionCore;
  using Run = RunOrders;
  using Texts = DocumentOrders;
  using M = ToServer;
  using enum From;
  using enum Inbox::Kind;
  constexpr auto kRun = &Core::run_orders_;
  constexpr auto kDocuments = &Core::document_orders_;
  constexpr auto kFrames = &Core::frames_;
  constexpr auto kPeople = &Core::people_;
  constexpr auto kMaker = &Core::maker_;
  switch (body) {
    case M::BODY_NOT_SET:
    case M::kHello:
      return {};

    case M::kAcknowledge:
      return {kAnybody, kAtOnce, taken<&People::acknowledge, &M::acknowledge, kPeople>};
    case M::kBeat:
      return {kAnybody, kAtOnce, taken<&People::beat, &M::beat, kPeople>};
    case M::kEmergencyStop:
      return {kAnybody, kAtOnce, taken_before};
    case M::kWatch:
      return {kAnybody, kAfterCycle, taken<&Frames::watch, &M::watch, kFrames>};
    case M::kReadSeries:
      return {kAnybody, kDuringCycle, taken<&Frames::read_series, &M::read_series, kFrames>};
    case M::kTakeOperator:
      return {kAnybody, kDuringCycle, taken_whole<&Core::take_operator, &M::take_operator>};
    case M::kPassOperator:
      return {kAnybody, kDuringCycle, taken_whole<&Core::pass_operator, &M::pass_operator>};
    case M::kComplete:
      return {kAnybody, kDuringCycle, taken<&Texts::complete, &M::complete, kDocuments>};
    case M::kCheck:
      return {kAnybody, kDuringCycle, taken<&Texts::check, &M::check, kDocuments>};
    case M::kListFiles:
      return {kAnybody, kDuringCycle, taken<&Texts::list_files, &M::list_files, kDocuments>};

    case M::kControl:
      return {kOperator, kAfterCycle, taken_whole<&Core::control, &M::control>};
    case M::kSetSpeed:
      return {kOperator, kAfterCycle, taken<&Run::set_speed, &M::set_speed, kRun>};
    case M::kAnswer:
      return {kOperator, kAfterCycle, taken<&Run::answer, &M::answer, kRun>};
    case M::kStartTeleoperation:
      return {kOperator, kAfterCycle, taken<&Run::start_teleoperation, &M::start_teleoperation, kRun>};
    case M::kStick:
      return {kOperator, kAfterCycle, taken<&Run::stick, &M::stick, kRun>};
    case M::kEndTeleoperation:
      return {kOperator, kAfterCycle, taken<&Run::end_teleoperation, &M::end_teleoperation, kRun>};
    case M::kSetBreakpoint:
      return {kOperator, kAfterCycle, taken<&Run::set_breakpoint, &M::set_breakpoint, kRun>};
    case M::kRemoveBreakpoint:
      return {kOperator, kAfterCycle, taken<&Run::remove_breakpoint, &M::remove_breakpoint, kRun>};
    case M::kForceState:
      return {kOperator, kAfterCycle, taken<&Run::force_state, &M::force_state, kRun>};
    case M::kHoldValue:
      return {kOperator, kAfterCycle, taken<&Run::hold_value, &M::hold_value, kRun>};
    case M::kReleaseValue:
      return {kOperator, kAfterCycle, taken<&Run::release_value, &M::release_value, kRun>};
    case M::kTyped:
      return {kOperator, kAfterCycle, taken<&RunMaker::typed, &M::typed, kMaker>};
    case M::kSetOption:
      return {kOperator, kAfterCycle, taken<&RunMaker::set_option, &M::set_option, kMaker>};
    case M::kSetParameter:
      return {kOperator, kAfterCycle, taken<&RobotParameters::set, &M::set_parameter, &Core::parameters_>};

    case M::kEditText:
      return {kOperator, kAfterCycle, taken<&Texts::edit_text, &M::edit_text, kDocuments>};
    case M::kEditMap:
      return {kOperator, kAfterCycle, taken<&Texts::edit_map, &M::edit_map, kDocuments>};
    case M::kCreateObstacles:
      return {kOperator, kAfterCycle, taken<&Texts::create_obstacles, &M::create_obstacles, kDocuments>};
    case M::kUndo:
      return {kOperator, kAfterCycle, taken<&Texts::undo, &M::undo, kDocuments>};
    case M::kRedo:
      return {kOperator, kAfterCycle, taken<&Texts::redo, &M::redo, kDocuments>};
    case M::kOpenMission:
      return {kOperator, kEndsWait, taken<&Texts::open, &M::open_mission, kDocuments>};
    case M::kNewDocument:
      return {kOperator, kAfterCycle, taken<&Texts::create, &M::new_document, kDocuments>};
    case M::kSaveDocuments:
      return {kOperator, kDuringCycle, taken<&Texts::save, &M::save_documents, kDocuments>};
    case M::kReloadDocument:
      return {kOperator, kAfterCycle, taken<&Texts::reload, &M::reload_document, kDocuments>};
  }
  return {};
}

Inbox::Kind Order::kind_of(const ToServer& message) {
  const bool ends_run = message.has_control() && (message.control().action() == Control::ABORT ||
                                                  message.control().action() == Control::RESTART);
  return ends_run ? Inbox::Kind::kEndsWait : of(message.body_case()).when;
}

bool Order::is_for_operator(const ToServer& message) {
  const bool looks_only = message.has_typed() && message.typed().preview();
  return of(message.body_case()).from == From::kOperator && !looks_only;
}

}  // namespace mlab::console
