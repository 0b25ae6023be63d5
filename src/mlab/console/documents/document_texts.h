#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mlab/console/documents/documents.h"
#include "mlab/project/open_texts.h"

namespace mlab::console {

/// The documents of the mission that is open, to who looks at the whole project.
class DocumentTexts : public project::OpenTexts {
 public:
  /// @param wrote_file  called after a file was written that is not open
  DocumentTexts(OpenDocuments& documents, std::function<void()> wrote_file)
      : documents_(documents), wrote_file_(std::move(wrote_file)) {}

  documents::Store& store() override { return documents_.store(); }
  assist::Surroundings surroundings() override;
  bool is_edited_here(std::string_view path) const override;
  /// Also what can be saved under another name only.
  bool is_changeable(const documents::Document& /*any*/) const override { return true; }
  /// The mission's, where it is no file of the project: an example's.
  std::vector<std::string> folders_beside() const override;
  std::shared_ptr<documents::EditLog> log() const override { return documents_.log(); }
  text::Result<documents::Document*> open(const std::string& path, double now) override {
    return documents_.open_kept(path, now);
  }
  void change(const std::vector<documents::Store::Change>& changes, const std::string& name,
              double now) override {
    documents_.change(changes, name, now);
  }
  void wrote_file(const std::string& /*path*/) override { wrote_file_(); }
  void save(documents::Document& document) override;
  void tell(const std::string& sentence) override { documents_.add_notice(sentence); }

 private:
  OpenDocuments& documents_;
  const std::function<void()> wrote_file_;
};

}  // namespace mlab::console
