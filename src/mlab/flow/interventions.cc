#include "mlab/flow/interventions.h"

#include <algorithm>
#include <cstring>
#include <type_traits>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "mlab/flow/program.h"
#include "mlab/flow/type_words.h"
#include "mlab/text/shown.h"

namespace mlab::flow {

static_assert(std::is_trivially_copyable_v<Interventions>, "is handed to processes byte by byte");

std::optional<std::string> Interventions::force(const Program& program, const std::byte* frame,
                                                std::string_view sequence, std::string_view state) {
  std::uint32_t s = 0;
  while (s < program.sequence_count() && program.sequence_name(s) != sequence) ++s;
  if (s == program.sequence_count()) return fmt::format("there is no sequence `{}`", text::shown(sequence));
  const std::vector<std::string>& names = program.state_names(s);
  const auto name = std::ranges::find(names, state);
  if (name == names.end()) return fmt::format("`{}` has no state `{}`", sequence, text::shown(state));
  std::vector<Program::SequenceState> states;
  program.sequence_states(frame, states);
  const std::uint64_t now = Program::cycle(frame);
  if (now != 0 && states[s].cycle != static_cast<std::uint32_t>(now))
    return fmt::format("`{}` does not run now", sequence);
  Forced* known = coming(s);
  if (known == nullptr) {
    if (coming_count_ == kMostForced)
      return fmt::format("{} sequences are to go somewhere already", kMostForced);
    known = &coming_[coming_count_++];
  }
  *known = {s, static_cast<std::uint32_t>(name - names.begin()), false};
  return std::nullopt;
}

std::optional<std::string> Interventions::why_never_held(const Program& program, const Port& port) {
  if (port.role != Port::Role::kOutput)
    return fmt::format("`{}` is not computed: set it instead of holding it", port.path);
  if (program.is_news(port))
    return fmt::format("`{}` says when a value has come, and can't be held: hold the value", port.path);
  if (port.type->parse == nullptr) return why_not_written(port.path, *port.type);
  if (port.type->size > kLargest)
    return fmt::format("{} has {} bytes, and at most {} can be held", value_of(*port.type), port.type->size,
                       kLargest);
  return std::nullopt;
}

std::optional<std::string> Interventions::hold(const Program& program, const std::byte* frame,
                                               std::string_view path, std::string_view value) {
  const Port* port = program.find(path);
  if (port == nullptr) return fmt::format("the program has no `{}`", text::shown(path));
  if (auto problem = why_never_held(program, *port)) return problem;
  alignas(Frame::kAlignment) Program::ValueBytes bytes{};
  if (auto problem = Program::read(*port, value, bytes)) return problem;
  Held* known = held_at(port->offset);
  if (known == nullptr) {
    if (held_count_ == kMostHeld)
      return fmt::format("{} values are held already, and no more can be", kMostHeld);
    known = &held_[held_count_++];
    *known = {};
    known->offset = port->offset;
    known->size = port->type->size;
    std::memcpy(known->computed.data(), frame + port->offset, known->size);
  }
  known->port = static_cast<std::uint32_t>(port - program.ports().data());
  std::memcpy(known->value.data(), bytes.data(), known->size);
  return std::nullopt;
}

std::optional<std::string> Interventions::release(const Program& program, std::byte* frame,
                                                  std::string_view path) {
  if (path.empty()) {
    let_go(frame);
    held_count_ = 0;
    return std::nullopt;
  }
  const Port* port = program.find(path);
  Held* known = port == nullptr ? nullptr : held_at(port->offset);
  if (known == nullptr) return fmt::format("`{}` is not held", text::shown(path));
  std::memcpy(frame + known->offset, known->computed.data(), known->size);
  std::move(known + 1, held_.data() + held_count_, known);
  --held_count_;
  return std::nullopt;
}

void Interventions::finish() {
  last_ = coming_;
  last_count_ = std::exchange(coming_count_, 0);
}

void Interventions::begin_anew(const std::byte* frame) {
  coming_count_ = last_count_ = 0;
  for (std::uint32_t i = 0; i < held_count_; ++i)
    std::memcpy(held_[i].computed.data(), frame + held_[i].offset, held_[i].size);
}

void Interventions::let_go(std::byte* frame) const {
  for (const Held& one : held()) std::memcpy(frame + one.offset, one.computed.data(), one.size);
}

std::optional<std::string> Interventions::why_not_held(const Port* mine, const Port& theirs, const Held& held,
                                                       const Program& after, bool has_same_code) {
  if (mine == nullptr) return "nothing of that name is left";
  if (mine->type != theirs.type && !(has_same_code && same_type(*mine->type, *theirs.type)))
    return fmt::format("it is {} now", value_of(*mine->type));
  if (auto problem = why_never_held(after, *mine)) return problem;
  if (held_at(mine->offset) != nullptr) return "it is one with another that is held";
  if (!Program::is_in_range(*mine, held.value.data())) return "the value is out of its range now";
  return std::nullopt;
}

std::vector<Interventions::Lost> Interventions::carry_over(const Program& before,
                                                           const std::byte* before_frame,
                                                           const Program& after, std::byte* frame,
                                                           bool has_same_code) {
  std::vector<Lost> lost;
  const Interventions old = std::exchange(*this, {});
  for (const Held& one : old.held()) {
    const Port& theirs = before.ports()[one.port];
    const Port* const mine = after.find(theirs.path);
    if (const auto why = why_not_held(mine, theirs, one, after, has_same_code)) {
      lost.push_back({theirs.path, fmt::format("is not held any more: {}", *why)});
      continue;
    }
    Held& held = held_[held_count_++];
    held = one;
    held.port = static_cast<std::uint32_t>(mine - after.ports().data());
    held.offset = mine->offset;
    // Of the node before, or of one that begins anew.
    std::memcpy(held.computed.data(), frame + held.offset, held.size);
    const bool was_seen =
        before_frame != nullptr && std::memcmp(before_frame + one.offset, one.computed.data(), one.size) != 0;
    if (was_seen) std::memcpy(frame + held.offset, before_frame + one.offset, held.size);
  }
  for (std::uint32_t i = 0; i < old.coming_count_; ++i) {
    const std::string& sequence = before.sequence_name(old.coming_[i].sequence);
    const std::string& state = before.state_names(old.coming_[i].sequence)[old.coming_[i].state];
    if (const auto why = force(after, frame, sequence, state))
      lost.push_back({sequence, fmt::format("is not sent to {} any more: {}", state, *why)});
  }
  return lost;
}

bool Interventions::are_of(const Program& program) const {
  if (held_count_ > kMostHeld || coming_count_ > kMostForced || last_count_ > kMostForced) return false;
  const auto is_held = [&](const Held& one) {
    if (one.port >= program.ports().size()) return false;
    const Port& port = program.ports()[one.port];
    return one.offset == port.offset && one.size == port.type->size && !why_never_held(program, port);
  };
  const auto is_forced = [&](const Forced& one) {
    std::byte flag{};
    std::memcpy(&flag, &one.was_done, 1);
    return flag <= std::byte{1} && one.sequence < program.sequence_count() &&
           one.state < program.state_names(one.sequence).size();
  };
  return std::all_of(held_.begin(), held_.begin() + held_count_, is_held) &&
         std::all_of(coming_.begin(), coming_.begin() + coming_count_, is_forced) &&
         std::all_of(last_.begin(), last_.begin() + last_count_, is_forced);
}

void Interventions::take_notes_of(const Interventions& other) {
  for (std::uint32_t i = 0; i < held_count_; ++i) held_[i].computed = other.held_[i].computed;
  for (std::uint32_t i = 0; i < coming_count_; ++i) {
    std::byte flag{};
    std::memcpy(&flag, &other.coming_[i].was_done, 1);
    coming_[i].was_done = flag != std::byte{0};
  }
}

}  // namespace mlab::flow
