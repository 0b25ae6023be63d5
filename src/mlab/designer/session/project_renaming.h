#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mlab/assist/service.h"
#include "mlab/designer/session/desk.h"
#include "mlab/designer/session/project_texts.h"

namespace mlab::designer {

/// Carries a renaming out in all files that it changes, and takes it back again.
///
/// What is open is changed as by any edit, so that Undo takes it back there as well, and is saved where
/// nothing was unsaved: after a renaming the files on disk fit each other, and a mission that is run from the
/// shell finds what it names. Unsaved work stays unsaved. Files that are not open are written; nobody has a
/// text of them to undo, so taking the whole back is offered instead.
class ProjectRenaming {
 public:
  ProjectRenaming(Desk& desk, ProjectTexts& texts) : desk_(desk), texts_(texts) {}

  /// All files or none. @errors where a file was changed meanwhile, or can't be written
  text::Result<bool> carry_out(const assist::Renaming& what, const std::string& to, double now);
  /// @errors where there was none, or one of its files has changed since
  text::Result<bool> take_back(double now);

 private:
  struct Step {
    std::string path;  ///< of the project's file, or a document's id
    std::string before;
    std::string after;
    bool is_open = false;
    bool was_saved = false;  ///< nothing was unsaved, and there is a file
  };
  text::Result<bool> write(const std::vector<Step>& steps);
  text::Result<bool> write_file(const std::string& path, const std::string& text) const;
  text::Result<bool> check(const Step& step) const;
  void edit(const Step& step, const std::string& name, double now);

  Desk& desk_;
  ProjectTexts& texts_;
  std::string name_;        // of the step, for undo
  std::vector<Step> last_;  // of the last renaming
};

}  // namespace mlab::designer
