#include "mlab/comparison/program_pair.h"

#include <algorithm>
#include <cstring>
#include <map>

namespace mlab::comparison {

ProgramPair::ProgramPair(const Both<const flow::Program*>& programs) : programs_(programs) {
  const auto& [a, b] = programs;
  is_same_layout_ = a == b || a->layout_hash() == b->layout_hash();
  for (const flow::Port& port : a->ports()) {
    const flow::Port* const other = b->find(port.path);
    const bool is_output = port.role == flow::Port::Role::kOutput;
    if (other != nullptr && other->role == port.role && flow::same_type(*port.type, *other->type))
      (is_output ? outputs_ : settings_).push_back({{&port, other}});
    else if (is_output)
      only_[0].push_back(port.path);
  }
  for (const flow::Port& port : b->ports()) {
    if (port.role == flow::Port::Role::kOutput && a->find(port.path) == nullptr)
      only_[1].push_back(port.path);
  }
  // Offsets grow in the order in which values are computed.
  std::ranges::stable_sort(outputs_, {}, [](const PortPair& pair) { return pair.ports[0]->offset; });
  std::map<std::string, std::uint32_t> theirs;
  for (std::uint32_t i = 0; i < b->sequence_count(); ++i) theirs.emplace(b->sequence_name(i), i);
  for (std::uint32_t i = 0; i < a->sequence_count(); ++i) {
    const auto found = theirs.find(a->sequence_name(i));
    if (found != theirs.end()) sequences_.emplace_back(i, found->second);
  }
}

bool ProgramPair::are_equal_bytes(const Frames& frames) const {
  return is_same_layout_ && std::memcmp(frames[0], frames[1], programs_[0]->frame_size()) == 0;
}

// Bytes between the members of a value mean nothing, and neither does which NaN it is; so what looks the same
// to a person, down to the last digit, is the same.
bool ProgramPair::differs(const PortPair& pair, const Frames& frames) const {
  const auto& [a, b] = pair.ports;
  if (std::memcmp(frames[0] + a->offset, frames[1] + b->offset, a->type->size) == 0) return false;
  return a->type->print == nullptr ||
         flow::Program::print(frames[0], *a) != flow::Program::print(frames[1], *b);
}

const ProgramPair::PortPair* ProgramPair::first_difference(const Frames& frames) const {
  const auto found =
      std::ranges::find_if(outputs_, [&](const PortPair& pair) { return differs(pair, frames); });
  return found == outputs_.end() ? nullptr : &*found;
}

std::optional<Value> ProgramPair::state_difference(const Frames& frames) const {
  if (sequences_.empty()) return std::nullopt;
  Both<std::vector<flow::Program::SequenceState>> states;
  for (const std::size_t side : kSides) programs_[side]->sequence_states(frames[side], states[side]);
  for (const auto& [a, b] : sequences_) {
    const std::string& one = programs_[0]->state_names(a)[states[0][a].active];
    const std::string& other = programs_[1]->state_names(b)[states[1][b].active];
    if (one != other) return Value{programs_[0]->sequence_name(a), {one, other}};
  }
  return std::nullopt;
}

Value value_of(const ProgramPair::PortPair& pair, const ProgramPair::Frames& frames) {
  return {pair.ports[0]->path,
          {flow::Program::print(frames[0], *pair.ports[0]), flow::Program::print(frames[1], *pair.ports[1])}};
}

}  // namespace mlab::comparison
