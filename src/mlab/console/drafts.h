#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/console/state_folder.h"

namespace mlab::console {

/// What is kept between sessions of one project: texts that were not saved, and which missions were opened.
class Drafts {
 public:
  struct Draft {
    std::string text;
    bool had_file = false;    ///< it is an edited file, not a new one
    std::string file_digest;  ///< of that file, to see whether it has changed since
  };
  struct Recent {
    std::string path;
    std::string title;
  };

  /// @param folder   of the user's state; empty: nothing is kept
  /// @param project  where the project is on the machine
  Drafts(const std::string& folder, std::string_view project);

  void keep(std::string_view path, std::string_view text, const std::string* file);
  std::optional<Draft> find(std::string_view path) const;
  void drop(std::string_view path);
  /// Of new files, which are not on disk yet.
  std::vector<std::string> new_files() const;

  /// Most recent first, each path once, at most kMostRecent.
  std::vector<Recent> recent() const;
  void add_recent(std::string_view path, std::string_view title);

  static std::string digest(std::string_view text);
  static constexpr std::size_t kMostRecent = 12;

 private:
  StateFolder folder_;
};

}  // namespace mlab::console
