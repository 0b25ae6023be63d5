#include "mlab/designer/edit/change/wires.h"

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include <fmt/core.h>

#include "mlab/designer/drawing/shapes.h"
#include "mlab/designer/edit/find/followed.h"
#include "mlab/designer/edit/find/pages.h"
#include "mlab/designer/edit/values.h"
#include "mlab/text/shown.h"

namespace mlab::designer {
namespace {

using Kind = GraphNode::Kind;

std::optional<std::uint32_t> index_of(const auto& change) {
  return change.has_index() ? std::optional<std::uint32_t>(change.index()) : std::nullopt;
}

// Whether a block or a big call may stand there.
bool takes(const Spot& spot, const cdl::Expression& expression) {
  const GraphInput* input = spot.at();
  const Role role = input == nullptr ? Role::kMember : input->role;
  const bool is_line =
      role == Role::kMember || role == Role::kDrive || role == Role::kCase || role == Role::kValue;
  if (is_block(expression)) return is_line;
  return role != Role::kWeight || std::holds_alternative<cdl::Call>(expression.what);
}

// What nobody reads yet is written where it is read now, if it can stand there.
Done connect_let(PageWriter& pages, const PageView& view, int from, const Spot& to) {
  Workspace& work = pages.work();
  const GraphNode& source = view.node(from);
  const cdl::Let& let = *source.let;
  const bool is_alone = count_uses(*view.graph, let.name.text) == 0;
  const bool has_help = !let.help.empty() && (to.at() == nullptr || to.at()->role != Role::kMember);
  const bool makes_itself = to.node >= 0 && reaches(view, from, to.node);
  const bool is_inlined = is_alone && !has_help && !makes_itself && takes(to, *let.value) &&
                          source.kind != Kind::kValue && source.kind != Kind::kOuter;
  if (is_inlined) work.changes().remove(let);
  const Done done = pages.write(to, is_inlined ? bare_as(*let.value, let.name.text) : named(let.name.text));
  return done ? work.commit() : done;
}

}  // namespace

Done connect(PageWriter& pages, const Connect& change) {
  Workspace& work = pages.work();
  text::Result<PageView> view = find_page(work.model(), change.page());
  if (!view) return std::unexpected(view.error());
  const text::Result<int> from = find_node(*view, change.from_node());
  if (!from) return std::unexpected(from.error());
  const text::Result<Spot> to = find_spot(*view, change.to_node(), change.to_port(), index_of(change), true);
  if (!to) return std::unexpected(to.error());
  const GraphNode& source = view->node(*from);
  if (source.kind == Kind::kActuator) return refusal("an actuator gives no value");
  const GraphInput* input = to->at();
  if (input != nullptr && input->from == *from && !input->is_open) return true;
  if (const std::string reason = why_not(view->type_of(*from), wanted_type(work.model(), *to));
      !reason.empty())
    return refusal(reason);
  const bool is_delayed = input != nullptr && input->role == Role::kDelayed;
  if (to->node >= 0 && !is_delayed && reaches(*view, *from, to->node))
    return refusal(
        fmt::format("`{}` is made from `{}`: a loop needs a delay", source.name, view->node(to->node).name));

  if (source.parameter != nullptr) {
    const Done done = pages.write(*to, named(source.parameter->name.text));
    return done ? work.commit() : done;
  }
  if (source.kind == Kind::kOuter || source.let != nullptr) return connect_let(pages, *view, *from, *to);
  // It is written where it is read first: from now on both read a name.
  const std::string owner = view->graph->name;
  const int target = to->node < 0 ? -1 : follow(work, *view, to->node);
  const std::string name = pages.make_let(Spot{*view, source.reader, source.reader_input, ""});
  if (const Done done = work.commit(); !done) return done;
  Connect again = change;
  again.set_from_node(name);
  if (target >= 0) {
    const auto found = followed(work, owner, target);
    if (!found) return refusal("the node has gone");
    again.set_page(found->first.page->path);
    again.set_to_node(found->first.node(found->second).name);
  }
  return connect(pages, again);
}

Done disconnect(PageWriter& pages, const Disconnect& change) {
  Workspace& work = pages.work();
  const text::Result<PageView> view = find_page(work.model(), change.page());
  if (!view) return std::unexpected(view.error());
  const text::Result<Spot> to = find_spot(*view, change.to_node(), change.to_port(), index_of(change), false);
  if (!to) return std::unexpected(to.error());
  if (to->written() == nullptr) return refusal("nothing is connected there");
  const Done done = pages.clear(*to);
  return done ? work.commit() : done;
}

Done set_value(PageWriter& pages, const SetValue& change) {
  Workspace& work = pages.work();
  const text::Result<PageView> view = find_page(work.model(), change.page());
  if (!view) return std::unexpected(view.error());
  const bool is_new = change.has_index() || !change.value().empty();
  text::Result<Spot> to = find_spot(*view, change.node(), change.port(), index_of(change), false);
  if (!to && is_new) to = find_spot(*view, change.node(), change.port(), index_of(change), true);
  if (!to) return std::unexpected(to.error());
  if (change.value().empty()) {
    const Done done = pages.clear(*to);
    return done ? work.commit() : done;
  }
  const cdl::ExpressionPtr value = typed_value(change.value());
  if (!value) return refusal(fmt::format("`{}` is no value", text::shown(change.value())));
  const Done done = pages.write(*to, value);
  return done ? work.commit() : done;
}

}  // namespace mlab::designer
