#include "mlab/flow/frame_difference.h"

#include <cstring>
#include <random>

#include <gtest/gtest.h>

namespace mlab::flow {
namespace {

Frame drawn(std::size_t size, std::mt19937& random) {
  Frame out(size);
  for (std::size_t i = 0; i < size; ++i) out.data()[i] = static_cast<std::byte>(random());
  return out;
}

TEST(FrameDifference, MakesTheFrameAgainWhateverDiffers) {
  std::mt19937 random(1);
  for (int round = 0; round < 500; ++round) {
    const std::size_t size = random() % 300;
    const Frame base = drawn(size, random);
    Frame frame = base;
    for (std::size_t changes = size == 0 ? 0 : random() % 20; changes > 0; --changes)
      frame.data()[random() % size] = static_cast<std::byte>(random());
    Frame made = drawn(random() % 300, random);
    FrameDifference(base, frame).apply(base, made);
    EXPECT_TRUE(made == frame) << "of " << size << " bytes";
  }
}

TEST(FrameDifference, HoldsWhatDiffersAndLittleMore) {
  const Frame base(10'000);
  Frame frame = base;
  EXPECT_EQ(FrameDifference(base, frame).bytes(), 0U);
  frame.data()[9'999] = std::byte{1};
  EXPECT_LE(FrameDifference(base, frame).bytes(), 16U);
}

}  // namespace
}  // namespace mlab::flow
