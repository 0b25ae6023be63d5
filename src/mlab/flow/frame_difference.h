#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mlab/flow/frame.h"

namespace mlab::flow {

/// A frame as what differs from another one of the same program. Most of a frame is parameters, and nodes
/// that do not fire: what is left is a fraction of it.
class FrameDifference {
 public:
  FrameDifference() = default;
  /// @param base  of the same size; needed again to make the frame
  FrameDifference(const Frame& base, const Frame& frame);

  /// Makes the frame, bit for bit.
  void apply(const Frame& base, Frame& out) const;
  /// That it holds beside itself.
  std::size_t bytes() const { return bytes_.capacity() + runs_.capacity() * sizeof(Run); }

 private:
  struct Run {
    std::uint32_t offset;
    std::uint32_t size;
  };
  std::vector<Run> runs_;
  std::vector<std::byte> bytes_;  // of all runs
};

}  // namespace mlab::flow
