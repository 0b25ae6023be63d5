#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "mlab/assist/service.h"
#include "mlab/designer/session/desk.h"

namespace mlab::designer {

/// All texts of a project as they stand: what is open, what is kept of unsaved work, and what is on disk. A
/// file is read once, and again when it has changed there.
class ProjectTexts {
 public:
  static constexpr std::size_t kMostFiles = 2000;

  /// @param drafts  of the console: missions and overlays that are edited there
  ProjectTexts(Desk& desk, documents::Drafts drafts) : desk_(desk), drafts_(std::move(drafts)) {}

  std::vector<assist::Text> all();
  /// What of the project `all` has left out the last time, as a sentence; empty: nothing.
  std::string left_out() const;
  /// What stands beside a text of the project; valid as long as this.
  assist::Surroundings surroundings();
  /// Why a file can't be changed from here, as assist::Surroundings::fixed.
  std::string why_fixed(const std::string& source_name) const;
  /// The path of the project's file that a source is the text of, a document's id where it is open.
  std::string path_of(const text::SourcePtr& source) const { return desk_.document_of(source->name()); }

 private:
  struct File {
    std::filesystem::file_time_type time;
    std::uintmax_t size = 0;
    std::optional<assist::Text> text;  ///< nothing: it can't be read
  };
  void find(const std::string& folder, int depth, std::vector<std::string>& out);
  const File& file(const std::string& path);
  std::optional<assist::Text> kept_of(const std::string& path) const;

  Desk& desk_;
  documents::Drafts drafts_;
  std::map<std::string, File> files_;  // by path in the project
  bool is_cut_ = false;                // there was more than `all` looks at
};

}  // namespace mlab::designer
