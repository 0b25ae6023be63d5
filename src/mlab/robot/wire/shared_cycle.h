#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <new>
#include <optional>
#include <span>
#include <vector>

#include "mlab/flow/interventions.h"
#include "mlab/percept/action.h"
#include "mlab/percept/percepts.h"
#include "mlab/robot/wire/shared_number.h"

/// How a run and a robot program of the same build share a cycle in memory, without copying it through a
/// pipe.
///
/// Two files: in `frames` both sides write, the program reads `percepts` only. `frames` begins with a
/// Control, and from kFirstPlace on has one place for each robot of the cycle: a PlaceHeader, and behind it
/// the robot's frame, and its flow::Interventions. The run fills places and percepts, one after the other,
/// and counts in `asked` how many; the program computes them in that order, at once, and counts in
/// `answered`. Both go on from cycle to cycle, and over the largest number to 0. What the run reads there may
/// be anything: the program is not trusted.

namespace mlab::robot_wire {

/// The descriptors that a program finds the files under.
inline constexpr int kFramesDescriptor = 3;
inline constexpr int kPerceptsDescriptor = 4;

inline constexpr std::size_t kFirstPlace = 4096;

struct alignas(64) Control {
  static constexpr std::uint32_t kNobody = 0xffffffffU;

  alignas(64) SharedNumber asked;
  std::uint32_t before = 0;       ///< what `asked` was before the first place of the cycle
  std::uint64_t frames_size = 0;  ///< of the files; they only grow [bytes]
  std::uint64_t percepts_size = 0;
  alignas(64) SharedNumber answered;
  alignas(64) std::atomic<std::uint32_t> place{kNobody};  ///< whose program runs now
  std::atomic<std::uint32_t> node{kNobody};  ///< which node of the network whose code was brought
  std::atomic<std::uint32_t> out_of_memory{0};
};

/// In front of each frame.
struct alignas(64) PlaceHeader {
  std::uint32_t robot = 0;
  std::uint32_t has_interventions = 0;  ///< 0: what stands behind the frame is of no meaning
  std::uint64_t seed = 0;
  std::uint64_t percepts = 0;                               ///< where they begin in the other file
  std::array<std::byte, sizeof(percept::Action)> action{};  ///< as `write_action` leaves it
};

/// Bytes from one place to the next.
constexpr std::size_t place_size(std::size_t frame_size) {
  return (sizeof(PlaceHeader) + frame_size + sizeof(flow::Interventions) + 63) / 64 * 64;
}
/// @param frame_size  a multiple of the alignment of frames
inline flow::Interventions* interventions_of(std::byte* frame, std::size_t frame_size) {
  return std::launder(reinterpret_cast<flow::Interventions*>(frame + frame_size));
}

/// Changes with everything that both sides have to agree on byte by byte.
std::uint64_t shared_layout();

/// How many bytes `write_percepts` fills.
std::size_t percepts_size(const percept::Percepts& percepts);
/// Copies percepts with all their lists to `out`, which is aligned to 64 bytes.
void write_percepts(const percept::Percepts& percepts, std::byte* out);

/// Percepts as `write_percepts` left them. Their lists are views of what was written.
class ReadPercepts {
 public:
  const percept::Percepts& read(const std::byte* from);

 private:
  percept::Percepts percepts_;
  std::vector<percept::Room> rooms_;
};

using ActionBytes = std::span<std::byte, sizeof(percept::Action)>;
using ConstActionBytes = std::span<const std::byte, sizeof(percept::Action)>;
/// Copies what counts of an action: mostly it asks for nothing and tells nothing.
void write_action(const percept::Action& action, ActionBytes out);
/// The action that a program left. False, and nothing in `out`: it has a field that there is not.
bool read_action(ConstActionBytes bytes, percept::Action& out);

}  // namespace mlab::robot_wire
