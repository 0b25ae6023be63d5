#include "mlab/designer/edit/owner_names.h"

#include <algorithm>

#include "mlab/designer/edit/values.h"

namespace mlab::designer {

bool OwnerNames::is_taken(const OwnerGraph& owner, std::string_view name) const {
  const auto is_it = [&](const auto& one) { return one.name.text == name; };
  return std::ranges::any_of(owner.lets(), is_it) || std::ranges::any_of(owner.parameters(), is_it) ||
         given_.contains({owner.name, std::string(name)});
}

std::string OwnerNames::free_name(const OwnerGraph& owner, const std::string& wanted) const {
  std::set<std::string> taken;
  for (const cdl::Let& let : owner.lets()) taken.insert(let.name.text);
  for (const cdl::Parameter& parameter : owner.parameters()) taken.insert(parameter.name.text);
  for (const auto& [name_of_owner, name] : given_) {
    if (name_of_owner == owner.name) taken.insert(name);
  }
  const GraphPage& own = owner.pages.front();
  for (const GraphNode& node : own.nodes) taken.insert(node.name);
  if (own.sequence != nullptr) {
    for (const cdl::State& state : own.sequence->states) taken.insert(state.name.text);
  }
  return unique(wanted, taken);
}

}  // namespace mlab::designer
