#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace mlab::console {

/// Where files of one project are kept between sessions: a folder of the user's state, not of the project,
/// that nobody else can read. Where it can't be written nothing is kept and nobody complains.
class StateFolder {
 public:
  /// @param folder   of the user's state; empty: nothing is kept
  /// @param project  where the project is on the machine
  StateFolder(const std::string& folder, std::string_view project);

  /// A file's name for what belongs to a path of the project. Different paths may have the same: what is kept
  /// says its path too.
  static std::string name_of(std::string_view path, std::string_view extension);

  /// False where there is no such file, or it has more bytes.
  bool read(const std::string& name, std::size_t most_bytes, std::string& out) const;
  void write(const std::string& name, std::string_view bytes) const;
  void remove(const std::string& name) const;
  /// Of files with this extension, at most 1000, in no order.
  std::vector<std::string> names(std::string_view extension) const;

 private:
  std::string folder_;  // empty: nothing is kept
};

}  // namespace mlab::console
