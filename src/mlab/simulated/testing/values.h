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

/// What a port holds: its numbers bit by bit, and a sum of the words of what is none. Frames can't be
/// compared byte by byte: what lies between the members of a value is nobody's.
inline void add_value(const std::byte* frame, const flow::Port& port, std::vector<std::uint64_t>& out) {
  switch (port.type->kind) {
    case flow::TypeKind::kReal:
    case flow::TypeKind::kVector:
    case flow::TypeKind::kPoint:
    case flow::TypeKind::kPose:  // all of them doubles, and nothing between
      for (std::uint32_t at = 0; at < port.type->size; at += sizeof(double))
        std::memcpy(&out.emplace_back(), frame + port.offset + at, sizeof(double));
      return;
    case flow::TypeKind::kBool:
    case flow::TypeKind::kInteger:
    case flow::TypeKind::kChoice:
    case flow::TypeKind::kMask:
      out.push_back(std::bit_cast<std::uint64_t>(*flow::Program::number(frame, port)));
      return;
    case flow::TypeKind::kText:
    case flow::TypeKind::kList:
    case flow::TypeKind::kOther:
      out.push_back(base::hash_text(flow::Program::print(frame, port)));
  }
}

/// All that a robot's program holds, with next to no words, for who asks in each cycle: its ports with their
/// values, and the states of its sequences.
inline std::vector<std::uint64_t> values_of(const fleet::FleetRobot& robot) {
  const robot::Workings at = robot.workings();
  std::vector<std::uint64_t> out;
  for (const flow::Port& port : at.program->ports()) {
    out.push_back(base::hash_text(port.path));
    add_value(at.frame, port, out);
  }
  std::vector<flow::Program::SequenceState> states;
  at.program->sequence_states(at.frame, states);
  for (const flow::Program::SequenceState& one : states) {
    out.push_back(one.active);
    out.push_back(one.cycle);
  }
  return out;
}

}  // namespace mlab::simulated::testing
