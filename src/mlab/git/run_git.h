#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace mlab::git {

struct GitAnswer {
  int failure = 0;  ///< why it could not be started, as `errno` has it (ENOENT: there is none); 0: it was
  bool is_whole = true;  ///< false: it wrote too much, or took too long, and was ended
  int status = -1;
  std::string output;
  std::string errors;  ///< what it said of what is wrong, at most some kilobytes
};

/// Runs `git` in a folder and waits for it, at most `seconds`. Its standard input is empty, its environment
/// such that it asks nobody, opens no connection and takes no lock.
/// @param most  bytes of output
GitAnswer run_git(const std::string& folder, const std::vector<std::string>& arguments, std::size_t most,
                  double seconds = 20.0);

}  // namespace mlab::git
