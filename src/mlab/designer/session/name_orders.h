#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "mlab/assist/search.h"
#include "mlab/assist/service.h"
#include "mlab/designer/session/desk.h"
#include "mlab/designer/session/project_renaming.h"
#include "mlab/designer/session/project_texts.h"
#include "mlab/designer/session/request.h"

namespace mlab::designer {

/// Names of the whole project: where they are used, other names for them, search.
class NameOrders {
 public:
  NameOrders(Desk& desk, ProjectTexts& texts) : desk_(desk), texts_(texts), renaming_(desk, texts) {}

  void find_uses(const FindUses& request, Answer& out);
  void plan_rename(const PlanRename& request, Answer& out);
  void rename_everywhere(const RenameEverywhere& request, Answer& out);
  void undo_rename(Answer& out);
  void search(const Search& request, Answer& out);

 private:
  /// The text and the place in it of what is asked about.
  struct NamePlace {
    assist::Text text;
    std::uint32_t cursor = 0;
  };
  /// Nothing where it has no name, which the answer says then.
  std::optional<NamePlace> asked_name(const NameAt& at, Answer& out);
  /// As people know the file.
  std::string path_of(const text::SourcePtr& source) const;
  /// Of the source, at the end of a list that is ordered by files.
  names::File& file_message(const text::SourcePtr& source,
                            google::protobuf::RepeatedPtrField<names::File>& files);
  void refuse_name(const assist::Refusal& refusal, Answer& out);
  /// Nothing where it is refused; else the answer has it as well.
  std::optional<assist::Renaming> plan(const NameAt& at, const std::string& name, Answer& out);

  Desk& desk_;
  ProjectTexts& texts_;
  ProjectRenaming renaming_;
  assist::ProjectIndex index_;
};

}  // namespace mlab::designer
