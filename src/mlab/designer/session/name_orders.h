#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "mlab/assist/search.h"
#include "mlab/assist/service.h"
#include "mlab/designer/session/desk.h"
#include "mlab/designer/session/request.h"
#include "mlab/project/project_names.h"

namespace mlab::designer {

/// Names of the whole project: where they are declared and used, other names for them, search.
class NameOrders {
 public:
  NameOrders(Desk& desk, project::ProjectTexts& texts);

  void find_uses(const FindUses& request, Answer& out);
  void plan_rename(const PlanRename& request, Answer& out);
  void rename_everywhere(const RenameEverywhere& request, Answer& out);
  void undo_rename(Answer& out);
  void search(const Search& request, Answer& out);
  /// Where what stands at the cursor of an open text is declared.
  void find_definition(const OpenConfiguration& document, std::uint32_t cursor, Answer& out);

 private:
  /// The text and the place in it of what is asked about.
  struct NamePlace {
    assist::Text text;
    std::uint32_t cursor = 0;
  };
  /// Nothing where it has no name, which the answer says then.
  std::optional<NamePlace> asked_name(const NameAt& at, Answer& out);

  Desk& desk_;
  project::ProjectTexts& texts_;
  project::ProjectNames names_;
  assist::ProjectIndex index_;
};

}  // namespace mlab::designer
