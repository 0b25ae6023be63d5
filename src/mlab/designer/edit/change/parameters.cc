#include "mlab/designer/edit/change/parameters.h"

#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/core.h>

#include "mlab/designer/drawing/serving.h"
#include "mlab/designer/edit/find/declared.h"
#include "mlab/designer/edit/find/devices.h"
#include "mlab/designer/edit/find/pages.h"
#include "mlab/designer/edit/values.h"
#include "mlab/lang/cdl/syntax/parser.h"
#include "mlab/text/shown.h"

namespace mlab::designer {
namespace {

// Calls `visit` with the assemblage, robot or class of a name; with the robot where a class has the same.
void visit_owner(const Model& model, std::string_view name, const auto& visit) {
  if (const cdl::Assemblage* assemblage = model.assemblage(name))
    visit(*assemblage);
  else if (const cdl::Robot* robot = model.robot(name))
    visit(*robot);
  else if (const cdl::RobotClass* robot_class = model.robot_class(name))
    visit(*robot_class);
  else if (const cdl::Binding* binding = model.binding(name))
    visit(*binding);
}

// Of an assemblage, a robot, a class, a binding point; null: there is none.
const std::vector<cdl::Parameter>* parameters_of(const Model& model, std::string_view owner) {
  const std::vector<cdl::Parameter>* out = nullptr;
  visit_owner(model, owner, [&](const auto& one) { out = &one.parameters; });
  return out;
}

// As it is said; what has no type yet has one that is not used.
text::Result<cdl::Parameter> parameter_of(const SetParameter& change) {
  std::string words = fmt::format("assemblage A({}: {}", change.name(),
                                  change.type().empty() ? std::string("gain") : change.type());
  if (!change.initial().empty()) words += " = " + change.initial();
  if (!change.low().empty()) words += fmt::format(" in {} .. {}", change.low(), change.high());
  text::Diagnostics sink;
  const cdl::Tree tree = cdl::parse(std::make_shared<const text::Source>("", words + "\n);"), sink);
  const auto* holder = tree.items.size() == 1 ? std::get_if<cdl::Assemblage>(&tree.items.front()) : nullptr;
  if (sink.has_errors()) return refusal(fmt::format("that can't be read: {}", sink.items().front().message));
  if (holder == nullptr || holder->parameters.size() != 1) return refusal("that can't be read");
  cdl::Parameter out = holder->parameters.front();
  out.help = change.help();
  out.name.place = {};
  out.whole = {};
  return out;
}

// @param stays  what is not said stays as it is
void change_parameter(Workspace& work, const cdl::Parameter& old, const cdl::Parameter& said, bool stays) {
  work.changes().change<cdl::Parameter>(old, [said, stays](cdl::Parameter& now) {
    if (!stays) {
      now.type = said.type;
      now.unit = said.unit;
    }
    if (!stays || said.initial) now.initial = said.initial;
    if (!stays || said.low) {
      now.low = said.low;
      now.high = said.high;
    }
    if (!stays || !said.help.empty()) now.help = said.help;
  });
}

}  // namespace

Done set_parameter(Workspace& work, const SetParameter& change) {
  const std::vector<cdl::Parameter>* all = parameters_of(work.model(), change.owner());
  if (all == nullptr) return refusal(fmt::format("there is no `{}`", text::shown(change.owner())));
  if (!is_cdl_name(change.name())) return refusal(fmt::format("`{}` is no name", text::shown(change.name())));
  for (const std::string* value : {&change.initial(), &change.low(), &change.high()}) {
    if (!value->empty() && !typed_value(*value))
      return refusal(fmt::format("`{}` is no value", text::shown(*value)));
  }
  if (change.low().empty() != change.high().empty()) return refusal("a range has two ends");
  const auto known =
      std::ranges::find_if(*all, [&](const cdl::Parameter& p) { return p.name.text == change.name(); });
  if (known == all->end() && change.type().empty()) return refusal("a parameter has a type");
  bool is_let = false;
  visit_owner(work.model(), change.owner(), [&](const auto& one) {
    if constexpr (requires { one.lets; })
      is_let =
          std::ranges::any_of(one.lets, [&](const cdl::Let& let) { return let.name.text == change.name(); });
  });
  if (known == all->end() && is_let) return refusal(fmt::format("`{}` is taken already", change.name()));
  const text::Result<cdl::Parameter> said = parameter_of(change);
  if (!said) return std::unexpected(said.error());
  if (known != all->end()) {
    change_parameter(work, *known, *said, change.type().empty());
  } else {
    visit_owner(work.model(), change.owner(), [&]<class X>(const X& one) {
      work.changes().change<X>(one, [said = *said](X& now) { now.parameters.push_back(said); });
    });
  }
  return work.commit();
}

Done remove_parameter(PageWriter& pages, const RemoveParameter& change) {
  Workspace& work = pages.work();
  const std::vector<cdl::Parameter>* all = parameters_of(work.model(), change.owner());
  if (all == nullptr) return refusal(fmt::format("there is no `{}`", text::shown(change.owner())));
  const auto known =
      std::ranges::find_if(*all, [&](const cdl::Parameter& p) { return p.name.text == change.name(); });
  if (known == all->end())
    return refusal(fmt::format("there is no parameter `{}`", text::shown(change.name())));
  const bool is_class = is_equipment(work.model(), change.owner());
  if (is_class && reads_parameter(*equipped(work.model(), change.owner()).robot_class, change.name()))
    return refusal(fmt::format("the body or a device reads `{}`: change that first", change.name()));
  if (const OwnerGraph* graph = is_class ? nullptr : work.model().graph(change.owner())) {
    if (const std::optional<Spot> reader = reader_of(*graph, change.name())) {
      const Done done = known->initial ? pages.write(*reader, known->initial) : pages.clear(*reader);
      if (!done) return done;
      if (const Done committed = work.commit(); !committed) return committed;
      return remove_parameter(pages, change);
    }
    if (count_uses(*graph, change.name()) > 0)
      return refusal(fmt::format("a trigger or another parameter needs `{}`", change.name()));
  }
  work.changes().remove(*known);
  for_each_call(work.model().tree(), change.owner(), [&](const cdl::Call& call) {
    for (const cdl::Argument& argument : call.arguments) {
      if (argument.name.text == change.name()) work.changes().remove(argument);
    }
  });
  return work.commit();
}

}  // namespace mlab::designer
