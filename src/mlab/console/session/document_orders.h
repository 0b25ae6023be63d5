#pragma once

#include <functional>
#include <string>

#include "mlab/console/documents/documents.h"
#include "mlab/console/run/event_log.h"
#include "mlab/console/session/request.h"
#include "mlab/console/session/run_maker.h"
#include "mlab/documents/project_folder.h"

namespace mlab::console {

/// What people ask of the texts that are open, and of the files of the project. After each change the run
/// follows, and what is not saved is in the file system before the answer is given.
class DocumentOrders {
 public:
  struct Parts {
    OpenDocuments& documents;
    const documents::ProjectFolder& project;
    RunControl& run;
    RunMaker& maker;
    EventLog& log;
  };
  /// @param tell_not_kept  as SessionSettings
  DocumentOrders(const Parts& parts, std::function<void(const std::string& why)> tell_not_kept);

  // ---- the operator

  Answered edit_text(const Sender& sender, const EditText& edit);
  Answered edit_map(const Sender& sender, const EditMap& edit);
  Answered create_obstacles(const Sender& sender, const CreateObstacles& create);
  Answered undo(const Sender& sender);
  Answered redo(const Sender& sender);
  Answered open(const Sender& sender, const OpenMission& open);
  Answered create(const Sender& sender, const NewDocument& create);
  Answered save(const Sender& sender, const SaveDocuments& save);
  Answered reload(const Sender& sender, const ReloadDocument& reload);

  // ---- anybody

  Answered list_files(const ListFiles& list, Reply& reply);
  Answered complete(const Complete& wanted, Reply& reply);
  Answered check(const Check& wanted, Reply& reply);

  /// After a change, or an attempt at one.
  /// @param what  for the log; empty: it is not told of
  Answered changed(const Sender& sender, const text::Result<bool>& result, const std::string& what);

  // ---- files and drafts

  /// Looks at the files now and then. What was changed there is taken over where nothing is unsaved here, and
  /// the run follows.
  void look_at_disk();
  /// Whatever ends this process, what is not saved is in the file system, or whoever asked is told that it is
  /// not.
  void keep_drafts();
  /// The same, and it is on the disk.
  void sync_drafts();

 private:
  void note(const Sender& sender, const std::string& what);
  void tell_not_kept();

  OpenDocuments& documents_;
  const documents::ProjectFolder& project_;
  RunControl& run_;
  RunMaker& maker_;
  EventLog& log_;
  const std::function<void(const std::string& why)> tell_not_kept_;
  std::string not_kept_;  // as it was told last
  double looked_ = -1e9;  // at the files
};

}  // namespace mlab::console
