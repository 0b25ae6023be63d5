#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "mlab/base/hash.h"
#include "mlab/fleet/fleet.h"
#include "mlab/flow/program.h"

namespace mlab::simulated::testing {

/// What a port holds, word by word: its numbers bit by bit, and a sum of the words of what is none. Frames
/// can't be compared byte by byte: what lies between the members of a value is nobody's.
/// @param take  is given each word
template <class Take>
void visit_value(const std::byte* frame, const flow::Port& port, const Take& take) {
  switch (port.type->kind) {
    case flow::TypeKind::kReal:
    case flow::TypeKind::kVector:
    case flow::TypeKind::kPoint:
    case flow::TypeKind::kPose:  // all of them doubles, and nothing between
      for (std::uint32_t at = 0; at < port.type->size; at += sizeof(double)) {
        std::uint64_t word = 0;
        std::memcpy(&word, frame + port.offset + at, sizeof(double));
        take(word);
      }
      return;
    case flow::TypeKind::kBool:
    case flow::TypeKind::kInteger:
    case flow::TypeKind::kChoice:
    case flow::TypeKind::kMask:
      take(std::bit_cast<std::uint64_t>(*flow::Program::number(frame, port)));
      return;
    case flow::TypeKind::kText:
    case flow::TypeKind::kList:
    case flow::TypeKind::kOther:
      take(base::hash_text(flow::Program::print(frame, port)));
  }
}

/// All that a robot's program holds, with next to no words, for who asks in each cycle: its ports with their
/// values, and the states of its sequences.
/// @param take  is given each word
template <class Take>
void visit_values(const fleet::FleetRobot& robot, const Take& take) {
  const robot::Workings at = robot.workings();
  for (const flow::Port& port : at.program->ports()) {
    take(base::hash_text(port.path));
    visit_value(at.frame, port, take);
  }
  std::vector<flow::Program::SequenceState> states;
  at.program->sequence_states(at.frame, states);
  for (const flow::Program::SequenceState& one : states) {
    take(one.active);
    take(one.cycle);
  }
}

inline std::vector<std::uint64_t> values_of(const fleet::FleetRobot& robot) {
  std::vector<std::uint64_t> out;
  visit_values(robot, [&out](std::uint64_t word) { out.push_back(word); });
  return out;
}

}  // namespace mlab::simulated::testing
