#include "mlab/designer/edit/offered.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include <fmt/core.h>

#include "mlab/robot/program/robot_program.h"

namespace mlab::designer {
namespace {

std::string normal_path(const std::string& path) {
  return std::filesystem::path(path).lexically_normal().string();
}

bool has_file(const std::vector<std::string>& files, const std::string& path) {
  return std::ranges::any_of(files,
                             [&](const std::string& one) { return normal_path(one) == normal_path(path); });
}

/// All names that a file and those that it uses declare, without some of the files.
std::set<std::string, std::less<>> declared_names(const cdl::Configuration& configuration,
                                                  const std::vector<std::string>& without) {
  std::set<std::string, std::less<>> out;
  for (const auto& tree : configuration.trees) {
    if (tree->source && has_file(without, tree->source->name())) continue;
    for (const cdl::Item& item : tree->items) {
      if (const auto* one = std::get_if<cdl::Assemblage>(&item)) out.insert(one->name.text);
      if (const auto* one = std::get_if<cdl::Binding>(&item)) out.insert(one->name.text);
      if (const auto* one = std::get_if<cdl::RobotClass>(&item)) out.insert(one->name.text);
      if (const auto* one = std::get_if<cdl::Robot>(&item)) out.insert(one->name.text);
      if (const auto* one = std::get_if<cdl::SocietyOperator>(&item)) out.insert(one->name.text);
      if (const auto* one = std::get_if<cdl::Society>(&item)) out.insert(one->name.text);
    }
  }
  return out;
}

/// `Average` of `coordinate by Average`.
std::string_view called_name(std::string_view component) {
  for (const std::string_view by : {"coordinate by ", "fuse by "}) {
    if (component.starts_with(by)) return component.substr(by.size());
  }
  return component;
}

/// What a change places; empty where it places nothing.
std::string component_of(const Change& change) {
  if (change.has_place()) return change.place().component();
  if (change.has_replace()) return change.replace().component();
  if (change.has_set_active()) return change.set_active().component();
  if (change.has_add_state()) return change.add_state().component();
  if (change.has_set_device()) return change.set_device().component();
  if (change.has_change_trigger()) return change.change_trigger().component();
  return "";
}

}  // namespace

std::vector<Callable> callables_of(const Model& offered) {
  std::vector<Callable> out;
  const Components& components = offered.components();
  for (const cdl::Item& item : offered.tree().items) {
    const auto* one = std::get_if<cdl::Assemblage>(&item);
    if (one != nullptr && !one->name.text.empty()) out.push_back(components.of(*one));
  }
  const std::vector<const flow::Behavior*> known = robot::component_library().behaviors();
  for (const flow::Behavior* behavior : offered.library().behaviors()) {
    if (std::ranges::find(known, behavior) == known.end())
      out.push_back(components.of(flow::Library::Entry{behavior, nullptr}));
  }
  return out;
}

bool can_use(const Model& model, const std::string& disk_path, const Model& offered) {
  if (offered.problems().has_errors() || has_file(model.configuration().files, disk_path) ||
      has_file(offered.configuration().files, model.source()->name()))
    return false;
  const auto own = declared_names(model.configuration(), {});
  // What both use is no clash.
  return std::ranges::none_of(declared_names(offered.configuration(), model.configuration().files),
                              [&](const std::string& name) { return own.contains(name); });
}

const Callable* find_callable(const std::vector<Callable>& all, std::string_view name) {
  const auto found = std::ranges::find(all, called_name(name), &Callable::name);
  return found == all.end() ? nullptr : &*found;
}

const Offered* find_offered(const std::vector<Offered>& all, const Model& model, std::string_view component) {
  if (component.empty() || model.components().find(called_name(component))) return nullptr;
  const auto found = std::ranges::find_if(
      all, [&](const Offered& one) { return find_callable(callables_of(*one.model), component) != nullptr; });
  return found == all.end() ? nullptr : &*found;
}

std::vector<std::string> files_needed(const Edit& edit, const Model& model, const std::vector<Offered>& all) {
  std::vector<std::string> out;
  if (all.empty()) return out;
  for (const Change& change : edit.changes()) {
    const Offered* one = find_offered(all, model, component_of(change));
    if (one != nullptr && std::ranges::find(out, one->file) == out.end()) out.push_back(one->file);
  }
  return out;
}

Done add_use(Workspace& work, const std::string& file) {
  const auto& items = work.model().tree().items;
  const auto is_use = [](const cdl::Item& item) { return std::holds_alternative<cdl::Use>(item); };
  const auto last = std::ranges::find_if(items.rbegin(), items.rend(), is_use);
  const auto behind = static_cast<std::size_t>(items.rend() - last);  // the first where there is none
  work.changes().add(cdl::Use{{file, {}}}, behind < items.size() ? &items[behind] : nullptr);
  return work.commit();
}

void add_offered(const std::vector<Offered>& all, const DrawingContext& context, Palette& palette) {
  std::set<std::string> names;
  for (const Component& component : palette.components()) names.insert(component.name());
  for (const Offered& one : all) {
    for (const Callable& callable : callables_of(*one.model)) {
      if (callable.gives_nothing || !names.insert(callable.name).second) continue;
      Component& component = *palette.add_components();
      component = palette_entry(callable, *one.model, context);
      component.set_group("This project");
      component.set_source(one.document.ends_with(".cdl") ? one.document : "");
      component.set_is_own(true);
    }
  }
}

}  // namespace mlab::designer
