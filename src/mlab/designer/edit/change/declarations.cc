#include "mlab/designer/edit/change/declarations.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "mlab/designer/edit/change/layout.h"
#include "mlab/designer/edit/change/robots.h"
#include "mlab/designer/edit/find/declared.h"
#include "mlab/designer/edit/values.h"
#include "mlab/text/shown.h"

namespace mlab::designer {

Done add_declaration(Workspace& work, const AddDeclaration& change) {
  const std::string& name = change.name();
  if (!is_cdl_name(name)) return refusal(fmt::format("`{}` is no name", text::shown(name)));
  if (is_declared(work, name)) return refusal(fmt::format("there is a `{}` already", name));
  std::string words;
  if (change.kind() == "assemblage") {
    words = fmt::format("assemblage {}() {{\n}}", name);
  } else if (change.kind() == "robot") {
    words = fmt::format("robot {} {{\n}}", name);
  } else if (change.kind() == "class") {
    words = fmt::format("class {} {{\nbody {{ radius = 0.3 m; }}\n}}", name);
  } else if (change.kind() == "society") {
    const auto& robots = work.model().configuration().own_robots;
    words = robots.empty() ? fmt::format("society {}: caste {{ }};", name)
                           : fmt::format("society {}: team of 3 {};", name, robots.front()->name.text);
  } else if (change.kind() == "operator") {
    words = fmt::format("operator {} {{\n}}", name);
  } else if (change.kind() == "binding") {
    words = fmt::format("binding {}() -> Obstacles;", name);
  } else {
    return refusal(fmt::format("`{}` is no kind of declaration", text::shown(change.kind())));
  }
  if (!change.robot().empty() && change.kind() != "class")
    return refusal(fmt::format("a robot has no {} of its own", change.kind()));
  work.add(items_of(words).front());
  if (const Done done = work.commit(); !done) return done;
  if (!change.robot().empty()) {
    if (const Done done = add_class_for(work, name, change.robot()); !done) return done;
  }
  return arrange_one(work, "", name, change);
}

Done remove_declarations(Workspace& work, const Remove& change) {
  for (const std::string& name : change.nodes()) {
    if (!visit_declaration(work.model().tree(), name, [&](const auto& one) { work.changes().remove(one); }))
      return refusal(fmt::format("there is no `{}`", text::shown(name)));
  }
  return work.commit();
}

Done copy_component(Workspace& work, const CopyComponent& change) {
  const Model& model = work.model();
  const auto& configuration = model.configuration();
  text::SourcePtr source;
  const auto look = [&](const auto& table) {
    const auto found = table.find(change.component());
    if (found != table.end()) source = found->second->name.place.source;
  };
  look(configuration.assemblages);
  look(configuration.classes);
  look(configuration.robots);
  look(configuration.operators);
  look(configuration.bindings);
  if (!source)
    return refusal(
        fmt::format("`{}` is no assemblage: only those can be copied", text::shown(change.component())));
  const std::string name = change.name().empty() ? change.component() : change.name();
  const Model other(source, cdl::Environment{configuration.built_in, nullptr});
  if (!is_cdl_name(name)) return refusal(fmt::format("`{}` is no name", text::shown(name)));
  if (is_declared(work, name)) return refusal(fmt::format("there is a `{}` already", name));
  visit_declaration(other.tree(), change.component(), [&](auto one) {
    if (one.name.text != name) one.whole = {};
    one.name.text = name;
    work.add(std::move(one));
  });
  return work.commit();
}

Done set_binding(Workspace& work, const SetBinding& change) {
  const cdl::Binding* binding = work.model().binding(change.binding());
  if (binding == nullptr)
    return refusal(fmt::format("there is no binding point `{}`", text::shown(change.binding())));
  if (change.type() == binding->result_type.text) return true;
  const bool is_known =
      change.type().empty() || work.model().components().types().named(change.type()).type != nullptr;
  if (!is_known) return refusal(fmt::format("there is no type `{}`", text::shown(change.type())));
  work.changes().change<cdl::Binding>(
      *binding, [type = change.type()](cdl::Binding& now) { now.result_type.text = type; });
  return work.commit();
}

}  // namespace mlab::designer
