#include "mlab/designer/edit/change/exposing.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "mlab/designer/drawing/shapes.h"
#include "mlab/designer/edit/change/equipment_values.h"
#include "mlab/designer/edit/change/parameters.h"
#include "mlab/designer/edit/find/devices.h"
#include "mlab/designer/edit/find/pages.h"
#include "mlab/designer/edit/values.h"
#include "mlab/lang/cdl/types/body.h"
#include "mlab/lang/cdl/types/units.h"
#include "mlab/text/shown.h"

namespace mlab::designer {
namespace {

std::string text_of(const Workspace& work, const cdl::Expression& expression) {
  const text::Span span = expression.place.span;
  return std::string(work.text().substr(span.begin, span.end - span.begin));
}

// The type and default of the parameter that something becomes.
text::Result<SetParameter> exposed(const Workspace& work, const Expose& change,
                                   const cdl::RobotClass& robot_class) {
  SetParameter out;
  if (change.node().starts_with(kBodyNode)) {
    const cdl::BodyProperty* property = cdl::body_property(change.port());
    if (property == nullptr) return refusal("what drive it has is no parameter");
    const auto known = std::ranges::find_if(robot_class.body, [&](const cdl::BodySetting& setting) {
      return setting.name.text == property->name;
    });
    const bool is_said = known != robot_class.body.end() && known->value;
    // A parameter is in SI units; its default may be in any.
    const auto unit = cdl::unit_named(property->unit);
    out.set_type(property->unit.empty() ? "number" : fmt::format("double [{}]", cdl::si_unit(*unit)));
    out.set_initial(is_said ? text_of(work, *known->value) : std::string(property->initial));
    return out;
  }
  const text::Result<DeviceSpot> spot = find_device(work.model(), change.page(), change.node());
  if (!spot) return std::unexpected(spot.error());
  if (spot->by == nullptr) return refusal("what type it has can't be told");
  const auto socket = std::ranges::find(spot->by->inputs, change.port(), &Socket::name);
  if (socket == spot->by->inputs.end() || socket->type.type == nullptr)
    return refusal("what type it has can't be told");
  const cdl::Argument* known = argument_of(spot->device->by, *spot->by, change.port());
  out.set_type(type_words(socket->type));
  out.set_initial(known != nullptr && known->value ? text_of(work, *known->value) : socket->initial);
  if (out.initial().empty()) return refusal("it needs a value first: a class's parameters have defaults");
  return out;
}

}  // namespace

Done expose_input(PageWriter& pages, const Expose& change) {
  Workspace& work = pages.work();
  const text::Result<PageView> view = find_page(work.model(), change.page());
  if (!view) return std::unexpected(view.error());
  text::Result<Spot> to =
      find_spot(*view, change.node(), change.port(),
                change.has_index() ? std::optional<std::uint32_t>(change.index()) : std::nullopt, false);
  if (!to) return std::unexpected(to.error());
  if (to->node < 0) return refusal("only an input of a node can be a parameter");
  const GraphInput& input = *to->at();
  if (input.from >= 0) return refusal("a wire drives it: disconnect it first");
  if (input.role == Role::kFormula)
    return refusal("a formula that reads nodes can't be a default: write the parameter's name into it");
  const GraphNode& there = view->node(to->node);
  const std::vector<Socket> all = sockets(there, work.model().components(), *view->graph);
  const auto socket = std::ranges::find(all, input.port, &Socket::name);
  if (socket == all.end() || socket->type.type == nullptr) return refusal("what type it has can't be told");
  std::string name = change.parameter();
  if (name.empty()) name = input.role == Role::kWeight ? "gain" : input.port;
  if (!is_cdl_name(name)) return refusal(fmt::format("`{}` is no name", text::shown(name)));
  const auto& parameters = view->graph->parameters();
  const auto known =
      std::ranges::find_if(parameters, [&](const cdl::Parameter& p) { return p.name.text == name; });
  if (known != parameters.end() && !change.parameter().empty()) {
    const std::string reason = why_not(work.model().components().types().of(*known), socket->type);
    if (!reason.empty()) return refusal(fmt::format("`{}` does not fit: {}", name, reason));
    const Done done = pages.write(*to, named(name));
    return done ? work.commit() : done;
  }
  if (pages.names().is_taken(*view->graph, name)) name = pages.names().free_name(*view->graph, name);
  std::string initial =
      input.written
          ? std::string(work.text().substr(input.written->place.span.begin,
                                           input.written->place.span.end - input.written->place.span.begin))
          : socket->initial;
  const auto* word = input.written ? std::get_if<cdl::Name>(&input.written->what) : nullptr;
  if (word != nullptr && pages.names().is_taken(*view->graph, word->name.text))
    return refusal(fmt::format("`{}` is one already", word->name.text));
  const bool has_unit = !initial.empty() && initial.find_first_not_of("0123456789.-+e") != std::string::npos;
  if (!initial.empty() && !has_unit && !socket->type.unit.empty()) initial += " " + socket->type.unit;
  if (input.role == Role::kWeight && initial.empty()) initial = "1";
  const std::string owner = view->graph->name;
  if (const Done done = pages.write(*to, named(name)); !done) return done;
  SetParameter parameter;
  parameter.set_owner(owner);
  parameter.set_name(name);
  parameter.set_type(input.role == Role::kWeight ? "gain" : type_words(socket->type));
  parameter.set_initial(initial);
  parameter.set_help("");
  return set_parameter(work, parameter);
}

Done expose_equipment(Workspace& work, const Expose& change) {
  const cdl::RobotClass* robot_class = equipped(work.model(), change.page()).robot_class;
  if (robot_class == nullptr) return refusal("an operator of societies has no parameters");
  const std::string name = change.parameter().empty() ? change.port() : change.parameter();
  if (!is_cdl_name(name)) return refusal(fmt::format("`{}` is no name", text::shown(name)));
  const bool is_known = std::ranges::any_of(robot_class->parameters,
                                            [&](const cdl::Parameter& one) { return one.name.text == name; });
  text::Result<SetParameter> parameter = exposed(work, change, *robot_class);
  if (!parameter) return std::unexpected(parameter.error());
  if (parameter->initial() == name) return refusal(fmt::format("`{}` is one already", name));
  if (is_known && change.parameter().empty())
    return refusal(fmt::format("there is a parameter `{}` already: type its name", name));
  if (!is_known) {
    parameter->set_owner(change.page());
    parameter->set_name(name);
    if (const Done done = set_parameter(work, *parameter); !done) return done;
  }
  SetValue reads;
  reads.set_page(change.page());
  reads.set_node(change.node());
  reads.set_port(change.port());
  reads.set_value(name);
  return set_equipment_value(work, reads);
}

}  // namespace mlab::designer
