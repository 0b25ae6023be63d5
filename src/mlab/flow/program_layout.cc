#include <algorithm>
#include <cstring>
#include <iterator>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "mlab/base/hash.h"
#include "mlab/flow/port_types.h"
#include "mlab/flow/program_builder.h"

namespace mlab::flow {

using Instruction = Program::Instruction;

namespace {

template <class Code>
void append_each_once(std::vector<Code>& all, std::vector<Code> some, std::uint32_t& first,
                      std::uint32_t& count) {
  std::ranges::sort(some);
  some.erase(std::ranges::unique(some).begin(), some.end());
  first = static_cast<std::uint32_t>(all.size());
  count = static_cast<std::uint32_t>(some.size());
  all.insert(all.end(), some.begin(), some.end());
}

}  // namespace

std::uint32_t ProgramBuilder::allocate(std::size_t size, std::size_t alignment) {
  const auto a = static_cast<std::uint32_t>(alignment);
  frame_size_ = (frame_size_ + a - 1) / a * a;
  const std::uint32_t offset = frame_size_;
  frame_size_ += static_cast<std::uint32_t>(size);
  return offset;
}

std::uint32_t ProgramBuilder::canonical(std::uint32_t op) const {
  while (ops_[op].same_as != kNone) op = ops_[op].same_as;
  return op;
}

std::uint32_t ProgramBuilder::offset_of(const Ref& ref) const {
  switch (ref.kind) {
    case Ref::Kind::kSlot:
      return slots_[ref.index].offset;
    case Ref::Kind::kFresh:
      return ops_[canonical(ref.index)].fresh;
    default:
      return ops_[canonical(ref.index)].output;
  }
}

// All operations that the roots need, each after its own sources. What only a state or a case needs is left
// out, unless asked for: it has a block of its own. Iterative, because a chain may be ten thousand nodes
// long.
std::vector<std::uint32_t> ProgramBuilder::order(const std::vector<std::uint32_t>& roots, bool with_members) {
  visited_.resize(ops_.size(), 0);
  ++block_number_;
  std::vector<std::uint32_t> out;
  struct Visit {
    std::uint32_t op;
    std::vector<std::uint32_t> sources;
    std::size_t next = 0;
  };
  std::vector<std::uint32_t> waiting(roots.rbegin(), roots.rend());
  std::vector<Visit> path;
  const auto enter = [&](std::uint32_t op) {
    op = canonical(op);
    if (std::exchange(visited_[op], block_number_) == block_number_) return;
    Visit visit{op, {}, 0};
    const auto add = [&](const Ref& ref) {
      if (ref.kind == Ref::Kind::kOp || ref.kind == Ref::Kind::kFresh) visit.sources.push_back(ref.index);
    };
    for (const auto& input : ops_[op].inputs) {
      for (const Ref& ref : input) add(ref);
    }
    add(ops_[op].selector);
    for (const StateRefs& state : ops_[op].states) {
      if (!with_members) break;
      for (const Ref& trigger : state.triggers) add(trigger);
      add(state.member);
    }
    for (const Ref& member : ops_[op].cases) {
      if (with_members) add(member);
    }
    // What a delay keeps for the next cycle has to be evaluated in this one, but not before it.
    if (ops_[op].value.kind == Ref::Kind::kOp) waiting.insert(waiting.begin(), ops_[op].value.index);
    path.push_back(std::move(visit));
  };
  while (!waiting.empty() || !path.empty()) {
    if (path.empty()) {
      const std::uint32_t root = waiting.back();
      waiting.pop_back();
      enter(root);
      continue;
    }
    if (path.back().next < path.back().sources.size()) {
      enter(path.back().sources[path.back().next++]);
    } else {
      out.push_back(path.back().op);
      path.pop_back();
    }
  }
  return out;
}

void ProgramBuilder::lay_out() {
  place_values();
  program_->root_ = emit(roots());
  assign_stamps();
  emit_mixtures();
  for (std::uint32_t i = 0; i < ops_.size(); ++i) {
    if (op_ports_[i] != kNone)
      program_->ports_[op_ports_[i]].offset = offset_of({Ref::Kind::kOp, i, nullptr, "", ""});
  }
  list_kept();
  add_fresh_ports();
  for (std::uint32_t i = 0; i < program_->ports_.size(); ++i)
    program_->port_index_.emplace(program_->ports_[i].path, i);
  for (const auto& [name, entry] : names_) {  // a parameter's other names
    if (entry.ref.kind == Ref::Kind::kSlot) program_->port_index_.emplace(name, slots_[entry.ref.index].port);
  }
  write_initial_frame();
}

// A cycle goes through a frame from its beginning to its end, about: where robots are many each part of a
// frame that it touches comes from afar. So what is large, of which mostly the begin is used, stands behind
// the rest.
void ProgramBuilder::place_values() {
  for (Slot& slot : slots_) {
    const TypeInfo& type = *program_->ports_[slot.port].type;
    slot.offset = allocate(type.size, type.alignment);
    program_->ports_[slot.port].offset = slot.offset;
  }
  const std::vector<std::uint32_t> ops = order_of_cycle();
  for (const bool is_large : {false, true}) {
    if (is_large) program_->near_size_ = frame_size_;
    const auto place = [&](const Op& op, std::uint32_t& offset, std::uint32_t size, std::uint32_t alignment) {
      constexpr std::uint32_t kLarge = 8 * Frame::kAlignment;
      if ((size >= kLarge) != is_large) return;
      offset = allocate(size, is_large ? static_cast<std::uint32_t>(Frame::kAlignment) : alignment);
      if (is_large) program_->large_.push_back({offset, op.stamp});
    };
    for (const std::uint32_t i : ops) {
      Op& op = ops_[i];
      if (!is_large && has_own_stamp(op)) op.stamp = allocate(4, 4);
      if (op.behavior != nullptr) place(op, op.state, op.behavior->state_size, op.behavior->state_alignment);
      if (op.type != nullptr) place(op, op.output, op.type->size, op.type->alignment);
      if (!is_large && op.kind == Instruction::Kind::kStartAsync) op.fresh = allocate(1, 1);
    }
  }
}

// All operations about as a cycle comes to them: those of a state or a case before what chooses among them.
std::vector<std::uint32_t> ProgramBuilder::order_of_cycle() {
  std::vector<std::uint32_t> all = roots();
  for (std::uint32_t i = 0; i < ops_.size(); ++i) all.push_back(i);
  return order(all, true);
}

std::vector<std::uint32_t> ProgramBuilder::roots() const {
  std::vector<std::uint32_t> out;
  for (std::uint32_t i = 0; i < ops_.size(); ++i) {
    const bool is_sink = ops_[i].behavior != nullptr && ops_[i].type == nullptr;
    if (is_sink || (ops_[i].node != nullptr && ops_[i].node->is_public)) out.push_back(i);
  }
  return out;
}

void ProgramBuilder::list_kept() {
  for (const Op& op : ops_) {
    if (op.blocks == 0 || op.behavior == nullptr || op.behavior->state_size == 0) continue;
    program_->kept_.push_back(
        {op.path, base::hash_text(op.path), op.state, static_cast<std::uint32_t>(op.behavior->state_size)});
  }
}

void ProgramBuilder::add_fresh_ports() {
  for (const Op& op : ops_) {
    if (op.kind != Instruction::Kind::kStartAsync) continue;
    program_->ports_.push_back({op.path + ".fresh", Port::Role::kOutput, &type_info<bool>(), "", "", op.fresh,
                                -kNoLimit, kNoLimit, ""});
  }
}

void ProgramBuilder::write_initial_frame() {
  program_->initial_ = Frame((frame_size_ + Frame::kAlignment - 1) / Frame::kAlignment * Frame::kAlignment);
  std::byte* frame = program_->initial_.data();
  for (const Slot& slot : slots_)
    std::copy(slot.value.begin(), slot.value.begin() + program_->ports_[slot.port].type->size,
              frame + slot.offset);
  for (const Op& op : ops_) {
    // One that shares another's value has no place of its own: its output would be the frame's beginning.
    if (op.same_as != kNone) continue;
    if (op.type != nullptr && op.behavior != nullptr && op.behavior->write_initial_output != nullptr) {
      op.behavior->write_initial_output(frame + op.output);
    }
  }
}

Program::Block ProgramBuilder::emit_for(const std::vector<Ref>& refs) {
  std::vector<std::uint32_t> roots;
  for (const Ref& ref : refs) {
    if (ref.kind == Ref::Kind::kOp || ref.kind == Ref::Kind::kFresh) roots.push_back(ref.index);
  }
  return emit(roots);
}

// Leaves out what needs the value of an op whose own blocks are being emitted: only a delay leads there from
// inside of them. What such a delay keeps is evaluated behind that op.
std::vector<std::uint32_t> ProgramBuilder::take_what_waits(const std::vector<std::uint32_t>& ops) {
  is_begun_.resize(ops_.size(), 0);
  std::map<std::uint32_t, std::uint32_t> waits_for;
  std::vector<std::uint32_t> out;
  for (const std::uint32_t i : ops) {
    std::optional<std::uint32_t> begun;
    if (is_begun_[i] != 0) begun = i;
    const auto look = [&](const Ref& ref) {
      if (ref.kind != Ref::Kind::kOp && ref.kind != Ref::Kind::kFresh) return;
      const auto found = waits_for.find(canonical(ref.index));
      if (found != waits_for.end()) begun = found->second;
    };
    for (const auto& input : ops_[i].inputs) {
      for (const Ref& ref : input) look(ref);
    }
    look(ops_[i].selector);
    if (begun)
      waits_for.emplace(i, *begun);
    else
      out.push_back(i);
  }
  for (const std::uint32_t i : out) {
    if (ops_[i].value.kind != Ref::Kind::kOp) continue;
    const auto found = waits_for.find(canonical(ops_[i].value.index));
    if (found != waits_for.end()) waiting_[found->second].push_back(found->first);
  }
  return out;
}

Program::Block ProgramBuilder::emit(const std::vector<std::uint32_t>& roots) {
  std::vector<std::uint32_t> all = roots;
  std::vector<std::uint32_t> ops;
  std::vector<Instruction> block;
  for (bool is_complete = false; !is_complete;) {
    const std::size_t known = all.size();
    block.clear();
    ops = take_what_waits(order(all));
    for (const std::uint32_t i : ops) {
      block.push_back(emit_op(i));
      const auto waiting = waiting_.extract(i);
      if (waiting) all.insert(all.end(), waiting.mapped().begin(), waiting.mapped().end());
    }
    is_complete = all.size() == known;
  }
  for (const std::uint32_t i : ops) ++ops_[i].blocks;
  Program::Block out;
  out.first = static_cast<std::uint32_t>(program_->instructions_.size());
  out.count = static_cast<std::uint32_t>(block.size());
  program_->instructions_.insert(program_->instructions_.end(), block.begin(), block.end());
  instruction_ops_.insert(instruction_ops_.end(), ops.begin(), ops.end());
  emit_needs(ops, out);
  return out;
}

Instruction ProgramBuilder::emit_op(std::uint32_t i) {
  Instruction out;
  out.kind = ops_[i].kind;
  static_cast<Firing&>(out) = {ops_[i].output, ops_[i].state, base::hash_text(ops_[i].path)};
  if (ops_[i].behavior != nullptr) out.fire = ops_[i].behavior->fire;
  const bool is_new = ops_[i].data == kNone;
  switch (ops_[i].kind) {
    case Instruction::Kind::kFire:
      out.inputs = emit_inputs(ops_[i]);
      break;
    case Instruction::Kind::kSequence:
    case Instruction::Kind::kSelect:
      if (!is_new) break;
      is_begun_[i] = 1;
      ops_[i].data =
          ops_[i].kind == Instruction::Kind::kSelect ? emit_select(ops_[i]) : emit_sequence(ops_[i]);
      is_begun_[i] = 0;
      break;
    case Instruction::Kind::kDelay:
      if (!is_new) break;
      ops_[i].data = emit_delay(ops_[i]);
      delay_ops_.push_back(i);
      break;
    case Instruction::Kind::kStartAsync:
      out.inputs = static_cast<std::uint32_t>(program_->words_.size());
      if (is_new)
        ops_[i].data = emit_async(ops_[i], out.inputs);
      else
        out.inputs = ops_[i].captured;
      break;
  }
  if (ops_[i].data != kNone) out.data = ops_[i].data;
  return out;
}

std::uint32_t ProgramBuilder::emit_inputs(const Op& op) {
  const auto first = static_cast<std::uint32_t>(program_->words_.size());
  // A list stands in the inputs as the index of its words, which come after the inputs: see Call::inputs.
  std::vector<std::uint32_t> words;
  for (std::size_t i = 0; i < op.inputs.size(); ++i) {
    if (op.behavior->inputs[i].is_list) words.push_back(static_cast<std::uint32_t>(op.inputs[i].size()));
    for (const Ref& ref : op.inputs[i]) words.push_back(offset_of(ref));
  }
  program_->words_.insert(program_->words_.end(), words.begin(), words.end());
  return first;
}

std::uint32_t ProgramBuilder::emit_sequence(const Op& op) {
  Program::SequenceCode code;
  code.active = allocate(sizeof(std::uint32_t), alignof(std::uint32_t));
  code.start = op.start;
  code.value_size = op.type->size;
  const std::vector<StateRefs>& states = op.states;
  const Node& node = *op.node;
  std::vector<std::string> names;
  for (std::size_t s = 0; s < states.size(); ++s) {
    Program::StateCode state;
    state.triggers = emit_for(states[s].triggers);
    state.member = emit_for({states[s].member});
    state.value = offset_of(states[s].member);
    for (std::size_t t = 0; t < states[s].triggers.size(); ++t) {
      const Transition& transition = node.states[s].transitions[t];
      state.transitions.push_back({offset_of(states[s].triggers[t]), transition.is_negated,
                                   transition.restarts, states[s].targets[t]});
    }
    code.states.push_back(std::move(state));
    names.push_back(node.states[s].name);
  }
  program_->sequences_.push_back(std::move(code));
  program_->sequence_names_.push_back(node.name);
  program_->state_names_.push_back(std::move(names));
  return static_cast<std::uint32_t>(program_->sequences_.size() - 1);
}

// Most selectors are truth values and choices of one byte, or small numbers: their case stands at the value's
// own place.
void ProgramBuilder::list_choices(const Node& node, Program::SelectCode& code) {
  constexpr std::int64_t kMostDirect = 256;
  if (code.selector_size == 1) code.direct.resize(kMostDirect, code.otherwise);
  for (std::size_t i = 0; i < node.cases.size(); ++i) {
    for (const std::int64_t value : node.cases[i].values) {
      if (value < 0 || value >= kMostDirect) {
        code.choices.push_back({value, static_cast<std::uint32_t>(i)});
        continue;
      }
      const auto at = static_cast<std::size_t>(value);
      if (at >= code.direct.size()) code.direct.resize(at + 1, code.otherwise);
      code.direct[at] = static_cast<std::int32_t>(i);
    }
  }
}

std::uint32_t ProgramBuilder::emit_select(const Op& op) {
  Program::SelectCode code;
  code.selector = offset_of(op.selector);
  code.selector_size = op.selector.type->size;
  code.value_size = op.type->size;
  const std::vector<Ref>& members = op.cases;
  const Node& node = *op.node;
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (node.cases[i].values.empty()) code.otherwise = static_cast<std::int32_t>(i);
    code.cases.push_back({emit_for({members[i]}), offset_of(members[i])});
  }
  list_choices(node, code);
  program_->selects_.push_back(std::move(code));
  return static_cast<std::uint32_t>(program_->selects_.size() - 1);
}

std::uint32_t ProgramBuilder::emit_delay(const Op& op) {
  Program::DelayCode code;
  code.source = offset_of(op.value);
  code.initial = offset_of(op.initial);
  code.next = allocate(op.type->size, op.type->alignment);
  code.value_size = op.type->size;
  program_->delays_.push_back(code);
  return static_cast<std::uint32_t>(program_->delays_.size() - 1);
}

std::uint32_t ProgramBuilder::emit_async(const Op& op, std::uint32_t words) {
  Program::AsyncCode code;
  code.behavior = op.behavior;
  code.started = allocate(sizeof(std::uint32_t), alignof(std::uint32_t));
  code.fresh = op.fresh;
  code.captured = allocate(24, 8);  // time, cycle duration, whether it is the node's first job
  code.output_size = op.type == nullptr ? 0 : op.type->size;
  for (std::size_t i = 0; i < op.inputs.size(); ++i) {
    const TypeInfo& type = *op.behavior->inputs[i].type;
    code.sources.push_back(offset_of(op.inputs[i].front()));
    code.captured_offsets.push_back(allocate(type.size, type.alignment));
    code.sizes.push_back(type.size);
  }
  program_->words_.insert(program_->words_.end(), code.captured_offsets.begin(), code.captured_offsets.end());
  ops_[static_cast<std::size_t>(&op - ops_.data())].captured = words;
  program_->asyncs_.push_back(std::move(code));
  return static_cast<std::uint32_t>(program_->asyncs_.size() - 1);
}

// Those of a select's cases are known already: their blocks were emitted before the one that it stands in.
void ProgramBuilder::emit_needs(const std::vector<std::uint32_t>& ops, Program::Block& block) {
  std::vector<Program::NeedCode> needs;
  std::vector<Program::NeedySequence> sequences;
  for (const std::uint32_t i : ops) {
    const Op& op = ops_[i];
    if (op.behavior != nullptr) {
      for (const Need& need : op.behavior->needs) needs.push_back(need_of(op, need));
    }
    if (op.kind == Instruction::Kind::kSequence) sequences.push_back({op.data, false});
    if (op.kind != Instruction::Kind::kSelect) continue;
    for (const Program::CaseCode& one : program_->selects_[op.data].cases) {
      std::ranges::copy(program_->needs_of(one.member), std::back_inserter(needs));
      for (const auto& inner : program_->sequences_of(one.member))
        sequences.push_back({inner.sequence, true});
    }
  }
  append_each_once(program_->needs_, std::move(needs), block.first_need, block.need_count);
  append_each_once(program_->needy_sequences_, std::move(sequences), block.first_sequence,
                   block.sequence_count);
}

Program::NeedCode ProgramBuilder::need_of(const Op& op, const Need& need) const {
  const bool has_own_reach = percept::info(need.sensor).has_own_reach;
  Program::NeedCode out{need.sensor, kNone, has_own_reach ? percept::kOwnReach : need.range};
  if (need.range_input >= 0)
    out.range_offset = offset_of(op.inputs[static_cast<std::size_t>(need.range_input)].front());
  return out;
}

bool ProgramBuilder::is_mixture(const Op& op) const {
  if (op.behavior == nullptr || op.behavior->inputs.size() < 2 || op.node == nullptr) return false;
  const Input& values = op.behavior->inputs[0];
  const Input& gains = op.behavior->inputs[1];
  return values.is_list && gains.is_list && values.type->kind == TypeKind::kVector &&
         gains.type->kind == TypeKind::kReal;
}

std::string ProgramBuilder::path_of(const Ref& ref) const {
  return ref.kind == Ref::Kind::kSlot ? program_->ports_[slots_[ref.index].port].path : ops_[ref.index].path;
}

void ProgramBuilder::emit_mixtures() {
  for (const Op& op : ops_) {
    if (op.blocks == 0 || !is_mixture(op)) continue;
    Program::MixtureCode code{op.path, op.stamp, {}};
    const std::size_t count = std::min(op.inputs[0].size(), op.inputs[1].size());
    for (std::size_t i = 0; i < count; ++i) {
      code.members.push_back(
          {path_of(op.inputs[0][i]), offset_of(op.inputs[0][i]), offset_of(op.inputs[1][i])});
    }
    program_->mixtures_.push_back(std::move(code));
  }
}

// It matters when it ran last, in however many blocks it stands.
bool ProgramBuilder::has_own_stamp(const Op& op) const {
  const bool keeps_state = op.behavior != nullptr && (op.behavior->state_size > 0 || op.behavior->has_header);
  const bool is_operator = op.kind == Instruction::Kind::kSequence || op.kind == Instruction::Kind::kDelay ||
                           op.kind == Instruction::Kind::kStartAsync;
  return keeps_state || is_operator || is_mixture(op);
}

// Only now is it known which operations stand in several blocks.
void ProgramBuilder::assign_stamps() {
  for (Op& op : ops_) {
    if (op.blocks > 1 && op.stamp == kNone) op.stamp = allocate(4, 4);
  }
  for (std::size_t i = 0; i < program_->instructions_.size(); ++i) {
    const Op& op = ops_[instruction_ops_[i]];
    program_->instructions_[i].stamp = op.stamp;
    program_->instructions_[i].is_guarded = op.blocks > 1;
    if (op.kind == Instruction::Kind::kSequence)
      program_->sequences_[program_->instructions_[i].data].stamp = op.stamp;
  }
  for (std::size_t i = 0; i < delay_ops_.size(); ++i) program_->delays_[i].stamp = ops_[delay_ops_[i]].stamp;
}

}  // namespace mlab::flow
