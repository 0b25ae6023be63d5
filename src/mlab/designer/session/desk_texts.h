#pragma once

#include <string>
#include <string_view>

#include "mlab/designer/session/desk.h"
#include "mlab/project/open_texts.h"

namespace mlab::designer {

/// A file that the designer shows, by its path.
bool is_configuration(std::string_view path);

/// The open configurations, to who looks at the whole project.
class DeskTexts : public project::OpenTexts {
 public:
  explicit DeskTexts(Desk& desk) : desk_(desk) {}

  documents::Store& store() override { return desk_.store(); }
  assist::Surroundings surroundings() override { return desk_.surroundings(); }
  bool is_edited_here(std::string_view path) const override { return path.ends_with(".cdl"); }
  bool is_changeable(const documents::Document& document) const override { return document.is_writable; }
  std::vector<std::string> folders_beside() const override { return {}; }
  std::shared_ptr<documents::EditLog> log() const override { return nullptr; }
  text::Result<documents::Document*> open(const std::string& path, double now) override;
  void change(const std::vector<documents::Store::Change>& changes, const std::string& name,
              double now) override;
  /// Files are looked at all the time.
  void wrote_file(const std::string& /*path*/) override {}
  void save(documents::Document& document) override;
  void tell(const std::string& /*nothing is undone in a history of all texts*/) override {}

 private:
  Desk& desk_;
};

}  // namespace mlab::designer
