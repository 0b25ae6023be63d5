#include "mlab/flow/carry_over.h"

#include <algorithm>
#include <cstring>
#include <map>
#include <optional>
#include <utility>

#include <fmt/core.h>

#include "mlab/base/hash.h"

namespace mlab::flow {

/// One robot's values on their way from one program to another.
class CarryOver {
 public:
  CarryOver(const ProgramVersion& before, const std::byte* frame, const ProgramVersion& after,
            bool has_same_code)
      : before_(before), old_(frame), after_(after), has_same_code_(has_same_code) {}

  CarriedOver carry();

 private:
  using Instruction = Program::Instruction;
  using Kind = Instruction::Kind;
  static constexpr std::uint32_t kNone = Program::kNone;

  std::byte* fresh() { return out_.frame.data(); }
  void copy(std::uint32_t to, std::uint32_t from, std::size_t size) {
    std::memcpy(fresh() + to, old_ + from, size);
  }
  bool is_same_program() const;
  bool is_same_type(const TypeInfo& a, const TypeInfo& b) const {
    return &a == &b || (has_same_code_ && same_type(a, b));
  }
  bool does_same(const Instruction& mine, const Instruction& theirs) const;
  void index();
  void carry_settings();
  void carry_node(const Instruction& mine);
  void carry_stamp(const Instruction& mine, const Instruction& theirs);
  bool carry_state(const Instruction& mine, const Instruction& theirs);
  void carry_sequence(const Instruction& mine, const Instruction& theirs);
  void carry_delay(const Instruction& mine, const Instruction& theirs);
  void tell(std::uint64_t path_hash, std::string why);

  const ProgramVersion& before_;
  const std::byte* old_;
  const ProgramVersion& after_;
  const bool has_same_code_;
  CarriedOver out_;
  std::map<std::uint64_t, const Instruction*> theirs_;         // by path
  std::map<std::uint64_t, const Program::KeptCode*> my_kept_;  // likewise
  std::map<std::uint64_t, const Program::KeptCode*> their_kept_;
  std::map<std::uint64_t, const Port*> my_outputs_;
  std::map<std::uint64_t, const Port*> their_outputs_;
};

CarriedOver CarryOver::carry() {
  if (is_same_program()) {
    out_.frame = after_.initial;
    std::memcpy(fresh(), old_, out_.frame.size());
    carry_settings();
    return std::move(out_);
  }
  index();
  out_.frame = after_.initial;
  copy(0, 0, sizeof(std::uint64_t));  // the cycle
  carry_settings();
  std::map<std::uint64_t, bool> is_done;
  for (const Instruction& mine : after_.program.instructions_) {
    if (!std::exchange(is_done[mine.path_hash], true)) carry_node(mine);
  }
  return std::move(out_);
}

// Equal layouts may still be of other behaviors.
bool CarryOver::is_same_program() const {
  const Program& a = before_.program;
  const Program& b = after_.program;
  if (&a == &b) return true;
  const bool can_be = has_same_code_ && a.layout_hash() == b.layout_hash() &&
                      a.state_names_ == b.state_names_ && a.sequence_names_ == b.sequence_names_ &&
                      a.asyncs_.empty();
  return can_be &&
         std::ranges::equal(a.instructions_, b.instructions_, {}, &Instruction::fire, &Instruction::fire) &&
         std::ranges::equal(a.ports_, b.ports_, [this](const Port& x, const Port& y) {
           return x.role == y.role && is_same_type(*x.type, *y.type);
         });
}

void CarryOver::index() {
  for (const Instruction& one : before_.program.instructions_) theirs_.try_emplace(one.path_hash, &one);
  for (const auto& kept : after_.program.kept_) my_kept_.try_emplace(kept.path_hash, &kept);
  for (const auto& kept : before_.program.kept_) their_kept_.try_emplace(kept.path_hash, &kept);
  const auto list = [](const Program& program, std::map<std::uint64_t, const Port*>& out) {
    for (const Port& port : program.ports_) {
      if (port.role == Port::Role::kOutput) out.try_emplace(base::hash_text(port.path), &port);
    }
  };
  list(after_.program, my_outputs_);
  list(before_.program, their_outputs_);
}

// What the text says is what holds, unless somebody has set it while the robot ran.
void CarryOver::carry_settings() {
  for (const Port& mine : after_.program.ports_) {
    if (mine.role == Port::Role::kOutput) continue;
    const std::size_t size = mine.type->size;
    std::memcpy(fresh() + mine.offset, after_.initial.data() + mine.offset, size);
    const Port* const theirs = before_.program.find(mine.path);
    if (theirs == nullptr || theirs->role == Port::Role::kOutput || !is_same_type(*mine.type, *theirs->type))
      continue;
    const bool was_set =
        std::memcmp(old_ + theirs->offset, before_.initial.data() + theirs->offset, size) != 0;
    if (!was_set) continue;
    if (Program::is_in_range(mine, old_ + theirs->offset))
      copy(mine.offset, theirs->offset, size);
    else
      out_.restarts.push_back({mine.path, kOutOfRange});
  }
}

bool CarryOver::does_same(const Instruction& mine, const Instruction& theirs) const {
  if (mine.kind != theirs.kind) return false;
  const bool is_behavior = mine.kind == Kind::kFire || mine.kind == Kind::kStartAsync;
  if (is_behavior && mine.fire != theirs.fire) return false;
  if (is_behavior && mine.fire == nullptr && !has_same_code_) return false;
  const auto my_output = my_outputs_.find(mine.path_hash);
  const auto their_output = their_outputs_.find(mine.path_hash);
  const bool has_output = my_output != my_outputs_.end();
  if (has_output != (their_output != their_outputs_.end())) return false;
  return !has_output || is_same_type(*my_output->second->type, *their_output->second->type);
}

void CarryOver::carry_node(const Instruction& mine) {
  const auto found = theirs_.find(mine.path_hash);
  if (found == theirs_.end()) return;  // it is new
  const Instruction& theirs = *found->second;
  if (!does_same(mine, theirs) || !carry_state(mine, theirs)) {
    if (mine.stamp != kNone) tell(mine.path_hash, "is another component now");
    return;
  }
  if (const auto output = my_outputs_.find(mine.path_hash); output != my_outputs_.end())
    copy(output->second->offset, their_outputs_.at(mine.path_hash)->offset, output->second->type->size);
  carry_stamp(mine, theirs);
  if (mine.kind == Kind::kSequence) carry_sequence(mine, theirs);
  if (mine.kind == Kind::kDelay) carry_delay(mine, theirs);
  if (mine.kind == Kind::kStartAsync) tell(mine.path_hash, "computes anew: what it was at is lost");
}

void CarryOver::carry_stamp(const Instruction& mine, const Instruction& theirs) {
  if (mine.stamp != kNone && theirs.stamp != kNone) copy(mine.stamp, theirs.stamp, sizeof(std::uint32_t));
}

bool CarryOver::carry_state(const Instruction& mine, const Instruction& /*theirs*/) {
  const auto my_state = my_kept_.find(mine.path_hash);
  const auto their_state = their_kept_.find(mine.path_hash);
  const bool has_state = my_state != my_kept_.end();
  if (has_state != (their_state != their_kept_.end())) return false;
  if (!has_state) return true;
  if (my_state->second->size != their_state->second->size) return false;
  copy(my_state->second->offset, their_state->second->offset, my_state->second->size);
  return true;
}

void CarryOver::carry_sequence(const Instruction& mine, const Instruction& theirs) {
  const Program::SequenceCode& code = after_.program.sequences_[mine.data];
  const std::string& state =
      before_.program.state_names_[theirs.data][before_.program.sequences_[theirs.data].active_in(old_)];
  const std::vector<std::string>& names = after_.program.state_names_[mine.data];
  const auto known = std::ranges::find(names, state);
  const auto active = known == names.end() ? code.start : static_cast<std::uint32_t>(known - names.begin());
  std::memcpy(fresh() + code.active, &active, sizeof active);
  if (known == names.end())
    tell(mine.path_hash, fmt::format("begins in {}: its state {} is gone", names[code.start], state));
}

void CarryOver::carry_delay(const Instruction& mine, const Instruction& theirs) {
  const Program::DelayCode& my_delay = after_.program.delays_[mine.data];
  copy(my_delay.next, before_.program.delays_[theirs.data].next, my_delay.value_size);
}

void CarryOver::tell(std::uint64_t path_hash, std::string why) {
  std::string path = "something without a name";
  if (const auto port = my_outputs_.find(path_hash); port != my_outputs_.end())
    path = port->second->path;
  else if (const auto kept = my_kept_.find(path_hash); kept != my_kept_.end())
    path = kept->second->path;
  out_.restarts.push_back({std::move(path), std::move(why)});
}

CarriedOver carry_over(const ProgramVersion& before, const std::byte* frame, const ProgramVersion& after,
                       bool has_same_code) {
  return CarryOver(before, frame, after, has_same_code).carry();
}

}  // namespace mlab::flow
