#include "mlab/flow/frame_difference.h"

#include <algorithm>
#include <cstring>

namespace mlab::flow {
namespace {

constexpr std::size_t kWord = 8;  // what is compared at once [bytes]

}  // namespace

FrameDifference::FrameDifference(const Frame& base, const Frame& frame) {
  const std::size_t size = frame.size();
  std::size_t changed = 0;
  for (std::size_t at = 0; at < size; at += kWord) {
    const std::size_t word = std::min(kWord, size - at);
    if (std::memcmp(base.data() + at, frame.data() + at, word) == 0) continue;
    changed += word;
    if (!runs_.empty() && runs_.back().offset + runs_.back().size == at)
      runs_.back().size += static_cast<std::uint32_t>(word);
    else
      runs_.push_back({static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(word)});
  }
  runs_.shrink_to_fit();
  bytes_.reserve(changed);
  for (const Run& run : runs_)
    bytes_.insert(bytes_.end(), frame.data() + run.offset, frame.data() + run.offset + run.size);
}

void FrameDifference::apply(const Frame& base, Frame& out) const {
  out = base;
  const std::byte* from = bytes_.data();
  for (const Run& run : runs_) {
    std::memcpy(out.data() + run.offset, from, run.size);
    from += run.size;
  }
}

}  // namespace mlab::flow
