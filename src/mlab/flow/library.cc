#include "mlab/flow/library.h"

#include "mlab/flow/port_types.h"

namespace mlab::flow {

Library::Library() {
  add_port_types(*this);
}

void Library::add(std::span<const Behavior* const> behaviors) {
  for (const Behavior* behavior : behaviors) {
    entries_[std::string(behavior->name)] = {behavior, nullptr};
    for (const Alias& alias : behavior->aliases) entries_[std::string(alias.name)] = {behavior, &alias};
    if (behavior->output != nullptr && !types_.contains(behavior->output->name)) add_type(*behavior->output);
    for (const Input& input : behavior->inputs) {
      if (!types_.contains(input.type->name)) add_type(*input.type);
    }
  }
}

void Library::add_type(const TypeInfo& type, std::string_view alias) {
  types_[std::string(alias.empty() ? type.name : alias)] = &type;
}

Library::Entry Library::find(std::string_view name) const {
  const auto it = entries_.find(name);
  return it == entries_.end() ? Entry{} : it->second;
}

const TypeInfo* Library::find_type(std::string_view name) const {
  const auto it = types_.find(name);
  return it == types_.end() ? nullptr : it->second;
}

std::vector<const Behavior*> Library::behaviors() const {
  std::vector<const Behavior*> out;
  for (const auto& [name, entry] : entries_) {
    if (entry.alias == nullptr) out.push_back(entry.behavior);
  }
  return out;
}

std::vector<std::string> Library::names() const {
  std::vector<std::string> out;
  for (const auto& [name, entry] : entries_) out.push_back(name);
  return out;
}

}  // namespace mlab::flow
