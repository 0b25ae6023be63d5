#pragma once

#include <array>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <string>
#include <string_view>

#include "descriptor.h"
#include "event_loop.h"
#include "link.h"

namespace mlab::network {

/// What a process writes to its standard output and errors, read as it comes, so that the process never waits
/// for its reader. Of each the first and the last half megabyte are kept.
class Output {
 public:
  enum Stream : std::uint8_t { kOutput, kErrors };

  /// @param loop  lives longer than this
  Output(EventLoop& loop, Descriptor output, Descriptor errors);
  ~Output();
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  std::string text(Stream stream) const;
  /// Waits until it has written this, whole, to one of the two.
  /// @return  false: not within the time, or all who could write it have ended
  bool has(std::string_view text, Duration limit) const;
  /// Reads what is there already: all that one who has ended had written.
  void drain();

 private:
  struct Part {
    Descriptor pipe;
    bool is_open = true;
    std::string first;
    std::string last;
    std::size_t left_out = 0;  ///< bytes between them
  };

  void read_from(Part& part);
  static void keep(Part& part, std::string_view text);
  std::string text_of(const Part& part) const;

  EventLoop& loop_;
  mutable std::mutex mutex_;  ///< of the parts
  mutable std::condition_variable changed_;
  std::array<Part, 2> parts_;
};

}  // namespace mlab::network
