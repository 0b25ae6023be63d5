#include "mlab/designer/edit/change/help.h"

#include <string>

#include <fmt/core.h>

#include "mlab/designer/edit/find/declared.h"
#include "mlab/designer/edit/find/devices.h"
#include "mlab/designer/edit/find/pages.h"
#include "mlab/designer/edit/values.h"
#include "mlab/text/shown.h"

namespace mlab::designer {
namespace {

template <class X>
Done write_help(Workspace& work, const X& what, const std::string& help) {
  work.changes().change<X>(what, [help](X& now) { now.help = help; });
  return work.commit();
}

Done set_declaration_help(Workspace& work, const std::string& name, const std::string& help) {
  const auto note = [&]<class X>(const X& one) {
    work.changes().change<X>(one, [help](X& now) { now.help = help; });
  };
  if (!visit_declaration(work.model().tree(), name, note))
    return refusal(fmt::format("there is no `{}`", text::shown(name)));
  return work.commit();
}

}  // namespace

Done set_help(Workspace& work, const SetHelp& change) {
  if (change.page().empty()) return set_declaration_help(work, change.node(), change.text());
  if (change.node().empty() && change.page().find('.') == std::string::npos)
    return set_declaration_help(work, change.page(), change.text());
  if (is_equipment(work.model(), change.page())) {
    const text::Result<DeviceSpot> spot = find_device(work.model(), change.page(), change.node());
    return spot ? write_help(work, *spot->device, change.text()) : std::unexpected(spot.error());
  }
  const text::Result<PageView> view = find_page(work.model(), change.page());
  if (!view) return std::unexpected(view.error());
  if (change.node().empty()) {
    if (view->page->state != nullptr) return write_help(work, *view->page->state, change.text());
    return refusal("this page has no help of its own");
  }
  if (view->page->sequence != nullptr) {
    for (const cdl::State& state : view->page->sequence->states) {
      if (state.name.text == change.node()) return write_help(work, state, change.text());
    }
  }
  const text::Result<int> at = find_node(*view, change.node());
  if (!at) return std::unexpected(at.error());
  const GraphNode& there = view->node(*at);
  if (there.parameter != nullptr) return write_help(work, *there.parameter, change.text());
  if (there.let != nullptr) return write_help(work, *there.let, change.text());
  // A member of an operator has its line.
  const GraphInput* input =
      there.reader < 0 ? nullptr
                       : &view->node(there.reader).inputs[static_cast<std::size_t>(there.reader_input)];
  if (input == nullptr || input->role != Role::kMember)
    return refusal("only what has a line of its own can have help: a name, a member, a state");
  const auto& members = *members_of(*view->node(there.reader).expression);
  return write_help(work, members[static_cast<std::size_t>(input->at)], change.text());
}

}  // namespace mlab::designer
