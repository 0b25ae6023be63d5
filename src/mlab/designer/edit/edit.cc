#include "mlab/designer/edit/edit.h"

#include <utility>

#include <fmt/core.h>

#include "mlab/designer/edit/apply.h"
#include "mlab/designer/edit/page_writer.h"
#include "mlab/designer/edit/workspace.h"

namespace mlab::designer {
namespace {

constexpr int kMostChanges = 10'000;

std::string several(int count, const std::string& one, const char* what) {
  return count == 1 ? one : fmt::format("{} {}", count, what);
}

// For undo, where the browser says nothing.
// NOLINTNEXTLINE(readability-function-size): a sentence for each change
std::string name_of(const Change& change) {
  switch (change.change_case()) {
    case Change::kPlace:
      return "place " + change.place().component();
    case Change::kRemove:
      return "remove " + (change.remove().nodes().empty()
                              ? std::string()
                              : several(change.remove().nodes_size(), change.remove().nodes(0), "nodes"));
    case Change::kConnect:
      return change.connect().to_node() == "$result"
                 ? fmt::format("connect {} to the result", change.connect().from_node())
                 : fmt::format("connect {} to {}", change.connect().from_node(), change.connect().to_node());
    case Change::kDisconnect:
      return fmt::format("disconnect {} of {}", change.disconnect().to_port(), change.disconnect().to_node());
    case Change::kSetValue:
      return fmt::format("set {} of {}", change.set_value().port(), change.set_value().node());
    case Change::kExpose:
      return fmt::format("expose {} of {}", change.expose().port(), change.expose().node());
    case Change::kRename:
      return fmt::format("rename {} to {}", change.rename().node(), change.rename().name());
    case Change::kArrange:
      return "move " + several(change.arrange().nodes_size(),
                               change.arrange().nodes().empty() ? "" : change.arrange().nodes(0).node(),
                               "nodes");
    case Change::kSetActive:
      return "change the active part of " + change.set_active().node();
    case Change::kGroup:
      return "make assemblage " + change.group().name();
    case Change::kUngroup:
      return "take apart " + change.ungroup().node();
    case Change::kPaste:
      return "paste";
    case Change::kSetNote:
      return change.set_note().is_frame() ? "change a frame" : "change a note";
    case Change::kReplace:
      return fmt::format("replace {} by {}", change.replace().node(), change.replace().component());
    case Change::kAddDeclaration:
      return fmt::format("add {} {}", change.add_declaration().kind(), change.add_declaration().name());
    case Change::kSetParameter:
      return "change parameter " + change.set_parameter().name();
    case Change::kRemoveParameter:
      return "remove parameter " + change.remove_parameter().name();
    case Change::kSetHelp:
      return "describe " +
             (change.set_help().node().empty() ? change.set_help().page() : change.set_help().node());
    case Change::kCopyComponent:
      return "copy " + change.copy_component().component();
    case Change::kAddState:
      return "add a state";
    case Change::kSetState:
      return "change state " + change.set_state().state();
    case Change::kAddTransition:
      return fmt::format("add transition {} to {}", change.add_transition().from(),
                         change.add_transition().to());
    case Change::kSetTransition:
      return "change a transition of " + change.set_transition().from();
    case Change::kChangeTrigger:
      return "change a trigger of " + change.change_trigger().from();
    case Change::kRemoveTransition:
      return "remove a transition of " + change.remove_transition().from();
    case Change::kSetClass:
      return change.set_class().class_name().empty() ? "make the robot abstract"
                                                     : "make it a " + change.set_class().class_name();
    case Change::kUseDevice:
      return "use " + change.use_device().device();
    case Change::kSetMember:
      return "change a member";
    case Change::kRemoveMember:
      return "remove a member";
    case Change::kSetDevice:
      return change.set_device().device().empty() ? "add a device for " + change.set_device().binds()
                                                  : "change device " + change.set_device().device();
    case Change::kSetBinding:
      return "change what " + change.set_binding().binding() + " gives";
    case Change::kGroupMembers:
      return "make a caste of " + several(change.group_members().members_size(), "a member", "members");
    case Change::kUngroupMembers:
      return "take a caste apart";
    case Change::kMoveMember:
      return "move a member";
    case Change::CHANGE_NOT_SET:
      break;
  }
  return "edit";
}

}  // namespace

text::Result<Edited> edited(std::shared_ptr<const Model> model, const cdl::Environment& environment,
                            const Edit& edit, const std::vector<Offered>& offered) {
  if (!model->is_readable()) return refusal("the text has a slip of grammar: mend it first");
  if (edit.changes().empty()) return refusal("nothing is to be changed");
  if (edit.changes_size() > kMostChanges) return refusal("too many changes at once");
  const std::vector<std::string> files = files_needed(edit, *model, offered);
  Workspace work(std::move(model), environment);
  for (const std::string& file : files) {
    if (const Done done = add_use(work, file); !done) return std::unexpected(done.error());
  }
  PageWriter pages(work);
  for (const Change& change : edit.changes()) {
    if (const Done done = apply(pages, change); !done) return std::unexpected(done.error());
  }
  return Edited{std::string(work.text()), edit.name().empty() ? name_of(edit.changes(0)) : edit.name()};
}

}  // namespace mlab::designer
