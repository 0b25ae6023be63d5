#pragma once

#include <string>

namespace mlab::cli {

/// Shows an address in the browser of who is at this machine. What is opened is a file that only he can read
/// and that leads there: the address holds a token, and command lines are seen by everybody.
class Browser {
 public:
  /// @return false where there is no display, or nothing that opens files
  bool open(const std::string& url);
  Browser() = default;
  ~Browser();
  Browser(const Browser&) = delete;
  Browser& operator=(const Browser&) = delete;

 private:
  std::string file_;
};

}  // namespace mlab::cli
