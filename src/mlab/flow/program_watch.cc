// What happened in the cycle that ran last: for who looks on. Nothing of it is called by `step`.

#include <algorithm>
#include <cstring>
#include <new>

#include "mlab/flow/program.h"

namespace mlab::flow {
namespace {

template <class T>
const T& value_at(const std::byte* frame, std::uint32_t offset) {
  return *std::launder(reinterpret_cast<const T*>(frame + offset));
}

}  // namespace

std::optional<geom::Vector> Program::vector(const std::byte* frame, const Port& port) {
  if (port.type->kind != TypeKind::kVector) return std::nullopt;
  return value_at<geom::Vector>(frame, port.offset);
}

void Program::sequence_states(const std::byte* frame, std::vector<SequenceState>& out) const {
  out.clear();
  for (const SequenceCode& sequence : sequences_) {
    out.push_back({sequence.active_in(frame),
                   sequence.stamp == kNone ? 0 : value_at<std::uint32_t>(frame, sequence.stamp)});
  }
}

std::optional<std::uint32_t> Program::way_taken(const std::byte* frame, std::uint32_t sequence,
                                                std::uint32_t from) const {
  const std::vector<TransitionCode>& ways = sequences_[sequence].states[from].transitions;
  for (std::uint32_t i = 0; i < ways.size(); ++i) {
    if ((frame[ways[i].trigger] != std::byte{0}) != ways[i].is_negated) return i;
  }
  return std::nullopt;
}

// A sequence goes on where it ran in the cycle before, unless something around it was restarted; then what it
// did does not fit to the state that it had.
std::uint32_t Program::state_before(const std::byte* frame, std::uint32_t sequence,
                                    std::span<const SequenceState> before) const {
  const SequenceCode& code = sequences_[sequence];
  const auto now = static_cast<std::uint32_t>(cycle(frame));
  if (before.size() != sequences_.size() || before[sequence].cycle == 0 || before[sequence].cycle != now - 1)
    return code.start;
  const std::uint32_t from = before[sequence].active;
  if (from >= code.states.size()) return code.start;
  const auto way = way_taken(frame, sequence, from);
  const std::uint32_t to = way ? code.states[from].transitions[*way].target : from;
  return to == code.active_in(frame) ? from : code.start;
}

// A way that leads there counts as taken, where there is one: who draws it shows it.
Program::Transit Program::forced_transit(const std::byte* frame, const Interventions::Forced& forced,
                                         std::span<const SequenceState> before) const {
  const SequenceCode& code = sequences_[forced.sequence];
  const auto now = static_cast<std::uint32_t>(cycle(frame));
  const bool went_on = before.size() == sequences_.size() && before[forced.sequence].cycle != 0 &&
                       before[forced.sequence].cycle == now - 1;
  const std::uint32_t known = went_on ? before[forced.sequence].active : code.start;
  const std::uint32_t from = known < code.states.size() ? known : code.start;
  const std::vector<TransitionCode>& ways = code.states[from].transitions;
  const auto way = std::ranges::find(ways, forced.state, &TransitionCode::target);
  return {forced.sequence, from, way == ways.end() ? kNone : static_cast<std::uint32_t>(way - ways.begin()),
          forced.state, true};
}

namespace {

// What the last cycle made the sequence do; null: nothing.
const Interventions::Forced* forced_in(const Interventions* interventions, std::uint32_t sequence) {
  if (interventions == nullptr) return nullptr;
  for (const Interventions::Forced& one : interventions->forced()) {
    if (one.sequence == sequence && one.was_done) return &one;
  }
  return nullptr;
}

}  // namespace

std::vector<Program::Transit> Program::transits(const std::byte* frame, std::span<const SequenceState> before,
                                                const Interventions* interventions) const {
  std::vector<Transit> out;
  const auto now = static_cast<std::uint32_t>(cycle(frame));
  for (std::uint32_t s = 0; s < sequences_.size(); ++s) {
    const SequenceCode& code = sequences_[s];
    if (now == 0 || code.stamp == kNone || value_at<std::uint32_t>(frame, code.stamp) != now) continue;
    if (const auto* const forced = forced_in(interventions, s)) {
      out.push_back(forced_transit(frame, *forced, before));
      continue;
    }
    const std::uint32_t from = state_before(frame, s, before);
    const auto way = way_taken(frame, s, from);
    if (!way) continue;
    const TransitionCode& taken = code.states[from].transitions[*way];
    if (taken.target != from || taken.restarts) out.push_back({s, from, *way, taken.target, false});
  }
  return out;
}

void Program::add_ran(const Block& block, const std::byte* frame, std::span<const SequenceState> before,
                      const Interventions* interventions, std::vector<std::uint32_t>& out) const {
  const auto now = static_cast<std::uint32_t>(cycle(frame));
  for (std::uint32_t n = block.first; n < block.first + block.count; ++n) {
    const Instruction& i = instructions_[n];
    if (i.stamp != kNone && value_at<std::uint32_t>(frame, i.stamp) != now) continue;
    out.push_back(i.output);
    if (i.kind == Instruction::Kind::kSequence) {
      const SequenceCode& code = sequences_[i.data];
      if (forced_in(interventions, i.data) == nullptr) {
        add_ran(code.states[state_before(frame, i.data, before)].triggers, frame, before, interventions, out);
      }
      add_ran(code.states[code.active_in(frame)].member, frame, before, interventions, out);
    } else if (i.kind == Instruction::Kind::kSelect) {
      const CaseCode* const chosen = selects_[i.data].chosen_in(frame);
      if (chosen != nullptr) add_ran(chosen->member, frame, before, interventions, out);
    }
  }
}

std::vector<std::uint32_t> Program::ran(const std::byte* frame, std::span<const SequenceState> before,
                                        const Interventions* interventions) const {
  std::vector<std::uint32_t> out;
  if (cycle(frame) != 0) add_ran(root_, frame, before, interventions, out);
  std::ranges::sort(out);
  out.erase(std::ranges::unique(out).begin(), out.end());
  return out;
}

}  // namespace mlab::flow
