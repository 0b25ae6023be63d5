#pragma once

#include <string>
#include <vector>

#include "mlab/designer/edit/find/pages.h"
#include "mlab/designer/edit/owner_names.h"
#include "mlab/designer/edit/refusal.h"
#include "mlab/designer/edit/workspace.h"

namespace mlab::designer {

/// Notes what is to stand at inputs of nodes and in `let`s of assemblages and robots. It never commits:
/// whoever calls it does, before anything is looked up again.
class PageWriter {
 public:
  /// @param work  outlives it
  explicit PageWriter(Workspace& work) : work_(work) {}

  Workspace& work() { return work_; }
  const OwnerNames& names() const { return names_; }

  /// What stands at the spot from now on. What stood there before is lost, unless it is a node that can be
  /// drawn alone: then it gets a `let`.
  /// @errors  `cannot-edit`: nothing can stand there
  Done write(const Spot& spot, const cdl::ExpressionPtr& what);
  /// Nothing stands at the spot from now on, or what means nothing where something has to stand: a constant,
  /// a component that stands still. What stood there is kept as by `write`.
  /// @errors  `cannot-edit`: it is what a name stands for
  Done clear(const Spot& spot);

  /// @param name  a free one
  void add_let(const PageView& view, const std::string& name, cdl::ExpressionPtr value,
               const std::string& help = "");
  /// A `let` for the node that is written at the spot, which reads its name from now on. @return that name
  std::string make_let(const Spot& spot);

 private:
  /// A `let` for the node that is written at the spot, with its help. @return its name
  std::string save_inline(const Spot& spot);
  void clear_member(const Spot& spot);

  Workspace& work_;
  OwnerNames names_;
};

/// The `let`s stand behind those that the owner has.
void add_lets(Workspace& work, const OwnerGraph& owner, std::vector<cdl::Let> lets);

}  // namespace mlab::designer
