#pragma once

#include <string>
#include <vector>

#include <sys/types.h>

namespace mlab {

/// A program on a terminal of its own (a pseudo-terminal), and the person in front of it.
class Terminal {
 public:
  /// Starts `words` by the shell, in this folder.
  Terminal(const std::string& folder, const std::string& words);
  ~Terminal();
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  /// Everything that was printed so far, with the escape sequences in it.
  const std::string& output() const { return output_; }
  /// What stands in the last line, as the person sees it.
  std::string last_line() const;
  /// Reads until `text` was printed. False where the program ends or half a minute passes without.
  bool await(const std::string& text);
  /// Reads for so long, or until the program ends.
  void watch(double seconds);
  void type(const std::string& text) const;
  /// Reads to the end. @return the exit status; -1: none
  int finish();

 private:
  bool read_some(double seconds);

  int screen_ = -1;
  pid_t process_ = -1;
  bool has_ended_ = false;
  std::string output_;
};

/// Seconds by a clock that never jumps.
double now();

}  // namespace mlab
