#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>

namespace mlab::console {

/// The files of the web client, read once. What is asked for is looked up among their names and never becomes
/// a path, so nothing else can be reached.
class WebFiles {
 public:
  struct File {
    std::string content_type;
    std::shared_ptr<const std::string> bytes;
    std::string etag;           ///< with its quotes
    bool is_immutable = false;  ///< its name changes with its content
  };

  /// A folder that is missing has no files.
  static WebFiles read(const std::string& folder);
  /// @param path  `/assets/x.js`, as it stands in the request; null where there is no such file
  const File* find(std::string_view path) const;

 private:
  std::map<std::string, File, std::less<>> files_;
};

}  // namespace mlab::console
