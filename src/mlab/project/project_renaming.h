#pragma once

#include <memory>
#include <string>
#include <vector>

#include "mlab/assist/service.h"
#include "mlab/project/project_texts.h"

namespace mlab::project {

/// Carries a renaming out in all files that it changes, and takes it back again.
///
/// What is open is changed as by any edit, so that Undo takes it back there as well, and is saved where
/// nothing was unsaved: after a renaming the files on disk fit each other, and a mission that is run from the
/// shell finds what it names. Unsaved work stays unsaved. Files that are not open are written. Where all open
/// texts have one history, undoing there takes all of it back; else nobody has a text of the others to undo,
/// so taking the whole back is offered instead.
class ProjectRenaming {
 public:
  explicit ProjectRenaming(ProjectTexts& texts) : texts_(texts) {}

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
  using Steps = std::vector<Step>;

  documents::Store& store() const { return texts_.open().store(); }
  void look_whether_open(Step& step) const;
  text::Result<bool> write(const Steps& steps) const;
  text::Result<bool> write_file(const std::string& path, const std::string& text) const;
  text::Result<bool> check(const Step& step) const;
  void edit(const Steps& steps, const std::string& name, double now) const;
  void save(const std::vector<std::string>& paths) const;
  std::vector<std::string> saved_now(const Steps& steps) const;
  void exchange_files(const Steps& steps, std::string Step::* from, std::string Step::* to) const;
  bool exchange_file(const std::string& path, const std::string& from, const std::string& to) const;

  ProjectTexts& texts_;
  std::string name_;  // of the step, for undo
  Steps last_;        // of the last renaming
};

}  // namespace mlab::project
