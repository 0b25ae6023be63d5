#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/assist/service.h"
#include "mlab/documents/drafts.h"
#include "mlab/project/open_texts.h"

namespace mlab::project {

/// All texts of a project as they stand: what is open, what is kept of unsaved work, and what is on disk. A
/// file is read once, and again when it has changed there.
class ProjectTexts {
 public:
  static constexpr std::size_t kMostFiles = 2000;

  /// What another program of the project keeps of unsaved work on files that are not edited here.
  struct Elsewhere {
    documents::Drafts drafts;
    std::string where;  ///< `in the console`
  };

  ProjectTexts(OpenTexts& open, Elsewhere elsewhere) : open_(open), elsewhere_(std::move(elsewhere)) {}

  std::vector<assist::Text> all();
  /// What of the project `all` has left out the last time, as a sentence; empty: nothing.
  std::string left_out() const;
  /// What stands beside a text of the project; valid as long as this.
  assist::Surroundings surroundings();
  /// Why a file can't be changed from here, as assist::Surroundings::fixed.
  std::string why_fixed(const std::string& source_name) const;
  /// The name that people open a source's file by: in the project, in the library, or as it is open. Empty
  /// where it can't be opened.
  std::string path_of(std::string_view source_name) const;
  /// The text of that name as `all` has it, or of the library.
  /// @errors  `cannot-read`; `no-language`: it is in none of ours
  text::Result<assist::Text> read(const std::string& path);
  OpenTexts& open() { return open_; }

 private:
  struct File {
    std::filesystem::file_time_type time;
    std::uintmax_t size = 0;
    std::optional<assist::Text> text;  ///< nothing: it can't be read
  };
  void find(const std::string& folder, int depth, std::vector<std::string>& out);
  const File& file(const std::string& path);
  std::optional<assist::Text> kept_of(const std::string& path) const;

  OpenTexts& open_;
  Elsewhere elsewhere_;
  std::map<std::string, File> files_;  // by path in the project
  bool is_cut_ = false;                // there was more than `all` looks at
};

}  // namespace mlab::project
