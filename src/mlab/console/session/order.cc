#include "mlab/console/session/order.h"

namespace mlab::console {

// Longer than a function should be: it is a table. It has no `default:`, so a message without a line doesn't
// compile.
// NOLINTNEXTLINE(readability-function-size): a row for each message
Order Order::of(ToServer::BodyCase body) {
  using Core = SessionCore;
  using Run = RunOrders;
  using Texts = DocumentOrders;
  using Names = NameOrders;
  using M = ToServer;
  using T = Table;
  using enum From;
  using enum Inbox::Kind;
  constexpr auto kRun = &Core::run_orders_;
  constexpr auto kDocuments = &Core::document_orders_;
  constexpr auto kNames = &Core::name_orders_;
  constexpr auto kPreflight = &Core::preflight_orders_;
  constexpr auto kTrials = &Core::failsafe_trials_;
  constexpr auto kFrames = &Core::frames_;
  constexpr auto kPeople = &Core::people_;
  constexpr auto kMaker = &Core::maker_;
  constexpr auto kPast = &Core::look_backs_;
  constexpr auto kBookmarks = &Core::bookmark_orders_;
  using Futures = OtherFutures;
  constexpr auto kFutures = &Core::other_futures_;
  constexpr auto kResumption = &Core::resumption_;
  switch (body) {
    case M::BODY_NOT_SET:
    case M::kHello:
      return {};

    case M::kAcknowledge:
      return {kAnybody, kAtOnce, T::taken<&People::acknowledge, &M::acknowledge, kPeople>};
    case M::kBeat:
      return {kAnybody, kAtOnce, T::taken<&People::beat, &M::beat, kPeople>};
    case M::kEmergencyStop:
      return {kAnybody, kAtOnce, T::taken_before};
    case M::kWatch:
      return {kAnybody, kAfterCycle, T::taken<&Frames::watch, &M::watch, kFrames>};
    case M::kReadSeries:
      return {kAnybody, kDuringCycle, T::taken<&Frames::read_series, &M::read_series, kFrames>};
    case M::kTakeOperator:
      return {kAnybody, kDuringCycle, T::taken_whole<&Core::take_operator, &M::take_operator>};
    case M::kPassOperator:
      return {kAnybody, kDuringCycle, T::taken_whole<&Core::pass_operator, &M::pass_operator>};
    case M::kComplete:
      return {kAnybody, kDuringCycle, T::taken<&Texts::complete, &M::complete, kDocuments>};
    case M::kCheck:
      return {kAnybody, kDuringCycle, T::taken<&Texts::check, &M::check, kDocuments>};
    case M::kListFiles:
      return {kAnybody, kDuringCycle, T::taken<&Texts::list_files, &M::list_files, kDocuments>};
    case M::kFindDefinition:
      return {kAnybody, kDuringCycle, T::taken<&Names::find_definition, &M::find_definition, kNames>};
    case M::kFindUses:
      return {kAnybody, kDuringCycle, T::taken<&Names::find_uses, &M::find_uses, kNames>};
    case M::kReadSaid:
      return {kAnybody, kAfterCycle, T::taken<&Run::read_said, &M::read_said, kRun>};
    case M::kReadText:
      return {kAnybody, kDuringCycle, T::taken<&Names::read_text, &M::read_text, kNames>};
    case M::kCheckVehicles:
      return {kAnybody, kDuringCycle, T::taken<&PreflightOrders::check, &M::check_vehicles, kPreflight>};
    case M::kTryFailsafes:
      return {kAnybody, kAfterCycle, T::taken<&FailsafeTrials::try_out, &M::try_failsafes, kTrials>};

    case M::kLookBack:
      return {kAnybody, kDuringCycle, T::taken<&LookBacks::look_back, &M::look_back, kPast>};
    case M::kReadPast:
      return {kAnybody, kDuringCycle, T::taken<&LookBacks::read_past, &M::read_past, kPast>, true};
    case M::kFindMoments:
      return {kAnybody, kDuringCycle, T::taken<&LookBacks::find_moments, &M::find_moments, kPast>, true};

    case M::kReadChangeable:
      return {kAnybody, kDuringCycle, T::taken<&Futures::read_changeable, &M::read_changeable, kFutures>,
              true};
    case M::kWhatIf:
      return {kAnybody, kDuringCycle, T::taken<&Futures::what_if, &M::what_if, kFutures>, true};
    case M::kForgetFuture:
      return {kAnybody, kDuringCycle, T::taken<&Futures::forget_future, &M::forget_future, kFutures>};
    case M::kSaveFuture:
      return {kAnybody, kDuringCycle, T::taken<&Futures::save, &M::save_future, kFutures>, true};

    case M::kControl:
      return {kOperatorNow, kAfterCycle, T::taken_whole<&Core::control, &M::control>};
    case M::kSetSpeed:
      return {kOperatorNow, kAfterCycle, T::taken<&Run::set_speed, &M::set_speed, kRun>};
    case M::kAnswer:
      return {kOperatorNow, kAfterCycle, T::taken<&Run::answer, &M::answer, kRun>};
    case M::kStartTeleoperation:
      return {kOperatorNow, kAfterCycle, T::taken<&Run::start_teleoperation, &M::start_teleoperation, kRun>};
    case M::kStick:
      return {kOperatorNow, kAfterCycle, T::taken<&Run::stick, &M::stick, kRun>};
    case M::kEndTeleoperation:
      return {kOperatorNow, kAfterCycle, T::taken<&Run::end_teleoperation, &M::end_teleoperation, kRun>};
    case M::kSetBreakpoint:
      return {kOperator, kAfterCycle, T::taken<&Run::set_breakpoint, &M::set_breakpoint, kRun>};
    case M::kRemoveBreakpoint:
      return {kOperator, kAfterCycle, T::taken<&Run::remove_breakpoint, &M::remove_breakpoint, kRun>};
    case M::kForceState:
      return {kOperatorNow, kAfterCycle, T::taken<&Run::force_state, &M::force_state, kRun>};
    case M::kHoldValue:
      return {kOperatorNow, kAfterCycle, T::taken<&Run::hold_value, &M::hold_value, kRun>};
    case M::kReleaseValue:
      return {kOperatorNow, kAfterCycle, T::taken<&Run::release_value, &M::release_value, kRun>};
    case M::kReplaceRobot:
      return {kOperatorNow, kAfterCycle, T::taken<&Run::replace_robot, &M::replace_robot, kRun>};
    case M::kSignPreflight:
      return {kOperatorNow, kAfterCycle, T::taken<&PreflightOrders::sign, &M::sign_preflight, kPreflight>,
              true};
    case M::kTyped:
      return {kOperatorNow, kAfterCycle, T::taken<&RunMaker::typed, &M::typed, kMaker>};
    case M::kSetOption:
      return {kOperatorNow, kAfterCycle, T::taken<&RunMaker::set_option, &M::set_option, kMaker>};
    case M::kSetParameter:
      return {kOperatorNow, kAfterCycle,
              T::taken<&RobotParameters::set, &M::set_parameter, &Core::parameters_>};

    case M::kEditText:
      return {kOperator, kAfterCycle, T::taken<&Texts::edit_text, &M::edit_text, kDocuments>};
    case M::kEditMap:
      return {kOperator, kAfterCycle, T::taken<&Texts::edit_map, &M::edit_map, kDocuments>};
    case M::kCreateObstacles:
      return {kOperator, kAfterCycle, T::taken<&Texts::create_obstacles, &M::create_obstacles, kDocuments>};
    case M::kUndo:
      return {kOperator, kAfterCycle, T::taken<&Texts::undo, &M::undo, kDocuments>};
    case M::kRedo:
      return {kOperator, kAfterCycle, T::taken<&Texts::redo, &M::redo, kDocuments>};
    case M::kOpenMission:
      return {kOperator, kEndsWait, T::taken<&Texts::open, &M::open_mission, kDocuments>};
    case M::kNewDocument:
      return {kOperator, kAfterCycle, T::taken<&Texts::create, &M::new_document, kDocuments>};
    case M::kSaveDocuments:
      return {kOperator, kDuringCycle, T::taken<&Texts::save, &M::save_documents, kDocuments>};
    case M::kReloadDocument:
      return {kOperator, kAfterCycle, T::taken<&Texts::reload, &M::reload_document, kDocuments>};
    case M::kPlanRename:
      return {kOperator, kDuringCycle, T::taken<&Names::plan, &M::plan_rename, kNames>};
    case M::kContinueRun:
      return {kOperator, kEndsWait, T::taken<&Resumption::continue_run, &M::continue_run, kResumption>};
    case M::kSetBookmark:
      return {kOperatorEver, kAfterCycle, T::taken<&BookmarkOrders::set, &M::set_bookmark, kBookmarks>};
    case M::kRemoveBookmark:
      return {kOperatorEver, kAfterCycle, T::taken<&BookmarkOrders::remove, &M::remove_bookmark, kBookmarks>};
    case M::kRenameEverywhere:
      return {kOperator, kAfterCycle, T::taken<&Names::rename, &M::rename_everywhere, kNames>};
  }
  return {};
}

Inbox::Kind Order::kind_of(const ToServer& message) {
  const bool ends_run = message.has_control() && (message.control().action() == Control::ABORT ||
                                                  message.control().action() == Control::RESTART);
  return ends_run ? Inbox::Kind::kEndsWait : of(message.body_case()).when;
}

bool Order::is_to_be_kept(const ToServer& message) {
  return of(message.body_case()).from != From::kAnybody || message.has_emergency_stop() ||
         message.has_take_operator() || message.has_pass_operator();
}

bool Order::is_for_operator(const ToServer& message) {
  const bool looks_only = message.has_typed() && message.typed().preview();
  return of(message.body_case()).from != From::kAnybody && !looks_only;
}

}  // namespace mlab::console
