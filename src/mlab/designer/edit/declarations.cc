// Declarations of a file, and their parameters.

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "mlab/designer/edit/editor.h"
#include "mlab/designer/edit/values.h"
#include "mlab/lang/cdl/syntax/parser.h"
#include "mlab/text/shown.h"

namespace mlab::designer {

// ---- declarations

Done Editor::add_declaration(const AddDeclaration& change) {
  const std::string& name = change.name();
  if (!is_cdl_name(name)) return refusal(fmt::format("`{}` is no name", text::shown(name)));
  if (is_declared(work_, name)) return refusal(fmt::format("there is a `{}` already", name));
  std::string words;
  if (change.kind() == "assemblage") {
    words = fmt::format("assemblage {}() {{\n}}", name);
  } else if (change.kind() == "robot") {
    words = fmt::format("robot {} {{\n}}", name);
  } else if (change.kind() == "class") {
    words = fmt::format("class {} {{\nbody {{ radius = 0.3 m; }}\n}}", name);
  } else if (change.kind() == "society") {
    const auto& robots = work_.model().configuration().own_robots;
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
  work_.add(items_of(words).front());
  if (const Done done = work_.commit(); !done) return done;
  if (!change.robot().empty()) {
    if (const Done done = add_class_for(name, change.robot()); !done) return done;
  }
  return arrange_one(work_, "", name, change);
}

Done Editor::remove_declarations(const Remove& change) {
  for (const std::string& name : change.nodes()) {
    if (!visit_declaration(work_.model().tree(), name, [&](const auto& one) { work_.changes().remove(one); }))
      return refusal(fmt::format("there is no `{}`", text::shown(name)));
  }
  return work_.commit();
}

Done Editor::copy_component(const CopyComponent& change) {
  const Model& model = work_.model();
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
  if (is_declared(work_, name)) return refusal(fmt::format("there is a `{}` already", name));
  visit_declaration(other.tree(), change.component(), [&](auto one) {
    if (one.name.text != name) one.whole = {};
    one.name.text = name;
    work_.add(std::move(one));
  });
  return work_.commit();
}

// ---- parameters

// Calls `visit` with the assemblage, robot or class of a name; with the robot where a class has the same.
void Editor::visit_owner(std::string_view name, const auto& visit) const {
  const Model& model = work_.model();
  if (const cdl::Assemblage* assemblage = model.assemblage(name))
    visit(*assemblage);
  else if (const cdl::Robot* robot = model.robot(name))
    visit(*robot);
  else if (const cdl::RobotClass* robot_class = model.robot_class(name))
    visit(*robot_class);
  else if (const cdl::Binding* binding = model.binding(name))
    visit(*binding);
}

const std::vector<cdl::Parameter>* Editor::parameters(std::string_view owner) const {
  const std::vector<cdl::Parameter>* out = nullptr;
  visit_owner(owner, [&](const auto& one) { out = &one.parameters; });
  return out;
}

Done Editor::set_parameter(const SetParameter& change) {
  const std::vector<cdl::Parameter>* all = parameters(change.owner());
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
  visit_owner(change.owner(), [&](const auto& one) {
    if constexpr (requires { one.lets; })
      is_let =
          std::ranges::any_of(one.lets, [&](const cdl::Let& let) { return let.name.text == change.name(); });
  });
  if (known == all->end() && is_let) return refusal(fmt::format("`{}` is taken already", change.name()));
  const text::Result<cdl::Parameter> said = parameter_of(change);
  if (!said) return std::unexpected(said.error());
  if (known != all->end()) {
    change_parameter(*known, *said, change.type().empty());
  } else {
    visit_owner(change.owner(), [&]<class X>(const X& one) {
      work_.changes().change<X>(one, [said = *said](X& now) { now.parameters.push_back(said); });
    });
  }
  return work_.commit();
}

// As it is said; what has no type yet has one that is not used.
text::Result<cdl::Parameter> Editor::parameter_of(const SetParameter& change) const {
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
void Editor::change_parameter(const cdl::Parameter& old, const cdl::Parameter& said, bool stays) {
  work_.changes().change<cdl::Parameter>(old, [said, stays](cdl::Parameter& now) {
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

// What read it gets its default, and who gave it gives it no more.
Done Editor::remove_parameter(const RemoveParameter& change) {
  const std::vector<cdl::Parameter>* all = parameters(change.owner());
  if (all == nullptr) return refusal(fmt::format("there is no `{}`", text::shown(change.owner())));
  const auto known =
      std::ranges::find_if(*all, [&](const cdl::Parameter& p) { return p.name.text == change.name(); });
  if (known == all->end())
    return refusal(fmt::format("there is no parameter `{}`", text::shown(change.name())));
  const bool is_class = is_equipment(work_.model(), change.owner());
  if (is_class && reads_parameter(*equipped(work_.model(), change.owner()).robot_class, change.name()))
    return refusal(fmt::format("the body or a device reads `{}`: change that first", change.name()));
  if (const OwnerGraph* graph = is_class ? nullptr : work_.model().graph(change.owner())) {
    if (const std::optional<Spot> reader = reader_of(*graph, change.name())) {
      const Done done = known->initial ? pages_.write(*reader, known->initial) : pages_.clear(*reader);
      if (!done) return done;
      if (const Done committed = work_.commit(); !committed) return committed;
      return remove_parameter(change);
    }
    if (count_uses(*graph, change.name()) > 0)
      return refusal(fmt::format("a trigger or another parameter needs `{}`", change.name()));
  }
  work_.changes().remove(*known);
  for_each_call(work_.model().tree(), change.owner(), [&](const cdl::Call& call) {
    for (const cdl::Argument& argument : call.arguments) {
      if (argument.name.text == change.name()) work_.changes().remove(argument);
    }
  });
  return work_.commit();
}

}  // namespace mlab::designer
