#include "mlab/designer/edit/find/declared.h"

#include <concepts>

#include "mlab/lang/cdl/syntax/parts.h"

namespace mlab::designer {

bool is_declared(const Workspace& work, const std::string& name) {
  return anchors_of(work.model(), "", work.tokens()).contains(name);
}

void for_each_call(const cdl::Tree& tree, std::string_view callee,
                   const std::function<void(const cdl::Call&)>& visit) {
  const auto look = [&]<class X>(const X& one) {
    if constexpr (std::same_as<X, cdl::Call>) {
      if (one.callee.text == callee) visit(one);
    }
  };
  for (const cdl::Item& item : tree.items) cdl::for_each_construct(item, look);
}

}  // namespace mlab::designer
