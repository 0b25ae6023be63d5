#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/documents/enclosed_file.h"

namespace mlab::documents {

/// Where files of one project are kept between sessions: a folder of the user's state, not of the project,
/// that nobody else can read. What is written there outlives this process at once, whatever ends it; `sync`
/// makes it outlive the machine. Functions that return a text say why it could not be done; empty: it was.
class StateFolder {
 public:
  /// @param folder   of the user's state; empty: there is none, and nothing can be kept
  /// @param project  where the project is on the machine
  StateFolder(const std::string& folder, std::string_view project);

  /// A file's name for what belongs to a path of the project. Different paths may have the same: what is kept
  /// says its path too.
  static std::string name_of(std::string_view path, std::string_view extension);

  /// False where there is no such file, or it has more bytes.
  bool read(const std::string& name, std::size_t most_bytes, std::string& out) const;
  std::string write(const std::string& name, std::string_view bytes) const;
  /// What is not there is removed already.
  std::string remove(const std::string& name) const;
  std::string sync(const std::string& name) const;
  /// Where they are on the machine; empty: nowhere.
  const std::string& path() const { return folder_; }
  /// Tries whether something can be kept here.
  std::string problem() const;
  /// Of files with this extension, at most 1000, in no order.
  std::vector<std::string> names(std::string_view extension) const;

 private:
  /// Where it is missing. @return  why it could not be made; empty: it is there
  std::string make() const;
  /// What processes that were killed while they wrote have left behind.
  void remove_leftovers() const;

  std::string folder_;  // empty: nothing is kept
};

}  // namespace mlab::documents
