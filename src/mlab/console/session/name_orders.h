#pragma once

#include "mlab/console/documents/document_texts.h"
#include "mlab/console/documents/documents.h"
#include "mlab/console/session/document_orders.h"
#include "mlab/console/session/request.h"
#include "mlab/console/session/run_maker.h"
#include "mlab/project/project_names.h"

namespace mlab::console {

/// What people ask of the names in the mission's texts and in all files of the project.
class NameOrders {
 public:
  /// @param elsewhere  drafts of configurations
  NameOrders(OpenDocuments& documents, DocumentOrders& orders, RunMaker& maker,
             project::ProjectTexts::Elsewhere elsewhere);

  // ---- anybody

  Answered find_definition(const FindDefinition& find, Reply& reply);
  Answered find_uses(const FindUses& find, Reply& reply);
  Answered read_text(const ReadText& read, Reply& reply);

  // ---- the operator

  Answered plan(const PlanRename& wanted, Reply& reply);
  Answered rename(const Sender& sender, const RenameEverywhere& wanted, Reply& reply);

 private:
  DocumentTexts open_;
  project::ProjectTexts texts_;
  DocumentOrders& orders_;
  project::ProjectNames names_;
};

}  // namespace mlab::console
