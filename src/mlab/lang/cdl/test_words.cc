#include "mlab/lang/cdl/test_words.h"

#include <algorithm>
#include <iterator>

#include "mlab/base/table.h"

namespace mlab::cdl {
namespace {

constexpr std::array kObjectStyles = {TestObjectStyle{"fixed", percept::ObjectStyle::kFixed},
                                      TestObjectStyle{"movable", percept::ObjectStyle::kMovable},
                                      TestObjectStyle{"container", percept::ObjectStyle::kContainer}};
static_assert(base::has_a_row_for_each<kObjectStyles, &TestObjectStyle::style>());

using Request = percept::Request::Kind;
constexpr TestAction kActions[] = {
    {"PickUp", Request::kPickUp, "picks something up"},
    {"Drop", Request::kDrop, "puts down what it carries"},
    {"DropInBasket", Request::kDropInBasket, "puts what it carries into a basket"},
    {"Notify", Request::kNotify, "tells others, or itself, a notification"},
    {"AskToProceed", Request::kProceed, "asks the operator whether to go on"},
    {"TakeNotification", Request::kTakeNotification, "has heard a notification"},
    {"SharePlace", Request::kSharePlace, "tells the others a place"},
    {"AskPassage", Request::kAskPassage, "asks those in its way to let it through"},
    {"Claim", Request::kClaim, "claims an object for itself"},
    {"MarkObject", Request::kMarkObject, "marks an object as something else"},
    {"MarkDoor", Request::kMarkDoor, "marks a door"},
    {"UnmarkDoor", Request::kUnmarkDoor, "takes the mark off a door"},
    {"ShowAs", Request::kShowAs, "shows itself in another colour"},
    {"Localize", Request::kLocalize, "says where it is"},
    {"Halt", Request::kHalt, "ends its program"},
    {"EndMission", Request::kEndMission, "ends the mission for all"},
    {"AnnounceTask", Request::kAnnounceTask, "offers a task to its team"},
    {"BidOnTask", Request::kBid, "bids for a task that is on offer"},
    {"KeepTasks", Request::kKeepTasks, "still works on what it was awarded"},
    {"StartTask", Request::kStartTask, "begins with a task that it was awarded"},
    {"FinishTask", Request::kFinishTask, "tells that a task is done"},
    {"RenegeTask", Request::kRenegeTask, "gives a task back"},
    {"Alert", std::nullopt, "alerts the operator"},
    {"Done", std::nullopt, "says that its order is done"},
    {"Look", std::nullopt, "turns its camera"},
};

}  // namespace

const TestPerceptInfo* test_percept_named(std::string_view name) {
  const auto* const found = std::ranges::find(kTestPercepts, name, &TestPerceptInfo::name);
  return found == kTestPercepts.end() ? nullptr : found;
}

std::span<const TestObjectStyle> test_object_styles() {
  return kObjectStyles;
}

const TestObjectStyle* test_object_style_named(std::string_view name) {
  const auto* const found = std::ranges::find(kObjectStyles, name, &TestObjectStyle::name);
  return found == kObjectStyles.end() ? nullptr : found;
}

std::span<const TestAction> test_actions() {
  return kActions;
}

const TestAction* test_action_named(std::string_view name) {
  const auto* const found = std::ranges::find(kActions, name, &TestAction::name);
  return found == std::end(kActions) ? nullptr : found;
}

bool is_done(const TestAction& what, const percept::Action& action) {
  if (what.request) {
    const auto asked = std::span(action.requests).first(action.request_count);
    return std::ranges::find(asked, *what.request, &percept::Request::kind) != asked.end();
  }
  if (what.name == "Alert") return action.alert[0] != 0;
  if (what.name == "Done") return action.status.done;
  return action.looks;
}

}  // namespace mlab::cdl
