#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <variant>

#include "mlab/designer/edit/workspace.h"

// Declarations of a text, and calls of them. All of it only reads.

namespace mlab::designer {

bool is_declared(const Workspace& work, const std::string& name);

/// Every call in the text of what is called so.
void for_each_call(const cdl::Tree& tree, std::string_view callee,
                   const std::function<void(const cdl::Call&)>& visit);

/// Calls `visit` with the declaration of a name. @return whether there is one
bool visit_declaration(const cdl::Tree& tree, std::string_view name, const auto& visit) {
  for (const cdl::Item& item : tree.items) {
    const bool is_it = std::visit(
        [&](const auto& one) {
          if constexpr (requires { one.name.text, one.help; }) {
            if (one.name.text == name) visit(one);
            return one.name.text == name;
          }
          return false;
        },
        item);
    if (is_it) return true;
  }
  return false;
}

}  // namespace mlab::designer
