#pragma once

#include <expected>
#include <memory>
#include <string>
#include <string_view>

namespace mlab::model_vehicles {

/// A serial line whose other end is a file that programs open as they open `/dev/ttyS0`. What nobody there
/// reads is thrown away, as it is on a line.
class PseudoTerminal {
 public:
  /// @param link  a symbolic link to its file that is to be there as long as it is; empty: none. One that
  ///              points at a pseudo-terminal is replaced: who was killed leaves it
  /// @errors  what the system said of it, as a sentence
  static std::expected<std::unique_ptr<PseudoTerminal>, std::string> open(const std::string& link);
  ~PseudoTerminal();
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;

  /// Of the file that is to be opened.
  const std::string& path() const { return path_; }
  /// All that has come; does not wait.
  std::string read() const;
  void write(std::string_view bytes) const;

 private:
  PseudoTerminal() = default;

  int own_end_ = -1;
  int other_end_ = -1;  // kept open: whoever closes his does not hang up
  std::string path_;
  std::string link_;
};

}  // namespace mlab::model_vehicles
