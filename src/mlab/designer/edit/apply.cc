#include "mlab/designer/edit/apply.h"

#include "mlab/designer/edit/change/declarations.h"
#include "mlab/designer/edit/change/devices.h"
#include "mlab/designer/edit/change/equipment_values.h"
#include "mlab/designer/edit/change/exposing.h"
#include "mlab/designer/edit/change/groups.h"
#include "mlab/designer/edit/change/help.h"
#include "mlab/designer/edit/change/layout.h"
#include "mlab/designer/edit/change/names.h"
#include "mlab/designer/edit/change/nodes.h"
#include "mlab/designer/edit/change/parameters.h"
#include "mlab/designer/edit/change/paste.h"
#include "mlab/designer/edit/change/robots.h"
#include "mlab/designer/edit/change/societies.h"
#include "mlab/designer/edit/change/states.h"
#include "mlab/designer/edit/change/triggers.h"
#include "mlab/designer/edit/change/wires.h"
#include "mlab/designer/edit/find/devices.h"

namespace mlab::designer {

// NOLINTNEXTLINE(readability-function-size): a row for each change
Done apply(PageWriter& pages, const Change& change) {
  Workspace& work = pages.work();
  const auto is_device = [&](const auto& one) { return is_equipment(work.model(), one.page()); };
  switch (change.change_case()) {
    case Change::kPlace:
      return is_device(change.place()) ? place_device(work, change.place())
                                       : place_node(pages, change.place());
    case Change::kRemove:
      if (change.remove().page().empty()) return remove_declarations(work, change.remove());
      return is_device(change.remove()) ? remove_devices(work, change.remove())
                                        : remove_from_page(pages, change.remove());
    case Change::kConnect:
      return is_device(change.connect()) ? connect_device(work, change.connect())
                                         : connect(pages, change.connect());
    case Change::kDisconnect:
      if (is_device(change.disconnect()))
        return refusal("a device serves a binding point: lead it to another one, or remove it");
      return disconnect(pages, change.disconnect());
    case Change::kSetValue:
      return is_device(change.set_value()) ? set_equipment_value(work, change.set_value())
                                           : set_value(pages, change.set_value());
    case Change::kExpose:
      return is_device(change.expose()) ? expose_equipment(work, change.expose())
                                        : expose_input(pages, change.expose());
    case Change::kRename:
      return rename(work, pages.names(), change.rename());
    case Change::kArrange:
      return arrange(work, change.arrange());
    case Change::kSetActive:
      return set_active(pages, change.set_active());
    case Change::kGroup:
      return group_nodes(work, change.group());
    case Change::kUngroup:
      return ungroup_node(work, change.ungroup());
    case Change::kPaste:
      return paste(work, change.paste());
    case Change::kSetNote:
      return set_note(work, change.set_note());
    case Change::kReplace:
      return is_device(change.replace()) ? replace_device(work, change.replace())
                                         : replace_node(pages, change.replace());
    case Change::kAddDeclaration:
      return add_declaration(work, change.add_declaration());
    case Change::kSetParameter:
      return set_parameter(work, change.set_parameter());
    case Change::kRemoveParameter:
      return remove_parameter(pages, change.remove_parameter());
    case Change::kSetHelp:
      return set_help(work, change.set_help());
    case Change::kCopyComponent:
      return copy_component(work, change.copy_component());
    case Change::kAddState:
      return add_state(work, change.add_state());
    case Change::kSetState:
      return set_state(work, change.set_state());
    case Change::kAddTransition:
      return add_transition(work, change.add_transition());
    case Change::kSetTransition:
      return set_transition(work, change.set_transition());
    case Change::kRemoveTransition:
      return remove_transition(work, change.remove_transition());
    case Change::kChangeTrigger:
      return change_trigger(work, change.change_trigger());
    case Change::kSetDevice:
      return set_device(work, change.set_device());
    case Change::kSetBinding:
      return set_binding(work, change.set_binding());
    case Change::kGroupMembers:
      return group_members(work, change.group_members());
    case Change::kUngroupMembers:
      return ungroup_members(work, change.ungroup_members());
    case Change::kMoveMember:
      return move_member(work, change.move_member());
    case Change::kSetClass:
      return set_class(work, change.set_class());
    case Change::kUseDevice:
      return use_device(work, change.use_device());
    case Change::kSetMember:
      return set_member(work, change.set_member());
    case Change::kRemoveMember:
      return remove_member(work, change.remove_member());
    case Change::CHANGE_NOT_SET:
      break;
  }
  return refusal("nothing is to be changed");
}

}  // namespace mlab::designer
