#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/documents/state_folder.h"

namespace mlab::documents {

/// What is kept between sessions of one project: texts that were not saved, and which missions were opened.
/// Functions that return a text say why it could not be done; empty: it was, and outlives this process.
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

  std::string keep(std::string_view path, std::string_view text, const std::string* file);
  /// @param file_digest  as an earlier draft of the same text had it
  std::string keep_of(std::string_view file_digest, std::string_view path, std::string_view text);
  /// Waits until a draft that was kept is on the disk.
  std::string sync(std::string_view path) const;
  std::optional<Draft> find(std::string_view path) const;
  std::string drop(std::string_view path);
  /// Tries whether drafts can be kept.
  std::string problem() const { return folder_.problem(); }
  /// Of all of them, in order.
  std::vector<std::string> paths() const;

  /// Most recent first, each path once, at most kMostRecent.
  std::vector<Recent> recent() const;
  void add_recent(std::string_view path, std::string_view title);

  static std::string digest(std::string_view text);
  static constexpr std::size_t kMostRecent = 12;

 private:
  StateFolder folder_;
};

}  // namespace mlab::documents
