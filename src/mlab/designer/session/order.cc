#include "mlab/designer/session/order.h"

namespace mlab::designer {

// Longer than a function should be: it is a table. It has no `default:`, so a message without a line doesn't
// compile.
// NOLINTNEXTLINE(readability-function-size): a row for each message
Order Order::of(ToDesigner::BodyCase body) {
  using Core = DesignerCore;
  using Texts = DocumentOrders;
  using Names = NameOrders;
  using M = ToDesigner;
  using T = Table;
  using enum From;
  using enum Needs;
  constexpr auto kClients = &Core::clients_;
  constexpr auto kDocuments = &Core::document_orders_;
  constexpr auto kQuestions = &Core::questions_;
  constexpr auto kNames = &Core::name_orders_;
  constexpr auto kTrials = &Core::trials_;
  constexpr auto kMarks = &Core::marks_;
  constexpr auto kTests = &Core::test_orders_;
  constexpr auto kComparisons = &Core::comparisons_;
  switch (body) {
    case M::BODY_NOT_SET:
      return {};

    case M::kGreeting:
      return {kAnybody, kModels, T::taken_whole<&Core::greet, &M::greeting>};
    case M::kBeat:
      return {kAnybody, kNothing, T::taken<&Clients::beat, &M::beat, kClients>};
    case M::kLook:
      return {kGreeted, kModels, T::taken<&Clients::look, &M::look, kClients>};

    case M::kOpen:
      return {kGreeted, kModels, T::taken<&Texts::open, &M::open, kDocuments>};
    case M::kClose:
      return {kGreeted, kModels, T::taken<&Texts::close, &M::close, kDocuments>};
    case M::kDiscard:
      return {kGreeted, kModels, T::taken<&Texts::discard, &M::discard, kDocuments>};
    case M::kSave:
      return {kGreeted, kModels, T::taken<&Texts::save, &M::save, kDocuments>};
    case M::kReload:
      return {kGreeted, kModels, T::taken<&Texts::reload, &M::reload, kDocuments>};
    case M::kListFiles:
      return {kGreeted, kModels, T::taken<&Texts::list_files, &M::list_files, kDocuments>};
    case M::kEditText:
      return {kGreeted, kNothing, T::taken<&Texts::edit_text, &M::edit_text, kDocuments>};
    case M::kEdit:
      return {kGreeted, kModels, T::taken<&Texts::edit, &M::edit, kDocuments>};
    case M::kUndo:
      return {kGreeted, kModels, T::taken<&Texts::undo, &M::undo, kDocuments>};
    case M::kRedo:
      return {kGreeted, kModels, T::taken<&Texts::redo, &M::redo, kDocuments>};
    case M::kCopy:
      return {kGreeted, kModels, T::taken<&Texts::copy, &M::copy, kDocuments>};

    case M::kAskLanguage:
      return {kGreeted, kModels, T::taken<&Questions::ask_language, &M::ask_language, kQuestions>};
    case M::kDescribe:
      return {kGreeted, kModels, T::taken<&Questions::describe, &M::describe, kQuestions>};
    case M::kFits:
      return {kGreeted, kModels, T::taken<&Questions::fits, &M::fits, kQuestions>};

    case M::kFindUses:
      return {kGreeted, kModels, T::taken<&Names::find_uses, &M::find_uses, kNames>};
    case M::kPlanRename:
      return {kGreeted, kModels, T::taken<&Names::plan_rename, &M::plan_rename, kNames>};
    case M::kRenameEverywhere:
      return {kGreeted, kModels, T::taken<&Names::rename_everywhere, &M::rename_everywhere, kNames>};
    case M::kUndoRename:
      return {kGreeted, kModels, T::taken<&Names::undo_rename, &M::undo_rename, kNames>};
    case M::kSearch:
      return {kGreeted, kModels, T::taken<&Names::search, &M::search, kNames>};

    case M::kTry:
      return {kGreeted, kModels, T::taken<&Trials::try_out, &M::try_, kTrials>};
    case M::kFindLive:
      return {kGreeted, kModels, T::taken<&Trials::find_live, &M::find_live, kTrials>};
    case M::kWriteBack:
      return {kGreeted, kModels, T::taken<&Trials::write_back, &M::write_back, kTrials>};
    case M::kReadField:
      return {kGreeted, kModels, T::taken<&Fields::read, &M::read_field, &Core::fields_>};
    case M::kSetMark:
      return {kGreeted, kModels, T::taken<&MarkKeeper::set, &M::set_mark, kMarks>};
    case M::kRemoveMark:
      return {kGreeted, kModels, T::taken<&MarkKeeper::remove, &M::remove_mark, kMarks>};

    case M::kWatchTests:
      return {kGreeted, kModels, T::taken<&TestOrders::watch, &M::watch_tests, kTests>};
    case M::kRunTests:
      return {kGreeted, kModels, T::taken<&TestOrders::run, &M::run_tests, kTests>};
    case M::kShowTestCycle:
      return {kGreeted, kModels, T::taken<&TestOrders::show_cycle, &M::show_test_cycle, kTests>};
    case M::kAddTest:
      return {kGreeted, kModels, T::taken<&TestOrders::add, &M::add_test, kTests>};

    case M::kCompareWith:
      return {kGreeted, kModels, T::taken<&Comparisons::compare_with, &M::compare_with, kComparisons>};
    case M::kStopComparing:
      return {kGreeted, kModels, T::taken<&Comparisons::stop, &M::stop_comparing, kComparisons>};
    case M::kListRevisions:
      return {kGreeted, kModels, T::taken<&Comparisons::list_revisions, &M::list_revisions, kComparisons>};
  }
  return {};
}

}  // namespace mlab::designer
